#include "ui/base/named_places.h"

#include <QLineF>

#include <algorithm>

namespace rasterlens
{

std::vector<NamedPlace> joinedPlaces(const std::vector<NamedPlace>& places, double distance)
{
    std::vector<NamedPlace> joined;
    for (const NamedPlace& place : places) {
        const auto earlier = std::ranges::find_if(
            joined, [&](const NamedPlace& other) { return QLineF(place.at, other.at).length() < distance; });
        if (earlier == joined.end())
            joined.push_back(place);
        else
            earlier->name += QStringLiteral(", ") + place.name;
    }
    return joined;
}

} // namespace rasterlens
