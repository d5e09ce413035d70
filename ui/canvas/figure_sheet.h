#pragma once
#include <QImage>
#include <QRectF>
#include <QSize>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QPainter;

namespace rasterlens
{

/// A picture of a figure, with a name above it where there are several.
struct FigurePanel {
    QString title;
    QSize size;
    std::function<void(QPainter&)> paint; ///< from (0, 0) on
};

/// What a sign of the picture means.
struct LegendEntry {
    std::function<void(QPainter&, const QRectF& box)> paint;
    QString text;
};

/// What stands below the pictures of a figure; what is empty takes no room.
struct FigureTexts {
    QString caption;
    QStringList formula; ///< line by line
    std::vector<LegendEntry> legend;
};

/// A figure for a page or a slide: pictures beside each other on white, a margin around them, and below them a caption,
/// a formula and a legend. Pixels are shown at the size of the panels, so that nothing in it has to be scaled.
class FigureSheet
{
public:
    FigureSheet(std::vector<FigurePanel> panels, FigureTexts texts);

    /// Empty where a picture has no size.
    [[nodiscard]] QSize size() const { return m_size; }
    void paint(QPainter& painter) const;
    /// errors  a null image where the figure would be too large
    [[nodiscard]] QImage image() const;

private:
    /// The place of a line of text or of an entry of the legend.
    struct Line {
        QRectF box;
        QString text;
    };

    void layOut();
    double layOutWords(const QString& text, const QFont& font, double top, std::vector<Line>& lines) const;
    double layOutLegend(double top);

    std::vector<FigurePanel> m_panels;
    FigureTexts m_texts;
    QSize m_size;
    std::vector<QPoint> m_corners; ///< of the panels
    std::vector<Line> m_caption;
    std::vector<Line> m_formula;
    std::vector<Line> m_legend;
};

} // namespace rasterlens
