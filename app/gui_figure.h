#pragma once
#include "core/render/motion.h"

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QRect>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <utility>

namespace rasterlens
{

class MainWindow;

/// A figure that is written in place of a screenshot.
struct FigureArguments {
    QString path;
    std::optional<int> scale;
    std::optional<QString> caption;      ///< nothing: what the window says
    std::optional<QRect> region;         ///< pixels; nothing: all of the picture
    std::optional<QStringList> overlays; ///< ids; nothing: those that the window starts with
    bool beforeAfter = false;
    std::optional<std::pair<std::size_t, std::size_t>> steps; ///< an animation of this run
    std::optional<MotionRun> motion;                          ///< an animation of these frames, or one of them
    std::optional<Motion> moves;                              ///< what the window begins with
    std::optional<int> milliseconds;                          ///< of each step in it
};

/// The options of the program about it.
struct FigureOptions {
    QCommandLineOption path;
    QCommandLineOption scale;
    QCommandLineOption caption;
    QCommandLineOption region;
    QCommandLineOption overlays;
    QCommandLineOption beforeAfter;
    QCommandLineOption steps;
    QCommandLineOption motion;
    QCommandLineOption frameTime;

    FigureOptions();
    [[nodiscard]] QList<QCommandLineOption> all() const;
};

/// Reads the options about a figure.
///
/// out  why one of them is refused
[[nodiscard]] std::optional<QString> readFigure(const QCommandLineParser& parser, const FigureOptions& options,
                                                FigureArguments& figure);

/// Moves the picture as the arguments ask for, or shows one frame of it.
///
/// out  false: the scene does not move so, which an error message says
[[nodiscard]] bool startMotion(MainWindow& window, const FigureArguments& figure);

/// Lays over the picture what the figure is to show.
void prepareFigure(MainWindow& window, const FigureArguments& figure);

/// Writes the figure as soon as all in it is computed, and ends the program: with 0; 2 where an input would be
/// overwritten, and where the record has no such steps; 3 where the file cannot be written.
void writeFigure(MainWindow& window, const FigureArguments& figure);

} // namespace rasterlens
