#!/usr/bin/env bash
# Question: whose code does libQCustomPlotQt6 run when it puts a text into a QList<QString>: its own, or the program's?
# Usual guess: its own. QList is a template in a header; what the library was compiled to stays in the library.
# Seen with Qt 6.4.2 and QCustomPlot 2.1.0 (Debian 12, libqcustomplot-dev): the program's. GCC leaves instances of templates
#   open to replacement, the linker exports those from a program that a library it links wants too, and QCustomPlot's list
#   of labels calls five functions that the program's compiler made of the program's headers. With -fvisibility=hidden: none.
# Why it matters: a plot library is built once and Qt moves on. Where a newer Qt has changed what such a function does, a
#   program that is merely built anew makes the library call it, and the first axis with labels ends the program (seen
#   with Qt 6.11.2 and QCustomPlot 2.1.1+dfsg1-1+b2 of Debian sid). Renderers that plot their error meet this first.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had (apt-get install g++ libqcustomplot-dev).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg-query -Wf '${Version}' libqcustomplot-dev 2>/dev/null) == 2.1.0* ]] || exit 2
[[ $(dpkg-query -Wf '${Version}' qt6-base-dev 2>/dev/null) == 6.4.2* ]] || exit 2
cat >plot.cpp <<'CPP'
#include <qcustomplot.h>

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QStringList words; // the program's own use of the template
    for (int i = 0; i < argc; ++i)
        words << QString::number(i);
    QCustomPlot plot;
    plot.xAxis->setLabel(words.join(QString()));
    return plot.toPixmap(200, 100).isNull() ? 1 : 0;
}
CPP
folder=/usr/include/$(g++ -print-multiarch)/qt6
modules=()
for module in Core Gui Widgets PrintSupport; do
    modules+=(-isystem "$folder/Qt$module")
done

# The functions that the library finds in the program.
taken() {
    g++ -std=c++17 -fPIC -fvisibility="$1" -isystem "$folder" "${modules[@]}" plot.cpp -o plot \
        -lQCustomPlotQt6 -lQt6PrintSupport -lQt6Widgets -lQt6Gui -lQt6Core
    LD_DEBUG=bindings LD_BIND_NOW=1 QT_QPA_PLATFORM=offscreen ./plot 2>&1 |
        sed -n 's/.*binding file [^ ]*libQCustomPlotQt6[^ ]* \[0\] to \.\/plot .*symbol `\([^'"'"']*\).*/\1/p' | sort -u | c++filt
}
echo "by default:"
taken default | tee default.txt
echo "with -fvisibility=hidden:"
taken hidden | tee hidden.txt
grep -q 'QMovableArrayOps<QString>::emplace' default.txt && [[ ! -s hidden.txt ]] || { echo "This changed."; exit 1; }
