#pragma once
#include "core/base/reason.h"

#include <QJsonObject>
#include <QSize>
#include <QString>
#include <QStringList>
#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

namespace rasterlens
{

// The choices a user has. The order of the enumerators is the order of the choices in the field table (settings.cpp).
enum class Algorithm { EdgeEquation, EdgeWalking, Tiled, ColumnFill };
enum class NumberType { Fixed, Float32, Float64 };
enum class Stepping { Incremental, Direct };
enum class Fill { Solid, Wireframe, Points };
enum class LineAlgorithm { Bresenham, Dda };
enum class LineRule { Inclusive, HalfOpen, DiamondExit };
enum class LineTies { ByDirection, Canonical };
enum class SharedEdges { Once, EachFace };
enum class Clipping { Frustum, FrustumW, GuardBand, DepthClamp, AnyVertexInside, NearFarReject, CohenSutherland, None };
enum class Culling { Back, Front, None };
enum class Winding { CounterClockwise, Clockwise };
enum class CullSpace { Screen, Clip, View };
enum class DepthTest { Less, LessEqual, Equal, GreaterEqual, Greater, NotEqual, Always, None };
enum class DepthFormat { Float32, Unorm24, Unorm16, Unorm8 };
enum class DepthOrder { BeforeShading, AfterShading };
enum class ClipZ { Gl, D3d };
enum class Projection { Perspective, Orthographic };
enum class Visibility { ZBuffer, Painter, SubmissionOrder };
enum class Interpolation { Perspective, Affine, Every8, Every16 };
enum class AttributePath { Planes, EdgeThenSpan };
enum class CoverageRule { Centre, Conservative, Inner };
enum class TieRule { TopLeft, Inclusive, Exclusive };
enum class Samples { One, Grid2, Grid3, Grid4, Msaa2, Msaa4, Msaa8, Msaa16 };
enum class AttributeAt { Centre, Centroid, Sample };
enum class ResolveLight { Gamma, Linear };
enum class Shading { Gouraud, Flat, RandomFlat, Texture, Phong, Depth, Normals, Uv, Overdraw, TriangleId, MipLevel };
enum class TextureFilter { Nearest, Bilinear, Trilinear };
enum class AlphaTest { On, Off };
enum class Simd { Auto, Scalar, Sse4, Avx2, Avx512, Neon };

/// Pixels [x, x + width) x [y, y + height), origin top left.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Where the camera is. `fit` frames the scene's bounding sphere; otherwise eye, target and up are used as they are.
struct View {
    bool fit = true;
    double yaw = 0;             ///< fit: degrees the eye goes round the world's y axis
    double pitch = 0;           ///< fit: degrees the eye rises, -90..90
    double distance = 1;        ///< fit: factor on the distance at which the sphere touches the frustum, > 0
    glm::dvec2 pan{0, 0};       ///< fit: target moves right and up, in bounding-sphere radii
    glm::dvec3 eye{0, 0, 3};    ///< world space
    glm::dvec3 target{0, 0, 0}; ///< world space
    glm::dvec3 up{0, 1, 0};     ///< world space
    double fov = 45;            ///< full vertical angle, degrees, 0 < fov < 180
    std::optional<double> near; ///< distance > 0; empty: from the bounding sphere
    std::optional<double> far;  ///< distance > near; empty: from the bounding sphere

    friend bool operator==(const View&, const View&) = default;
};

/// Where the light comes from; it is the same direction everywhere.
struct Light {
    /// Towards the light, world space, any length but 0; empty: the headlight, which shines along the camera's view.
    std::optional<glm::dvec3> towards = glm::dvec3(0.3, 0.5, 1);

    [[nodiscard]] bool isHead() const { return !towards; }
    friend bool operator==(const Light&, const Light&) = default;
};

/// What is added to the depths of a face before they are interpolated: the constant times the unit of the depth format,
/// and the slope times the steepness of the face (core/pipeline/depth_bias.h).
struct DepthBias {
    double constant = 0;
    double slope = 0;
    double clamp = 0; ///< > 0: the sum is no more than this; < 0: no less; 0: not clamped

    [[nodiscard]] bool isOn() const { return constant != 0 || slope != 0; }
    friend bool operator==(const DepthBias&, const DepthBias&) = default;
};

/// The depths that near and far plane are mapped to, 0..1 each; far may be the smaller one, or both may be equal.
struct DepthRange {
    double near = 0;
    double far = 1;

    [[nodiscard]] bool isWhole() const { return near == 0 && far == 1; }
    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

/// The value a user edits. Default-constructed = correct graphics.
/// A lesson, a command-line run, a benchmark row, a test case and an undo step are each one Settings.
struct Settings {
    QSize size{1920, 1080}; ///< viewport in pixels, 1..16384 each
    View view;
    Light light;
    Projection projection = Projection::Perspective; ///< of the camera; a scene in clip space has none
    Algorithm algorithm = Algorithm::EdgeEquation;
    NumberType numberType = NumberType::Fixed;
    int subpixelBits = 8; ///< 0..8
    Stepping stepping = Stepping::Incremental;
    Fill fill = Fill::Solid;
    LineAlgorithm line = LineAlgorithm::Bresenham;
    LineRule lineRule = LineRule::Inclusive;
    LineTies lineTies = LineTies::ByDirection;
    SharedEdges sharedEdges = SharedEdges::Once;
    Clipping clipping = Clipping::Frustum;
    Culling culling = Culling::Back;
    Winding winding = Winding::CounterClockwise;
    CullSpace cullSpace = CullSpace::Screen;
    DepthTest depthTest = DepthTest::Less;
    DepthFormat depthFormat = DepthFormat::Float32;
    DepthOrder depthOrder = DepthOrder::BeforeShading;
    DepthBias depthBias;
    DepthRange depthRange;
    bool reversedZ = false;
    ClipZ clipZ = ClipZ::Gl;
    Visibility visibility = Visibility::ZBuffer;
    Interpolation interpolation = Interpolation::Perspective;
    AttributePath attributePath = AttributePath::Planes;
    CoverageRule coverageRule = CoverageRule::Centre;
    TieRule tieRule = TieRule::TopLeft;
    Samples samples = Samples::One;
    AttributeAt attributeAt = AttributeAt::Centre; ///< multi-sampling only
    ResolveLight resolveLight = ResolveLight::Gamma;
    Shading shading = Shading::Gouraud;
    TextureFilter textureFilter = TextureFilter::Nearest;
    AlphaTest alphaTest = AlphaTest::On;
    Simd simd = Simd::Auto;
    int threads = 0;      ///< 0 = as many as the machine has
    QStringList mistakes; ///< ids of the mistake table, each once, in the order they were switched on

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// One value a field may take.
struct Choice {
    const char* id;    ///< stable: command line, JSON
    const char* title; ///< QT_TRANSLATE_NOOP("Settings", ...)
};

/// What the pipeline panel groups by, in pipeline order.
enum class Stage { Scene, Clip, Screen, Cull, Cover, Depth, Shade, Image };

/// One row of the field table: drives JSON, command line, panel, tool-tips and tests.
/// A value is the index into `choices`, the number itself, or 0 / 1 for a flag.
struct SettingsField {
    enum class Kind { Choice, Integer, Flag };

    const char* id;    ///< JSON key and option name without the dashes
    const char* title; ///< QT_TRANSLATE_NOOP("Settings", ...)
    const char* help;  ///< one sentence, QT_TRANSLATE_NOOP("Settings", ...)
    Stage stage;
    Kind kind;
    std::span<const Choice> choices; ///< Kind::Choice only
    int minimum;
    int maximum;
    int (*get)(const Settings&);
    void (*set)(Settings&, int); ///< in: minimum <= value <= maximum
};

/// Every field but size, view, light, mistakes and those of numbers_field.h, in pipeline order.
[[nodiscard]] std::span<const SettingsField> settingsFields();
[[nodiscard]] const SettingsField* findSettingsField(const QString& id);

/// The id of the present value: `top-left`, `8`, `true`.
[[nodiscard]] QString valueId(const SettingsField& field, const Settings& settings);

/// Sets a field from text.
///
/// errors  names the field and the values it takes, a text of the context "Diagnostic"; `settings` is then unchanged
[[nodiscard]] std::optional<Reason> setFromText(const SettingsField& field, const QString& text, Settings& settings);

/// All fields, also those at their default. `size` is "WxH", `view` an object, `light` "head" or three
/// numbers, `mistakes` an array, the fields of numbers_field.h arrays of numbers.
[[nodiscard]] QJsonObject toJson(const Settings& settings);

/// Reads what toJson writes; keys that are absent keep the value of `base`.
///
/// errors  texts of the context "Diagnostic" (unknown key, value of the wrong kind or out of range); the result is then
///         `base`
struct SettingsParse {
    Settings settings;
    std::vector<Reason> errors;
};
[[nodiscard]] SettingsParse settingsFromJson(const QJsonObject& json, const Settings& base = {});

/// "WIDTHxHEIGHT" with 1..16384 each, or nothing.
[[nodiscard]] std::optional<QSize> parseSize(const QString& text);

/// "head", or three numbers x,y,z that are not all 0, or nothing.
[[nodiscard]] std::optional<Light> parseLight(const QString& text);

/// The text that parseLight() reads.
[[nodiscard]] QString lightText(const Light& light);

/// The side of the sample grid: 1, 2, 3 or 4; 1 for multi-sampling, whose samples lie on no grid.
[[nodiscard]] constexpr int sampleGrid(Samples samples)
{
    return samples < Samples::Msaa2 ? static_cast<int>(samples) + 1 : 1;
}

/// How many samples the pattern of multi-sampling has: 2, 4, 8 or 16; 1 where there is none.
[[nodiscard]] constexpr int patternSamples(Samples samples)
{
    return samples < Samples::Msaa2 ? 1 : 2 << (static_cast<int>(samples) - static_cast<int>(Samples::Msaa2));
}

/// How many samples a pixel has, on a grid or in a pattern.
[[nodiscard]] constexpr int samplesPerPixel(Samples samples)
{
    return sampleGrid(samples) * sampleGrid(samples) * patternSamples(samples);
}

/// How many samples of a span share a division by w: 1, 8 or 16. Between two divisions attributes run straight.
[[nodiscard]] constexpr int dividedEvery(Interpolation interpolation)
{
    switch (interpolation) {
    case Interpolation::Every8: return 8;
    case Interpolation::Every16: return 16;
    case Interpolation::Perspective:
    case Interpolation::Affine: break;
    }
    return 1;
}

constexpr int kMaxViewport = 16384;

} // namespace rasterlens
