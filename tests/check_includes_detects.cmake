# Plants one forbidden include after the other and expects check_includes.cmake to name it.
#
# cmake -D SCRATCH=<folder of its own> -D QT_WIDGETS=<..> -P check_includes_detects.cmake
include(${CMAKE_CURRENT_LIST_DIR}/expect_check.cmake)

# write_source(FILE INCLUDE): a source with that include below SCRATCH
function(write_source file include)
    file(WRITE ${SCRATCH}/${file} "#pragma once\n#include <vector>\n  #  include ${include}\n")
endfunction()

# expect_includes(NAME PASS|FAIL [COMPLAINT]): what the check says of the sources that were written
function(expect_includes name expected)
    expect_check(check_includes.cmake "${name}" ${expected} "${ARGN}" -D QT_WIDGETS=${QT_WIDGETS})
endfunction()

# plant(FILE INCLUDE PASS|FAIL)
function(plant file include expected)
    file(REMOVE_RECURSE ${SCRATCH})
    write_source(${file} "${include}")
    expect_includes("${file} with ${include}" ${expected} "${file}: includes")
endfunction()

plant(core/base/a.h "<QImage>" PASS)
plant(core/base/a.h "<QWidget>" FAIL)
plant(core/base/a.cpp "<QApplication>" FAIL)
plant(core/deep/er/a.cpp "<QtWidgets/QLabel>" FAIL)
plant(core/base/a.cpp "<QPainter>" FAIL)
plant(core/base/a.cpp "<QObject>" FAIL)
plant(core/base/a.cpp "\"ui/document/document.h\"" FAIL)
plant(core/truth/a.cpp "\"core/pipeline/clipping.h\"" PASS)
plant(core/base/a.cpp "\"core/pipeline/clipping.h\"" FAIL)
plant(core/scene/a.cpp "\"core/io/obj_loader.h\"" FAIL)
plant(core/pipeline/a.cpp "\"core/render/render.h\"" FAIL)
plant(core/tiled/a.cpp "\"core/render/render.h\"" FAIL)
plant(core/settings/a.h "\"core/scene/scene.h\"" FAIL)
plant(ui/base/a.cpp "\"core/pipeline/clipping.h\"" FAIL)
plant(ui/base/a.cpp "\"core/tiled/tiled.h\"" FAIL)
plant(ui/base/a.cpp "\"core/render/render.h\"" PASS)
plant(ui/base/a.cpp "\"core/observe/step_log.h\"" PASS)
plant(ui/base/a.cpp "\"core/pipeline/statistics.h\"" PASS)
plant(ui/base/a.cpp "<QWidget>" PASS)
plant(ui/base/a.cpp "\"ui/document/document.h\"" FAIL)
plant(ui/steps/a.cpp "\"ui/truth/referee.h\"" FAIL)
plant(ui/steps/a.cpp "\"ui/canvas/wipe.h\"" PASS)
plant(ui/window/a.cpp "\"ui/truth/referee.h\"" PASS)
plant(ui/base/a.cpp "\"app/cli/verbs.h\"" FAIL)
plant(app/cli/a.cpp "<QMainWindow>" FAIL)
plant(app/cli_main.cpp "\"ui/document/document.h\"" FAIL)
plant(app/gui_main.cpp "<QApplication>" PASS)
plant(app/cli/a.cpp "\"core/pipeline/clipping.h\"" FAIL)
plant(app/cli/a.cpp "\"core/pipeline/frame.h\"" PASS)

# Folders that the list of rooms does not know
file(REMOVE_RECURSE ${SCRATCH})
write_source(core/attic/a.h "<QImage>")
expect_includes("a folder that is no room" FAIL "core/attic is no room")

# Circles of files, within one room
file(REMOVE_RECURSE ${SCRATCH})
write_source(core/base/a.h "\"core/base/b.h\"")
write_source(core/base/b.h "<QImage>")
expect_includes("a chain of two" PASS)
write_source(core/base/b.cpp "\"core/base/c.h\"")
write_source(core/base/c.h "\"core/base/a.h\"")
expect_includes("a circle of three" FAIL "in a circle")

# A picture of other rooms
file(REMOVE_RECURSE ${SCRATCH})
file(WRITE ${SCRATCH}/docs/images/rooms.svg "<title>core/base:</title>")
expect_includes("a picture without core/settings" FAIL "does not show \"core/settings: core/base\"")
