#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// The samples of a line by the definition of the diamond rule: those whose diamond it leaves, and no other.
///
/// Every sample near the line is asked by itself whether the line, cut by the four sides of its diamond in fractions,
/// begins within, passes through the inside or through the corner that belongs to the diamond, and does not end within.
/// The line rules walk along the longer axis and ask no sample by itself.
///
/// in      ends in 1/256 of a sample, |coordinate| < 2^28
/// out     in the order of their columns, or of their rows where the line is steep
/// exact   integers only
/// source  Direct3D 11, Rasterization Rules: Line Rasterization Rules (Aliased, Without Multisampling)
[[nodiscard]] std::vector<glm::ivec2> exactLine(const glm::i64vec2& from, const glm::i64vec2& to);

/// The samples of a line from the centre of one sample to that of another, both included: at every step along the
/// longer axis the sample that is nearest to the line, of two that are equally near the one nearer to where it starts.
///
/// in      samples, |coordinate| < 2^28
/// out     in the order of the way
/// exact   integers only
[[nodiscard]] std::vector<glm::ivec2> exactCentreLine(const glm::ivec2& from, const glm::ivec2& to);

/// Whether the line leaves the diamond round the centre of one sample.
[[nodiscard]] bool leavesDiamond(const glm::i64vec2& from, const glm::i64vec2& to, int column, int row);

} // namespace rasterlens
