#pragma once
#include "app/cli/failure.h"

#include <QStringList>

namespace rasterlens::cli
{

/// One verb of the program: `rasterlens-cli NAME ARGUMENTS`.
struct Verb {
    const char* name;
    const char* summary;                       ///< one line for --help
    ExitCode (*run)(const QStringList& words); ///< the words after the verb; throws Failure
};

ExitCode runBench(const QStringList& words);
ExitCode runCases(const QStringList& words);
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

} // namespace rasterlens::cli
