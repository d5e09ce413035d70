#pragma once
#include "app/gui_figure.h"
#include "app/gui_page.h"
#include "core/derive/topics.h"
#include "ui/base/language.h"
#include "ui/base/theme.h"
#include "ui/truth/truth_mode.h"

#include <QPoint>
#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace rasterlens
{

enum ExitCode { kFine = 0, kBadArguments = 2, kInvalidInput = 3 };

void printError(const QString& text);

/// What the command line asks the window program for.
struct Arguments {
    QString scene;
    QString screenshot;
    QString step;
    QString identify;
    FigureArguments figure;
    PageArguments page;
    std::optional<QSize> windowSize;
    QString panel;
    std::optional<DerivationTopic> topic;
    QString view;
    QStringList overlays;
    std::optional<QPoint> pixel;
    bool referee = false;
    ReferenceSpace reference = ReferenceSpace::Clip;
    int measuredFrames = 0;
    CompareView compare = CompareView::Off;
    std::optional<LanguageKind> language;
    std::optional<ThemeKind> theme;
    bool keys = false;
    QString model;             ///< in place of the one that the session names
    bool allowOutside = false; ///< files may name others outside their folders
    QString lesson;
    int slide = 1;     ///< counted from 1
    bool asks = false; ///< the slide's question is open
    bool presentation = false;
    bool guide = false;
};

/// The arguments, or the code to exit with: after an error message, or after what --help and --version print.
struct ParsedArguments {
    std::optional<Arguments> arguments;
    int exitCode = kFine;
};

[[nodiscard]] ParsedArguments parseArguments(const QStringList& words);

} // namespace rasterlens
