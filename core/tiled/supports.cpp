#include "core/tiled/tiled.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

// What the kernels draw. A value that is added to one of these lists is not drawn until it stands here.

bool draws(Shading shading)
{
    switch (shading) {
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Texture:
    case Shading::Phong:
    case Shading::Depth:
    case Shading::Normals:
    case Shading::Uv:
    case Shading::Overdraw:
    case Shading::TriangleId: return true;
    case Shading::MipLevel: break;
    }
    return false;
}

bool draws(TextureFilter filter)
{
    switch (filter) {
    case TextureFilter::Nearest:
    case TextureFilter::Bilinear:
    case TextureFilter::Trilinear: return true;
    }
    return false;
}

bool draws(Clipping clipping)
{
    switch (clipping) {
    case Clipping::Frustum:
    case Clipping::FrustumW:
    case Clipping::GuardBand:
    case Clipping::AnyVertexInside:
    case Clipping::NearFarReject:
    case Clipping::CohenSutherland:
    case Clipping::None:
    case Clipping::DepthClamp: return true;
    }
    return false;
}

bool draws(DepthFormat format)
{
    switch (format) {
    case DepthFormat::Float32:
    case DepthFormat::Unorm24:
    case DepthFormat::Unorm16:
    case DepthFormat::Unorm8: return true;
    }
    return false;
}

bool draws(DepthCompare compare)
{
    switch (compare) {
    case DepthCompare::Less:
    case DepthCompare::LessEqual:
    case DepthCompare::Greater:
    case DepthCompare::GreaterEqual:
    case DepthCompare::Always:
    case DepthCompare::Equal:
    case DepthCompare::NotEqual: return true;
    }
    return false;
}

bool drawsAll(const Rules& rules)
{
    return draws(rules.shading) && draws(rules.textureFilter) && draws(rules.clipping) && draws(rules.depthFormat) &&
           draws(rules.depthCompare);
}

} // namespace

std::optional<Reason> Tiled::supports(const Rules& rules)
{
    if (rules.shading == Shading::MipLevel)
        return Reason{QT_TRANSLATE_NOOP("Unsupported",
                                        "algorithm tiled computes no mip level by itself: it does not draw "
                                        "shading mip-level")};
    if (!drawsAll(rules))
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled does not draw these settings")};
    if (rules.numberType != NumberType::Fixed)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled needs number-type fixed")};
    if (rules.multiSampled() && rules.attributeAt != AttributeAt::Centre)
        return Reason{QT_TRANSLATE_NOOP("Unsupported",
                                        "algorithm tiled with samples msaa2 to msaa16 needs attribute-at centre: it "
                                        "shades what is left when all triangles are drawn, and knows their masks no "
                                        "more")};
    if (rules.samplesPerPixel() > 1 && rules.resolveLight != ResolveLight::Gamma)
        return Reason{
            QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled with several samples a pixel needs resolve gamma")};
    if (rules.lineFaces)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled draws triangles, and this scene has lines; "
                                                       "edge-equation, edge-walking and column-fill draw both")};
    if (rules.fill != Fill::Solid)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled needs fill solid")};
    if (rules.painter)
        return Reason{
            QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled needs visibility z-buffer or submission-order")};
    if (rules.tie.owner != 0 || rules.tie.other != 1)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled needs tie-rule top-left")};
    if (rules.attributePath == AttributePath::EdgeThenSpan)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "attribute-path edge-then-span needs algorithm edge-walking")};
    return std::nullopt;
}

} // namespace rasterlens
