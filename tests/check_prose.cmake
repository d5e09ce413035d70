# Fails when a comment or a document says something about a thing that it does not name. A comment is read alone, far from
# the one before it: "the same", "likewise" or "is told" leave the reader to guess what is meant, and "nobody" stands in
# place of the function that does not read a value. The patterns below are the words that such comments were found by.
#
# It also fails when a document names a file of the tree that does not exist.
#
# cmake -D ROOT=<tree> -P check_prose.cmake
#
# It reads the // comments of core, ui, app, tests and bench, and every .md file of the project and of these folders.
cmake_policy(VERSION 3.25)
set(folders core ui app tests bench)
set(violations "")

# Where a sentence begins: at the front of the comment or of a table's cell, or behind a full stop. A word behind a
# quotation mark is only spoken about.
set(sentence "(^|[.!?|] )")
set(word "(^|[^A-Za-z_\"])")
set(end "([^A-Za-z_]|$)")
set(patterns
    "${sentence}(The same|Is|Are|Was|Were|Those|To be|Of)${end}"
    "${word}([Ll]ikewise|[Dd]itto|[Aa]s above|[Ss]ee above)${end}"
    "${word}([Nn]obody|[Ss]omebody|[Aa]nybody|[Aa]nyone|[Ww]hoever)${end}"
    "${word}[Ss]uch( again)?[.,:)]"
    "^of (all )?(these|those|below)${end}"
    "${word}as the (next|following)(,|[.]|$)")

# Looks at the lines of a text that match `prose`, whose first group holds what is to be read.
function(check_lines file text prose)
    # These characters have a meaning in CMake's lists.
    string(REPLACE ";" "," text "${text}")
    string(REPLACE "[" "(" text "${text}")
    string(REPLACE "]" ")" text "${text}")
    string(REPLACE "\\" "/" text "${text}")
    string(REPLACE "\n" ";" lines "${text}")
    set(number 0)
    foreach(line IN LISTS lines)
        math(EXPR number "${number} + 1")
        if(line MATCHES "${prose}")
            # The headings of an interface comment stand in front of a sentence.
            string(REGEX REPLACE "^(in|out|covers|order|cost|exact|units|errors|source)  +" "" read "${CMAKE_MATCH_1}")
            foreach(pattern IN LISTS patterns)
                if(read MATCHES "${pattern}")
                    string(STRIP "${CMAKE_MATCH_0}" found)
                    string(APPEND violations "${file}:${number}: \"${found}\" names no subject: ${read}\n")
                endif()
            endforeach()
        endif()
    endforeach()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

# Looks at the paths of a document, `like/this.cpp`; a header and its source may be named without the suffix.
function(check_paths file text)
    string(REGEX MATCHALL "`(core|ui|app|tests|bench|docs|scripts|resources)/[A-Za-z0-9_./*-]+`" paths "${text}")
    foreach(path IN LISTS paths)
        string(REPLACE "`" "" path "${path}")
        string(REGEX REPLACE "/$" "" path "${path}")
        file(GLOB found ${ROOT}/${path} ${ROOT}/${path}.*)
        if(NOT found)
            string(APPEND violations "${file}: there is no ${path}\n")
        endif()
    endforeach()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

file(GLOB documents RELATIVE ${ROOT} ${ROOT}/*.md ${ROOT}/docs/*.md)
foreach(folder IN LISTS folders)
    file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    foreach(source IN LISTS sources)
        file(READ ${ROOT}/${source} text)
        check_lines(${source} "${text}" "//+<?[ \t]*(.*)$")
    endforeach()
    file(GLOB_RECURSE more RELATIVE ${ROOT} ${ROOT}/${folder}/*.md)
    list(APPEND documents ${more})
endforeach()
# docs/MISTAKES.md is left out: it repeats the texts of core/settings/mistakes.cpp, in which people say why they make a
# mistake.
list(REMOVE_ITEM documents docs/MISTAKES.md)
foreach(document IN LISTS documents)
    file(READ ${ROOT}/${document} text)
    check_paths(${document} "${text}")
    check_lines(${document} "${text}" "^[-#>| \t]*(.*)$")
endforeach()
if(violations)
    message(FATAL_ERROR "Sentences without a subject, or files that do not exist:\n${violations}")
endif()
