#pragma once
#include <QString>

#include <optional>
#include <span>

namespace rasterlens
{

/// What a derivation is about. The order is that of the table in topics.cpp.
enum class DerivationTopic {
    Bresenham,
    EdgeFunction,
    Bounds,
    Inside,
    Barycentric,
    Perspective,
    DepthCurve,
    Cut,
    CohenSutherland,
    TwoPoint,
    FlatLight,
    Painter,
    Attribute,
    Blend,
};

/// The edge of the face that a topic is about where none is named.
enum class TopicEdge {
    None, ///< it is about no edge
    First,
    MostUnequal, ///< mostUnequalEdge()
};

/// A row of the table of topics.
struct DerivationTopicInfo {
    DerivationTopic topic;
    const char* id;    ///< stable: command line, JSON
    const char* title; ///< QT_TRANSLATE_NOOP("Derive", ...)
    TopicEdge edge = TopicEdge::None;
};
[[nodiscard]] std::span<const DerivationTopicInfo> derivationTopics();
[[nodiscard]] const DerivationTopicInfo& infoOf(DerivationTopic topic);
[[nodiscard]] std::optional<DerivationTopic> derivationTopic(const QString& id);

} // namespace rasterlens
