#pragma once
#include "ui/steps/step_formula.h"

#include <QStringList>
#include <QWidget>

class QPainter;

namespace rasterlens
{

/// A line of the listing: the code that is run and, where a mistake is in its place, the right code behind it, struck
/// through. Code that has no room ends in dots, or is broken into rows; the tool tip has all of it.
class CodeLine : public QWidget
{
    Q_OBJECT

public:
    explicit CodeLine(QWidget* parent = nullptr);

    /// in  isPresent: it is the line at work
    void setLine(const ListingLine& line, bool isPresent);

    /// A smaller type, in parts of the usual one.
    void setScale(double scale);
    /// The scale, of those from 1 down to `least`, at which a line of code has room in a width.
    [[nodiscard]] static double scaleFor(const QString& code, int width, double least);

    /// Code that has no room is broken into rows, and the right code stands below the code that is run.
    void setWrapped(bool on);
    /// The rows of the code, and then those of the right code, that have room in a width; none but the first is wider
    /// unless a word of it is.
    struct Rows {
        QStringList code;
        QStringList right;
    };
    [[nodiscard]] Rows rowsFor(int width) const;

    /// The code as it is shown in one row, with dots where it has no room.
    struct Shown {
        QString code;
        QString right;
    };
    [[nodiscard]] Shown shown() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintRows(QPainter& painter, QFont font) const;

    ListingLine m_line;
    bool m_isPresent = false;
    bool m_isWrapped = false;
    double m_scale = 1;
};

} // namespace rasterlens
