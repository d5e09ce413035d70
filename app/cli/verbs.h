#pragma once
#include "app/cli/failure.h"
#include "app/cli/options.h"

#include <QStringList>

#include <span>

namespace rasterlens::cli
{

/// One verb of the program: `rasterlens-cli NAME ARGUMENTS`.
struct Verb {
    const char* name;
    const char* summary;                       ///< one line for --help
    ExitCode (*run)(const QStringList& words); ///< the words after the verb; throws Failure
    Usage (*usage)();                          ///< what it takes
};

/// All verbs, in the order of the help.
[[nodiscard]] std::span<const Verb> verbs();

ExitCode runBench(const QStringList& words);
ExitCode runCases(const QStringList& words);
ExitCode runComplete(const QStringList& words);
ExitCode runDerive(const QStringList& words);
ExitCode runDiff(const QStringList& words);
ExitCode runFigure(const QStringList& words);
ExitCode runIdentify(const QStringList& words);
ExitCode runInfo(const QStringList& words);
ExitCode runLesson(const QStringList& words);
ExitCode runPage(const QStringList& words);
ExitCode runRender(const QStringList& words);
ExitCode runSteps(const QStringList& words);
ExitCode runWhy(const QStringList& words);

Usage benchUsage();
Usage casesUsage();
Usage completeUsage();
Usage deriveUsage();
Usage diffUsage();
Usage figureUsage();
Usage identifyUsage();
Usage infoUsage();
Usage lessonUsage();
Usage pageUsage();
Usage renderUsage();
Usage stepsUsage();
Usage whyUsage();

} // namespace rasterlens::cli
