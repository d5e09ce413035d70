# For the tests that plant what a check of the house rules must find.

# expect_check(SCRIPT NAME PASS|FAIL COMPLAINT [-D NAME=VALUE]...): what the script says of the tree below SCRATCH. One that
# must fail has to say COMPLAINT, a regular expression.
function(expect_check script name expected complaint)
    execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} ${ARGN} -P ${CMAKE_CURRENT_LIST_DIR}/${script}
                    RESULT_VARIABLE result ERROR_VARIABLE message)
    if(expected STREQUAL FAIL AND (result EQUAL 0 OR NOT message MATCHES "${complaint}"))
        message(SEND_ERROR "${name} passes the check, but must not. ${message}")
    elseif(expected STREQUAL PASS AND NOT result EQUAL 0)
        message(SEND_ERROR "${name} does not pass the check, but should. ${message}")
    endif()
endfunction()
