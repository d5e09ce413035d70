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

/// A row of the table of topics.
struct DerivationTopicInfo {
    DerivationTopic topic;
    const char* id;      ///< stable: command line, JSON
    const char* title;   ///< QT_TRANSLATE_NOOP("Derive", ...)
    bool ofEdge = false; ///< it is about one edge of the face
};
[[nodiscard]] std::span<const DerivationTopicInfo> derivationTopics();
[[nodiscard]] const DerivationTopicInfo& infoOf(DerivationTopic topic);
[[nodiscard]] std::optional<DerivationTopic> derivationTopic(const QString& id);

} // namespace rasterlens
