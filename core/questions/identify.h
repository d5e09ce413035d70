#pragma once
#include "core/base/reason.h"
#include "core/questions/identification.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QImage>
#include <QJsonObject>

#include <optional>
#include <stop_token>

namespace rasterlens
{

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
