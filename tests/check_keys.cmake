# Fails when README.md's list of keys is not what `rasterlens --keys` prints.
#
# cmake -D README=<file> -D RASTERLENS=<program> -P check_keys.cmake
#
# Mend it with the program's output between the two markers.
execute_process(COMMAND ${CMAKE_COMMAND} -E env QT_QPA_PLATFORM=offscreen ${RASTERLENS} --keys
                OUTPUT_VARIABLE printed RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${RASTERLENS} --keys ends with ${result}")
endif()
set(begin "<!-- what `rasterlens --keys` prints -->\n")
set(end "<!-- end of the keys -->")
file(READ ${README} text)
string(FIND "${text}" "${begin}" from)
string(FIND "${text}" "${end}" to)
if(from LESS 0 OR to LESS from)
    message(FATAL_ERROR "${README} has no list of keys between \"${begin}\" and \"${end}\"")
endif()
string(LENGTH "${begin}" length)
math(EXPR from "${from} + ${length}")
math(EXPR length "${to} - ${from}")
string(SUBSTRING "${text}" ${from} ${length} listed)
if(NOT listed STREQUAL printed)
    message(FATAL_ERROR "${README} lists other keys than the program, which prints:\n${printed}")
endif()
