#pragma once
#include "core/render/render.h"
#include "core/truth/exact_reference.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rasterlens
{

/// The picture of a case, by a rasterizer or by the reference: the window of the scene, one entry a pixel (the sample
/// nearest the centre).
struct Outcome {
    PixelRect window;
    std::vector<std::uint32_t> cover;
    std::vector<std::int32_t> id;
    std::vector<double> depth;
    std::vector<glm::dvec3> color;   ///< 8-bit steps, 0..255
    std::optional<int> nonFinite;    ///< faces dropped, where known
    std::optional<int> clipVertices; ///< most corners of a clipped face, where known
};

[[nodiscard]] Outcome outcomeOf(const ExactFrame& frame, glm::vec3 background);

/// in      a frame with depth, ids and coverage; statistics only for `nonfinite`
[[nodiscard]] Outcome outcomeOf(const Frame& frame, const Scene& scene, const Statistics* statistics = nullptr);

/// One `expect key value` line and whether it holds.
struct Expectation {
    QString key;
    QString value;
    bool holds = false;
    QString found; ///< the value that was found, or what is wrong with the line
};

/// An `expect` line in words: `face 0 is seen in 16 pixels`; English without `translate`, which is handed texts of the
/// context "HardCase". A line of the wrong form comes back as it is.
[[nodiscard]] QString wordsOf(const QString& key, const QString& value, QString (*translate)(const char*) = nullptr);

/// Evaluates `expect` lines. Pixels are counted within the case's window; x and y are those of the viewport.
///
/// | key | value | holds when |
/// |---|---|---|
/// | `covered` | N | N pixels are covered by at least one face |
/// | `watertight` | true | every pixel is covered exactly once |
/// | `holes` | N | N uncovered pixels have covered ones to the left, to the right, above and below |
/// | `hit_twice` | N | N pixels are covered by two faces or more |
/// | `max_count` | N | no pixel is covered by more than N faces, one is by N |
/// | `covers` | X Y N | N faces cover the pixel |
/// | `winner` | FACE N | the face is seen in N pixels |
/// | `pixel` | X Y FACE | the face is seen there; -1: none |
/// | `front_wins` | N | of the strips (four faces each: two behind, then two in front) N show only the front |
/// | `depth` | X Y Z | the depth there is Z to 2^-22 |
/// | `color` | X Y R G B | the colour there is R G B in 8-bit steps, to 1.01 |
/// | `nonfinite` | N | N faces were dropped for a position that is no number |
/// | `clip_vertices` | N | a face has N corners after clipping and none has more |
///
/// out     one entry a line, in order; `nonfinite` and `clip_vertices` hold where the outcome does not know them
/// errors  an unknown key or a value of the wrong form does not hold, and `found` says why
[[nodiscard]] std::vector<Expectation> checkExpectations(const std::vector<std::pair<QString, QString>>& lines,
                                                         const Outcome& outcome);

} // namespace rasterlens
