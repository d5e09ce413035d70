#pragma once
#include "core/base/reason.h"

#include <QString>
#include <glm/glm.hpp>

#include <vector>

namespace rasterlens
{

/// A line of a figure through two or more points.
struct FigureStroke {
    enum class Look { Solid, Dashed };

    std::vector<glm::dvec2> points; ///< in the units of the figure's axes
    QString name;                   ///< stands at its middle; empty: none
    Look look = Look::Solid;
    int symbol = -1; ///< index into Derivation::symbols of what it is the picture of; -1 none
};

/// A point of a figure, with its name beside it.
struct FigurePoint {
    glm::dvec2 at{0, 0}; ///< in the units of the figure's axes
    QString name;
    int symbol = -1; ///< index into Derivation::symbols; -1 none
};

/// A place on the x axis of a figure that has a name.
struct FigureTick {
    double at = 0;
    QString name;
};

/// A drawing of a derivation that has no place over the picture: a view from the side, a curve. The axes are its own:
/// x to the right, y up, each in its own unit.
struct DerivationFigure {
    Reason title{QString()}; ///< of the context "Derive"
    QString xName;           ///< what the axis counts, as formulas call it
    QString yName;
    glm::dvec2 low{0, 0}; ///< the corner of what is shown where both axes are least
    glm::dvec2 high{1, 1};
    /// x grows logarithmically from this distance of 0 on, to both sides, and evenly nearer to 0; 0: evenly everywhere.
    double logFrom = 0;
    std::vector<FigureTick> xTicks;    ///< empty: the ends of the x axis are told
    std::vector<FigureStroke> strokes; ///< from behind to the front
    std::vector<FigurePoint> points;   ///< in front of the strokes

    /// The part of the width at which an x lies: 0 at low.x, 1 at high.x.
    [[nodiscard]] double partOfWidth(double x) const;
    /// The x that lies there.
    [[nodiscard]] double xAt(double partOfWidth) const;
};

} // namespace rasterlens
