#pragma once
#include <QLineF>

#include <algorithm>

namespace rasterlens
{

/// How far a point is from the nearest point of a segment; the segment may be a point.
[[nodiscard]] inline double distanceToSegment(QPointF point, const QLineF& segment)
{
    const QPointF along = segment.p2() - segment.p1();
    const double length2 = QPointF::dotProduct(along, along);
    const double part = length2 > 0 ? QPointF::dotProduct(point - segment.p1(), along) / length2 : 0;
    return QLineF(point, segment.p1() + std::clamp(part, 0.0, 1.0) * along).length();
}

} // namespace rasterlens
