# Fails when a source includes what its room must not know, when two files include each other in a circle, and when a
# folder is no room.
#
# cmake -D ROOT=<tree> -D QT_WIDGETS=<folder of the QtWidgets headers> -P check_includes.cmake
#
# With -D PRINT=ON it also prints the rooms and what each of them uses.
cmake_policy(VERSION 3.25)
set(violations "")

# The rooms of core and ui from below, and the rooms each of them may use. A room may always use itself; the files that
# lie in core or ui itself are build files only.
set(rooms
    "core/base:"
    "core/settings: core/base"
    "core/scene: core/base core/settings"
    "core/io: core/base core/settings core/scene"
    "core/scenes: core/base core/settings core/scene core/io"
    "core/pipeline: core/base core/settings core/scene"
    "core/rasterizers: core/base core/settings core/pipeline"
    "core/tiled: core/base core/settings core/scene core/pipeline core/rasterizers"
    "core/observe: core/base core/settings core/scene core/pipeline"
    "core/render: core/base core/settings core/scene core/pipeline core/rasterizers core/tiled core/observe"
    "core/questions: core/base core/settings core/scene core/pipeline core/observe core/render"
    "core/derive: core/base core/settings core/scene core/pipeline core/observe core/render core/questions"
    "core/truth: core/base core/settings core/scene core/io core/scenes core/pipeline core/observe core/render"
    "core/opengl: core/base core/settings core/scene core/pipeline core/truth"
    "core/lessons: core/base core/settings core/scene core/io core/scenes core/pipeline core/observe core/render core/questions core/truth"
    "core/page: core/base core/settings core/scene core/pipeline core/observe core/render core/questions core/lessons"
    "ui/base:"
    "ui/document: ui/base"
    "ui/canvas: ui/base ui/document"
    "ui/pipeline: ui/base ui/document ui/canvas"
    "ui/steps: ui/base ui/document ui/canvas"
    "ui/face: ui/base ui/document ui/canvas"
    "ui/truth: ui/base ui/document ui/canvas"
    "ui/lessons: ui/base ui/document ui/canvas"
    "ui/window: ui/base ui/document ui/canvas ui/pipeline ui/steps ui/face ui/truth ui/lessons")

# What ui and app may include of core: every room but those of the stages and the rasterizers, and of the stages' room the
# results.
set(entry_rooms core/base core/settings core/scene core/io core/scenes core/observe core/render core/questions core/derive core/truth
    core/opengl core/lessons core/page)
set(entry_headers core/pipeline/frame.h core/pipeline/statistics.h)

# <QWidget> and <QtWidgets/QWidget>
function(is_widgets_header header result)
    set(${result} FALSE PARENT_SCOPE)
    if(header MATCHES "^QtWidgets" OR (header MATCHES "^Q[^/]+$" AND EXISTS ${QT_WIDGETS}/${header}))
        set(${result} TRUE PARENT_SCOPE)
    endif()
endfunction()

# Sets `why` in case a source of core must not include the header.
function(core_rule source header)
    get_filename_component(room ${source} DIRECTORY)
    get_filename_component(used "${header}" DIRECTORY)
    is_widgets_header("${header}" is_widgets)
    if(is_widgets)
        set(why "core knows no QtWidgets" PARENT_SCOPE)
    elseif(header MATCHES "^(QtGui/)?QPaint" OR header MATCHES "^(QtCore/)?QObject$")
        set(why "core draws without QPainter and holds no QObject" PARENT_SCOPE)
    elseif(header MATCHES "^(ui|app)/")
        set(why "core stands below ui and app" PARENT_SCOPE)
    elseif(header MATCHES "^core/" AND NOT used STREQUAL room AND NOT used IN_LIST may_use_${room})
        set(why "${room} may not use ${used}" PARENT_SCOPE)
    endif()
endfunction()

function(ui_rule source header)
    get_filename_component(room ${source} DIRECTORY)
    get_filename_component(used "${header}" DIRECTORY)
    if(header MATCHES "^app/")
        set(why "ui stands below app" PARENT_SCOPE)
    elseif(header MATCHES "^core/" AND NOT used IN_LIST entry_rooms AND NOT header IN_LIST entry_headers)
        set(why "ui knows neither the stages nor the rasterizers" PARENT_SCOPE)
    elseif(header MATCHES "^ui/" AND NOT used STREQUAL room AND NOT used IN_LIST may_use_${room})
        set(why "${room} may not use ${used}" PARENT_SCOPE)
    endif()
endfunction()

function(app_rule source header)
    get_filename_component(used "${header}" DIRECTORY)
    is_widgets_header("${header}" is_widgets)
    if(source MATCHES "^app/cli" AND (is_widgets OR header MATCHES "^ui/"))
        set(why "the command line knows no widgets" PARENT_SCOPE)
    elseif(header MATCHES "^core/" AND NOT used IN_LIST entry_rooms AND NOT header IN_LIST entry_headers)
        set(why "app knows neither the stages nor the rasterizers" PARENT_SCOPE)
    endif()
endfunction()

# Whether any of the files of one list stands in another.
function(uses_any files others result)
    set(${result} FALSE PARENT_SCOPE)
    foreach(file IN LISTS files)
        if(file IN_LIST others)
            set(${result} TRUE PARENT_SCOPE)
            return()
        endif()
    endforeach()
endfunction()

# Gives every include of the sources below `folder` to `rule`. A header and its .cpp are one file pair; `pairs` and
# `uses_PAIR` become the graph of the pairs.
function(check_folder folder rule)
    set(pairs "")
    file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    foreach(source IN LISTS sources)
        string(REGEX REPLACE "\\.(h|cpp)$" "" pair ${source})
        list(APPEND pairs ${pair})
        get_filename_component(room ${source} DIRECTORY)
        if(folder MATCHES "^(core|ui)$" AND NOT room IN_LIST room_names)
            string(APPEND violations "${source}: ${room} is no room; tests/check_includes.cmake lists them\n")
        endif()
        file(STRINGS ${ROOT}/${source} includes REGEX "^[ \t]*#[ \t]*include")
        foreach(line IN LISTS includes)
            string(REGEX MATCH "[<\"]([^>\"]+)[>\"]" matched "${line}")
            set(header "${CMAKE_MATCH_1}")
            set(why "")
            cmake_language(CALL ${rule} ${source} "${header}")
            if(why)
                string(APPEND violations "${source}: includes ${header}, but ${why}\n")
            endif()
            string(REGEX REPLACE "\\.h$" "" used "${header}")
            if(used MATCHES "^${folder}/" AND NOT used STREQUAL pair)
                list(APPEND uses_${pair} "${used}")
                get_filename_component(used_room ${used} DIRECTORY)
                list(APPEND room_uses_${room} ${used_room})
            endif()
        endforeach()
    endforeach()
    list(REMOVE_DUPLICATES pairs)

    # Pairs that use nothing that is left are taken away, again and again; what stays runs in a circle or uses one.
    set(left ${pairs})
    set(found TRUE)
    while(found)
        set(found FALSE)
        foreach(pair IN LISTS left)
            uses_any("${uses_${pair}}" "${left}" still_used)
            if(NOT still_used)
                list(REMOVE_ITEM left ${pair})
                set(found TRUE)
            endif()
        endforeach()
    endwhile()
    if(left)
        list(JOIN left " " circle)
        string(APPEND violations "${folder}: these include each other in a circle, or what does: ${circle}\n")
    endif()

    if(PRINT)
        list(LENGTH pairs pair_count)
        list(LENGTH left circular)
        message(STATUS "${folder}: ${pair_count} file pairs, ${circular} in circles")
        foreach(room IN LISTS room_names)
            if(room MATCHES "^${folder}/")
                set(used_rooms ${room_uses_${room}})
                list(REMOVE_DUPLICATES used_rooms)
                list(REMOVE_ITEM used_rooms ${room})
                list(SORT used_rooms)
                list(JOIN used_rooms " " used_rooms)
                message(STATUS "  ${room} uses: ${used_rooms}")
            endif()
        endforeach()
    endif()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

if(NOT EXISTS ${QT_WIDGETS}/QWidget)
    message(FATAL_ERROR "QT_WIDGETS: there is no QWidget in \"${QT_WIDGETS}\"")
endif()
# A room may use rooms that stand before it only: so no two of them can include each other.
set(room_names "")
foreach(row IN LISTS rooms)
    string(REGEX MATCH "^([^:]+):(.*)$" matched "${row}")
    set(room ${CMAKE_MATCH_1})
    separate_arguments(may_use_${room} UNIX_COMMAND "${CMAKE_MATCH_2}")
    foreach(used IN LISTS may_use_${room})
        if(NOT used IN_LIST room_names)
            message(FATAL_ERROR "the list of rooms: ${room} uses ${used}, which does not stand before it")
        endif()
    endforeach()
    list(APPEND room_names ${room})
endforeach()
# The picture of the rooms, if the tree has one, shows this list.
if(EXISTS ${ROOT}/docs/images/rooms.svg)
    file(READ ${ROOT}/docs/images/rooms.svg picture)
    foreach(row IN LISTS rooms)
        string(FIND "${picture}" "<title>${row}</title>" place)
        if(place EQUAL -1)
            string(APPEND violations "docs/images/rooms.svg does not show \"${row}\"; scripts/draw_rooms draws it anew\n")
        endif()
    endforeach()
endif()
check_folder(core core_rule)
check_folder(ui ui_rule)
check_folder(app app_rule)
if(violations)
    message(FATAL_ERROR "Forbidden includes, or an old picture of them:\n${violations}")
endif()
