#pragma once
#include "core/settings/settings.h"

#include <QImage>
#include <QPoint>
#include <QRect>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace rasterlens
{

/// The id that stands for the picture without mistakes.
constexpr const char* kNoMistake = "none";

/// A picture with this score or more is taken for a match.
constexpr double kLeastScore = 0.5;

/// How well a picture fits what a mistake, or none, draws in a scene.
struct MistakeMatch {
    QString mistake;   ///< id, or kNoMistake
    double score = 0;  ///< 1: all that the mistake changes is there and nothing else; 0: nothing of it
    int pixels = 0;    ///< that the mistake changes in the right picture
    QRect where;       ///< the smallest rectangle around them, in pixels of the scene's picture
    int unlike = 0;    ///< pixels at which the picture handed in differs visibly from the one that the mistake draws
    QStringList alike; ///< other mistakes that draw the very same picture here
    QString with;      ///< the mistake that is made as well, where two at once fit better than one; else empty
};

/// What a picture was found to be.
struct Identification {
    std::vector<MistakeMatch> matches; ///< best first
    Settings settings;                 ///< without mistakes: what the right picture is drawn with
    QImage picture;                    ///< handed in, laid over the right picture and in its size; Format_RGB32
    QRect place;                       ///< of the scene in the picture handed in
    QPoint offset;                     ///< by which the best match had to be moved within the place

    /// Whether the best match is one.
    [[nodiscard]] bool fits() const { return !matches.empty() && matches.front().score >= kLeastScore; }
};

/// Called with the pictures compared so far and those there are to compare.
using IdentifyProgress = std::function<void(int done, int total)>;

} // namespace rasterlens
