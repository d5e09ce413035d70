#pragma once
#include "core/base/reason.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QImage>
#include <QJsonObject>
#include <QPoint>
#include <QRect>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <stop_token>
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

/// Why a picture cannot be compared with these settings, or nothing; a text of the context "Diagnostic".
[[nodiscard]] std::optional<Reason> whyNotIdentified(const QImage& picture, const Settings& settings);

/// Compares a picture with the right one of a scene, and with what each mistake draws there, alone and two at once.
///
/// in      the picture may have a border, be half or twice as large, lie up to two pixels beside its place, be noisy or
///         come from JPEG; `settings` for which unsupported() is empty, mistakes among them are not looked at. Where
///         nothing fits at their size, the scene is also drawn in the picture's own size.
/// out     every mistake that these settings can draw and that changes the picture; at least five matches, those that
///         change nothing here last
/// cost    one picture for each mistake and, unless one fits alone, some hundred for two at once
/// errors  throws std::bad_alloc; `stop` ends the work early and leaves what means nothing
[[nodiscard]] Identification identify(const Scene& scene, const Settings& settings, const QImage& picture,
                                      const IdentifyProgress& progress = {}, const std::stop_token& stop = {});

/// The settings that draw the picture of a match.
[[nodiscard]] Settings settingsOf(const MistakeMatch& match, const Identification& found);

/// `{"matches": [{"mistake", "score", "pixels", "where": [x, y, w, h], "unlike", "alike": [..]}, ..], "fits", "size",
/// "place", "offset"}`; `"with"` only where two mistakes are made at once.
[[nodiscard]] QJsonObject toJson(const Identification& found);

} // namespace rasterlens
