#include "core/derive/derive.h"

#include "core/derive/topic_list.h"
#include "core/questions/vertex_table.h"

namespace rasterlens
{
namespace
{

using Derive = Derivation (*)(const Scene&, const Settings&, const DerivationPlace&, const std::stop_token&);

Derive functionOf(DerivationTopic topic)
{
    switch (topic) {
    case DerivationTopic::Bresenham: return deriveBresenham;
    case DerivationTopic::EdgeFunction: return deriveEdgeFunction;
    case DerivationTopic::Bounds: return deriveBounds;
    case DerivationTopic::Inside: return deriveInside;
    case DerivationTopic::Barycentric: return deriveBarycentric;
    case DerivationTopic::Perspective: return derivePerspective;
    case DerivationTopic::DepthCurve: return deriveDepthCurve;
    case DerivationTopic::Cut: return deriveCut;
    case DerivationTopic::CohenSutherland: return deriveCohenSutherland;
    case DerivationTopic::TwoPoint: return deriveTwoPoint;
    case DerivationTopic::FlatLight: return deriveFlatLight;
    case DerivationTopic::Painter: return derivePainter;
    case DerivationTopic::Attribute: return deriveAttribute;
    case DerivationTopic::Blend: break;
    }
    return deriveBlend;
}

/// The edge that a topic is about: that of the place or, where it names none, the topic's own choice.
std::optional<int> edgeOf(DerivationTopic topic, const Scene& scene, const Settings& settings,
                          const DerivationPlace& place)
{
    switch (infoOf(topic).edge) {
    case TopicEdge::None: return std::nullopt;
    case TopicEdge::First: return place.edge.value_or(0);
    case TopicEdge::MostUnequal: break;
    }
    return place.edge ? *place.edge : mostUnequalEdge(vertexTable(scene, settings, place.face));
}

} // namespace

Derived derive(DerivationTopic topic, const Scene& scene, const Settings& settings, const DerivationPlace& place,
               const std::stop_token& stop)
{
    DerivationPlace at = place;
    at.edge = edgeOf(topic, scene, settings, place);
    Settings about = settings;
    if (patternSamples(settings.samples) > 1) // derivations are about the centre of a pixel
        about.samples = Samples::One;
    about.coverageRule = CoverageRule::Centre;
    try {
        return {functionOf(topic)(scene, about, at, stop), Reason(QString()), at.edge};
    } catch (const NoDerivation& none) {
        return {std::nullopt, none.why, at.edge};
    }
}

} // namespace rasterlens
