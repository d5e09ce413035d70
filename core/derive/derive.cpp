#include "core/derive/derive.h"

#include "core/derive/topic_list.h"

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

} // namespace

Derived derive(DerivationTopic topic, const Scene& scene, const Settings& settings, const DerivationPlace& place,
               const std::stop_token& stop)
{
    try {
        return {functionOf(topic)(scene, settings, place, stop), Reason(QString())};
    } catch (const NoDerivation& none) {
        return {std::nullopt, none.why};
    }
}

} // namespace rasterlens
