# Plants one forbidden include after the other and expects check_includes.cmake to name it.
#
# cmake -D SCRATCH=<folder of its own> -D QT_WIDGETS=<..> -P check_includes_detects.cmake
# plant(FILE INCLUDE PASS|FAIL)
function(plant file include expected)
    file(REMOVE_RECURSE ${SCRATCH})
    file(WRITE ${SCRATCH}/${file} "#pragma once\n#include <vector>\n  #  include ${include}\n")
    execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -D QT_WIDGETS=${QT_WIDGETS}
                            -P ${CMAKE_CURRENT_LIST_DIR}/check_includes.cmake
                    RESULT_VARIABLE result ERROR_VARIABLE message)
    if(expected STREQUAL FAIL AND (result EQUAL 0 OR NOT message MATCHES "${file}: includes"))
        message(SEND_ERROR "${file} may include ${include}, but must not. ${message}")
    elseif(expected STREQUAL PASS AND NOT result EQUAL 0)
        message(SEND_ERROR "${file} may not include ${include}, but should. ${message}")
    endif()
endfunction()

plant(core/a.h "<QImage>" PASS)
plant(core/a.h "<QWidget>" FAIL)
plant(core/a.cpp "<QApplication>" FAIL)
plant(core/deep/er/a.cpp "<QtWidgets/QLabel>" FAIL)
plant(core/a.cpp "<QPainter>" FAIL)
plant(core/a.cpp "<QObject>" FAIL)
plant(core/a.cpp "\"ui/document/document.h\"" FAIL)
plant(core/a.cpp "\"core/pipeline/clipping.h\"" PASS)
plant(ui/a.cpp "\"core/pipeline/clipping.h\"" FAIL)
plant(ui/a.cpp "\"core/tiled/tiled.h\"" FAIL)
plant(ui/a.cpp "\"core/render/render.h\"" PASS)
plant(ui/a.cpp "\"core/observe/step_log.h\"" PASS)
plant(ui/a.cpp "<QWidget>" PASS)
plant(ui/a.cpp "\"app/cli/verbs.h\"" FAIL)
plant(app/cli/a.cpp "<QMainWindow>" FAIL)
plant(app/cli_main.cpp "\"ui/document/document.h\"" FAIL)
plant(app/gui_main.cpp "<QApplication>" PASS)
