#include "core/io/vertex_colors.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr glm::vec3 kNone(-1);

/// What the colours are divided by: 255 or 65535 where they are whole numbers of one or two bytes.
float divisor(float largest, bool wholeNumbers)
{
    constexpr float kSurelyNoLight = 2; // a colour a little above 1 is a bright one, not a dark byte
    if (largest <= 1 || (!wholeNumbers && largest < kSurelyNoLight))
        return 1;
    return largest <= 255 ? 255 : 65535;
}

} // namespace

void VertexColors::add(std::size_t vertex, const glm::vec3& color)
{
    m_colors.resize(vertex, kNone);
    m_colors.push_back(color);
    m_largest = std::max({m_largest, color.r, color.g, color.b});
    m_wholeNumbers = m_wholeNumbers && glm::floor(color) == color;
}

void VertexColors::comment(std::string_view line)
{
    constexpr std::string_view kMark = "#MRGB";
    if (!line.starts_with(kMark))
        return;
    const std::string_view digits = trimmed(line.substr(kMark.size()));
    for (std::size_t i = 0; i + 8 <= digits.size(); i += 8) { // mask, red, green, blue: two digits each
        std::uint32_t value = 0;
        std::from_chars(digits.data() + i, digits.data() + i + 8, value, 16);
        const auto channel = [&](int shift) { return static_cast<float>(value >> shift & 255U) / 255; };
        m_paintColors.emplace_back(channel(16), channel(8), channel(0));
    }
}

std::vector<glm::vec3> VertexColors::take(std::size_t vertices, DiagnosticSink& diagnostics)
{
    if (m_colors.empty() && !m_paintColors.empty()) {
        if (m_paintColors.size() != vertices)
            diagnostics.warning(
                0, {QT_TRANSLATE_NOOP("Diagnostic", "#MRGB: %1 colours for %2 \"v\"; white where there is none"),
                    {m_paintColors.size(), vertices}});
        m_paintColors.resize(vertices, glm::vec3(1));
        return std::move(m_paintColors);
    }
    if (m_colors.empty())
        return {};
    const float by = divisor(m_largest, m_wholeNumbers);
    if (by > 1)
        diagnostics.warning(0, {QT_TRANSLATE_NOOP("Diagnostic", "v: colours up to %1; all are divided by %2"),
                                {QString::number(m_largest), QString::number(by)}});
    else if (m_largest > 1)
        diagnostics.warning(0,
                            {QT_TRANSLATE_NOOP("Diagnostic", "v: colours up to %1; shown as 1 where they are larger"),
                             {QString::number(m_largest)}});
    m_colors.resize(vertices, kNone);
    for (glm::vec3& color : m_colors)
        color = color == kNone ? glm::vec3(1) : color / by;
    return std::move(m_colors);
}

} // namespace rasterlens
