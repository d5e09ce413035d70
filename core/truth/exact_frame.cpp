#include "core/truth/exact_frame.h"

namespace rasterlens
{

std::size_t ExactFrame::sampleNearestCentre(int x, int y) const
{
    return static_cast<std::size_t>(y * sampleGrid + sampleGrid / 2) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x * sampleGrid + sampleGrid / 2);
}

namespace
{

glm::dvec3 lightOf(const glm::dvec3& value)
{
    return glm::mix(glm::pow((value + 0.055) / 1.055, glm::dvec3(2.4)), value / 12.92,
                    glm::lessThanEqual(value, glm::dvec3(0.04045)));
}

glm::dvec3 valueOf(const glm::dvec3& light)
{
    return glm::mix(1.055 * glm::pow(light, glm::dvec3(1 / 2.4)) - 0.055, light * 12.92,
                    glm::lessThanEqual(light, glm::dvec3(0.0031308)));
}

} // namespace

glm::dvec3 ExactFrame::pixelColor(int x, int y, glm::vec3 background) const
{
    const bool isLinear = resolveLight == ResolveLight::Linear;
    glm::dvec3 sum(0);
    for (int plane = 0; plane < patternSamples; ++plane)
        for (int row = y * sampleGrid; row < (y + 1) * sampleGrid; ++row)
            for (int column = x * sampleGrid; column < (x + 1) * sampleGrid; ++column) {
                const std::size_t i = static_cast<std::size_t>(plane * height + row) * static_cast<std::size_t>(width) +
                                      static_cast<std::size_t>(column);
                const glm::dvec3 value = id[i] >= 0 ? glm::clamp(color[i], 0.0, 1.0) : glm::dvec3(background);
                sum += isLinear ? lightOf(value) : value;
            }
    sum /= static_cast<double>(sampleGrid * sampleGrid * patternSamples);
    return isLinear ? valueOf(sum) : sum;
}

} // namespace rasterlens
