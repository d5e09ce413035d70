#include "ui/canvas/figure_sheet.h"

#include "ui/base/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QTextLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kMargin = 20;
constexpr int kGap = 16;         ///< between pictures, and between them and what is written
constexpr int kTextPixels = 15;  ///< height of letters
constexpr int kLeastWidth = 440; ///< that lines of text have
constexpr double kSign = 18;     ///< side of a sign of the legend
constexpr double kSignGap = 7;   ///< between sign and text
constexpr double kEntryGap = 22; ///< between entries
constexpr int kMostPixels = 16384;
const QColor kInk(20, 24, 30);

QFont wordFont(bool bold = false)
{
    QFont font = textFont(0, bold);
    font.setPixelSize(kTextPixels);
    return font;
}

QFont formulaFont()
{
    QFont font = numberFont();
    font.setPixelSize(kTextPixels - 1);
    return font;
}

double lineHeight(const QFont& font) { return std::ceil(QFontMetricsF(font).lineSpacing()) + 2; }

} // namespace

FigureSheet::FigureSheet(std::vector<FigurePanel> panels, FigureTexts texts)
    : m_panels(std::move(panels)), m_texts(std::move(texts))
{
    layOut();
}

void FigureSheet::layOut()
{
    const bool titled = std::ranges::any_of(m_panels, [](const FigurePanel& panel) { return !panel.title.isEmpty(); });
    const int top = kMargin + (titled ? int(lineHeight(wordFont(true))) : 0);
    int right = kMargin;
    int bottom = top;
    for (const FigurePanel& panel : m_panels) {
        if (panel.size.isEmpty())
            return;
        if (!m_corners.empty())
            right += kGap;
        m_corners.emplace_back(right, top);
        right += panel.size.width();
        bottom = std::max(bottom, top + panel.size.height());
    }
    const bool hasTexts = !m_texts.caption.isEmpty() || !m_texts.formula.isEmpty() || !m_texts.legend.empty();
    m_size.setWidth(std::max(right, hasTexts ? kMargin + kLeastWidth : 0) + kMargin);
    double y = bottom;
    if (!m_texts.caption.isEmpty())
        y = layOutWords(m_texts.caption, wordFont(), y + kGap * 0.75, m_caption);
    if (!m_texts.formula.isEmpty()) {
        y += kGap / 2.0;
        for (const QString& line : std::as_const(m_texts.formula))
            y = layOutWords(line, formulaFont(), y, m_formula);
    }
    if (!m_texts.legend.empty())
        y = layOutLegend(y + kGap * 0.75);
    m_size.setHeight(int(std::ceil(y)) + kMargin);
}

/// Breaks a text into lines as wide as the figure.
///
/// out  the lower end of the last line
double FigureSheet::layOutWords(const QString& text, const QFont& font, double top, std::vector<Line>& lines) const
{
    const double width = m_size.width() - 2 * kMargin;
    const double height = lineHeight(font);
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        QTextLayout layout(paragraph, font);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(width);
            lines.push_back({QRectF(kMargin, top, width, height), paragraph.mid(line.textStart(), line.textLength())});
            top += height;
        }
        layout.endLayout();
    }
    return top;
}

double FigureSheet::layOutLegend(double top)
{
    const QFontMetricsF metrics(wordFont());
    const double height = std::max(lineHeight(wordFont()), kSign + 4);
    double x = kMargin;
    for (const LegendEntry& entry : m_texts.legend) {
        const double width = kSign + kSignGap + metrics.horizontalAdvance(entry.text);
        if (x > kMargin && x + width > m_size.width() - kMargin) {
            x = kMargin;
            top += height;
        }
        m_legend.push_back({QRectF(x, top, width + 2, height), entry.text});
        x += width + kEntryGap;
    }
    return top + height;
}

void FigureSheet::paint(QPainter& painter) const
{
    painter.fillRect(QRect(QPoint(0, 0), m_size), Qt::white);
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const FigurePanel& panel = m_panels[i];
        painter.setFont(wordFont(true));
        painter.setPen(kInk);
        painter.drawText(QRectF(m_corners[i].x(), kMargin, panel.size.width(), lineHeight(wordFont(true))),
                         Qt::AlignLeft | Qt::AlignTop, panel.title);
        painter.save();
        painter.translate(m_corners[i]);
        painter.setClipRect(QRect(QPoint(0, 0), panel.size));
        panel.paint(painter);
        painter.restore();
    }
    const auto write = [&painter](const std::vector<Line>& lines, const QFont& font) {
        painter.setFont(font);
        painter.setPen(kInk);
        for (const Line& line : lines)
            painter.drawText(line.box, Qt::AlignLeft | Qt::AlignVCenter, line.text);
    };
    write(m_caption, wordFont());
    write(m_formula, formulaFont());
    for (std::size_t i = 0; i < m_legend.size(); ++i) {
        const QRectF& box = m_legend[i].box;
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        m_texts.legend[i].paint(painter, QRectF(box.left(), box.center().y() - kSign / 2, kSign, kSign));
        painter.restore();
        painter.setFont(wordFont());
        painter.setPen(kInk);
        painter.drawText(box.adjusted(kSign + kSignGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, m_legend[i].text);
    }
}

QImage FigureSheet::image() const
{
    if (m_size.isEmpty() || std::max(m_size.width(), m_size.height()) > kMostPixels)
        return {};
    QImage image(m_size, QImage::Format_RGB32);
    if (image.isNull())
        return {};
    QPainter painter(&image);
    paint(painter);
    return image;
}

} // namespace rasterlens
