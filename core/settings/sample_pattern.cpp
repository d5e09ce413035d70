#include "core/settings/sample_pattern.h"

#include <array>
#include <bit>

namespace rasterlens
{
namespace
{

constexpr std::array<SampleOffset, 1> kOne{{{0, 0}}};
constexpr std::array<SampleOffset, 2> kTwo{{{4, 4}, {-4, -4}}};
constexpr std::array<SampleOffset, 4> kFour{{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
constexpr std::array<SampleOffset, 8> kEight{{{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};
constexpr std::array<SampleOffset, 16> kSixteen{{{1, 1},
                                                 {-1, -3},
                                                 {-3, 2},
                                                 {4, -1},
                                                 {-5, -2},
                                                 {2, 5},
                                                 {5, 3},
                                                 {3, -5},
                                                 {-2, 6},
                                                 {0, -7},
                                                 {-4, -6},
                                                 {-6, 4},
                                                 {-8, 0},
                                                 {7, -4},
                                                 {6, 7},
                                                 {-7, -8}}};
constexpr std::array<std::span<const SampleOffset>, 5> kPatterns{kOne, kTwo, kFour, kEight, kSixteen};

} // namespace

std::span<const SampleOffset> samplePattern(int samples)
{
    return kPatterns[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(samples)))];
}

glm::dvec2 shadingOffset(const Rules& rules, SampleMask covered)
{
    const bool isWhole = std::popcount(covered) == rules.patternSamples;
    if (rules.attributeAt == AttributeAt::Centre || isWhole || covered == 0)
        return {0, 0};
    return samplePattern(rules.patternSamples)[static_cast<std::size_t>(std::countr_zero(covered))].pixels();
}

} // namespace rasterlens
