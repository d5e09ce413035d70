#pragma once
#include <QString>

#include <cstddef>

namespace rasterlens
{

class LensModel;
struct LensView;

/// Edge walking in its stages, as far as they have come: the long edge and the broken one in two colours with their
/// legend, the cut at the middle corner and the halves, the present row with its crossings, and its span.
void paintWalk(const LensView& view, const LensModel& model);

/// `A`; `A = 1` once edge walking has sorted the corners by height.
///
/// in  vertex of the screen triangle
[[nodiscard]] QString walkedCornerName(const LensModel& model, std::size_t vertex);

} // namespace rasterlens
