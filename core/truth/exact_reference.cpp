#include "core/truth/exact_reference.h"

#include "core/camera.h"
#include "core/pipeline/vertex_stage.h"
#include "core/truth/edge_distance.h"
#include "core/truth/exact_geometry.h"

#include <QRect>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace rasterlens
{

using namespace exact;

namespace
{

/// One triangle to interpolate over: three weights that are >= 0 inside and as the perspective-correct ones to each
/// other.
struct Piece {
    std::array<Linear, 3> weights;
    Linear depthNumerator;
    Integer depthDenominator; // > 0
    std::array<glm::dvec3, 3> colors;
    std::int32_t face;
};

Piece makePiece(const std::array<ScreenCorner, 3>& t, const Integer& det, const ExactOptions& options,
                std::int64_t unit, std::int32_t face)
{
    const Integer sign = det.sign();
    Piece piece{};
    piece.face = face;
    piece.depthDenominator = det * sign;
    for (std::size_t i = 0; i < 3; ++i) {
        piece.weights[i] = determinantWith(t[(i + 1) % 3], t[(i + 2) % 3], unit) * sign;
        piece.depthNumerator = piece.depthNumerator + piece.weights[i] * t[i].z;
        piece.weights[i] = piece.weights[i] * t[i].scale;
        piece.colors[i] = t[i].color;
    }
    if (options.clipZ == ClipZ::Gl) {
        piece.depthNumerator.origin += piece.depthDenominator;
        piece.depthDenominator *= 2;
    }
    return piece;
}

/// Depth and colour along one row of a piece. Every weight is a sum of two terms >= 0, so none cancels.
class RowValues
{
public:
    RowValues(const Piece& piece, int row, Columns columns) : m_piece(piece), m_columns(columns)
    {
        const int last = columns.end - 1;
        std::array<Scaled, 3> starts;
        std::array<Scaled, 3> steps;
        int base = std::numeric_limits<int>::min();
        for (std::size_t i = 0; i < 3; ++i) {
            const Linear& weight = piece.weights[i];
            m_rising[i] = weight.perColumn.sign() >= 0;
            starts[i] = scaled(weight.at(m_rising[i] ? columns.begin : last, row));
            steps[i] = scaled(boost::multiprecision::abs(weight.perColumn));
            base = std::max({base, starts[i].exponent, steps[i].exponent});
        }
        for (std::size_t i = 0; i < 3; ++i) {
            m_starts[i] = starts[i].value(base);
            m_steps[i] = steps[i].value(base);
        }
        m_depthFirst = ratio(piece.depthNumerator.at(columns.begin, row), piece.depthDenominator);
        const double depthLast = ratio(piece.depthNumerator.at(last, row), piece.depthDenominator);
        m_depthStep = last > columns.begin ? (depthLast - m_depthFirst) / (last - columns.begin) : 0;
    }

    [[nodiscard]] double depth(int column) const { return m_depthFirst + m_depthStep * (column - m_columns.begin); }

    [[nodiscard]] glm::dvec3 color(int column) const
    {
        glm::dvec3 sum{0};
        double total = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int steps = m_rising[i] ? column - m_columns.begin : m_columns.end - 1 - column;
            const double weight = m_starts[i] + m_steps[i] * steps;
            sum += weight * m_piece.colors[i];
            total += weight;
        }
        return sum / total;
    }

private:
    const Piece& m_piece;
    Columns m_columns;
    std::array<bool, 3> m_rising{};
    std::array<double, 3> m_starts{};
    std::array<double, 3> m_steps{};
    double m_depthFirst = 0;
    double m_depthStep = 0;
};

/// The depth buffer: a double in front, the piece it came from behind it for the exact comparison.
class DepthBuffer
{
public:
    DepthBuffer(const ExactOptions& options, ExactFrame& frame)
        : m_compare(options.depthCompare), m_clear(options.depthClear > 0 ? 1 : 0), m_owners(frame.cover.size(), -1),
          m_frame(frame)
    {
        if (options.depthFormat != DepthFormat::Float32)
            m_codeMax = options.depthFormat == DepthFormat::Unorm16 ? 0xffff : 0xffffff;
        std::fill(frame.depth.begin(), frame.depth.end(), m_clear);
    }

    int addPiece(Piece piece)
    {
        m_pieces.push_back(std::move(piece));
        return static_cast<int>(m_pieces.size()) - 1;
    }
    void dropLastPiece() { m_pieces.pop_back(); }
    [[nodiscard]] const Piece& piece(int index) const { return m_pieces[static_cast<std::size_t>(index)]; }

    /// Compares and, when the fragment passes, stores.
    bool test(std::size_t sample, int pieceIndex, int column, int row, double depth)
    {
        const double value = m_codeMax > 0 ? code(pieceIndex, column, row, depth) / m_codeMax : depth;
        if (!passes(sample, pieceIndex, column, row, value))
            return false;
        m_frame.depth[sample] = value;
        m_owners[sample] = pieceIndex;
        return true;
    }

private:
    bool passes(std::size_t sample, int pieceIndex, int column, int row, double value) const
    {
        if (m_compare == DepthCompare::Always)
            return true;
        const int order = compare(sample, pieceIndex, column, row, value);
        switch (m_compare) {
        case DepthCompare::Less: return order < 0;
        case DepthCompare::LessEqual: return order <= 0;
        case DepthCompare::Greater: return order > 0;
        case DepthCompare::GreaterEqual: return order >= 0;
        case DepthCompare::Always: break;
        }
        return true;
    }

    /// The sign of new - stored.
    int compare(std::size_t sample, int pieceIndex, int column, int row, double value) const
    {
        constexpr double kFilter = 1e-14;
        const double difference = value - m_frame.depth[sample];
        if (m_codeMax > 0 || std::abs(difference) > kFilter)
            return (difference > 0) - (difference < 0);
        const int owner = m_owners[sample];
        const Piece& mine = piece(pieceIndex);
        const Integer numerator = mine.depthNumerator.at(column, row);
        if (owner < 0)
            return numerator.compare(mine.depthDenominator * m_clear);
        const Piece& stored = piece(owner);
        return Integer(numerator * stored.depthDenominator)
            .compare(Integer(stored.depthNumerator.at(column, row) * mine.depthDenominator));
    }

    /// The nearest unorm code, half to even.
    double code(int pieceIndex, int column, int row, double depth) const
    {
        constexpr double kFilter = 1e-6;
        const double above = depth * m_codeMax - std::floor(depth * m_codeMax);
        if (std::abs(above - 0.5) > kFilter)
            return std::round(depth * m_codeMax);
        const Piece& p = piece(pieceIndex);
        const Integer numerator = p.depthNumerator.at(column, row) * m_codeMax;
        return static_cast<double>(static_cast<std::int64_t>(roundHalfToEven(numerator, p.depthDenominator)));
    }

    DepthCompare m_compare;
    int m_clear;
    int m_codeMax = 0; // 0: exact depths
    std::vector<int> m_owners;
    std::vector<Piece> m_pieces;
    ExactFrame& m_frame;
};

/// Samples of the window, as columns and rows of the whole viewport.
struct SampleWindow {
    Columns columns;
    Columns rows;
};

/// Draws one face after the other into the frame.
class Painter
{
public:
    Painter(const ExactOptions& options, ExactFrame& frame)
        : m_options(options), m_frame(frame), m_depth(options, frame)
    {
        const int bits = options.snap ? options.subpixelBits : 0;
        m_lattice = {options.size, options.sampleGrid, std::int64_t{1} << bits};
        const PixelRect& w = frame.window;
        const int n = options.sampleGrid;
        m_window = {{w.x * n, (w.x + w.width) * n}, {w.y * n, (w.y + w.height) * n}};
    }

    void draw(const ClipTriangle& triangle)
    {
        const std::array<Corner, 3> corners = integerCorners(triangle);
        if (m_options.snap)
            drawSnapped(triangle, corners);
        else
            drawUnsnapped(triangle, corners);
    }

private:
    /// Counts and refuses what culling or a zero area removes. The sign is that of the area on the screen, y down.
    bool refused(int areaSign)
    {
        if (areaSign == 0) {
            ++m_frame.degenerate;
            return true;
        }
        m_frame.culled += culls(areaSign);
        return culls(areaSign);
    }

    [[nodiscard]] bool culls(int areaSign) const
    {
        const bool counterClockwise = areaSign < 0;
        const bool front = counterClockwise == (m_options.winding == Winding::CounterClockwise);
        return m_options.culling == (front ? Culling::Front : Culling::Back);
    }

    static bool hasArea(const std::vector<ScreenCorner>& polygon)
    {
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            if (determinant({polygon[0], polygon[i], polygon[i + 1]}).sign() != 0)
                return true;
        return false;
    }

    void drawUnsnapped(const ClipTriangle& triangle, const std::array<Corner, 3>& corners)
    {
        std::array<ScreenCorner, 3> screen;
        for (std::size_t i = 0; i < 3; ++i)
            screen[i] = toScreen(corners[i], triangle, m_lattice);
        const Integer det = determinant(screen);
        if (refused(det.sign()))
            return;
        if (m_options.edgeDistance)
            noteEdges(screenPolygon(clipExactly(corners, m_options.clipZ), triangle));
        Piece piece = makePiece(screen, det, m_options, m_lattice.unit, static_cast<std::int32_t>(triangle.face));
        const Linear nearSide = piece.depthNumerator;
        Linear farSide = nearSide * Integer(-1);
        farSide.origin += piece.depthDenominator;

        const int index = m_depth.addPiece(std::move(piece));
        bool owns = false;
        const Columns rows = rowsOf(screen);
        for (int row = rows.begin; row < rows.end; ++row) {
            Columns columns = m_window.columns;
            for (const Linear& weight : m_depth.piece(index).weights)
                if (!columns.empty())
                    keepPositive(weight, row, columns);
            if (!columns.empty())
                keepPositive(nearSide, row, columns);
            if (!columns.empty())
                keepPositive(farSide, row, columns);
            owns |= drawColumns(index, row, columns);
        }
        if (!owns)
            m_depth.dropLastPiece();
    }

    /// Rows the face may touch; all of them when it reaches behind the eye.
    [[nodiscard]] Columns rowsOf(const std::array<ScreenCorner, 3>& screen) const
    {
        Columns rows{m_window.rows.end, m_window.rows.begin};
        for (const ScreenCorner& corner : screen) {
            if (corner.w.sign() <= 0)
                return m_window.rows;
            const Integer row = floorDivide(corner.y, corner.w * (2 * m_lattice.unit));
            rows.begin = std::min(rows.begin, clampedTo(m_window.rows, Integer(row - 1)));
            rows.end = std::max(rows.end, clampedTo(m_window.rows, Integer(row + 1)));
        }
        return rows;
    }

    void drawSnapped(const ClipTriangle& triangle, const std::array<Corner, 3>& corners)
    {
        const std::vector<Corner> clipped = clipExactly(corners, m_options.clipZ);
        if (clipped.empty()) {
            ++m_frame.outside;
            return;
        }
        m_frame.maxClipVertices = std::max(m_frame.maxClipVertices, static_cast<int>(clipped.size()));
        std::vector<ScreenCorner> screen = screenPolygon(clipped, triangle);
        // only (0, 0, 0, 0) is inside all planes with w = 0: the face is seen edge-on
        const auto atEye = [](const ScreenCorner& corner) { return corner.w.sign() == 0; };
        if (std::any_of(screen.begin(), screen.end(), atEye)) {
            ++m_frame.degenerate;
            return;
        }
        const std::vector<ScreenCorner> unsnapped = screen;
        std::vector<Snapped> polygon;
        for (ScreenCorner& corner : screen)
            polygon.push_back(snap(corner, m_lattice));
        const std::int64_t area = doubledArea(polygon);
        const int sign = (area > 0) - (area < 0);
        // a face whose area vanishes on snapping still has true edges
        if (m_options.edgeDistance && (sign != 0 ? !culls(sign) : hasArea(unsnapped)))
            noteEdges(unsnapped);
        if (refused(sign))
            return;
        if (isFolded(polygon, sign)) {
            const std::vector<std::size_t> hull = hullCorners(polygon, sign);
            screen = picked(screen, hull);
            polygon = picked(polygon, hull);
        }
        drawPolygon(screen, polygon, sign, static_cast<std::int32_t>(triangle.face));
    }

    template <class Value>
    static std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::size_t>& indices)
    {
        std::vector<Value> result;
        for (const std::size_t i : indices)
            result.push_back(values[i]);
        return result;
    }

    [[nodiscard]] std::vector<ScreenCorner> screenPolygon(const std::vector<Corner>& clipped,
                                                          const ClipTriangle& triangle) const
    {
        std::vector<ScreenCorner> screen;
        for (const Corner& corner : clipped)
            screen.push_back(toScreen(corner, triangle, m_lattice));
        return screen;
    }

    void noteEdges(const std::vector<ScreenCorner>& polygon)
    {
        const auto pixels = [this](const ScreenCorner& corner) {
            const Integer denominator = corner.w * m_lattice.unitsPerPixel();
            return glm::dvec2(ratio(corner.x, denominator), ratio(corner.y, denominator));
        };
        for (std::size_t i = 0; i < polygon.size(); ++i)
            lowerEdgeDistance(m_frame, pixels(polygon[i]), pixels(polygon[(i + 1) % polygon.size()]));
    }

    void drawPolygon(const std::vector<ScreenCorner>& screen, const std::vector<Snapped>& polygon, int sign,
                     std::int32_t face)
    {
        std::vector<int> fan;
        for (std::size_t i = 1; i + 1 < screen.size(); ++i) {
            const std::array<ScreenCorner, 3> corners{screen[0], screen[i], screen[i + 1]};
            const Integer det = determinant(corners);
            if (det.sign() == sign)
                fan.push_back(m_depth.addPiece(makePiece(corners, det, m_options, m_lattice.unit, face)));
        }
        const auto byY = [](const Snapped& a, const Snapped& b) { return a.y < b.y; };
        const auto [top, bottom] = std::minmax_element(polygon.begin(), polygon.end(), byY);
        const int firstRow = std::max(m_window.rows.begin, static_cast<int>(top->y / (2 * m_lattice.unit)) - 1);
        const int endRow = std::min(m_window.rows.end, static_cast<int>(bottom->y / (2 * m_lattice.unit)) + 1);
        bool owns = false;
        for (int row = firstRow; row < endRow; ++row)
            for (const Columns& columns : windingColumns(polygon, sign, row, m_window.columns, m_lattice))
                owns |= drawFan(fan, row, columns);
        for (std::size_t i = 0; i < fan.size() && !owns; ++i)
            m_depth.dropLastPiece();
    }

    /// Hands every sample of the columns to the first triangle of the fan that holds it.
    bool drawFan(const std::vector<int>& fan, int row, Columns columns)
    {
        if (fan.size() == 1)
            return drawColumns(fan.front(), row, columns);
        bool owns = false;
        std::vector<Columns> open{columns};
        for (const int index : fan) {
            std::vector<Columns> left;
            for (const Columns& gap : open) {
                Columns held = gap;
                for (const Linear& weight : m_depth.piece(index).weights)
                    if (!held.empty())
                        keepPositive(weight, row, held);
                if (held.empty()) {
                    left.push_back(gap);
                    continue;
                }
                owns |= drawColumns(index, row, held);
                if (gap.begin < held.begin)
                    left.push_back({gap.begin, held.begin});
                if (held.end < gap.end)
                    left.push_back({held.end, gap.end});
            }
            open = std::move(left);
        }
        assert(open.empty());
        return owns;
    }

    /// out: whether any sample passed the depth test
    bool drawColumns(int pieceIndex, int row, Columns columns)
    {
        if (columns.empty())
            return false;
        const Piece& piece = m_depth.piece(pieceIndex);
        const RowValues values(piece, row, columns);
        bool owns = false;
        const std::size_t rowStart =
            static_cast<std::size_t>(row - m_window.rows.begin) * static_cast<std::size_t>(m_frame.width);
        for (int column = columns.begin; column < columns.end; ++column) {
            const std::size_t sample = rowStart + static_cast<std::size_t>(column - m_window.columns.begin);
            ++m_frame.cover[sample];
            if (!m_depth.test(sample, pieceIndex, column, row, values.depth(column)))
                continue;
            m_frame.id[sample] = piece.face;
            m_frame.color[sample] = values.color(column);
            owns = true;
        }
        return owns;
    }

    const ExactOptions& m_options;
    ExactFrame& m_frame;
    DepthBuffer m_depth;
    Lattice m_lattice{};
    SampleWindow m_window{};
};

bool isFinite(const ClipTriangle& triangle)
{
    for (const ClipVertex& vertex : triangle.vertices)
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(vertex.positionClip[k]))
                return false;
    return true;
}

/// The part of a window that a viewport shows, if it shows any.
std::optional<PixelRect> visiblePart(const PixelRect& window, QSize size)
{
    const QRect visible = QRect(window.x, window.y, window.width, window.height) & QRect({0, 0}, size);
    if (visible.isEmpty())
        return std::nullopt;
    return PixelRect{visible.x(), visible.y(), visible.width(), visible.height()};
}

ExactFrame emptyFrame(const ExactOptions& options)
{
    ExactFrame frame;
    frame.window = options.window.value_or(PixelRect{0, 0, options.size.width(), options.size.height()});
    frame.sampleGrid = options.sampleGrid;
    frame.depthTested = options.depthTested;
    frame.width = frame.window.width * options.sampleGrid;
    frame.height = frame.window.height * options.sampleGrid;
    const std::size_t samples = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    frame.cover.assign(samples, 0);
    frame.id.assign(samples, -1);
    frame.depth.assign(samples, 1);
    frame.color.assign(samples, glm::dvec3(0));
    if (options.edgeDistance)
        frame.edgeDistance.assign(samples, kFarFromEdges);
    return frame;
}

} // namespace

std::size_t ExactFrame::sampleNearestCentre(int x, int y) const
{
    return static_cast<std::size_t>(y * sampleGrid + sampleGrid / 2) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x * sampleGrid + sampleGrid / 2);
}

glm::dvec3 ExactFrame::pixelColor(int x, int y, glm::vec3 background) const
{
    glm::dvec3 sum(0);
    for (int row = y * sampleGrid; row < (y + 1) * sampleGrid; ++row)
        for (int column = x * sampleGrid; column < (x + 1) * sampleGrid; ++column) {
            const std::size_t i =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
            sum += id[i] >= 0 ? glm::clamp(color[i], 0.0, 1.0) : glm::dvec3(background);
        }
    return sum / static_cast<double>(sampleGrid * sampleGrid);
}

ExactFrame exactReference(std::span<const ClipTriangle> triangles, const ExactOptions& options, std::stop_token stop)
{
    ExactFrame frame = emptyFrame(options);
    Painter painter(options, frame);
    for (const ClipTriangle& triangle : triangles) {
        if (stop.stop_requested())
            break;
        if (isFinite(triangle))
            painter.draw(triangle);
        else
            ++frame.nonFinite;
    }
    return frame;
}

ExactOptions exactOptions(const Scene& scene, const Settings& settings)
{
    Settings correct = settings;
    correct.visibility = Visibility::ZBuffer;
    correct.mistakes.clear();
    const Rules rules = rulesFor(scene, correct);

    ExactOptions options;
    options.size = settings.size;
    options.snap = settings.numberType == NumberType::Fixed && !scene.exact;
    options.subpixelBits = settings.subpixelBits;
    options.clipZ = settings.clipZ;
    options.culling = settings.culling;
    options.winding = settings.winding;
    options.depthCompare = rules.depthTested ? rules.depthCompare : DepthCompare::Always;
    options.depthTested = rules.depthTested;
    options.depthClear = static_cast<double>(rules.depthClear);
    options.depthFormat = settings.depthFormat;
    options.sampleGrid = rules.sampleGrid;
    options.window = scene.window ? visiblePart(*scene.window, settings.size) : std::nullopt;
    return options;
}

std::vector<ClipTriangle> exactTriangles(const Scene& scene, const Settings& settings)
{
    Settings gouraud = settings;
    gouraud.shading = Shading::Gouraud;
    gouraud.mistakes.clear();
    const std::vector<ClipVertex> vertices =
        shadeVertices(scene, cameraMatrices(scene, gouraud), rulesFor(scene, gouraud));
    std::vector<ClipTriangle> triangles(scene.mesh.faceCount());
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        triangles[face].face = static_cast<std::uint32_t>(face);
        for (std::size_t i = 0; i < 3; ++i)
            triangles[face].vertices[i] = vertices[scene.mesh.indices[3 * face + i]];
    }
    return triangles;
}

ExactFrame exactReference(const Scene& scene, const Settings& settings, std::stop_token stop)
{
    return exactReference(exactTriangles(scene, settings), exactOptions(scene, settings), std::move(stop));
}

} // namespace rasterlens
