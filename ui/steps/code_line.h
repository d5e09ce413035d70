#pragma once
#include "ui/steps/step_formula.h"

#include <QWidget>

namespace rasterlens
{

/// A line of the listing: the code that is run and, where a mistake is in its place, the right code behind it, struck
/// through. Code that has no room ends in dots; the tool tip has all of it.
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

    /// The code as it is shown, with dots where it has no room.
    struct Shown {
        QString code;
        QString right;
    };
    [[nodiscard]] Shown shown() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ListingLine m_line;
    bool m_isPresent = false;
    double m_scale = 1;
};

} // namespace rasterlens
