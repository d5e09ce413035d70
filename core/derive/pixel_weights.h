#pragma once
#include "core/observe/step_log.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QPoint>
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>

namespace rasterlens
{

/// The barycentric weights with which a face was drawn at a pixel, and where its corners lie. Pixels, y down.
struct PixelWeights {
    std::uint32_t face = 0;
    std::array<glm::dvec2, 3> corners; ///< A, B, C of the triangle that holds the sample: the face or a piece of it
    std::array<double, 3> invW{};      ///< what interpolation is told of the corners
    glm::dvec2 point{0, 0};            ///< where the sample nearest the pixel's centre is tested
    Weights screen{};                  ///< of A, B, C on the screen
    Weights used{};                    ///< those that attributes are weighted with; as `screen` if nothing is shaded

    /// Whether perspective changes the weights by more than rounding does.
    [[nodiscard]] bool isCorrected() const;
};

/// The weights of a face at the sample nearest the centre of a pixel.
///
/// in      settings for which unsupported() is empty
/// out     nothing where the face does not cover that sample
/// exact   the numbers of the record and of why(): the face is drawn alone by the same stages
/// errors  std::bad_alloc; `stop` ends the work early, with or without a result
[[nodiscard]] std::optional<PixelWeights> pixelWeights(const Scene& scene, const Settings& settings, std::uint32_t face,
                                                       QPoint pixel, const std::stop_token& stop = {});

} // namespace rasterlens
