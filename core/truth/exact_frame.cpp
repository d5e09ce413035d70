#include "core/truth/exact_frame.h"

namespace rasterlens
{

std::size_t ExactFrame::sampleNearestCentre(int x, int y) const
{
    return static_cast<std::size_t>(y * sampleGrid + sampleGrid / 2) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x * sampleGrid + sampleGrid / 2);
}

glm::dvec3 ExactFrame::pixelColor(int x, int y, glm::vec3 background) const
{
    glm::dvec3 sum(0);
    for (int row = y * sampleGrid; row < (y + 1) * sampleGrid; ++row)
        for (int column = x * sampleGrid; column < (x + 1) * sampleGrid; ++column) {
            const std::size_t i =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
            sum += id[i] >= 0 ? glm::clamp(color[i], 0.0, 1.0) : glm::dvec3(background);
        }
    return sum / static_cast<double>(sampleGrid * sampleGrid);
}

} // namespace rasterlens
