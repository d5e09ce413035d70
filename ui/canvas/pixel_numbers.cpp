#include "ui/canvas/pixel_numbers.h"

#include "core/observe/names.h"
#include "ui/base/text_on.h"
#include "ui/base/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kDepthDecimals = 4;

/// What a counted frame knows of a pixel.
class Known
{
public:
    Known(const RenderedFrame& frame, QPoint pixel)
        : m_frame(frame), m_pixel(pixel),
          m_index(std::size_t(pixel.y()) * std::size_t(frame.frame.image.width()) + std::size_t(pixel.x()))
    {
    }

    [[nodiscard]] QRgb color() const { return m_frame.frame.image.pixel(m_pixel); }

    [[nodiscard]] QString depth() const
    {
        const DepthBuffer& depth = m_frame.frame.depth;
        const bool isKnown = m_frame.counted && m_index < depth.size();
        return isKnown ? QString::number(double(depth[m_index]), 'f', kDepthDecimals) : QString();
    }

    [[nodiscard]] QString face() const
    {
        const auto& ids = m_frame.frame.ids;
        const bool isFace = m_frame.counted && m_index < ids.size() && ids[m_index] >= 0;
        return isFace ? QStringLiteral("#%1").arg(ids[m_index]) : QString();
    }

    /// How many faces covered the pixel's middle sample; a colour tells it where there is but one.
    [[nodiscard]] QString count() const
    {
        const auto& coverage = m_frame.frame.coverage;
        if (m_frame.counted && m_index < coverage.size())
            return QStringLiteral("\u00d7%1").arg(coverage[m_index]);
        const auto count = m_frame.settings.samples == Samples::One ? overdrawCount(color()) : std::nullopt;
        if (!count)
            return {};
        return (*count < kMostOverdraw ? QStringLiteral("\u00d7%1") : QStringLiteral("\u2265\u00d7%1")).arg(*count);
    }

    [[nodiscard]] QString channels(NumberRoom room) const
    {
        const QColor c(color());
        return room == NumberRoom::Hex ? c.name().toUpper()
                                       : QStringLiteral("%1 %2 %3").arg(c.red()).arg(c.green()).arg(c.blue());
    }

    /// The unit normal that the colour stands for; a channel tells a component to 1/128. Empty where there is no face.
    [[nodiscard]] QString normal() const
    {
        const auto component = [](int channel) {
            const double value = channel / 127.5 - 1;
            return (value < 0 ? QChar(0x2212) : QLatin1Char('+')) + QString::number(std::abs(value), 'f', 2);
        };
        const QRgb rgb = color();
        return isBackground() ? QString()
                              : QStringLiteral("x %1\ny %2\nz %3")
                                    .arg(component(qRed(rgb)), component(qGreen(rgb)), component(qBlue(rgb)));
    }

    /// The texture coordinates that the colour stands for, without their whole parts; a channel tells one to 1/255.
    /// Empty where there is no face.
    [[nodiscard]] QString uv() const
    {
        const QRgb rgb = color();
        return isBackground()
                   ? QString()
                   : QStringLiteral("u %1\nv %2").arg(qRed(rgb) / 255.0, 0, 'f', 2).arg(qGreen(rgb) / 255.0, 0, 'f', 2);
    }

private:
    /// Whether no face was written: by the ids where there are any, else by the colour.
    [[nodiscard]] bool isBackground() const
    {
        const auto& ids = m_frame.frame.ids;
        if (m_frame.counted && m_index < ids.size())
            return ids[m_index] < 0;
        const glm::vec3 cleared = m_frame.scene->background * 255.0F + 0.5F;
        return color() == qRgb(int(cleared.r), int(cleared.g), int(cleared.b));
    }

    const RenderedFrame& m_frame;
    QPoint m_pixel;
    std::size_t m_index;
};

/// A font in which `digits` characters fit into a pixel of the canvas.
QFont cellFont(double zoom, int digits)
{
    QFont font = numberFont();
    constexpr int kReferencePixels = 100;
    font.setPixelSize(kReferencePixels);
    const double advance = QFontMetricsF(font).horizontalAdvance(QLatin1Char('0'));
    const double fitting = (zoom - 6) / digits * kReferencePixels / advance;
    font.setPixelSize(std::clamp(static_cast<int>(fitting), 5, 15));
    return font;
}

} // namespace

QStringList pixelNumbers(const RenderedFrame& frame, QPoint pixel, NumberRoom room)
{
    const Known known(frame, pixel);
    QStringList lines;
    switch (frame.settings.shading) {
    case Shading::Depth: lines = {known.depth(), known.face()}; break;
    case Shading::TriangleId: lines = {known.face(), known.depth()}; break;
    case Shading::Overdraw: lines = {known.count(), known.depth(), known.face()}; break;
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Texture:
    case Shading::MipLevel:
    case Shading::Phong: lines = {known.channels(room), known.depth(), known.face()}; break;
    case Shading::Normals: lines = {known.normal(), known.depth(), known.face()}; break;
    case Shading::Uv: lines = {known.uv(), known.depth(), known.face()}; break;
    }
    if (room != NumberRoom::Details)
        return {lines.first()};
    if (known.face().isEmpty()) // the background has no depth of its own
        return {frame.settings.shading == Shading::TriangleId ? QString() : lines.first()};
    return lines;
}

void paintPixelNumbers(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, const QImage& picture,
                       const PixelLines& linesAt)
{
    constexpr double kDecimalsFromZoom = 64;
    constexpr double kDetailsFromZoom = 96;
    constexpr int kHexDigits = 7;
    constexpr int kDecimalDigits = 11;
    const NumberRoom room = transform.zoom >= kDetailsFromZoom    ? NumberRoom::Details
                            : transform.zoom >= kDecimalsFromZoom ? NumberRoom::Decimals
                                                                  : NumberRoom::Hex;
    const QFont font = cellFont(transform.zoom, room == NumberRoom::Hex ? kHexDigits : kDecimalDigits);
    painter.setFont(font);
    const double lineSpacing = QFontMetricsF(font).lineSpacing();
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x) {
            const QRectF cell = transform.toCanvas(QRectF(x, y, 1, 1)).adjusted(2, 3, -2, -3);
            const QStringList lines = linesAt({x, y}, room);
            const QRgb color = picture.pixel(x, y);
            drawTextOn(painter, cell, Qt::AlignHCenter | Qt::AlignTop, lines.first(), color);
            for (qsizetype i = 1; i < lines.size(); ++i)
                drawTextOn(painter, cell.adjusted(0, 0, 0, -lineSpacing * double(lines.size() - 1 - i)),
                           Qt::AlignHCenter | Qt::AlignBottom, lines[i], color);
        }
}

} // namespace rasterlens
