#include "ui/face/sample_rows.h"

#include "core/settings/sample_pattern.h"
#include "ui/base/step_words.h"
#include "ui/base/text_on.h"

#include <QColor>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("rasterlens::PixelCard", text); }

/// The samples of a pixel as they lie in it; those that count as black are crossed out.
class SampleGrid : public QWidget
{
public:
    explicit SampleGrid(const ResolvedPixel& pixel) : m_pixel(pixel), m_grid(int(std::lround(std::sqrt(pixel.count))))
    {
        const int side = pixel.isPattern ? 96 : 60;
        setFixedSize(side + 1, side + 1);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        if (m_pixel.isPattern) {
            paintPattern(painter);
            return;
        }
        const double cell = double(width() - 1) / m_grid;
        for (int i = 0; i < m_pixel.count; ++i) {
            const QRectF part(i % m_grid * cell, i / m_grid * cell, cell, cell);
            const QColor stored{QRgb(m_pixel.samples[std::size_t(i)].color)};
            painter.fillRect(part, stored);
            drawTextOn(painter, part, Qt::AlignCenter, QString::number(i + 1), stored.rgb());
            painter.setPen(inkOn(stored.rgb()).ink);
            if (m_pixel.counted(i) != m_pixel.samples[std::size_t(i)].color) {
                painter.drawLine(part.topLeft(), part.bottomRight());
                painter.drawLine(part.topRight(), part.bottomLeft());
            }
            painter.setPen(palette().color(QPalette::Mid));
            painter.drawRect(part);
        }
    }

private:
    /// The samples where they lie, on discs.
    void paintPattern(QPainter& painter) const
    {
        const double side = width() - 1;
        const double radius = m_pixel.count > 8 ? side * 0.075 : side * 0.09;
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawRect(QRectF(0.5, 0.5, side, side));
        QFont small = font();
        small.setPixelSize(int(radius * 1.4));
        painter.setFont(small);
        for (int i = 0; i < m_pixel.count; ++i) {
            const SampleOffset offset = samplePattern(m_pixel.count)[std::size_t(i)];
            // a sample on the border is drawn within it
            const auto held = [&](int sixteenths) {
                return std::clamp((8 + sixteenths) / 16.0 * side, radius + 1, side - radius - 1);
            };
            const QPointF at(held(offset.x), held(offset.y));
            const QColor stored{QRgb(m_pixel.samples[std::size_t(i)].color)};
            painter.setPen(stored.lightness() > 128 ? Qt::black : Qt::white);
            painter.setBrush(stored);
            painter.drawEllipse(at, radius, radius);
            const QRectF box(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
            painter.drawText(box, Qt::AlignCenter, QString::number(i + 1));
            if (m_pixel.counted(i) == m_pixel.samples[std::size_t(i)].color)
                continue;
            painter.drawLine(box.topLeft(), box.bottomRight());
            painter.drawLine(box.topRight(), box.bottomLeft());
        }
    }

    ResolvedPixel m_pixel;
    int m_grid;
};

QLabel* textLabel(const QString& text, const char* look)
{
    auto* label = new QLabel(text);
    label->setObjectName(QLatin1String(look));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

SampleWords wordsOf(const QString& title, const ResolvedPixel& pixel)
{
    return {title, storedWords(pixel), meanWords(pixel), pixel};
}

} // namespace

std::vector<SampleWords> sampleWords(const WhyReport& report)
{
    std::vector<SampleWords> groups;
    if (!report.samples)
        return groups;
    groups.push_back(
        wordsOf(translated(QT_TRANSLATE_NOOP("rasterlens::PixelCard", "Its samples and their mean")), *report.samples));
    for (const WhyReport::Without& other : report.without) {
        const QString name = QStringLiteral("%1 %2").arg(QLatin1String(other.mistake->number),
                                                         QCoreApplication::translate("Mistake", other.mistake->title));
        groups.push_back(
            wordsOf(translated(QT_TRANSLATE_NOOP("rasterlens::PixelCard", "Without %1")).arg(name), other.samples));
    }
    return groups;
}

QWidget* makeSampleRows(const std::vector<SampleWords>& groups)
{
    auto* rows = new QWidget;
    auto* column = new QVBoxLayout(rows);
    column->setContentsMargins(8, 2, 8, 4);
    column->setSpacing(3);
    for (const SampleWords& group : groups) {
        column->addWidget(textLabel(group.title, "muted"));
        auto* line = new QHBoxLayout;
        line->setSpacing(10);
        line->addWidget(new SampleGrid(group.pixel), 0, Qt::AlignTop);
        line->addWidget(textLabel(group.samples.join(QLatin1Char('\n')), "numbers"), 1);
        column->addLayout(line);
        column->addWidget(textLabel(group.sums.join(QLatin1Char('\n')), "numbers"));
    }
    return rows;
}

} // namespace rasterlens
