#include "core/settings/settings.h"

#include "core/base/closed_list.h"

#include <QCoreApplication>

#include <array>
#include <type_traits>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr auto kAlgorithms = std::to_array<Choice>({{"edge-equation", QT_TRANSLATE_NOOP("Settings", "Edge equation")},
                                                    {"edge-walking", QT_TRANSLATE_NOOP("Settings", "Edge walking")},
                                                    {"tiled", QT_TRANSLATE_NOOP("Settings", "Tiled (fast)")},
                                                    {"column-fill", QT_TRANSLATE_NOOP("Settings", "Column fill")}});
constexpr auto kNumberTypes = std::to_array<Choice>({{"fixed", QT_TRANSLATE_NOOP("Settings", "Fixed point")},
                                                     {"float32", QT_TRANSLATE_NOOP("Settings", "Float, 32 bit")},
                                                     {"float64", QT_TRANSLATE_NOOP("Settings", "Float, 64 bit")}});
constexpr auto kSteppings = std::to_array<Choice>({{"incremental", QT_TRANSLATE_NOOP("Settings", "Incremental")},
                                                   {"direct", QT_TRANSLATE_NOOP("Settings", "Direct")}});
constexpr auto kFills = std::to_array<Choice>({{"solid", QT_TRANSLATE_NOOP("Settings", "Solid")},
                                               {"wireframe", QT_TRANSLATE_NOOP("Settings", "Wireframe")},
                                               {"points", QT_TRANSLATE_NOOP("Settings", "Points")}});
constexpr auto kLines = std::to_array<Choice>(
    {{"bresenham", QT_TRANSLATE_NOOP("Settings", "Bresenham")}, {"dda", QT_TRANSLATE_NOOP("Settings", "DDA")}});
constexpr auto kLineRules = std::to_array<Choice>({{"inclusive", QT_TRANSLATE_NOOP("Settings", "Both ends")},
                                                   {"half-open", QT_TRANSLATE_NOOP("Settings", "Without the last")},
                                                   {"diamond-exit", QT_TRANSLATE_NOOP("Settings", "Diamond exit")}});
constexpr auto kLineTies =
    std::to_array<Choice>({{"by-direction", QT_TRANSLATE_NOOP("Settings", "By the direction")},
                           {"canonical", QT_TRANSLATE_NOOP("Settings", "One for both directions")}});
constexpr auto kSharedEdges = std::to_array<Choice>({{"once", QT_TRANSLATE_NOOP("Settings", "Drawn once")},
                                                     {"each-face", QT_TRANSLATE_NOOP("Settings", "By each face")}});
constexpr auto kClippings =
    std::to_array<Choice>({{"frustum", QT_TRANSLATE_NOOP("Settings", "Frustum, 6 planes")},
                           {"frustum-w", QT_TRANSLATE_NOOP("Settings", "Frustum, 7 planes")},
                           {"guard-band", QT_TRANSLATE_NOOP("Settings", "Guard band")},
                           {"depth-clamp", QT_TRANSLATE_NOOP("Settings", "Sides only, depth clamped")},
                           {"any-vertex-inside", QT_TRANSLATE_NOOP("Settings", "Any vertex inside")},
                           {"near-far-reject", QT_TRANSLATE_NOOP("Settings", "Near / far reject")},
                           {"cohen-sutherland", QT_TRANSLATE_NOOP("Settings", "Cohen-Sutherland")},
                           {"none", QT_TRANSLATE_NOOP("Settings", "None")}});
constexpr auto kCullings = std::to_array<Choice>({{"back", QT_TRANSLATE_NOOP("Settings", "Back faces")},
                                                  {"front", QT_TRANSLATE_NOOP("Settings", "Front faces")},
                                                  {"none", QT_TRANSLATE_NOOP("Settings", "None")}});
constexpr auto kWindings = std::to_array<Choice>(
    {{"ccw", QT_TRANSLATE_NOOP("Settings", "Counter-clockwise")}, {"cw", QT_TRANSLATE_NOOP("Settings", "Clockwise")}});
constexpr auto kCullSpaces = std::to_array<Choice>({{"screen", QT_TRANSLATE_NOOP("Settings", "Screen area")},
                                                    {"clip", QT_TRANSLATE_NOOP("Settings", "Clip-space determinant")},
                                                    {"view", QT_TRANSLATE_NOOP("Settings", "Normal against gaze")}});
constexpr auto kDepthTests = std::to_array<Choice>({{"less", QT_TRANSLATE_NOOP("Settings", "Less")},
                                                    {"lequal", QT_TRANSLATE_NOOP("Settings", "Less or equal")},
                                                    {"equal", QT_TRANSLATE_NOOP("Settings", "Equal")},
                                                    {"gequal", QT_TRANSLATE_NOOP("Settings", "Greater or equal")},
                                                    {"greater", QT_TRANSLATE_NOOP("Settings", "Greater")},
                                                    {"notequal", QT_TRANSLATE_NOOP("Settings", "Not equal")},
                                                    {"always", QT_TRANSLATE_NOOP("Settings", "Always")},
                                                    {"none", QT_TRANSLATE_NOOP("Settings", "None")}});
constexpr auto kDepthFormats = std::to_array<Choice>({{"float32", QT_TRANSLATE_NOOP("Settings", "Float, 32 bit")},
                                                      {"unorm24", QT_TRANSLATE_NOOP("Settings", "24 bit")},
                                                      {"unorm16", QT_TRANSLATE_NOOP("Settings", "16 bit")},
                                                      {"unorm8", QT_TRANSLATE_NOOP("Settings", "8 bit")}});
constexpr auto kDepthOrders =
    std::to_array<Choice>({{"before-shading", QT_TRANSLATE_NOOP("Settings", "Before shading")},
                           {"after-shading", QT_TRANSLATE_NOOP("Settings", "After shading")}});
constexpr auto kClipZs = std::to_array<Choice>({{"gl", QT_TRANSLATE_NOOP("Settings", "-w to w (OpenGL)")},
                                                {"d3d", QT_TRANSLATE_NOOP("Settings", "0 to w (Direct3D)")}});
constexpr auto kProjections = std::to_array<Choice>({{"perspective", QT_TRANSLATE_NOOP("Settings", "Perspective")},
                                                     {"orthographic", QT_TRANSLATE_NOOP("Settings", "Orthographic")}});
constexpr auto kVisibilities =
    std::to_array<Choice>({{"z-buffer", QT_TRANSLATE_NOOP("Settings", "Z-buffer")},
                           {"painter", QT_TRANSLATE_NOOP("Settings", "Painter's algorithm")},
                           {"submission-order", QT_TRANSLATE_NOOP("Settings", "Submission order")}});
constexpr auto kInterpolations =
    std::to_array<Choice>({{"perspective", QT_TRANSLATE_NOOP("Settings", "Perspective-correct")},
                           {"affine", QT_TRANSLATE_NOOP("Settings", "Affine")},
                           {"every-8", QT_TRANSLATE_NOOP("Settings", "Divided every 8 pixels")},
                           {"every-16", QT_TRANSLATE_NOOP("Settings", "Divided every 16 pixels")}});
constexpr auto kAttributePaths =
    std::to_array<Choice>({{"planes", QT_TRANSLATE_NOOP("Settings", "Barycentric")},
                           {"edge-then-span", QT_TRANSLATE_NOOP("Settings", "Edge, then span")}});
constexpr auto kCoverageRules =
    std::to_array<Choice>({{"centre", QT_TRANSLATE_NOOP("Settings", "Centre inside")},
                           {"conservative", QT_TRANSLATE_NOOP("Settings", "Square touched")},
                           {"inner", QT_TRANSLATE_NOOP("Settings", "Square wholly inside")}});
constexpr auto kTieRules = std::to_array<Choice>({{"top-left", QT_TRANSLATE_NOOP("Settings", "Top-left")},
                                                  {"inclusive", QT_TRANSLATE_NOOP("Settings", "All inclusive")},
                                                  {"exclusive", QT_TRANSLATE_NOOP("Settings", "All exclusive")}});
constexpr auto kSamples = std::to_array<Choice>({{"1", QT_TRANSLATE_NOOP("Settings", "1")},
                                                 {"2x2", QT_TRANSLATE_NOOP("Settings", "2 x 2")},
                                                 {"3x3", QT_TRANSLATE_NOOP("Settings", "3 x 3")},
                                                 {"4x4", QT_TRANSLATE_NOOP("Settings", "4 x 4")},
                                                 {"msaa2", "MSAA 2"},
                                                 {"msaa4", "MSAA 4"},
                                                 {"msaa8", "MSAA 8"},
                                                 {"msaa16", "MSAA 16"}});
constexpr auto kAttributesAt =
    std::to_array<Choice>({{"centre", QT_TRANSLATE_NOOP("Settings", "The pixel's centre")},
                           {"centroid", QT_TRANSLATE_NOOP("Settings", "A covered place (centroid)")},
                           {"sample", QT_TRANSLATE_NOOP("Settings", "Every sample")}});
constexpr auto kResolveLights = std::to_array<Choice>({{"gamma", QT_TRANSLATE_NOOP("Settings", "Display values")},
                                                       {"linear", QT_TRANSLATE_NOOP("Settings", "Linear light")}});
constexpr auto kShadings = std::to_array<Choice>({{"gouraud", QT_TRANSLATE_NOOP("Settings", "Gouraud")},
                                                  {"flat", QT_TRANSLATE_NOOP("Settings", "Flat")},
                                                  {"random-flat", QT_TRANSLATE_NOOP("Settings", "Random flat colour")},
                                                  {"texture", QT_TRANSLATE_NOOP("Settings", "Texture")},
                                                  {"phong", QT_TRANSLATE_NOOP("Settings", "Phong")},
                                                  {"depth", QT_TRANSLATE_NOOP("Settings", "Depth")},
                                                  {"normals", QT_TRANSLATE_NOOP("Settings", "Normals")},
                                                  {"uv", QT_TRANSLATE_NOOP("Settings", "Texture coordinates")},
                                                  {"overdraw", QT_TRANSLATE_NOOP("Settings", "Overdraw")},
                                                  {"triangle-id", QT_TRANSLATE_NOOP("Settings", "Triangle id")},
                                                  {"mip-level", QT_TRANSLATE_NOOP("Settings", "Mip level")}});
constexpr auto kTextureFilters =
    std::to_array<Choice>({{"nearest", QT_TRANSLATE_NOOP("Settings", "Nearest")},
                           {"bilinear", QT_TRANSLATE_NOOP("Settings", "Bilinear")},
                           {"trilinear", QT_TRANSLATE_NOOP("Settings", "Bilinear with mipmaps")}});
constexpr auto kAlphaTests =
    std::to_array<Choice>({{"on", QT_TRANSLATE_NOOP("Settings", "On")}, {"off", QT_TRANSLATE_NOOP("Settings", "Off")}});
constexpr auto kSimds = std::to_array<Choice>({{"auto", QT_TRANSLATE_NOOP("Settings", "Best available")},
                                               {"scalar", QT_TRANSLATE_NOOP("Settings", "Scalar")},
                                               {"sse4", "SSE4"},
                                               {"avx2", "AVX2"},
                                               {"avx512", "AVX-512"},
                                               {"neon", "NEON"}});

/// A row for the member `Member`, whose type tells the kind.
template <auto Member>
int getMember(const Settings& settings)
{
    return static_cast<int>(settings.*Member);
}

template <auto Member>
void setMember(Settings& settings, int value)
{
    using Value = std::remove_reference_t<decltype(settings.*Member)>;
    settings.*Member = static_cast<Value>(value);
}

template <auto Member, std::size_t kCount>
constexpr SettingsField choice(const char* id, Stage stage, const std::array<Choice, kCount>& choices,
                               const char* title, const char* help)
{
    using Value = std::remove_reference_t<decltype(std::declval<Settings&>().*Member)>;
    static_assert(kCount == enumeratorCount<Value>(), "a choice for each value of the enumeration, in its order");
    return {id,
            title,
            help,
            stage,
            SettingsField::Kind::Choice,
            choices,
            0,
            static_cast<int>(choices.size()) - 1,
            getMember<Member>,
            setMember<Member>};
}

template <auto Member>
constexpr SettingsField integer(const char* id, Stage stage, int minimum, int maximum, const char* title,
                                const char* help)
{
    return {id,
            title,
            help,
            stage,
            SettingsField::Kind::Integer,
            {},
            minimum,
            maximum,
            getMember<Member>,
            setMember<Member>};
}

template <auto Member>
constexpr SettingsField flag(const char* id, Stage stage, const char* title, const char* help)
{
    return {id, title, help, stage, SettingsField::Kind::Flag, {}, 0, 1, getMember<Member>, setMember<Member>};
}

using S = Settings;

constexpr SettingsField kFields[] = {
    choice<&S::projection>(
        "projection", Stage::Clip, kProjections, QT_TRANSLATE_NOOP("Settings", "Projection"),
        QT_TRANSLATE_NOOP("Settings",
                          "Orthographic: w is 1 everywhere, distant things are as large as near ones, and what lies at "
                          "the camera's target keeps its size. A scene in clip space is projected already.")),
    choice<&S::clipping>("clipping", Stage::Clip, kClippings, QT_TRANSLATE_NOOP("Settings", "Clipping"),
                         QT_TRANSLATE_NOOP("Settings", "What happens to triangles that leave the view volume.")),
    choice<&S::clipZ>("clip-z", Stage::Clip, kClipZs, QT_TRANSLATE_NOOP("Settings", "Depth range in clip space"),
                      QT_TRANSLATE_NOOP("Settings", "The near plane is z = -w in OpenGL and z = 0 in Direct3D.")),
    flag<&S::reversedZ>(
        "reversed-z", Stage::Clip, QT_TRANSLATE_NOOP("Settings", "Reversed z"),
        QT_TRANSLATE_NOOP(
            "Settings",
            "The near plane maps to 1 and the far plane to 0, which spends float's precision where it is needed.")),
    integer<&S::subpixelBits>(
        "subpixel-bits", Stage::Screen, 0, 8, QT_TRANSLATE_NOOP("Settings", "Subpixel bits"),
        QT_TRANSLATE_NOOP("Settings", "Screen vertices snap to 1/2^bits of a pixel before anything is drawn.")),
    choice<&S::numberType>(
        "number-type", Stage::Screen, kNumberTypes, QT_TRANSLATE_NOOP("Settings", "Number type"),
        QT_TRANSLATE_NOOP("Settings", "The numbers that decide which pixels are covered. Fixed point is exact.")),
    choice<&S::culling>("culling", Stage::Cull, kCullings, QT_TRANSLATE_NOOP("Settings", "Culling"),
                        QT_TRANSLATE_NOOP("Settings", "Which faces are not drawn.")),
    choice<&S::winding>(
        "winding", Stage::Cull, kWindings, QT_TRANSLATE_NOOP("Settings", "Front faces wind"),
        QT_TRANSLATE_NOOP("Settings", "The order of the vertices of a face that looks at us, with y up.")),
    choice<&S::cullSpace>(
        "cull-space", Stage::Cull, kCullSpaces, QT_TRANSLATE_NOOP("Settings", "Facing decided by"),
        QT_TRANSLATE_NOOP("Settings",
                          "The sign that tells front from back: snapped screen area, det[x y w] before clipping, "
                          "or the normal against the gaze.")),
    choice<&S::fill>("fill", Stage::Cover, kFills, QT_TRANSLATE_NOOP("Settings", "Fill"),
                     QT_TRANSLATE_NOOP("Settings", "Whole triangles, their outlines, or their corners.")),
    choice<&S::algorithm>("algorithm", Stage::Cover, kAlgorithms, QT_TRANSLATE_NOOP("Settings", "Algorithm"),
                          QT_TRANSLATE_NOOP("Settings", "How the covered pixels of a triangle are found.")),
    choice<&S::stepping>(
        "stepping", Stage::Cover, kSteppings, QT_TRANSLATE_NOOP("Settings", "Stepping"),
        QT_TRANSLATE_NOOP("Settings",
                          "Add A per column and B per row, or evaluate the edge functions anew at every pixel.")),
    choice<&S::coverageRule>(
        "coverage-rule", Stage::Cover, kCoverageRules, QT_TRANSLATE_NOOP("Settings", "Pixel belongs if"),
        QT_TRANSLATE_NOOP("Settings", "What a triangle must do to have a pixel: hold its centre, touch its square "
                                      "(conservative), or hold the whole square (inner).")),
    choice<&S::tieRule>("tie-rule", Stage::Cover, kTieRules, QT_TRANSLATE_NOOP("Settings", "Tie rule"),
                        QT_TRANSLATE_NOOP("Settings", "Who owns a pixel centre that lies exactly on an edge.")),
    choice<&S::line>("line", Stage::Cover, kLines, QT_TRANSLATE_NOOP("Settings", "Lines"),
                     QT_TRANSLATE_NOOP("Settings", "How the lines of the wireframe are drawn.")),
    choice<&S::lineRule>(
        "line-rule", Stage::Cover, kLineRules, QT_TRANSLATE_NOOP("Settings", "Line rule"),
        QT_TRANSLATE_NOOP("Settings", "Which pixels belong to a line: from the pixel of its start to that of its end, "
                                      "the same without the last one, or those whose diamond it leaves.")),
    choice<&S::lineTies>(
        "line-ties", Stage::Cover, kLineTies, QT_TRANSLATE_NOOP("Settings", "Line ties"),
        QT_TRANSLATE_NOOP("Settings", "Where a line passes half-way between two pixels: the choice depends on which "
                                      "end is drawn first, or is one for both directions.")),
    choice<&S::sharedEdges>(
        "shared-edges", Stage::Cover, kSharedEdges, QT_TRANSLATE_NOOP("Settings", "Shared edges"),
        QT_TRANSLATE_NOOP("Settings", "The wireframe draws the edge between two faces once, or both faces draw it, one "
                                      "over the other.")),
    choice<&S::samples>(
        "samples", Stage::Cover, kSamples, QT_TRANSLATE_NOOP("Settings", "Samples a pixel"),
        QT_TRANSLATE_NOOP(
            "Settings",
            "Grids are super-sampling: every sample is shaded. MSAA also tests coverage and depth at every sample, at "
            "the positions of Direct3D and Vulkan, but shades a face only once a pixel. The mean of the samples is the "
            "pixel's colour.")),
    choice<&S::visibility>(
        "visibility", Stage::Depth, kVisibilities, QT_TRANSLATE_NOOP("Settings", "Visibility"),
        QT_TRANSLATE_NOOP(
            "Settings",
            "Who is in front: a depth for every pixel, faces sorted from far to near, or the order of the file.")),
    choice<&S::depthTest>(
        "depth-test", Stage::Depth, kDepthTests, QT_TRANSLATE_NOOP("Settings", "Depth test"),
        QT_TRANSLATE_NOOP("Settings", "A fragment is kept if its depth compares like this with the stored one.")),
    choice<&S::depthFormat>("depth-format", Stage::Depth, kDepthFormats, QT_TRANSLATE_NOOP("Settings", "Depth format"),
                            QT_TRANSLATE_NOOP("Settings", "The numbers the depth buffer stores.")),
    choice<&S::depthOrder>(
        "depth-order", Stage::Depth, kDepthOrders, QT_TRANSLATE_NOOP("Settings", "Depth test happens"),
        QT_TRANSLATE_NOOP("Settings",
                          "Testing before shading spares the work for hidden fragments; the picture is the same.")),
    choice<&S::interpolation>(
        "interpolation", Stage::Shade, kInterpolations, QT_TRANSLATE_NOOP("Settings", "Interpolation"),
        QT_TRANSLATE_NOOP("Settings",
                          "Attributes divided by w at every pixel, never, or at every 8th or 16th pixel of a span and "
                          "straight in between (edge, then span only).")),
    choice<&S::attributePath>(
        "attribute-path", Stage::Shade, kAttributePaths, QT_TRANSLATE_NOOP("Settings", "Attribute path"),
        QT_TRANSLATE_NOOP("Settings", "Barycentric weights at every pixel, or along the edges first and then along the "
                                      "span (edge walking only).")),
    choice<&S::attributeAt>(
        "attribute-at", Stage::Shade, kAttributesAt, QT_TRANSLATE_NOOP("Settings", "Attributes taken at"),
        QT_TRANSLATE_NOOP("Settings",
                          "MSAA: where attributes are evaluated. A face may cover samples but not the centre, and "
                          "then the centre's values lie outside of it; at every sample each is shaded.")),
    choice<&S::shading>("shading", Stage::Shade, kShadings, QT_TRANSLATE_NOOP("Settings", "Shading"),
                        QT_TRANSLATE_NOOP("Settings", "What colours a fragment.")),
    choice<&S::textureFilter>(
        "texture-filter", Stage::Shade, kTextureFilters, QT_TRANSLATE_NOOP("Settings", "Texture filter"),
        QT_TRANSLATE_NOOP("Settings",
                          "The nearest texel, a blend of the four around the point, or such blends in mipmaps: "
                          "smaller copies of the texture that keep distant patterns calm.")),
    choice<&S::alphaTest>(
        "alpha-test", Stage::Shade, kAlphaTests, QT_TRANSLATE_NOOP("Settings", "Alpha test"),
        QT_TRANSLATE_NOOP("Settings",
                          "Where a texture with transparency is less than half opaque, the face has a hole: nothing "
                          "is drawn there, and no depth is written. Textures without transparency have none.")),
    choice<&S::resolveLight>(
        "resolve", Stage::Image, kResolveLights, QT_TRANSLATE_NOOP("Settings", "Mean of the samples"),
        QT_TRANSLATE_NOOP("Settings",
                          "Samples are averaged as the numbers the display is sent (gamma), or as amounts of light.")),
    integer<&S::threads>(
        "threads", Stage::Image, 0, 256, QT_TRANSLATE_NOOP("Settings", "Threads"),
        QT_TRANSLATE_NOOP("Settings", "Threads of the tiled algorithm; 0 takes as many as the machine has.")),
    choice<&S::simd>("simd", Stage::Image, kSimds, QT_TRANSLATE_NOOP("Settings", "Vector instructions"),
                     QT_TRANSLATE_NOOP("Settings", "The instruction set of the tiled algorithm.")),
};

Reason valueList(const SettingsField& field)
{
    switch (field.kind) {
    case SettingsField::Kind::Flag: return QStringLiteral("true, false");
    case SettingsField::Kind::Integer:
        return {QT_TRANSLATE_NOOP("Diagnostic", "%1 to %2"), {field.minimum, field.maximum}};
    case SettingsField::Kind::Choice: break;
    }
    QStringList ids;
    for (const Choice& c : field.choices)
        ids << QString::fromLatin1(c.id);
    return ids.join(QStringLiteral(", "));
}

} // namespace

std::span<const SettingsField> settingsFields() { return kFields; }

const SettingsField* findSettingsField(const QString& id)
{
    for (const SettingsField& field : kFields)
        if (id == QLatin1String(field.id))
            return &field;
    return nullptr;
}

QString valueId(const SettingsField& field, const Settings& settings)
{
    const int value = field.get(settings);
    switch (field.kind) {
    case SettingsField::Kind::Flag: return value != 0 ? QStringLiteral("true") : QStringLiteral("false");
    case SettingsField::Kind::Integer: return QString::number(value);
    case SettingsField::Kind::Choice: break;
    }
    return QString::fromLatin1(field.choices[static_cast<std::size_t>(value)].id);
}

std::optional<Reason> setFromText(const SettingsField& field, const QString& text, Settings& settings)
{
    bool good = false;
    int value = 0;
    switch (field.kind) {
    case SettingsField::Kind::Integer: value = text.toInt(&good); break;
    case SettingsField::Kind::Flag:
        value = text == QLatin1String("true") ? 1 : 0;
        good = value == 1 || text == QLatin1String("false");
        break;
    case SettingsField::Kind::Choice:
        for (std::size_t i = 0; i < field.choices.size(); ++i)
            if (text == QLatin1String(field.choices[i].id)) {
                value = static_cast<int>(i);
                good = true;
            }
    }
    if (!good || value < field.minimum || value > field.maximum)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" is not a value of %2, which takes: %3"),
                      {text, QString::fromLatin1(field.id), valueList(field)});
    field.set(settings, value);
    return std::nullopt;
}

} // namespace rasterlens
