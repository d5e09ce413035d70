#include "core/truth/exact_reference.h"

#include "core/settings/depth_rules.h"
#include "core/truth/edge_distance.h"
#include "core/truth/exact_face.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rasterlens
{

using namespace exact;

namespace
{

/// Depth, colour and texture coordinates along one row of a piece. Every weight is a sum of two terms >= 0, so none
/// cancels.
class RowValues
{
public:
    /// in  textured: uv() is to be asked for
    RowValues(const Piece& piece, int row, Columns columns, bool textured) : m_piece(piece), m_columns(columns)
    {
        const int last = columns.end - 1;
        std::array<Scaled, 3> starts;
        std::array<Scaled, 3> steps;
        std::array<Scaled, 3> down;
        int base = std::numeric_limits<int>::min();
        for (std::size_t i = 0; i < 3; ++i) {
            const Linear& weight = piece.weights[i];
            m_rising[i] = weight.perColumn.sign() >= 0;
            starts[i] = nearestScaled(weight.at(m_rising[i] ? columns.begin : last, row));
            steps[i] = nearestScaled(boost::multiprecision::abs(weight.perColumn));
            if (textured)
                down[i] = nearestScaled(weight.perRow);
            base = std::max({base, starts[i].exponent, steps[i].exponent, down[i].exponent});
        }
        for (std::size_t i = 0; i < 3; ++i) {
            m_starts[i] = starts[i].value(base);
            m_steps[i] = steps[i].value(base);
            m_down[i] = down[i].value(base);
        }
        m_depthFirst = nearestQuotient(piece.depthNumerator.at(columns.begin, row), piece.depthDenominator);
        const double depthLast = nearestQuotient(piece.depthNumerator.at(last, row), piece.depthDenominator);
        m_depthStep = last > columns.begin ? (depthLast - m_depthFirst) / (last - columns.begin) : 0;
    }

    [[nodiscard]] double depth(int column) const { return m_depthFirst + m_depthStep * (column - m_columns.begin); }

    [[nodiscard]] glm::dvec3 color(int column) const
    {
        glm::dvec3 sum{0};
        double total = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double weight = weightAt(i, column);
            sum += weight * m_piece.colors[i];
            total += weight;
        }
        return sum / total;
    }

    [[nodiscard]] ExactUv uv(int column) const
    {
        ExactUv uv;
        double total = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            uv.place += weightAt(i, column) * m_piece.uvs[i];
            total += weightAt(i, column);
        }
        uv.place /= total;
        if (m_piece.isLine)
            return uv;
        // With uv = sum(w uv_i) / sum(w), the quotient rule leaves sum(w' (uv_i - uv)) / sum(w).
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 pull = (m_piece.uvs[i] - uv.place) / total;
            uv.perColumn += (m_rising[i] ? m_steps[i] : -m_steps[i]) * pull;
            uv.perRow += m_down[i] * pull;
        }
        return uv;
    }

private:
    [[nodiscard]] double weightAt(std::size_t i, int column) const
    {
        const int steps = m_rising[i] ? column - m_columns.begin : m_columns.end - 1 - column;
        return m_starts[i] + m_steps[i] * steps;
    }

    const Piece& m_piece;
    Columns m_columns;
    std::array<bool, 3> m_rising{};
    std::array<double, 3> m_starts{};
    std::array<double, 3> m_steps{};
    std::array<double, 3> m_down{};
    double m_depthFirst = 0;
    double m_depthStep = 0;
};

/// The pieces whose depths are stored, made anew when an exact comparison asks for one: kept, they would take a
/// kilobyte a face.
class Pieces
{
public:
    Pieces(std::span<const ClipTriangle> triangles, const FaceSetup& setup) : m_triangles(triangles), m_setup(setup) {}

    [[nodiscard]] const Piece& at(PieceIndex index)
    {
        if (index.triangle != m_triangle) {
            m_fan = m_setup.piecesOf(m_triangles[static_cast<std::size_t>(index.triangle)]);
            m_triangle = index.triangle;
        }
        return m_fan[static_cast<std::size_t>(index.piece)];
    }

private:
    std::span<const ClipTriangle> m_triangles;
    const FaceSetup& m_setup;
    std::vector<Piece> m_fan; ///< of the triangle asked for last: neighbouring samples ask for the same
    std::int32_t m_triangle = -1;
};

/// A fragment on its way to the depth test.
struct Candidate {
    const Piece& piece;
    PieceIndex index;
    int column;
    int row;
    double depth;
};

/// The depth buffer: a double in front, the piece it came from behind it for the exact comparison.
class DepthBuffer
{
public:
    DepthBuffer(const ExactOptions& options, ExactFrame& frame, Pieces pieces)
        : m_options(options), m_low(std::min(options.depthRange.near, options.depthRange.far)),
          m_high(std::max(options.depthRange.near, options.depthRange.far)),
          m_codeMax(largestDepthCode(options.depthFormat)),
          m_clear(m_codeMax > 0 ? std::round(options.depthClear * m_codeMax) / m_codeMax : options.depthClear),
          m_owners(frame.cover.size()), m_frame(frame), m_pieces(std::move(pieces))
    {
        std::fill(frame.depth.begin(), frame.depth.end(), m_clear);
    }

    /// Compares and, when the fragment passes, stores.
    bool test(std::size_t sample, const Candidate& candidate)
    {
        const double value = m_codeMax > 0 ? code(candidate) / m_codeMax : held(candidate.depth);
        if (!passes(sample, candidate, value))
            return false;
        m_frame.depth[sample] = value;
        m_owners[sample] = candidate.index;
        return true;
    }

private:
    bool passes(std::size_t sample, const Candidate& candidate, double value)
    {
        const DepthCompare wanted = static_cast<std::size_t>(candidate.piece.face) < m_options.firstPassFaces
                                        ? m_options.firstPassCompare
                                        : m_options.depthCompare;
        if (wanted == DepthCompare::Always)
            return true;
        const int order = compare(sample, candidate, value);
        switch (wanted) {
        case DepthCompare::Less: return order < 0;
        case DepthCompare::LessEqual: return order <= 0;
        case DepthCompare::Equal: return order == 0;
        case DepthCompare::NotEqual: return order != 0;
        case DepthCompare::Greater: return order > 0;
        case DepthCompare::GreaterEqual: return order >= 0;
        case DepthCompare::Always: break;
        }
        return true;
    }

    /// The sign of new - stored.
    int compare(std::size_t sample, const Candidate& candidate, double value)
    {
        constexpr double kFilter = 1e-14;
        const double difference = value - m_frame.depth[sample];
        if (m_codeMax > 0 || std::abs(difference) > kFilter)
            return (difference > 0) - (difference < 0);
        const Fraction mine = exactDepth(candidate.piece, candidate.column, candidate.row);
        const Fraction stored = m_owners[sample].triangle < 0
                                    ? fractionOf(m_clear)
                                    : exactDepth(m_pieces.at(m_owners[sample]), candidate.column, candidate.row);
        return order(mine, stored);
    }

    [[nodiscard]] static int order(const Fraction& a, const Fraction& b)
    {
        return Integer(a.numerator * b.denominator).compare(Integer(b.numerator * a.denominator));
    }

    [[nodiscard]] double held(double depth) const { return std::clamp(depth, m_low, m_high); }

    /// The depth of a piece at a sample, held within the depth range.
    [[nodiscard]] Fraction exactDepth(const Piece& piece, int column, int row) const
    {
        const Fraction depth{piece.depthNumerator.at(column, row), piece.depthDenominator};
        if (const Fraction low = fractionOf(m_low); order(depth, low) < 0)
            return low;
        const Fraction high = fractionOf(m_high);
        return order(depth, high) > 0 ? high : depth;
    }

    /// The nearest unorm code, half to even.
    [[nodiscard]] double code(const Candidate& candidate) const
    {
        constexpr double kFilter = 1e-6;
        const double scaledDepth = held(candidate.depth) * m_codeMax;
        if (std::abs(scaledDepth - std::floor(scaledDepth) - 0.5) > kFilter)
            return std::round(scaledDepth);
        const Fraction depth = exactDepth(candidate.piece, candidate.column, candidate.row);
        return static_cast<double>(
            static_cast<std::int64_t>(roundHalfToEven(depth.numerator * m_codeMax, depth.denominator)));
    }

    const ExactOptions& m_options;
    double m_low;
    double m_high;
    int m_codeMax; // 0: exact depths
    double m_clear;
    std::vector<PieceIndex> m_owners;
    ExactFrame& m_frame;
    Pieces m_pieces;
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
    Painter(std::span<const ClipTriangle> triangles, const ExactOptions& options, ExactFrame& frame)
        : m_triangles(triangles), m_options(options), m_setup(options), m_frame(frame),
          m_depth(options, frame, Pieces(triangles, m_setup))
    {
        const PixelRect& w = frame.window;
        const int n = options.sampleGrid;
        m_window = {{w.x * n, (w.x + w.width) * n}, {w.y * n, (w.y + w.height) * n}};
    }

    void draw(std::size_t triangle)
    {
        if (m_setup.isLine(m_triangles[triangle].face))
            return drawLine(triangle);
        const Outline outline = m_setup.outlineOf(m_triangles[triangle]);
        m_frame.maxClipVertices = std::max(m_frame.maxClipVertices, outline.clippedCorners);
        for (std::size_t i = 0; i < outline.trueEdges.size(); ++i)
            lowerEdgeDistance(m_frame, outline.trueEdges[i], outline.trueEdges[(i + 1) % outline.trueEdges.size()]);
        switch (outline.fate) {
        case Outline::Fate::Outside: ++m_frame.outside; return;
        case Outline::Fate::Degenerate: ++m_frame.degenerate; return;
        case Outline::Fate::Culled: ++m_frame.culled; return;
        case Outline::Fate::Drawn: break;
        }
        m_triangle = static_cast<std::int32_t>(triangle);
        if (m_options.snap)
            drawSnapped(outline);
        else
            drawUnsnapped(outline);
    }

private:
    /// Columns of one row.
    struct Span {
        int row;
        Columns columns;
    };

    void drawLine(std::size_t triangle)
    {
        if (m_options.offset.x != 0 || m_options.offset.y != 0)
            return; // the sample of a pattern
        const Segment segment = m_setup.segmentOf(m_triangles[triangle]);
        m_frame.outside += segment.fate == Outline::Fate::Outside;
        m_frame.degenerate += segment.fate == Outline::Fate::Degenerate;
        m_triangle = static_cast<std::int32_t>(triangle);
        for (const auto& [column, row, piece] : segment.samples)
            if (m_window.rows.begin <= row && row < m_window.rows.end && m_window.columns.begin <= column &&
                column < m_window.columns.end)
                drawColumns(segment.pieces, static_cast<std::size_t>(piece), {row, {column, column + 1}});
    }

    void drawUnsnapped(const Outline& outline)
    {
        const std::vector<Piece> fan = m_setup.fanOf(outline);
        const Piece& piece = fan.front();
        const Columns rows = rowsOf(outline.corners);
        for (int row = rows.begin; row < rows.end; ++row) {
            Columns columns = m_window.columns;
            for (const Linear& weight : piece.weights)
                if (!columns.empty())
                    keepPositive(weight, row, columns);
            if (!columns.empty())
                keepPositive(piece.nearSide, row, columns);
            if (!columns.empty())
                keepPositive(piece.farSide, row, columns);
            drawColumns(fan, 0, {row, columns});
        }
    }

    /// Rows the face may touch; all of them when it reaches behind the eye.
    [[nodiscard]] Columns rowsOf(const std::vector<ScreenCorner>& corners) const
    {
        Columns rows{m_window.rows.end, m_window.rows.begin};
        for (const ScreenCorner& corner : corners) {
            if (corner.w.sign() <= 0)
                return m_window.rows;
            const Integer row = floorDivide(corner.y, corner.w * (2 * m_setup.lattice().unit));
            rows.begin = std::min(rows.begin, clampedTo(m_window.rows, Integer(row - 1)));
            rows.end = std::max(rows.end, clampedTo(m_window.rows, Integer(row + 1)));
        }
        return rows;
    }

    void drawSnapped(const Outline& outline)
    {
        if (m_options.coverageRule != CoverageRule::Centre)
            return drawSquares(outline);
        const std::vector<Span> spans = spansOf(outline);
        if (spans.empty()) // most faces of a fine mesh: no plane equations for nothing
            return;
        const std::vector<Piece> fan = m_setup.fanOf(outline);
        for (const Span& span : spans)
            drawFan(fan, span);
    }

    /// The pixels whose square the triangles touch, or hold, that the face is drawn as: a fan round the leftmost corner
    /// (of those the topmost) that sees all of the outline.
    void drawSquares(Outline outline)
    {
        const auto place = [&](std::size_t corner) {
            return std::pair(outline.polygon[corner].x, outline.polygon[corner].y);
        };
        std::optional<std::size_t> apex;
        for (std::size_t corner = 0; corner < outline.polygon.size(); ++corner)
            if (seesAll(outline.polygon, outline.sign, corner) && (!apex || place(corner) < place(*apex)))
                apex = corner;
        const auto first = static_cast<std::ptrdiff_t>(apex.value_or(0)); // a hull has one
        std::ranges::rotate(outline.polygon, outline.polygon.begin() + first);
        std::ranges::rotate(outline.corners, outline.corners.begin() + first);
        const std::vector<Piece> fan = m_setup.fanOf(outline);
        const std::int64_t side = 2 * m_setup.lattice().unit;
        const auto pixelsOf = [&](std::int64_t low, std::int64_t high, const Columns& window) {
            return Columns{std::max(window.begin, static_cast<int>(low / side) - 1),
                           std::min(window.end, static_cast<int>(high / side) + 1)};
        };
        std::size_t piece = 0;
        for (std::size_t i = 1; i + 1 < outline.polygon.size(); ++i) {
            const std::array<Snapped, 3> corners{outline.polygon[0], outline.polygon[i], outline.polygon[i + 1]};
            const std::int64_t area = doubledArea(corners);
            if ((area > 0) - (area < 0) != outline.sign)
                continue; // no piece of the fan either
            const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
            const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
            const Columns columns = pixelsOf(left, right, m_window.columns);
            const Columns rows = pixelsOf(top, bottom, m_window.rows);
            for (int row = rows.begin; row < rows.end; ++row)
                for (int column = columns.begin; column < columns.end; ++column)
                    if (coversSquare(corners, {column * side, row * side}, side, m_options.coverageRule))
                        drawColumns(fan, piece, {row, {column, column + 1}});
            ++piece;
        }
    }

    [[nodiscard]] std::vector<Span> spansOf(const Outline& outline) const
    {
        const Lattice& lattice = m_setup.lattice();
        const auto byY = [](const Snapped& a, const Snapped& b) { return a.y < b.y; };
        const auto [top, bottom] = std::minmax_element(outline.polygon.begin(), outline.polygon.end(), byY);
        const int firstRow = std::max(m_window.rows.begin, static_cast<int>(top->y / (2 * lattice.unit)) - 1);
        const int endRow = std::min(m_window.rows.end, static_cast<int>(bottom->y / (2 * lattice.unit)) + 1);
        std::vector<Span> spans;
        for (int row = firstRow; row < endRow; ++row)
            for (const Columns& columns : windingColumns(outline.polygon, outline.sign, row, m_window.columns, lattice))
                spans.push_back({row, columns});
        return spans;
    }

    /// Hands every sample of the span to the first triangle of the fan that holds it.
    void drawFan(const std::vector<Piece>& fan, Span span)
    {
        if (fan.size() == 1) {
            drawColumns(fan, 0, span);
            return;
        }
        std::vector<Columns> open{span.columns};
        for (std::size_t piece = 0; piece < fan.size(); ++piece) {
            std::vector<Columns> left;
            for (const Columns& gap : open) {
                Columns held = gap;
                for (const Linear& weight : fan[piece].weights)
                    if (!held.empty())
                        keepPositive(weight, span.row, held);
                if (held.empty()) {
                    left.push_back(gap);
                    continue;
                }
                drawColumns(fan, piece, {span.row, held});
                if (gap.begin < held.begin)
                    left.push_back({gap.begin, held.begin});
                if (held.end < gap.end)
                    left.push_back({held.end, gap.end});
            }
            open = std::move(left);
        }
        assert(open.empty());
    }

    void drawColumns(const std::vector<Piece>& fan, std::size_t index, Span span)
    {
        if (span.columns.empty())
            return;
        const Piece& piece = fan[index];
        const RowValues values(piece, span.row, span.columns, m_options.textured);
        const std::size_t rowStart =
            static_cast<std::size_t>(span.row - m_window.rows.begin) * static_cast<std::size_t>(m_frame.width);
        for (int column = span.columns.begin; column < span.columns.end; ++column) {
            const std::size_t sample = rowStart + static_cast<std::size_t>(column - m_window.columns.begin);
            ++m_frame.cover[sample];
            const PieceIndex from{m_triangle, static_cast<std::int32_t>(index)};
            if (!m_depth.test(sample, {piece, from, column, span.row, values.depth(column)}))
                continue;
            m_frame.id[sample] = piece.face;
            m_frame.color[sample] = values.color(column);
            if (m_options.textured)
                m_frame.uv[sample] = values.uv(column);
        }
    }

    std::span<const ClipTriangle> m_triangles;
    const ExactOptions& m_options;
    FaceSetup m_setup;
    ExactFrame& m_frame;
    DepthBuffer m_depth;
    SampleWindow m_window{};
    std::int32_t m_triangle = -1; ///< being drawn
};

bool isFinite(const ClipTriangle& triangle)
{
    for (const ClipVertex& vertex : triangle.vertices)
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(vertex.positionClip[k]))
                return false;
    return true;
}

bool isFinite(const glm::dmat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

PixelRect windowOf(const ExactOptions& options)
{
    return options.window.value_or(PixelRect{0, 0, options.size.width(), options.size.height()});
}

ExactFrame emptyFrame(const ExactOptions& options)
{
    ExactFrame frame;
    frame.window = windowOf(options);
    frame.sampleGrid = options.sampleGrid;
    frame.offset = options.offset.pixels();
    frame.resolveLight = options.resolveLight;
    frame.depthTested = options.depthTested;
    frame.width = frame.window.width * options.sampleGrid;
    frame.height = frame.window.height * options.sampleGrid;
    const std::size_t samples = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    frame.cover.assign(samples, 0);
    frame.id.assign(samples, -1);
    frame.depth.assign(samples, 1);
    frame.color.assign(samples, glm::dvec3(0));
    if (options.textured)
        frame.uv.assign(samples, {});
    if (options.edgeDistance)
        frame.edgeDistance.assign(samples, kFarFromEdges);
    return frame;
}

/// Every sample of a pattern as a frame of its own, and these put together.
ExactFrame patternReference(std::span<const ClipTriangle> triangles, const ExactOptions& options,
                            const std::stop_token& stop, const ExactProgress& progress)
{
    ExactFrame whole;
    ExactOptions part = options;
    part.patternSamples = 1;
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    for (int sample = 0; sample < options.patternSamples; ++sample) {
        part.offset = samplePattern(options.patternSamples)[static_cast<std::size_t>(sample)];
        const auto partDone = [&](double done) { progress((sample + done) / options.patternSamples); };
        ExactFrame frame = exactReference(triangles, part, stop, progress ? ExactProgress(partDone) : nullptr);
        if (sample == 0) {
            whole = std::move(frame);
            continue;
        }
        append(whole.cover, frame.cover);
        append(whole.id, frame.id);
        append(whole.depth, frame.depth);
        append(whole.color, frame.color);
        append(whole.uv, frame.uv);
        append(whole.edgeDistance, frame.edgeDistance);
    }
    whole.patternSamples = options.patternSamples;
    return whole;
}

} // namespace

ExactFrame exactReference(std::span<const ClipTriangle> triangles, const ExactOptions& options, std::stop_token stop,
                          const ExactProgress& progress)
{
    if (options.patternSamples > 1)
        return patternReference(triangles, options, stop, progress);
    constexpr std::size_t kFacesBetweenReports = 1024;
    ExactFrame frame = emptyFrame(options);
    Painter painter(triangles, options, frame);
    const bool hasCamera = !options.clipFromObject || isFinite(*options.clipFromObject);
    for (std::size_t i = 0; i < triangles.size() && !stop.stop_requested(); ++i) {
        if (progress && i % kFacesBetweenReports == 0)
            progress(static_cast<double>(i) / static_cast<double>(triangles.size()));
        if (hasCamera && isFinite(triangles[i]))
            painter.draw(i);
        else
            ++frame.nonFinite;
    }
    return frame;
}

std::vector<PixelRect> bandsOf(const ExactOptions& options)
{
    const PixelRect window = windowOf(options);
    const std::int64_t samplesPerRow =
        std::int64_t{window.width} * options.sampleGrid * options.sampleGrid * options.patternSamples;
    const int rows = static_cast<int>(std::max<std::int64_t>(1, kSamplesPerBand / samplesPerRow));
    std::vector<PixelRect> bands;
    for (int y = 0; y < window.height; y += rows)
        bands.push_back({window.x, window.y + y, window.width, std::min(rows, window.height - y)});
    return bands;
}

} // namespace rasterlens
