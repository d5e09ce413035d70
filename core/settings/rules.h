#pragma once
#include "core/settings/settings.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace rasterlens
{

enum class DepthCompare { Less, LessEqual, Equal, GreaterEqual, Greater, NotEqual, Always };

// The first enumerator of each of these is the right one; the others are for mistakes or for settings.

/// What decides which way a face looks.
enum class Facing {
    ScreenArea,          ///< snapped area of what clipping left
    ClipDeterminant,     ///< det[x y w] before clipping
    ViewNormal,          ///< normal against gaze
    LightNormal,         ///< normal against the light
    AreaWithoutDivide,   ///< area of x and y in clip space, as if all w were the same
    AreaWithoutClipping, ///< area after the divide of the whole triangle, also where w <= 0
};

/// What interpolation is told of a vertex's w.
enum class KeptW {
    Inverse, ///< 1 / w
    One,     ///< w has been lost in the divide
    Itself,  ///< w, as if the near end weighed least
};

/// Whose depth, w and varyings a corner of a triangle is given.
enum class CornerData {
    Own,
    Next,      ///< those of the corner that follows it
    Exchanged, ///< B has those of C, C those of B
    Unsorted,  ///< positions are sorted by y, and only they
};

/// When a sample counts as inside by its three edge values.
enum class InsideTest {
    AllPositive,
    EitherSign, ///< also all negative, with the same thresholds
    Wrapped32,  ///< edge values are kept in 32 bits of whole pixel areas, which wrap around
    Wrapped16,  ///< edge values are kept in 16 bits of whole pixel areas
    None,       ///< every sample of the bounding box is
};

/// The bounding box samples are looked for in.
enum class Bounds {
    Clamped,   ///< to the target
    Unclamped, ///< columns beyond the target fall into the neighbouring rows of memory
    OneShort,  ///< without the last column and the last row
};

/// How a line makes its way.
enum class LineAdvance {
    LongerAxis, ///< one sample each step along the longer axis
    Columns,    ///< a column at a time, with dy/dx rows in each
    OneRow,     ///< a column at a time, with one row in each
};

/// What the box filter takes the mean of.
enum class Resolve {
    AllSamples,
    LastFace, ///< the samples of the face drawn last in the pixel; the others are black
};

/// Where the camera is moved to the origin from.
enum class ViewOrigin {
    Eye,
    Target, ///< what is looked at
};

/// How the view is put together from the camera's axes and its place.
enum class ViewOrder {
    TranslatedFirst, ///< R * T(-eye)
    RotatedFirst,    ///< T(-eye) * R
};

/// How the camera's matrices are made.
struct CameraRules {
    ViewOrigin origin = ViewOrigin::Eye;
    ViewOrder order = ViewOrder::TranslatedFirst;
    bool axesAreRows = true; ///< false: the rotation turns the other way, from the camera's axes to the world's
    double nearSign = 1;     ///< of near in the rows of x and y of the projection
    friend bool operator==(const CameraRules&, const CameraRules&) = default;
};

/// How a face is told to lie beside the screen as a whole.
enum class RejectBy {
    Planes,     ///< all corners outside of one plane, before the divide
    DividedBox, ///< the box of x / w and y / w, whatever the signs of w
};

/// Where new corners of a cut polygon are written.
enum class CutStore {
    OwnSlots,
    InPlace,      ///< over the corner outside, which the second cut at it is then made from
    LastUnwritten ///< the slot of the last corner is never written: it lies at (0, 0)
};

/// Which sample holds a point.
enum class GridRounding {
    Floor,
    TowardsZero, ///< (int): samples -1 and 0 of an axis fall together
};

/// Where texture coordinates come from.
enum class UvSource {
    Corners,
    Screen, ///< the sample's place on the screen, 0..1
};

/// What the mip level is made of.
enum class LevelSource {
    Sample,        ///< the derivatives at the sample
    Face,          ///< those in the middle of the triangle, for all of it
    WrappedSample, ///< differences of neighbours after whole numbers are taken off
};

/// How coordinates become texels.
struct TexelRules {
    UvSource uv = UvSource::Corners;
    bool vUp = true;     ///< row 0 of a texture lies at v = 0; false: the last one does
    double centre = 0.5; ///< texels from the corner of a texel to its centre (bilinear, trilinear)
    bool floored = true; ///< false: fractions are cut off towards 0 (nearest)
    LevelSource level = LevelSource::Sample;
    float levelsPerDoubling = 1; ///< how much the mip level rises where the step doubles
    friend bool operator==(const TexelRules&, const TexelRules&) = default;
};

/// What directions are carried through besides the rotation.
struct NormalRules {
    bool squashed = false;  ///< by the matrix of positions, which stretched the mesh: Scene::stretch
    bool moved = false;     ///< with w = 1: the camera's place is taken off
    bool normalized = true; ///< brought to length 1 again at every fragment (phong)
    friend bool operator==(const NormalRules&, const NormalRules&) = default;
};

/// What the stages read: Settings resolved into numbers and enumerations. Default-constructed = correct graphics.
/// A mistake sets a field to a wrong value. Some fields exist for mistakes only; stages read the field, and never ask
/// which mistakes are on.
struct Rules {
    // Vertex stage and shading
    Shading shading = Shading::Gouraud;
    TextureFilter textureFilter = TextureFilter::Nearest;
    bool lit = true;
    /// Towards the light, world space, unit length. What stands here is normalize(0.3, 0.5, 1).
    glm::vec3 light{0.259160519F, 0.431934208F, 0.863868415F};
    bool orthographic = false;   ///< all look along one direction, and w is 1: there is no distance in it
    glm::vec3 toViewer{0, 0, 1}; ///< orthographic: from everywhere towards the eye, world space, unit length
    glm::vec3 eye{0};            ///< world space
    glm::vec3 stretch{1};        ///< Scene::stretch
    CameraRules camera;
    NormalRules normals;
    TexelRules texels;
    bool colorsClamped = true; ///< phong: light beyond 1 is 1; false: it begins again at 0
    int varyingCount = 3;      ///< floats a vertex hands to the fragments; what no shader reads is not carried
    int maskUv = -1;           ///< where among them the coordinates of masks are; -1: no face is tested against a mask
    bool mirrorClipZ = false;  ///< reversed z for a scene that brings its own clip coordinates
    bool reversedZ = false;    ///< z of clip space falls with the distance

    // Clipping
    Clipping clipping = Clipping::Frustum;
    ClipZ clipZ = ClipZ::Gl;
    double clipInset = 0;         ///< Cohen-Sutherland: pixels by which new vertices are moved inward
    bool clipKeepsCorners = true; ///< Cohen-Sutherland: corners of the viewport inside the polygon join it
    RejectBy rejectBy = RejectBy::Planes;
    CutStore cutStore = CutStore::OwnSlots;
    bool clipInterpolates = true;     ///< false: new corners have the attributes of the corner outside
    bool clipUpdatesW = true;         ///< false: the pieces of a cut face are given the w of its three vertices
    bool continuesAfterReject = true; ///< false: the first rejected face ends the frame

    // Viewport
    int width = 0;      ///< pixels
    int height = 0;     ///< pixels
    int sampleGrid = 1; ///< samples a pixel along each axis
    /// Multi-sampling: samples a pixel at the positions of the standard pattern (sample_pattern.h); else 1. A sample of
    /// a pattern is drawn as a frame of one sample a pixel, and the frames are stored one after the other.
    int patternSamples = 1;
    NumberType numberType = NumberType::Fixed;
    int subpixelBits = 8;           ///< fixed point only: vertices snap to 1/2^bits pixel
    double screenUp = -1;           ///< which way y of the screen runs while y of NDC runs up
    double screenShift = 0;         ///< samples that positions are moved right and down
    int viewportShort = 0;          ///< pixels by which the viewport is narrower and lower than the picture
    bool rowsRounded = false;       ///< y of the screen is rounded to whole rows, and only y
    bool verticesTruncated = false; ///< positions on the screen lose their fraction
    KeptW keptW = KeptW::Inverse;

    // Culling
    Culling culling = Culling::Back;
    Facing facing = Facing::ScreenArea;
    double frontSign = 1;        ///< +1: counter-clockwise with y up is front, -1: clockwise
    bool rejectsZeroArea = true; ///< false: faces without area go on to coverage
    double smallestArea2 = 0;    ///< faces with less than this twice the area, in samples, are dropped

    // Coverage
    Algorithm algorithm = Algorithm::EdgeEquation;
    Stepping stepping = Stepping::Incremental;
    Fill fill = Fill::Solid;
    LineAlgorithm line = LineAlgorithm::Bresenham;
    LineRule lineRule = LineRule::Inclusive;
    bool lineTiesByDirection = true; ///< false: a line from B to A has the samples of that from A to B
    bool sharedEdgesOnce = true;     ///< wireframe: an edge of several faces is drawn by one of them
    /// Mesh::lines: faces that are lines, whatever the fill. Null: there are none.
    std::shared_ptr<const std::vector<std::uint32_t>> lineFaces;
    LineAdvance lineAdvance = LineAdvance::LongerAxis;
    unsigned lineOctants = 0xff; ///< the octants lines are drawn in, bit 0: 0 to 45 degrees, counter-clockwise
    bool rightLineEnds = true;   ///< lines include their right end
    GridRounding gridRounding = GridRounding::Floor;
    bool integerLineWeights = false; ///< i / n is divided in integers
    CoverageRule coverageRule = CoverageRule::Centre;
    /// The smallest edge value that counts as inside, in units of the last place: for an edge that owns its points and
    /// for one that does not. Top-left {0, 1}, inclusive {0, 0}, exclusive {1, 1}.
    struct TieThresholds {
        int owner = 0;
        int other = 1;
    } tie;
    double floatTieUnit = 0; ///< what a unit of the thresholds is in float32 and float64; 0: the smallest number
    InsideTest insideTest = InsideTest::AllPositive;
    bool triangleOriented = true;  ///< clockwise triangles are turned round before the edge functions are set up
    bool samplesTruncated = false; ///< all samples of a pixel are tested at the pixel's corner
    Bounds bounds = Bounds::Clamped;
    bool edgesPreStepped = true; ///< edge walking: edges begin where they cross the first row; false: at their corner
    bool spanEndsSorted = true;  ///< edge walking: false: the long edge is taken for the left one
    int extraEdgeHeight = 0;     ///< edge walking: rows by which edges are taken to be higher than they are
    bool wholeRows = false; ///< edge walking: rows at whole heights, filled between whole columns, both ends included

    // Depth
    bool painter = false;    ///< faces from far to near
    bool depthTested = true; ///< false: every fragment passes, and depth is kept only if someone asks for it
    DepthCompare depthCompare = DepthCompare::Less;
    float depthClear = 1;
    DepthFormat depthFormat = DepthFormat::Float32;
    DepthRange depthRange; ///< depths that are stored are held within it
    DepthBias depthBias;   ///< of the faces that are not of a first pass
    /// The faces before this one are the first pass of two: filled, the nearer ones win, and nothing biases them. 0:
    /// there is one pass.
    std::uint32_t firstPassFaces = 0;
    bool depthBeforeShading = true;
    bool depthWrittenOnFail = false; ///< the depth of a fragment is stored even if it is not drawn
    bool depthPerPixel = false;      ///< the samples of a pixel share one depth
    bool depthTruncated = false;     ///< unorm formats store the code below in place of the nearest one
    bool depthInLockstep = false;    ///< faces 2k and 2k + 1 are both tested before either is written
    bool depthIsDistance = false;    ///< depth is (w - near) / (far - near): linear in view space, not on the screen
    bool depthLinear = true;         ///< false: depth goes through the perspective correction of attributes

    // Interpolation
    bool perspectiveCorrect = true;
    int dividedEvery = 1; ///< edge-then-span: samples of a span that share a division by w; 1: each has its own
    AttributePath attributePath = AttributePath::Planes;
    CornerData cornerData = CornerData::Own;
    double weightUnit = 0; ///< depth: each of the three weights is rounded to multiples of it by itself; 0: none is
    AttributeAt attributeAt = AttributeAt::Centre; ///< multi-sampling: where a pixel of a face is shaded
    /// Multi-sampling: derivatives are taken for differences to the neighbours in blocks of 2 x 2 pixels, as if all
    /// were shaded a pixel apart.
    bool gradientByNeighbours = false;

    // Image
    bool positionInterpolated = false; ///< the fragment's place is interpolated as an attribute, and truncated
    bool strideIsRows = false;         ///< samples are stored as if a row of them had rows() samples
    Resolve resolve = Resolve::AllSamples;
    ResolveLight resolveLight = ResolveLight::Gamma;
    bool resolvedByFace = false; ///< multi-sampling: after each face the samples of its pixels are given their mean

    /// Whether the centres of samples decide what a triangle covers. Lines, corners and column fill go by the grid
    /// points of the corners.
    [[nodiscard]] bool coversByCentres() const { return fill == Fill::Solid && algorithm != Algorithm::ColumnFill; }
    [[nodiscard]] int columns() const { return width * sampleGrid; } ///< samples; pixels with a pattern
    [[nodiscard]] int rows() const { return height * sampleGrid; }   ///< samples; pixels with a pattern
    [[nodiscard]] bool multiSampled() const { return patternSamples > 1; }
    [[nodiscard]] int samplesPerPixel() const { return sampleGrid * sampleGrid * patternSamples; }
};

} // namespace rasterlens
