#include "core/questions/without_effect.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

struct Rule {
    const char* field;
    bool (*inert)(const Settings&);
    const char* reason;
};

bool notSolid(const Settings& s) { return s.fill != Fill::Solid; }
bool noWireframe(const Settings& s) { return s.fill != Fill::Wireframe; }
bool noDepthBuffer(const Settings& s) { return s.visibility != Visibility::ZBuffer; }
bool tiled(const Settings& s) { return s.algorithm == Algorithm::Tiled; }
bool columnFill(const Settings& s) { return s.algorithm == Algorithm::ColumnFill; }
bool notTiled(const Settings& s) { return !tiled(s); }

bool withoutAttributes(const Settings& s)
{
    switch (s.shading) {
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Overdraw:
    case Shading::TriangleId: return true;
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::Texture:
    case Shading::Phong:
    case Shading::Normals:
    case Shading::Uv:
    case Shading::MipLevel: break;
    }
    return false;
}

/// The first rule that holds gives the reason.
constexpr Rule kRules[] = {
    {"number-type", notSolid,
     QT_TRANSLATE_NOOP("Applicability", "Only filled triangles ask whether a pixel centre is inside.")},
    {"algorithm", notSolid, QT_TRANSLATE_NOOP("Applicability", "Only filled triangles are covered by an algorithm.")},
    {"stepping", notSolid, QT_TRANSLATE_NOOP("Applicability", "Only filled triangles are covered by an algorithm.")},
    {"tie-rule", notSolid, QT_TRANSLATE_NOOP("Applicability", "Only filled triangles share pixels at their edges.")},
    {"stepping", [](const Settings& s) { return s.algorithm == Algorithm::EdgeWalking; },
     QT_TRANSLATE_NOOP("Applicability", "Edge walking evaluates no edge functions.")},
    {"stepping", tiled,
     QT_TRANSLATE_NOOP("Applicability", "The tiled algorithm steps through blocks of samples in its own way.")},
    {"number-type", columnFill, QT_TRANSLATE_NOOP("Applicability", "Column fill counts in whole rows and columns.")},
    {"stepping", columnFill, QT_TRANSLATE_NOOP("Applicability", "Column fill evaluates no edge functions.")},
    {"tie-rule", columnFill,
     QT_TRANSLATE_NOOP("Applicability", "Column fill takes the outline of every triangle with it.")},
    {"tie-rule", [](const Settings& s) { return s.coverageRule != CoverageRule::Centre; },
     QT_TRANSLATE_NOOP("Applicability", "Squares of pixels are asked for, not centres: what touches one touches it.")},
    {"stepping", [](const Settings& s) { return s.coverageRule != CoverageRule::Centre; },
     QT_TRANSLATE_NOOP("Applicability", "The corners of a pixel are asked one by one.")},
    {"coverage-rule", notSolid,
     QT_TRANSLATE_NOOP("Applicability", "Only filled triangles ask whether a pixel is inside.")},
    {"line", noWireframe, QT_TRANSLATE_NOOP("Applicability", "Lines are drawn by the wireframe only.")},
    {"line", [](const Settings& s) { return s.lineRule == LineRule::DiamondExit; },
     QT_TRANSLATE_NOOP("Applicability", "The diamonds alone decide which pixels a line has.")},
    {"line-ties", [](const Settings& s) { return s.lineRule == LineRule::DiamondExit; },
     QT_TRANSLATE_NOOP("Applicability", "The diamonds alone decide which pixels a line has.")},
    {"line-rule", noWireframe, QT_TRANSLATE_NOOP("Applicability", "Lines are drawn by the wireframe only.")},
    {"line-ties", noWireframe, QT_TRANSLATE_NOOP("Applicability", "Lines are drawn by the wireframe only.")},
    {"shared-edges", [](const Settings& s) { return s.fill != Fill::Wireframe; },
     QT_TRANSLATE_NOOP("Applicability", "Only the wireframe draws the edges of faces.")},
    {"winding", [](const Settings& s) { return s.culling == Culling::None; },
     QT_TRANSLATE_NOOP("Applicability", "Nothing is culled.")},
    {"cull-space", [](const Settings& s) { return s.culling == Culling::None; },
     QT_TRANSLATE_NOOP("Applicability", "Nothing is culled.")},
    {"depth-test", noDepthBuffer, QT_TRANSLATE_NOOP("Applicability", "Only the z-buffer compares depths.")},
    {"depth-format", noDepthBuffer, QT_TRANSLATE_NOOP("Applicability", "Only the z-buffer stores depths.")},
    {"depth-bias", noDepthBuffer, QT_TRANSLATE_NOOP("Applicability", "Only the z-buffer compares depths.")},
    {"depth-range", noDepthBuffer, QT_TRANSLATE_NOOP("Applicability", "Only the z-buffer stores depths.")},
    {"depth-order", noDepthBuffer, QT_TRANSLATE_NOOP("Applicability", "Only the z-buffer compares depths.")},
    {"depth-order",
     [](const Settings& s) { return s.depthTest == DepthTest::None || s.depthTest == DepthTest::Always; },
     QT_TRANSLATE_NOOP("Applicability", "Every fragment passes the depth test.")},
    {"depth-order", tiled,
     QT_TRANSLATE_NOOP("Applicability", "The tiled algorithm shades visible samples only, each once.")},
    {"attribute-path", [](const Settings& s) { return s.algorithm != Algorithm::EdgeWalking; },
     QT_TRANSLATE_NOOP("Applicability", "Only edge walking interpolates along edges and spans.")},
    {"attribute-path", withoutAttributes,
     QT_TRANSLATE_NOOP("Applicability", "This shading reads no interpolated attributes.")},
    {"interpolation", withoutAttributes,
     QT_TRANSLATE_NOOP("Applicability", "This shading reads no interpolated attributes.")},
    {"attribute-at", [](const Settings& s) { return patternSamples(s.samples) == 1; },
     QT_TRANSLATE_NOOP("Applicability", "Only MSAA shades a pixel elsewhere than at its samples.")},
    {"attribute-at", withoutAttributes,
     QT_TRANSLATE_NOOP("Applicability", "This shading reads no interpolated attributes.")},
    {"resolve", [](const Settings& s) { return s.samples == Samples::One; },
     QT_TRANSLATE_NOOP("Applicability", "A pixel has one sample, and no mean is taken.")},
    {"texture-filter", [](const Settings& s) { return s.shading != Shading::Texture && s.shading != Shading::Phong; },
     QT_TRANSLATE_NOOP("Applicability", "Only texture and Phong shading read texels.")},
    {"threads", notTiled, QT_TRANSLATE_NOOP("Applicability", "Only the tiled algorithm uses threads.")},
    {"simd", notTiled, QT_TRANSLATE_NOOP("Applicability", "Only the tiled algorithm uses vector instructions.")},
};

/// The lines of a scene are drawn whatever the fill.
std::optional<Reason> reasonFor(const char* field, const Settings& settings, bool sceneHasLines)
{
    for (const Rule& rule : kRules)
        if (QLatin1String(rule.field) == QLatin1String(field) && rule.inert(settings) &&
            !(sceneHasLines && rule.inert == noWireframe))
            return Reason(rule.reason);
    return std::nullopt;
}

} // namespace

std::optional<Reason> whyWithoutEffect(const SettingsField& field, const Settings& settings, bool sceneHasLines)
{
    return reasonFor(field.id, settings, sceneHasLines);
}

std::optional<Reason> whyWithoutEffect(const NumbersField& field, const Settings& settings)
{
    return reasonFor(field.id, settings, false);
}

} // namespace rasterlens
