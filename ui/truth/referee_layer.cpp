#include "ui/base/inks.h"
#include "ui/base/theme.h"
#include "ui/truth/referee.h"

#include <QPainter>
#include <QPixmapCache>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rasterlens
{
namespace
{

/// The colours are told apart by people who do not tell red from green (Okabe and Ito's set); hatching and glyph say
/// the same again.
struct VerdictLook {
    QRgb color;
    Qt::BrushStyle hatching;
    const char* glyph;
};

VerdictLook lookOf(PixelVerdict verdict)
{
    switch (verdict) {
    case PixelVerdict::Right: break;
    case PixelVerdict::OtherFace: return {0xfff0e442, Qt::HorPattern, "\u2260"};
    case PixelVerdict::HitLess: return {0xff2fc79a, Qt::VerPattern, "<"};
    case PixelVerdict::HitTwice: return {0xffd98fb8, Qt::BDiagPattern, "2"};
    case PixelVerdict::Extra: return {0xffe69f00, Qt::DiagCrossPattern, "\u00d7"};
    case PixelVerdict::Missing: return {0xff56b4e9, Qt::NoBrush, "\u25cb"};
    }
    return {0, Qt::NoBrush, ""};
}

constexpr double kGlow = 6; ///< canvas pixels round a wrong pixel

void paintHalo(QPainter& painter, const QRectF& cell, const QColor& color)
{
    painter.setBrush(Qt::NoBrush);
    for (int ring = 1; ring <= static_cast<int>(kGlow); ++ring) {
        QColor faint = color;
        faint.setAlphaF(static_cast<float>(0.75 * (1 - ring / (kGlow + 1))));
        painter.setPen(QPen(faint, 1));
        painter.drawRoundedRect(cell.adjusted(-ring, -ring, ring, ring), ring, ring);
    }
}

/// Less than a cell's worth of pixels: a dot with a halo, however small the pixel is.
void paintSpot(QPainter& painter, QPointF at, PixelVerdict verdict, bool thick)
{
    const QColor color(verdictColor(verdict));
    const double radius = thick ? 4 : 2.5;
    paintHalo(painter, QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius), color);
    painter.setPen(QPen(QColor(kCanvasInk), 1));
    painter.setBrush(color);
    if (verdict == PixelVerdict::Missing)
        painter.drawEllipse(at, radius, radius);
    else
        painter.drawRect(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius));
}

/// What is painted again and again, as a picture.
QPixmap cachedTile(PixelVerdict verdict, double cell, bool thick)
{
    const QString key =
        QStringLiteral("rasterlens-verdict-%1-%2-%3").arg(static_cast<int>(verdict)).arg(cell).arg(thick);
    QPixmap tile;
    if (QPixmapCache::find(key, &tile))
        return tile;
    const double margin = kGlow + 4;
    tile = QPixmap(QSizeF(cell + 2 * margin, cell + 2 * margin).toSize());
    tile.fill(Qt::transparent);
    QPainter painter(&tile);
    painter.setRenderHint(QPainter::Antialiasing);
    if (cell >= kGridFromZoom)
        paintVerdict(painter, QRectF(margin, margin, cell, cell), verdict, thick);
    else
        paintSpot(painter, QRectF(tile.rect()).center(), verdict, thick);
    QPixmapCache::insert(key, tile);
    return tile;
}

/// The wrong pixels in sight or, where several fall on one spot of the canvas, the worst of them.
std::vector<WrongPixel> inSight(const std::vector<WrongPixel>& wrong, const QRect& pixels, double zoom, double spot)
{
    const auto first = std::ranges::lower_bound(wrong, pixels.top(), {}, &WrongPixel::y);
    const auto last = std::ranges::upper_bound(wrong, pixels.bottom(), {}, &WrongPixel::y);
    std::vector<WrongPixel> seen;
    const int step = static_cast<int>(std::ceil(spot / zoom));
    std::unordered_map<std::int64_t, std::size_t> spots;
    for (auto pixel = first; pixel != last; ++pixel) {
        if (pixel->x < pixels.left() || pixel->x > pixels.right())
            continue;
        if (step > 1) {
            const std::int64_t key = (std::int64_t{pixel->y / step} << 32) | (pixel->x / step);
            const auto [former, isNew] = spots.emplace(key, seen.size());
            if (!isNew) {
                if (seen[former->second].verdict < pixel->verdict)
                    seen[former->second] = *pixel;
                continue;
            }
        }
        seen.push_back(*pixel);
    }
    return seen;
}

} // namespace

QRgb verdictColor(PixelVerdict verdict) { return lookOf(verdict).color; }

void paintVerdict(QPainter& painter, const QRectF& cell, PixelVerdict verdict, bool thick)
{
    const VerdictLook look = lookOf(verdict);
    const QColor color(look.color);
    constexpr double kGlyphsFrom = 14;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintHalo(painter, cell, color);
    QColor veil = color;
    veil.setAlpha(70);
    painter.fillRect(cell, veil);
    painter.fillRect(cell, QBrush(color, look.hatching));
    const double width = (cell.width() >= 24 ? 3 : 2) * (thick ? 1.5 : 1);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(kCanvasInk), width + 2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    const double inset = width / 2;
    painter.drawRect(cell.adjusted(inset, inset, -inset, -inset));
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(cell.adjusted(inset, inset, -inset, -inset));
    if (cell.width() >= kGlyphsFrom) {
        // In the corner: the lens has its signs in the middle.
        const double side = std::clamp(cell.width() * 0.4, 11.0, thick ? 34.0 : 22.0);
        const QRectF badge(cell.right() - side, cell.top(), side, side);
        paintVerdictSign(painter, badge, verdict);
    }
    painter.restore();
}

void paintVerdictSign(QPainter& painter, const QRectF& box, PixelVerdict verdict)
{
    const VerdictLook look = lookOf(verdict);
    painter.fillRect(box, QColor(kCanvasInk));
    QFont font = textFont(0, true);
    font.setPixelSize(static_cast<int>(box.height() * 0.85));
    painter.setFont(font);
    painter.setPen(QColor(look.color));
    painter.drawText(box, Qt::AlignCenter, QString::fromUtf8(look.glyph));
}

void RefereeLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                         const OverlayOptions& options) const
{
    const Judgement* judgement = m_referee.judgement();
    if (!judgement || judgement->wrong.empty())
        return;
    // A glow reaches into the canvas from a pixel just outside.
    const int margin = static_cast<int>(kGlow);
    const QRect wide = canvas.adjusted(-margin, -margin, margin, margin);
    const QRect pixels(transform.pixelAt(wide.topLeft()), transform.pixelAt(wide.bottomRight()));
    const bool cells = transform.zoom >= kGridFromZoom;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kSpot = 6; // canvas pixels
    constexpr double kDot = 2;
    constexpr std::size_t kMostSpots = 1500; // more would hide the picture
    std::vector<WrongPixel> seen = inSight(judgement->wrong, pixels, transform.zoom, kDot);
    if (!cells && seen.size() <= kMostSpots) {
        seen = inSight(judgement->wrong, pixels, transform.zoom, kSpot);
    } else if (!cells) {
        const double side = std::max(transform.zoom, kDot);
        for (const WrongPixel& wrong : seen)
            painter.fillRect(QRectF(transform.toCanvas(QPointF(wrong.x, wrong.y)), QSizeF(side, side)),
                             QColor(verdictColor(wrong.verdict)));
        seen.clear();
    }
    for (const WrongPixel& wrong : seen) {
        const QRectF cell = transform.toCanvas(QRectF(wrong.x, wrong.y, 1, 1));
        if (isDrawing(painter)) {
            if (cells)
                paintVerdict(painter, cell, wrong.verdict, options.thickLines);
            else
                paintSpot(painter, cell.center(), wrong.verdict, options.thickLines);
            continue;
        }
        const QPixmap tile = cachedTile(wrong.verdict, cells ? cell.width() : 1, options.thickLines);
        painter.drawPixmap(cell.center() - QPointF(tile.width(), tile.height()) / 2, tile);
    }
    painter.restore();
}

} // namespace rasterlens
