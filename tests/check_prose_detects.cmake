# Plants one comment without a subject after the other and expects check_prose.cmake to name it.
#
# cmake -D SCRATCH=<folder of its own> -P check_prose_detects.cmake

# plant(FILE TEXT PASS|FAIL): what the check says of a tree with this file alone
function(plant file text expected)
    file(REMOVE_RECURSE ${SCRATCH})
    file(WRITE ${SCRATCH}/${file} "${text}\n")
    execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -P ${CMAKE_CURRENT_LIST_DIR}/check_prose.cmake
                    RESULT_VARIABLE result ERROR_VARIABLE message)
    if(expected STREQUAL FAIL AND (result EQUAL 0 OR NOT message MATCHES "${file}:[0-9]+: "))
        message(SEND_ERROR "\"${text}\" passes the check, but must not. ${message}")
    elseif(expected STREQUAL PASS AND NOT result EQUAL 0)
        message(SEND_ERROR "\"${text}\" does not pass the check, but should. ${message}")
    endif()
endfunction()

plant(core/base/a.h "/// The distance of two planes." PASS)
plant(core/base/a.h "/// The same for two lines." FAIL)
plant(core/base/a.h "int a; ///< likewise" FAIL)
plant(core/base/a.h "/// out     pixels. The same with samples." FAIL)
plant(core/base/a.h "/// exact   the same pixels as with one thread" PASS)
plant(ui/base/a.cpp "// Is told what happens." FAIL)
plant(ui/base/a.cpp "// What happens is told in order." PASS)
plant(ui/base/a.cpp "// A colour that nobody asks for is not stored." FAIL)
plant(ui/base/a.cpp "// kNobody: no triangle" PASS)
plant(app/cli/a.cpp "// Sums of two of them are such again." FAIL)
plant(app/cli/a.cpp "// Names such as these have a suffix, and such a name is unique." PASS)
plant(tests/a.cpp "// To be called last." FAIL)
plant(tests/a.cpp "// Of whole numbers." FAIL)
plant(bench/a.cpp "int b; ///< of these, the wrong ones" FAIL)
plant(bench/a.cpp "const char* text = \"Is told nothing\";" PASS)
plant(README.md "Whoever owns it is in front." FAIL)
plant(README.md "Not \"likewise\", but the thing itself." PASS)
plant(docs/A.md "| frustum | Likewise |" FAIL)
plant(docs/A.md "| frustum | the same planes as `guard-band` |" PASS)
plant(core/tiled/README.md "Those of the next tile wait." FAIL)
