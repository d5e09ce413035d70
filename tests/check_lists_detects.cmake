# Plants an enumerator into closed lists and expects that what must know of every value does not compile any more: a
# table without its row, a switch that forgets it.
#
# cmake -D ROOT=<tree> -D SCRATCH=<folder of its own> -D COMPILER=<c++> -D FLAGS=<include folders and options, with |>
#       -P check_lists_detects.cmake
cmake_policy(VERSION 3.25)
string(REPLACE "|" ";" flags "${FLAGS}")
file(REMOVE_RECURSE ${SCRATCH})

# plant(HEADER ENUM): a copy of the header below SCRATCH in which the enumeration has one value more
function(plant header enum)
    if(EXISTS ${SCRATCH}/${header})
        file(READ ${SCRATCH}/${header} text)
    else()
        file(READ ${ROOT}/${header} text)
    endif()
    string(FIND "${text}" "enum class ${enum} " begin)
    string(SUBSTRING "${text}" 0 ${begin} before)
    string(SUBSTRING "${text}" ${begin} -1 rest)
    string(FIND "${rest}" "}" end)
    string(SUBSTRING "${rest}" 0 ${end} values)
    string(SUBSTRING "${rest}" ${end} -1 after)
    if(begin EQUAL -1 OR end EQUAL -1)
        message(FATAL_ERROR "${header}: no enum class ${enum}")
    endif()
    if(values MATCHES "\n") # one value a line, a comma behind each
        string(APPEND values "    Planted,\n")
    else()
        string(APPEND values ", Planted ")
    endif()
    file(WRITE ${SCRATCH}/${header} "${before}${values}${after}")
endfunction()

# compile(SOURCE): sets `result` and `message`; headers below SCRATCH stand in for those of the tree
function(compile source)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} -std=c++20 -fsyntax-only -fmax-errors=0 -fno-diagnostics-show-caret -Wall -Wextra -Werror=switch
                            -I${SCRATCH} -I${ROOT} ${flags} ${ROOT}/${source}
                    RESULT_VARIABLE result ERROR_VARIABLE message)
    set(result ${result} PARENT_SCOPE)
    set(message "${message}" PARENT_SCOPE)
endfunction()

# expect_forgotten(SOURCE FUNCTION...): in each of the functions a switch forgets the planted value
function(expect_forgotten source)
    compile(${source})
    foreach(function IN LISTS ARGN)
        if(NOT message MATCHES "function [^\n]*${function}[^\n]*\n[^\n]*error: enumeration value .Planted. not handled")
            message(SEND_ERROR "${source}: ${function} compiles with a planted value:\n${message}")
        endif()
    endforeach()
endfunction()

# expect_missing_row(SOURCE): a table of the source has no row for the planted value
function(expect_missing_row source)
    compile(${source})
    if(result EQUAL 0 OR NOT message MATCHES "error: static assertion failed")
        message(SEND_ERROR "${source}: a table compiles without a row for a planted value:\n${message}")
    endif()
endfunction()

# The choices of a user: every enumeration of the field table at once, as each has an error of its own.
set(choices Algorithm NumberType Stepping Fill LineAlgorithm Clipping Culling Winding CullSpace DepthTest DepthFormat
            DepthOrder ClipZ Visibility Interpolation AttributePath TieRule Samples Shading TextureFilter AlphaTest Simd)
foreach(enum IN LISTS choices)
    plant(core/settings/settings.h ${enum})
endforeach()
set(members algorithm numberType stepping fill line clipping culling winding cullSpace depthTest depthFormat depthOrder
            clipZ visibility interpolation attributePath tieRule samples shading textureFilter alphaTest simd)
compile(core/settings/settings.cpp)
foreach(member IN LISTS members)
    if(NOT message MATCHES "Settings::${member};[^\n]*\n[^\n]*required from here\n[^\n]*error: static assertion failed")
        message(SEND_ERROR "a value of ${member} without a choice compiles:\n${message}")
    endif()
endforeach()
# What the tiled kernels draw.
plant(core/settings/rules.h DepthCompare)
expect_forgotten(core/tiled/supports.cpp "draws.rasterlens::Shading." "draws.rasterlens::TextureFilter."
                 "draws.rasterlens::Clipping." "draws.rasterlens::DepthFormat." "draws.rasterlens::DepthCompare.")
file(REMOVE_RECURSE ${SCRATCH})

plant(core/settings/step_kind.h StepKind)
expect_missing_row(core/settings/step_kind.cpp)
file(REMOVE_RECURSE ${SCRATCH})

plant(core/pipeline/types.h ClipPlane)
plant(core/pipeline/types.h FaceFate)
plant(core/settings/rules.h Facing)
plant(core/observe/names.h EdgeSide)
expect_missing_row(core/observe/names.cpp)
expect_forgotten(core/observe/names.cpp clipPlaneFormula faceFateId facingId edgeSideId)
file(REMOVE_RECURSE ${SCRATCH})
