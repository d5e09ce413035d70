#pragma once
#include "core/observe/step_log.h"

#include <QString>
#include <QStringList>

#include <array>

namespace rasterlens
{

/// A line of code of the listing.
struct ListingLine {
    QString code;  ///< what is run
    QString right; ///< what should be run, where a mistake is in its place; else empty
};

using Listing = std::array<ListingLine, 4>;

/// The algorithm in a few lines, the line at work, and its formula with the numbers put in.
struct StepExplanation {
    Listing listing;
    int line = -1;   ///< of the listing; -1: none
    QString formula; ///< may have several lines
};

/// What a step does, in the language in use.
///
/// in  event number
[[nodiscard]] StepExplanation explainStep(const StepLog& log, std::size_t i);

/// One event in a few words: `sample · row 4 · face 1`. In the language in use.
[[nodiscard]] QString stepTitle(const StepLog& log, std::size_t i);

/// Edge walking: alpha and xa on the long edge, beta and xb on the short one, each in a line with the numbers put in.
///
/// in  an event of kind Crossing
[[nodiscard]] QStringList crossingLines(const StepLog& log, const StepEvent& event);

enum class Digits {
    All, ///< as many as the number has
    Few, ///< six, unless they are rounded to another sample
};

/// Edge walking: where a span begins, where it ends, and the samples it fills.
[[nodiscard]] QStringList spanLines(const SpanStep& span, Digits digits);

} // namespace rasterlens
