#pragma once
#include "core/derive/derivation.h"
#include "core/derive/place.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <optional>
#include <stop_token>

namespace rasterlens
{

/// A derivation, or why there is none.
struct Derived {
    std::optional<Derivation> derivation;
    Reason refusal{QString()}; ///< of the context "Derive"; for people
    std::optional<int> edge;   ///< the edge that it is about, as DerivationPlace counts; empty: none
};

/// Derives a topic with the numbers of a scene.
///
/// in      settings for which unsupported() is empty; a face of the mesh
/// out     the numbers are those of the stages that draw: the face is drawn alone, by the rules of these settings. A
///         topic that is about one way to draw sets that way: lines by Bresenham, edge walking, Cohen-Sutherland, the
///         painter's algorithm
/// cost    that of drawing the face alone; the painter's algorithm needs all vertices
/// errors  a refusal where the place has nothing to derive: a face that is not drawn, a pixel outside the face, a
///         corner behind the eye. `stop` ends the work early; what is returned then means nothing
[[nodiscard]] Derived derive(DerivationTopic topic, const Scene& scene, const Settings& settings,
                             const DerivationPlace& place, const std::stop_token& stop = {});

} // namespace rasterlens
