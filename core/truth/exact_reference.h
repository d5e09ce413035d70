#pragma once
#include "core/pipeline/types.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"
#include "core/settings/settings.h"
#include "core/truth/exact_frame.h"

#include <QSize>
#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// Where the exact reference starts, and so what it judges.
enum class ReferenceSpace {
    Clip,   ///< from the float32 positions that the vertex stage hands on: everything behind that stage is judged
    Object, ///< from the positions of the mesh and the camera in double, multiplied exactly: the vertex stage as well
};

/// Told now and then which share of the faces is done, 0..1.
using ExactProgress = std::function<void(double share)>;

/// Coverage, winner, depth and perspective-correct colour of clip-space triangles by exact integer arithmetic; or of
/// object-space triangles seen through ExactOptions::clipFromObject.
///
/// No decision uses floating point: positions become integers with one common exponent a face, homogeneous points are
/// never divided, and what is compared are products of integers of any length. Doubles appear as a filter in front of
/// the depth comparison (an exact one follows where two depths differ by less than 1e-14) and in the finished values.
///
/// The method differs from that of the rasterizers it judges:
/// - Unsnapped: two-dimensional homogeneous rasterization. Nothing is clipped or projected; a sample is a ray through
///   the eye and lies in a face where the three 3x3 determinants have the sign of det[A B C] and z is within the range.
///   Sample centres are never on an x or y plane, so this equals clipping and then filling.
/// - Snapped: exact clipping against the six planes, exact rounding, then the winding number of the snapped polygon
///   along every row of samples. Snapping may dent a clipped polygon; it covers what it winds round in the sense of
///   its area, so that faces sharing an edge still add up. One that is folded so far that no corner sees all of it
///   covers its convex hull (docs/CONVENTIONS.md).
/// - The top-left rule is a symbolic displacement of the sample by (e, e^2) right and down with an infinitesimal e:
///   no edge is ever classified.
///
/// in      covers every finite position, also w <= 0; varyings[0..2] are red, green, blue; submission order
/// out     depth z/w mapped to 0..1 is linear between the snapped corners. A clipped face is interpolated over the fan
///         round its first corner (walking A, B, C; planes in the order x, y, z, the one at -w first), corner values
///         taken before snapping
/// order   depth tests run in submission order; with DepthCompare::Always the last face wins
/// cost    a few big-integer operations a face and row, a few doubles a covered sample. Measured on one core, 2,000
///         faces over 256 x 256: 0.02 s for small ones, 0.8 s for 31 million covered samples. Edge distances cost
///         their length. Memory: 48 bytes a sample, 96 where faces are textured,
///         nothing a face.
/// exact   cover and id; depth to 1e-15; colour to some 1e-15 of the largest corner value
/// errors  faces with a non-finite position are dropped and counted; `stop` ends the work early and leaves an
///         unfinished frame
/// source  Olano & Greer, Triangle scan conversion using 2D homogeneous coordinates, Graphics Hardware 1997.
///         Numbers: Boost.Multiprecision cpp_int rather than GMP: headers only, nothing to ship or link, and with 512
///         bits in place common input allocates nothing, which is fast enough by the measurement above.
[[nodiscard]] ExactFrame exactReference(std::span<const ClipTriangle> triangles, const ExactOptions& options,
                                        std::stop_token stop = {}, const ExactProgress& progress = {});

/// Windows of whole pixel rows that make up the picture, from the top, of at most kSamplesPerBand or one row: computed
/// band by band the truth about any picture fits the memory.
constexpr std::int64_t kSamplesPerBand = std::int64_t{1} << 23; ///< 400 MB of truth
[[nodiscard]] std::vector<PixelRect> bandsOf(const ExactOptions& options);

/// What these settings ought to draw: z-buffer visibility, the top-left rule, culling by the snapped area and correct
/// rules whatever the settings say about algorithm, clipping, visibility, ties, interpolation and mistakes. Vertices
/// snap for NumberType::Fixed unless the scene is `exact`; the window is that
/// of the scene, as far as the viewport shows it.
///
/// in  a space that referenceSpace() allows
[[nodiscard]] ExactOptions exactOptions(const Scene& scene, const Settings& settings,
                                        ReferenceSpace space = ReferenceSpace::Clip);

/// The faces of a scene with Gouraud colours and, for Shading::Texture, texture coordinates, in the space the reference
/// starts from: as the vertex stage hands them on, or as they stand in the mesh.
[[nodiscard]] std::vector<ClipTriangle> exactTriangles(const Scene& scene, const Settings& settings,
                                                       ReferenceSpace space = ReferenceSpace::Clip);

/// The space asked for, or clip space where the scene has no camera.
[[nodiscard]] ReferenceSpace referenceSpace(const Scene& scene, ReferenceSpace asked);

/// The truth about a scene; with texture coordinates for Shading::Texture, whose texels are not looked up.
[[nodiscard]] ExactFrame exactReference(const Scene& scene, const Settings& settings, std::stop_token stop = {});

} // namespace rasterlens
