#include "core/derive/topics.h"

#include "core/base/closed_list.h"

#include <QCoreApplication>

#include <array>

namespace rasterlens
{
namespace
{

constexpr auto kTopics = std::to_array<DerivationTopicInfo>({
    {DerivationTopic::Bresenham, "bresenham", QT_TRANSLATE_NOOP("Derive", "Bresenham's decision"), TopicEdge::First},
    {DerivationTopic::EdgeFunction, "edge-function", QT_TRANSLATE_NOOP("Derive", "Edge function"), TopicEdge::First},
    {DerivationTopic::Bounds, "bounds", QT_TRANSLATE_NOOP("Derive", "The bounding box")},
    {DerivationTopic::Inside, "inside", QT_TRANSLATE_NOOP("Derive", "Inside, asked in four forms")},
    {DerivationTopic::Barycentric, "barycentric", QT_TRANSLATE_NOOP("Derive", "Barycentric weights, five ways")},
    {DerivationTopic::Perspective, "perspective", QT_TRANSLATE_NOOP("Derive", "Perspective-correct weights"),
     TopicEdge::MostUnequal},
    {DerivationTopic::DepthCurve, "depth-curve", QT_TRANSLATE_NOOP("Derive", "The curve of depth"),
     TopicEdge::MostUnequal},
    {DerivationTopic::Cut, "cut", QT_TRANSLATE_NOOP("Derive", "Cut of an edge by the planes"), TopicEdge::First},
    {DerivationTopic::CohenSutherland, "cohen-sutherland",
     QT_TRANSLATE_NOOP("Derive", "Cohen-Sutherland, edge by edge")},
    {DerivationTopic::TwoPoint, "two-point", QT_TRANSLATE_NOOP("Derive", "Along the edges, then along the span")},
    {DerivationTopic::FlatLight, "flat-light", QT_TRANSLATE_NOOP("Derive", "Flat light")},
    {DerivationTopic::Painter, "painter", QT_TRANSLATE_NOOP("Derive", "The painter's order")},
    {DerivationTopic::Attribute, "attribute", QT_TRANSLATE_NOOP("Derive", "An attribute as the sum of three")},
    {DerivationTopic::Blend, "blend", QT_TRANSLATE_NOOP("Derive", "Transparent faces, and who comes first")},
});
static_assert(isClosedList(kTopics, &DerivationTopicInfo::topic));

} // namespace

std::span<const DerivationTopicInfo> derivationTopics() { return kTopics; }

const DerivationTopicInfo& infoOf(DerivationTopic topic) { return kTopics[static_cast<std::size_t>(topic)]; }

std::optional<DerivationTopic> derivationTopic(const QString& id)
{
    for (const DerivationTopicInfo& info : kTopics)
        if (id == QLatin1String(info.id))
            return info.topic;
    return std::nullopt;
}

} // namespace rasterlens
