#pragma once
#include "core/questions/why.h"

#include <QStringList>

class QWidget;

namespace rasterlens
{

/// A group of samples of a pixel, in words: a title, a line for each sample, the sum of each channel.
struct SampleWords {
    QString title;
    QStringList samples;
    QStringList sums;
    ResolvedPixel pixel;
};

/// The samples of the pixel, and what they would be without each mistake that changes them: one group with the mistake,
/// one without. None with one sample a pixel.
[[nodiscard]] std::vector<SampleWords> sampleWords(const WhyReport& report);

/// The groups as a part of the pixel card, each with its samples as colours.
[[nodiscard]] QWidget* makeSampleRows(const std::vector<SampleWords>& groups);

} // namespace rasterlens
