#include "core/questions/unchanged.h"

#include "core/observe/names.h"
#include "core/pipeline/geometry.h"
#include "core/pipeline/resolve.h"
#include "core/render/draw.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <set>

namespace rasterlens
{
namespace
{

/// Hears of every face what the facts are made of.
struct FactObserver : NullObserver {
    std::array<double, 3> w{};
    std::set<double> equalW;
    bool wDiffers = false;
    bool someCut = false;
    bool someFront = false;
    bool someBack = false;
    bool someLost = false; ///< rejected, or with a corner that is no number

    void onVertex(std::uint32_t /*face*/, int corner, std::uint32_t /*meshVertex*/, const ClipVertex& vertex)
    {
        constexpr double kSmallestW = 1e-5; // of the plane of w
        w[static_cast<std::size_t>(corner)] = vertex.positionClip.w;
        someCut = someCut || !(vertex.positionClip.w > kSmallestW);
    }
    void onClipped(std::uint32_t /*face*/, int /*pieces*/) { someCut = true; }
    void onFacing(std::uint32_t /*face*/, const FacingDecision& decision)
    {
        someFront = someFront || decision.fate == FaceFate::Rasterized;
        someBack = someBack || decision.fate == FaceFate::CulledBack;
    }
    void onFace(std::uint32_t /*face*/, FaceFate fate)
    {
        someLost = someLost || fate == FaceFate::Rejected || fate == FaceFate::NonFinite;
        wDiffers = wDiffers || w[0] != w[1] || w[0] != w[2];
        if (!wDiffers && equalW.size() <= FrameFacts::kMostNamed)
            equalW.insert(w[0]);
    }
};

/// Hears of every sample what the facts are made of.
class SampleObserver : public NullObserver
{
public:
    explicit SampleObserver(const Rules& rules)
        : m_columns(static_cast<std::size_t>(rules.columns())),
          m_pixels(m_columns * static_cast<std::size_t>(rules.rows())),
          m_isCovered(m_pixels * static_cast<std::size_t>(rules.patternSamples), 0)
    {
    }

    SampleFacts facts{true, true, true};

    void onPatternSample(int sample) { m_sample = static_cast<std::size_t>(std::max(sample, 0)); }
    void onSample(int /*x*/, int /*y*/, const EdgeValues& values, bool /*covered*/)
    {
        facts.noTies = facts.noTies && std::ranges::min(values) != 0;
    }
    void onFragment(const Fragment& fragment, float storedDepth, bool /*passedDepth*/)
    {
        char& isCovered = m_isCovered[m_sample * m_pixels + static_cast<std::size_t>(fragment.y) * m_columns +
                                      std::size_t(fragment.x)];
        const bool isBetween = fragment.depth > 0 && fragment.depth < 1;
        facts.coveredOnce = facts.coveredOnce && isCovered == 0 && isBetween;
        facts.noEqualDepths = facts.noEqualDepths && fragment.depth != storedDepth;
        isCovered = 1;
    }

private:
    std::size_t m_columns;
    std::size_t m_pixels;     ///< samples, of a pattern those with one number
    std::size_t m_sample = 0; ///< of a pattern
    std::vector<char> m_isCovered;
};

/// The facts by edge equation, which decides all samples one by one; nothing where the settings may decide otherwise.
std::optional<SampleFacts> sampleFacts(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    const bool isExact = settings.numberType == NumberType::Fixed || settings.algorithm == Algorithm::EdgeEquation;
    if (settings.fill != Fill::Solid || !scene.mesh.lines.empty() || settings.algorithm == Algorithm::ColumnFill ||
        settings.attributePath != AttributePath::Planes || !isExact)
        return std::nullopt;
    Settings asked = settings;
    asked.mistakes.clear();
    asked.algorithm = Algorithm::EdgeEquation;
    asked.shading = Shading::RandomFlat; // one colour a face, since colours do not matter
    const Resolved resolved = resolve(asked, scene);
    SampleObserver heard(resolved.rules);
    Frame frame;
    drawScene(scene, resolved, frame, {.picture = false}, heard, stop);
    return heard.facts;
}

/// `7`, `7 and 10`, `3, 7, 10 ..`
Reason numbersText(const std::vector<double>& numbers, bool more)
{
    QStringList words;
    for (const double number : numbers)
        words << shortNumber(number);
    if (words.size() == 2 && !more)
        return {QT_TRANSLATE_NOOP("Diagnostic", "%1 and %2"), {words[0], words[1]}};
    return words.join(QStringLiteral(", ")) + (more ? QStringLiteral(" ..") : QString());
}

std::optional<Reason> whenEqualW(const FrameFacts& facts)
{
    if (!facts.equalWEverywhere)
        return std::nullopt;
    const bool more = facts.equalW.size() > FrameFacts::kMostNamed;
    std::vector<double> named = facts.equalW;
    named.resize(std::min(named.size(), FrameFacts::kMostNamed));
    if (named.size() == 1)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "all w of these faces are equal: %1"),
                      {numbersText(named, more)});
    return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the three w of each face are equal: %1"),
                  {numbersText(named, more)});
}

std::optional<Reason> whenNoneOutside(const FrameFacts& facts)
{
    return facts.noneOutside ? std::optional(Reason(
                                   QT_TRANSLATE_NOOP("Diagnostic", "no face is cut, and none is rejected: all corners "
                                                                   "lie inside the view volume")))
                             : std::nullopt;
}

std::optional<Reason> whenNoTies(const FrameFacts& facts)
{
    return facts.samples && facts.samples->noTies
               ? std::optional(Reason(QT_TRANSLATE_NOOP("Diagnostic", "no sample lies exactly on an edge")))
               : std::nullopt;
}

std::optional<Reason> whenCoveredOnce(const FrameFacts& facts)
{
    return facts.samples && facts.samples->coveredOnce
               ? std::optional(Reason(QT_TRANSLATE_NOOP("Diagnostic", "no sample is covered by two faces")))
               : std::nullopt;
}

// What each field is asked, with the settings of both values.

std::optional<Reason> whyProjection(const Settings&, const Settings&, const FrameFacts& facts)
{
    return facts.noCamera
               ? std::optional(
                     Reason(QT_TRANSLATE_NOOP("Diagnostic", "the scene is given in clip space: no camera projects it")))
               : std::nullopt;
}

std::optional<Reason> whyClipping(const Settings&, const Settings&, const FrameFacts& facts)
{
    return whenNoneOutside(facts);
}

std::optional<Reason> whyCulling(const Settings& one, const Settings& other, const FrameFacts& facts)
{
    const auto isEither = [&](Culling culling) {
        return (one.culling == culling || one.culling == Culling::None) &&
               (other.culling == culling || other.culling == Culling::None);
    };
    if (isEither(Culling::Back) && facts.allFront)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "every face is a front face"));
    if (isEither(Culling::Front) && facts.allBack)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "every face is a back face"));
    return std::nullopt;
}

std::optional<Reason> whyStepping(const Settings& one, const Settings&, const FrameFacts&)
{
    return one.numberType == NumberType::Fixed
               ? std::optional(Reason(
                     QT_TRANSLATE_NOOP("Diagnostic", "fixed point is exact: adding up gives what the formula gives")))
               : std::nullopt;
}

std::optional<Reason> whyTieRule(const Settings&, const Settings&, const FrameFacts& facts)
{
    return whenNoTies(facts);
}

std::optional<Reason> whyVisibility(const Settings&, const Settings&, const FrameFacts& facts)
{
    return whenCoveredOnce(facts);
}

std::optional<Reason> whyDepthTest(const Settings& one, const Settings& other, const FrameFacts& facts)
{
    const auto isEither = [&](DepthTest first, DepthTest second) {
        return (one.depthTest == first || one.depthTest == second) &&
               (other.depthTest == first || other.depthTest == second);
    };
    if (one.depthTest == DepthTest::Equal || other.depthTest == DepthTest::Equal)
        return std::nullopt; // nothing between 0 and 1 equals what the buffer is cleared to
    if (isEither(DepthTest::Always, DepthTest::None))
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "either way every fragment is drawn"));
    if (isEither(DepthTest::Less, DepthTest::LessEqual) && facts.samples && facts.samples->noEqualDepths)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "no depth is exactly the one that it is compared with"));
    return whenCoveredOnce(facts);
}

std::optional<Reason> whyInterpolation(const Settings&, const Settings&, const FrameFacts& facts)
{
    return whenEqualW(facts);
}

std::optional<Reason> whyTextureFilter(const Settings& one, const Settings&, const FrameFacts& facts)
{
    return one.shading == Shading::Phong && facts.noTexture
               ? std::optional(Reason(QT_TRANSLATE_NOOP("Diagnostic", "no material has a texture")))
               : std::nullopt;
}

std::optional<Reason> whyAlphaTest(const Settings&, const Settings&, const FrameFacts& facts)
{
    return facts.noMask ? std::optional(Reason(QT_TRANSLATE_NOOP("Diagnostic", "no material has a mask")))
                        : std::nullopt;
}

/// A field, and why another value of it changes nothing.
struct FieldRow {
    const char* id;
    FactsOf needs;
    std::optional<Reason> (*why)(const Settings& one, const Settings& other, const FrameFacts& facts);
};
constexpr FieldRow kFields[] = {
    {"projection", FactsOf::Faces, whyProjection},
    {"clipping", FactsOf::Faces, whyClipping},
    {"culling", FactsOf::Faces, whyCulling},
    {"stepping", FactsOf::Faces, whyStepping},
    {"tie-rule", FactsOf::Samples, whyTieRule},
    {"visibility", FactsOf::Samples, whyVisibility},
    {"depth-test", FactsOf::Samples, whyDepthTest},
    {"interpolation", FactsOf::Faces, whyInterpolation},
    {"texture-filter", FactsOf::Faces, whyTextureFilter},
    {"alpha-test", FactsOf::Faces, whyAlphaTest},
};

const FieldRow* rowOf(const SettingsField& field)
{
    const auto row = std::ranges::find_if(
        kFields, [&](const FieldRow& one) { return QLatin1String(one.id) == QLatin1String(field.id); });
    return row == std::end(kFields) ? nullptr : row;
}

/// The facts that hold while these mistakes are made: those of samples hold without mistakes only.
FrameFacts withoutMistakes(FrameFacts facts, const QStringList& mistakes)
{
    if (!mistakes.empty())
        facts.samples.reset();
    return facts;
}

template <class... Ids>
bool isOneOf(const char* id, Ids... ids)
{
    return ((QLatin1String(id) == QLatin1String(ids)) || ...);
}

/// Reasons that lie in shading and texture filter.
std::optional<Reason> whenNothingIsLookedUp(const char* id, const Settings& settings)
{
    const bool readsTexels = settings.shading == Shading::Texture || settings.shading == Shading::Phong;
    const bool showsLevel = settings.shading == Shading::MipLevel;
    const bool isLevel = isOneOf(id, "lod-per-face", "wrap-before-derivative", "lod-doubled");
    if (!readsTexels && (isOneOf(id, "no-half-texel") || (!showsLevel && (isLevel || isOneOf(id, "xy-for-uv")))))
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "this shading reads no texels"));
    if (isLevel && !showsLevel && settings.textureFilter != TextureFilter::Trilinear)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "no mip levels are looked up"));
    if (isOneOf(id, "no-half-texel") && settings.textureFilter == TextureFilter::Nearest)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the nearest texel is taken, and none is blended"));
    if (isOneOf(id, "no-clamp", "not-normalized") && settings.shading != Shading::Phong)
        return Reason(
            QT_TRANSLATE_NOOP("Diagnostic", "light is not computed at every pixel: the shading is not phong"));
    return std::nullopt;
}

/// Reasons why mistakes of multi-sampling change nothing.
std::optional<Reason> whenNotOfPatterns(const char* id, const Settings& settings)
{
    if (patternSamples(settings.samples) == 1)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "needs MSAA: samples msaa2 to msaa16"));
    if (!isOneOf(id, "resolved-by-face") && settings.attributeAt == AttributeAt::Centre)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "attributes are taken at the pixels' centres"));
    if (isOneOf(id, "centroid-gradient") && settings.textureFilter != TextureFilter::Trilinear)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "only texture-filter trilinear asks for derivatives"));
    return std::nullopt;
}

/// Reasons that lie in the settings alone.
std::optional<Reason> whenNotAsked(const char* id, const Settings& settings, const FrameFacts& facts)
{
    if (isOneOf(id, "steep-columns", "steep-step", "integer-weight", "missing-octant", "missing-last-pixel",
                "line-tie-by-direction") &&
        settings.fill != Fill::Wireframe && !facts.hasLines)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "no lines are drawn"));
    if (isOneOf(id, "centre-outside", "centroid-gradient", "resolved-by-face"))
        return whenNotOfPatterns(id, settings);
    if (isOneOf(id, "coverage-times-color", "one-depth-per-pixel") && settings.samples == Samples::One)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "there is one sample a pixel"));
    if (isOneOf(id, "stride-exchanged") && settings.size.width() == settings.size.height())
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the picture is as wide as it is high"));
    if (isOneOf(id, "cull-reversed", "cull-before-divide", "cull-before-clip") && settings.culling == Culling::None)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "nothing is culled"));
    if (isOneOf(id, "truncate-to-zero") && settings.fill != Fill::Points)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "no points are drawn"));
    return whenNothingIsLookedUp(id, settings);
}

} // namespace

FrameFacts frameFacts(const Scene& scene, const Settings& settings, FactsOf what, const std::stop_token& stop)
{
    Settings asked = settings;
    asked.mistakes.clear();
    asked.clipping = Clipping::Frustum;
    asked.culling = Culling::Back;
    const Resolved resolved = resolve(asked, scene);
    const Geometry geometry(scene, resolved.matrices, resolved.rules);
    const auto faces = static_cast<std::uint32_t>(scene.mesh.faceCount());
    FactObserver heard;
    std::vector<ScreenTriangle> triangles;
    constexpr std::uint32_t kLook = 4096;
    for (std::uint32_t face = 0; face < faces && !(face % kLook == 0 && stop.stop_requested()); ++face) {
        triangles.clear();
        geometry.process(face, triangles, heard);
    }
    FrameFacts facts;
    facts.equalWEverywhere = faces > 0 && !heard.wDiffers;
    if (facts.equalWEverywhere)
        facts.equalW.assign(heard.equalW.begin(), heard.equalW.end());
    facts.noneOutside = !heard.someCut && !heard.someLost;
    facts.allFront = heard.someFront && !heard.someBack;
    facts.allBack = heard.someBack && !heard.someFront;
    facts.hasLines = !scene.mesh.lines.empty();
    facts.noCamera = scene.space == SceneSpace::Clip;
    facts.orthographic = resolved.matrices.orthographic;
    facts.noMask = std::ranges::none_of(scene.materials, [](const Material& material) { return material.mask >= 0; });
    facts.noTexture =
        std::ranges::none_of(scene.materials, [](const Material& material) { return material.texture >= 0; });
    if (what == FactsOf::Samples)
        facts.samples = sampleFacts(scene, settings, stop);
    return facts;
}

bool canBeUnchanged(const SettingsField& field) { return rowOf(field) != nullptr; }

FactsOf factsFor(const SettingsField& field)
{
    const FieldRow* row = rowOf(field);
    return row != nullptr ? row->needs : FactsOf::Faces;
}

FactsOf factsFor(const Mistake& mistake)
{
    return isOneOf(mistake.id, "all-inclusive", "all-exclusive") ? FactsOf::Samples : FactsOf::Faces;
}

std::optional<Reason> whyUnchanged(const SettingsField& field, const Settings& one, const Settings& other,
                                   const FrameFacts& facts)
{
    const FieldRow* row = rowOf(field);
    return row != nullptr ? row->why(one, other, withoutMistakes(facts, one.mistakes)) : std::nullopt;
}

std::optional<Reason> whyLightUnchanged(const Scene& scene, const Settings& settings)
{
    const Resolved resolved = resolve(settings, scene);
    if (resolved.rules.facing == Facing::LightNormal)
        return std::nullopt;
    if (!scene.lit)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "this scene has no light: its colours are shown as they are"));
    if (!resolved.rules.lit)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "lines and points are drawn without light"));
    switch (settings.shading) {
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::Texture:
    case Shading::Phong: return std::nullopt;
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Normals:
    case Shading::Uv:
    case Shading::Overdraw:
    case Shading::TriangleId:
    case Shading::MipLevel: break;
    }
    return Reason(QT_TRANSLATE_NOOP("Diagnostic", "this shading asks for no light"));
}

std::optional<Reason> whyUnchanged(const Mistake& mistake, const Settings& settings, const FrameFacts& facts)
{
    const char* id = mistake.id;
    std::optional<Reason> why = whenNotAsked(id, settings, facts);
    if (!why && isOneOf(id, "affine", "w-lost", "w-not-inverted", "z-corrected", "w-before-clipping"))
        why = whenEqualW(facts);
    if (!why && isOneOf(id, "order-reversed", "rotation-inverted", "translate-by-target", "near-negative") &&
        facts.noCamera)
        why = Reason(QT_TRANSLATE_NOOP("Diagnostic", "the scene is given in clip space: no camera projects it"));
    if (isOneOf(id, "view-z-linear") && facts.orthographic)
        why = Reason(QT_TRANSLATE_NOOP("Diagnostic", "the depth of an orthographic camera is linear in the distance"));
    if (!why && factsFor(mistake) == FactsOf::Samples) {
        QStringList others = settings.mistakes;
        others.removeAll(QLatin1String(id));
        why = whenNoTies(withoutMistakes(facts, others));
    }
    if (!why && isOneOf(id, "no-near-clip", "z-clamped", "any-vertex-inside", "near-far-reject", "cut-corners",
                        "return-for-continue", "w-before-clipping", "reject-after-divide", "cut-keeps-attributes",
                        "cut-in-place", "cut-left-at-origin"))
        why = whenNoneOutside(facts);
    return why;
}

} // namespace rasterlens
