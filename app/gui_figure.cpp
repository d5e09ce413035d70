#include "app/gui_figure.h"

#include "core/base/typed_numbers.h"
#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "core/lessons/moment.h"
#include "core/lessons/step_run.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/steps/motion_mode.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/figure_export.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QTimer>

#include <cstdio>

namespace rasterlens
{
namespace
{

enum ExitCode { kFine = 0, kBadArguments = 2, kInvalidInput = 3 };

/// Whether frames of a motion are written one after the other.
bool isMotionRun(const FigureArguments& figure)
{
    return !figure.path.isEmpty() && figure.motion && figure.motion->frames.first < figure.motion->frames.second;
}

/// Reads the options about an animation.
///
/// out  why one of them is refused
std::optional<QString> readRun(const QCommandLineParser& parser, const FigureOptions& options, FigureArguments& figure)
{
    if (parser.isSet(options.steps)) {
        figure.steps = stepRunFromText(parser.value(options.steps));
        if (!figure.steps || figure.path.isEmpty())
            return QStringLiteral("--figure-steps takes FIRST-LAST, as 10-60, and needs --figure");
    }
    if (parser.isSet(options.motion)) {
        figure.moves = motionFromId(parser.value(options.motion));
        figure.motion = motionRunFromText(parser.value(options.motion));
        if (!figure.moves && !figure.motion)
            return QStringLiteral("--motion takes %1").arg(motionRunHelp());
        if (figure.path.isEmpty() && figure.motion && figure.motion->frames.first < figure.motion->frames.second)
            return QStringLiteral("--motion: a run of frames needs --figure");
        if (!figure.path.isEmpty() && figure.moves)
            return QStringLiteral("--motion: --figure needs a frame or a run of them: %1").arg(motionRunHelp());
        if (figure.steps)
            return QStringLiteral("--motion: cannot be combined with --figure-steps");
    }
    if (parser.isSet(options.frameTime)) {
        figure.milliseconds = parser.value(options.frameTime).toInt();
        if (*figure.milliseconds < GifWriter::kLeastMilliseconds || *figure.milliseconds > GifWriter::kMostMilliseconds)
            return QStringLiteral("--frame-time takes %1 to %2")
                .arg(GifWriter::kLeastMilliseconds)
                .arg(GifWriter::kMostMilliseconds);
    }
    return std::nullopt;
}

} // namespace

FigureOptions::FigureOptions()
    : path(QStringLiteral("figure"),
           QStringLiteral(
               "Writes what the canvas shows as a figure with caption, formula and legend to <file> and exits: "
               "%1.")
               .arg(FigureExport::formats().join(QStringLiteral(", "))),
           QStringLiteral("file")),
      scale(QStringLiteral("figure-scale"),
            QStringLiteral("Side of a pixel in the figure, 1 to %1; default: as on the canvas.")
                .arg(FigureExport::kLargestZoom),
            QStringLiteral("n")),
      caption(QStringLiteral("caption"), QStringLiteral("Caption of the figure."), QStringLiteral("text")),
      region(QStringLiteral("region"), QStringLiteral("The pixels that the figure shows, from x, y on; default: all."),
             QStringLiteral("x,y,w,h")),
      overlays(QStringLiteral("figure-overlay"),
               QStringLiteral("What lies over the picture of the figure, with commas between: grid, samples, numbers, "
                              "referee, none, and what --overlay takes."),
               QStringLiteral("ids")),
      beforeAfter(QStringLiteral("before-after"),
                  QStringLiteral("The figure shows the picture without mistakes beside it.")),
      steps(QStringLiteral("figure-steps"),
            QStringLiteral("The figures of these steps as an animated GIF: --figure names a .gif then."),
            QStringLiteral("first-last")),
      motion(QStringLiteral("motion"),
             QStringLiteral("Moves the picture and tells how many pixels each frame changes: %1. With --figure a run "
                            "of frames is an animated GIF.")
                 .arg(motionRunHelp()),
             QStringLiteral("motion")),
      frameTime(QStringLiteral("frame-time"),
                QStringLiteral("Milliseconds of each picture in an animation, %1 to %2; default %3.")
                    .arg(GifWriter::kLeastMilliseconds)
                    .arg(GifWriter::kMostMilliseconds)
                    .arg(RunAnimation::kUsualMilliseconds),
                QStringLiteral("ms"))
{
}

QList<QCommandLineOption> FigureOptions::all() const
{
    return {path, scale, caption, region, overlays, beforeAfter, steps, motion, frameTime};
}

std::optional<QString> readFigure(const QCommandLineParser& parser, const FigureOptions& options,
                                  FigureArguments& figure)
{
    figure.path = parser.value(options.path);
    if (parser.isSet(options.path) && figure.path.isEmpty())
        return QStringLiteral("--figure needs a file");
    if (const auto why = readRun(parser, options, figure))
        return why;
    const QStringList formats =
        figure.steps || isMotionRun(figure) ? QStringList{QStringLiteral("gif")} : FigureExport::formats();
    if (const auto why = whyNotFormat(figure.path, formats))
        return QStringLiteral("--figure %1: %2").arg(figure.path, textOf(*why));
    if (parser.isSet(options.caption))
        figure.caption = parser.value(options.caption);
    figure.beforeAfter = parser.isSet(options.beforeAfter);
    if (parser.isSet(options.scale)) {
        figure.scale = parser.value(options.scale).toInt();
        if (*figure.scale < 1 || *figure.scale > FigureExport::kLargestZoom)
            return QStringLiteral("--figure-scale takes 1 to %1").arg(FigureExport::kLargestZoom);
    }
    if (parser.isSet(options.region)) {
        const auto numbers = typedNumbers(parser.value(options.region));
        if (!numbers || numbers->size() != 4)
            return QStringLiteral("--region takes x,y,w,h");
        figure.region = QRectF((*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]).toRect();
    }
    if (!parser.isSet(options.overlays))
        return std::nullopt;
    figure.overlays = parser.value(options.overlays).split(QLatin1Char(','), Qt::SkipEmptyParts);
    figure.overlays->removeAll(QStringLiteral("none"));
    QStringList known = CanvasViews::overlayNames();
    for (const char* id : overlayIds())
        known << QLatin1String(id);
    for (const QString& id : *figure.overlays)
        if (!known.contains(id))
            return QStringLiteral("--figure-overlay: \"%1\" is none of %2").arg(id, known.join(QStringLiteral(", ")));
    return std::nullopt;
}

bool startMotion(MainWindow& window, const FigureArguments& figure)
{
    if (!figure.moves && !figure.motion)
        return true;
    const Motion motion = figure.moves ? *figure.moves : figure.motion->motion;
    if (const auto why = whyNotMoved(*window.document().scene(), motion)) {
        std::fprintf(stderr, "--motion: %s\n", qPrintable(textOf(*why)));
        return false;
    }
    if (!figure.path.isEmpty()) // its caption says it
        window.motion().setPlate(!window.figures().hasTexts());
    if (figure.moves)
        window.motion().start(motion);
    else
        window.motion().showFrame(motion, figure.motion->frames.first);
    return true;
}

void prepareFigure(MainWindow& window, const FigureArguments& figure)
{
    window.figures().setZoom(figure.scale);
    window.figures().setCaption(figure.caption);
    window.figures().setRegion(figure.region);
    if (!figure.overlays)
        return;
    OverlayOptions overlays = window.viewport().overlays();
    overlays.grid = figure.overlays->contains(QStringLiteral("grid"));
    overlays.sampleDots = figure.overlays->contains(QStringLiteral("samples"));
    overlays.numbers = figure.overlays->contains(QStringLiteral("numbers"));
    window.viewport().setOverlays(overlays);
    window.truthMode().referee().setOn(figure.overlays->contains(QStringLiteral("referee")));
    for (const QString& name : *figure.overlays)
        window.canvasViews().setOverlayNamed(name, true);
}

void writeFigure(MainWindow& window, const FigureArguments& figure)
{
    constexpr int kWaitMs = 20;
    QTimer::singleShot(kWaitMs, &window, [&window, figure] {
        if (!window.isComplete()) {
            writeFigure(window, figure);
            return;
        }
        const QStringList inputs = window.document().inputFiles();
        const bool overInput = whyNotOver(figure.path, inputs).has_value();
        const auto end = [overInput](const QString& error) {
            if (!error.isEmpty())
                std::fprintf(stderr, "%s\n", qPrintable(error));
            QApplication::exit(overInput ? kBadArguments : error.isEmpty() ? kFine : kInvalidInput);
        };
        if (figure.steps && figure.steps->second > window.stepMode().session().size()) {
            std::fprintf(stderr, "--figure-steps: the record has the steps 0 to %zu\n",
                         window.stepMode().session().size());
            QApplication::exit(kBadArguments);
            return;
        }
        if (!figure.beforeAfter && !figure.steps && !isMotionRun(figure)) {
            end(window.figures().exportTo(figure.path).value_or(QString()));
            return;
        }
        QObject::connect(&window.figures(), &FigureExport::finished, &window,
                         [end](const QString&, const QString& error) { end(error); });
        const auto run = [&figure](const std::pair<std::size_t, std::size_t>& of) {
            return RunAnimation::Run{of.first, of.second,
                                     figure.milliseconds.value_or(RunAnimation::kUsualMilliseconds)};
        };
        if (figure.steps)
            window.figures().exportRun(figure.path, run(*figure.steps), &window);
        else if (isMotionRun(figure))
            window.figures().exportMotion(figure.path, figure.motion->motion, run(figure.motion->frames), &window);
        else
            window.figures().exportBeforeAfter(figure.path);
    });
}

} // namespace rasterlens
