# Plants lists of keys and expects check_keys.cmake to find each that differs from what the program prints.
#
# cmake -D SCRATCH=<folder of its own> -D README=<file> -D RASTERLENS=<program> -P check_keys_detects.cmake

# plant(TEXT PASS|FAIL WHAT): what the check says of a README with this text
function(plant text expected what)
    file(WRITE ${SCRATCH}/README.md "${text}")
    execute_process(COMMAND ${CMAKE_COMMAND} -D README=${SCRATCH}/README.md -D RASTERLENS=${RASTERLENS}
                            -P ${CMAKE_CURRENT_LIST_DIR}/check_keys.cmake
                    RESULT_VARIABLE result ERROR_VARIABLE message)
    if(expected STREQUAL FAIL AND result EQUAL 0)
        message(SEND_ERROR "${what} passes the check, but must not")
    elseif(expected STREQUAL PASS AND NOT result EQUAL 0)
        message(SEND_ERROR "${what} does not pass the check, but should. ${message}")
    endif()
endfunction()

file(READ ${README} text)
plant("${text}" PASS "the true list")
string(REPLACE "| Canvas | F | Fit |\n" "" less "${text}")
plant("${less}" FAIL "a list without the key F")
string(REPLACE "| Ctrl+1 |" "| Ctrl+2 |" other "${text}")
plant("${other}" FAIL "a list with another key")
string(REPLACE "<!-- end of the keys -->" "" open "${text}")
plant("${open}" FAIL "a list without its end")
