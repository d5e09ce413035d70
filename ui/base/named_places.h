#pragma once
#include <QPointF>
#include <QString>

#include <vector>

namespace rasterlens
{

/// A place with a name beside it.
struct NamedPlace {
    QPointF at;
    QString name;
};

/// Places in their order, where those nearer to an earlier one than a distance share its place: `A, C`.
[[nodiscard]] std::vector<NamedPlace> joinedPlaces(const std::vector<NamedPlace>& places, double distance);

} // namespace rasterlens
