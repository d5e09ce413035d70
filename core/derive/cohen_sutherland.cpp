#include "core/derive/topic_list.h"

#include "core/observe/face_moment.h"
#include "core/pipeline/unsnapped.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace rasterlens
{
namespace
{

/// A side of the screen, in the order in which ends are moved to them.
struct ScreenSide {
    unsigned bit;
    const char* id; ///< in formulas
    int axis;       ///< 0 is x, 1 is y
    Reason words;
};

const std::array<ScreenSide, 4>& screenSides()
{
    static const std::array<ScreenSide, 4> sides{{
        {kRegionRight, "RIGHT", 0, QT_TRANSLATE_NOOP("Derive", "It is right of the screen: the edge is cut there.")},
        {kRegionLeft, "LEFT", 0, QT_TRANSLATE_NOOP("Derive", "It is left of the screen: the edge is cut there.")},
        {kRegionAbove, "ABOVE", 1, QT_TRANSLATE_NOOP("Derive", "It is above the screen: the edge is cut there.")},
        {kRegionBelow, "BELOW", 1, QT_TRANSLATE_NOOP("Derive", "It is below the screen: the edge is cut there.")},
    }};
    return sides;
}

/// An end of an edge on the screen.
struct EdgeEnd {
    QString name;
    glm::dvec2 position; ///< pixels, y down
    unsigned region;
    std::optional<double> w; ///< of clip space, where the edge belongs to a face
};

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Writes how edges are cut by the sides of the screen.
class CohenSutherlandWriter
{
public:
    explicit CohenSutherlandWriter(const FaceRecord& record)
        : m_record(record), m_size(record.settings().size.width(), record.settings().size.height()),
          m_writer(DerivationTopic::CohenSutherland, faceReason(record))
    {
        m_writer.givenBits(QStringLiteral("LEFT"), kRegionLeft);
        m_writer.givenBits(QStringLiteral("RIGHT"), kRegionRight);
        m_writer.givenBits(QStringLiteral("BELOW"), kRegionBelow);
        m_writer.givenBits(QStringLiteral("ABOVE"), kRegionAbove);
        m_writer.given(QStringLiteral("border_LEFT"), 0);
        m_writer.given(QStringLiteral("border_RIGHT"), m_size.x);
        m_writer.given(QStringLiteral("border_ABOVE"), 0);
        m_writer.given(QStringLiteral("border_BELOW"), m_size.y);
        const auto events = m_record.log().eventsOf(StepKind::CohenSutherland);
        if (!events.empty())
            m_moment = faceMomentAt(m_record.log(), events.front() + 1);
    }

    Derivation write()
    {
        const std::vector<EdgeEnd> polygon = outline();
        for (const EdgeEnd& end : polygon)
            give(end);
        std::vector<QString> left;
        for (std::size_t i = 0; i < polygon.size(); ++i)
            writeEdge(polygon[i], polygon[(i + 1) % polygon.size()], left);
        writeOutline(polygon, left);
        writeExample();
        return m_writer.take();
    }

private:
    [[nodiscard]] EdgeEnd endAt(const QString& name, const glm::dvec4& clip) const
    {
        return {name, m_record.pixels(unsnappedPosition(clip, m_record.rules())), screenRegion(clip), clip.w};
    }

    /// What the sides of the screen are applied to: the face, or what near, far and the guard band have left of it.
    [[nodiscard]] std::vector<EdgeEnd> outline() const
    {
        std::vector<EdgeEnd> polygon;
        if (m_moment) {
            for (const MomentCorner& corner : m_moment->before)
                polygon.push_back(endAt(corner.name, corner.positionClip));
            return polygon;
        }
        requireBeforeEye(m_record);
        for (std::size_t i = 0; i < 3; ++i)
            polygon.push_back(endAt(cornerLetter(i), m_record.corners()[i].clip));
        return polygon;
    }

    [[nodiscard]] static CanvasPart partOf(const EdgeEnd& end) { return {CanvasKind::Point, end.name, {end.position}}; }

    void give(const EdgeEnd& end)
    {
        m_writer.given(QStringLiteral("x_") + end.name, end.position.x, partOf(end));
        m_writer.given(QStringLiteral("y_") + end.name, end.position.y, partOf(end));
        m_writer.givenBits(QStringLiteral("code_") + end.name, end.region, partOf(end));
        if (end.w)
            m_writer.given(QStringLiteral("w_") + end.name, *end.w, partOf(end));
    }

    /// The sides a point is beyond; one that rounding has left at most a billionth of the screen beyond is on the
    /// border.
    [[nodiscard]] unsigned regionOf(const glm::dvec2& p) const
    {
        const glm::dvec2 slack = m_size * 1e-9;
        return (p.x < -slack.x ? kRegionLeft : 0U) | (p.x > m_size.x + slack.x ? kRegionRight : 0U) |
               (p.y > m_size.y + slack.y ? kRegionBelow : 0U) | (p.y < -slack.y ? kRegionAbove : 0U);
    }

    /// An edge until it is inside, or out. Names of the ends that are left are added, each once.
    void writeEdge(EdgeEnd begin, EdgeEnd end, std::vector<QString>& left)
    {
        for (;;) {
            const CanvasPart mark = edgePart(begin.name + end.name, begin.position, end.position);
            const bool isOut = (begin.region & end.region) != 0;
            const bool isInside = (begin.region | end.region) == 0;
            m_writer.compare(formula("{code_%1} & {code_%2} == 0", begin.name, end.name),
                             andWords(begin, end, isOut, isInside), {mark});
            if (isOut)
                return;
            if (isInside)
                break;
            EdgeEnd& moved = begin.region != 0 ? begin : end;
            const EdgeEnd& other = begin.region != 0 ? end : begin;
            moved = cutEnd(moved, other, mark);
        }
        for (const QString& name : {begin.name, end.name})
            if (std::ranges::find(left, name) == left.end())
                left.push_back(name);
    }

    [[nodiscard]] static Reason andWords(const EdgeEnd& begin, const EdgeEnd& end, bool isOut, bool isInside)
    {
        if (isOut)
            return {QT_TRANSLATE_NOOP("Derive",
                                      "Edge %1%2: both ends are beyond the same side. Nothing of it is seen: a null "
                                      "line."),
                    {begin.name, end.name}};
        if (isInside)
            return {QT_TRANSLATE_NOOP("Derive", "Edge %1%2: both codes are 0000. It lies inside, and is kept."),
                    {begin.name, end.name}};
        return {QT_TRANSLATE_NOOP("Derive", "Edge %1%2: no side has both ends beyond it, so a part may be seen."),
                {begin.name, end.name}};
    }

    /// The name of a new end: that of the corner of the canvas that it becomes. One that is moved on, or cut away in
    /// the end, is no corner: it is a J.
    [[nodiscard]] QString nameOfCut(const glm::dvec2& position)
    {
        if (m_moment) {
            const double slack = 1e-6 * std::max(m_size.x, m_size.y) + 2 * m_record.rules().clipInset;
            for (const MomentCorner& corner : m_moment->corners)
                if (const auto place = corner.onScreen(m_record.rules());
                    place && glm::distance(m_record.pixels(*place), position) <= slack)
                    return corner.name;
        }
        return QStringLiteral("J%1").arg(++m_passing);
    }

    /// Moves an end that is outside to a side it is beyond.
    EdgeEnd cutEnd(const EdgeEnd& moved, const EdgeEnd& other, const CanvasPart& mark)
    {
        const ScreenSide& side =
            *std::ranges::find_if(screenSides(), [&](const ScreenSide& s) { return (moved.region & s.bit) != 0; });
        const QString sideId = QLatin1String(side.id);
        const QString along = QLatin1String(side.axis == 0 ? "x" : "y");
        const QString across = QLatin1String(side.axis == 0 ? "y" : "x");
        m_writer.compare(formula("{code_%1} & {%2} > 0", moved.name, sideId), side.words, {partOf(moved)});
        EdgeEnd cut{{}, {}, 0, {}};
        const double border = m_writer.valueOf(QStringLiteral("border_") + sideId);
        const double t = (border - moved.position[side.axis]) / (other.position[side.axis] - moved.position[side.axis]);
        cut.position = moved.position + t * (other.position - moved.position);
        cut.position[side.axis] = border;
        cut.region = regionOf(cut.position);
        cut.name = nameOfCut(cut.position);
        m_writer.show(QStringLiteral("x_") + cut.name, partOf(cut));
        m_writer.show(QStringLiteral("y_") + cut.name, partOf(cut));
        m_writer.line(
            formula("{t_%1}", cut.name),
            formula("({border_%1} - {%2_%3}) / ({%2_%4} - {%2_%3})", sideId, along, moved.name, other.name),
            {QT_TRANSLATE_NOOP("Derive", "The weight of the new end: how far the border is from %1, over how far the "
                                         "other end is."),
             {moved.name}},
            {mark});
        m_writer.line(
            formula("({%1_%2}, {%3_%2})", along, cut.name, across),
            formula("({border_%1}, lerp({%2_%3}, {%2_%4}, {t_%5}))", sideId, across, moved.name, other.name, cut.name),
            {QT_TRANSLATE_NOOP("Derive", "The new end %1 lies on the border."), {cut.name}}, {partOf(cut)});
        if (moved.w && other.w)
            cut.w = writeFraction(moved, other, cut.name, mark);
        if (cut.w && m_record.rules().clipInset != 0)
            writeNudge(cut, along, border == 0);
        m_writer.givenBits(QStringLiteral("code_") + cut.name, cut.region, partOf(cut));
        m_writer.compare(
            formula("{code_%1} & {%2} == 0", cut.name, sideId),
            {QT_TRANSLATE_NOOP("Derive", "Its new code is %1. On the border it counts as inside; a program that "
                                         "takes it for outside has to move it in by a little (0.001), or the loop "
                                         "never ends."),
             {regionText(cut.region)}},
            {partOf(cut)});
        return cut;
    }

    /// What the new end takes its colour and w by; its w.
    double writeFraction(const EdgeEnd& moved, const EdgeEnd& other, const QString& cut, const CanvasPart& mark)
    {
        m_writer.line(
            formula("{n_%1}", cut),
            formula("{t_%1} * {w_%2} / ((1 - {t_%1}) * {w_%3} + {t_%1} * {w_%2})", cut, moved.name, other.name),
            QT_TRANSLATE_NOOP("Derive", "The edge was cut on the screen, so attributes need the part of the way in "
                                        "space."),
            {mark});
        m_writer.line(formula("{w_%1}", cut), formula("lerp({w_%1}, {w_%2}, {n_%3})", moved.name, other.name, cut),
                      QT_TRANSLATE_NOOP("Derive", "w of the new end."), {mark});
        return m_writer.valueOf(QStringLiteral("w_") + cut);
    }

    /// Where a new end of the face is drawn while a mistake moves it off the border.
    void writeNudge(const EdgeEnd& cut, const QString& along, bool grows)
    {
        m_writer.given(QStringLiteral("nudge"), m_record.rules().clipInset);
        m_writer.line(formula("{%1_drawn_%2}", along, cut.name),
                      formula(grows ? "{%1_%2} + {nudge}" : "{%1_%2} - {nudge}", along, cut.name),
                      QT_TRANSLATE_NOOP("Derive", "A mistake is on: the new end is drawn this far off the border."),
                      {partOf(cut)});
    }

    /// How many corners of the screen lie inside an outline.
    [[nodiscard]] int screenCornersInside(const std::vector<EdgeEnd>& polygon) const
    {
        int count = 0;
        for (const glm::dvec2& corner : {glm::dvec2(0, 0), glm::dvec2(m_size.x, 0), m_size, glm::dvec2(0, m_size.y)}) {
            bool isLeft = true;
            bool isRight = true;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const glm::dvec2& from = polygon[i].position;
                const double side = cross(polygon[(i + 1) % polygon.size()].position - from, corner - from);
                isLeft = isLeft && side > 0;
                isRight = isRight && side < 0;
            }
            count += isLeft || isRight ? 1 : 0;
        }
        return count;
    }

    /// The polygon that is put together again from what is left of the edges.
    void writeOutline(const std::vector<EdgeEnd>& polygon, const std::vector<QString>& left)
    {
        m_writer.given(QStringLiteral("ends"), double(left.size()));
        m_writer.given(QStringLiteral("screen_corners"), screenCornersInside(polygon));
        if (const auto* step = m_record.first<CohenSutherlandStep>())
            m_writer.given(QStringLiteral("corners"), double(step->after.size()));
        QStringList ends;
        for (const QString& name : left)
            ends << name;
        QStringList screenCorners;
        for (const MomentCorner& corner : m_moment ? m_moment->corners : std::vector<MomentCorner>())
            if (!ends.contains(corner.name))
                screenCorners << corner.name;
        const auto listed = [](const QStringList& names) {
            return names.isEmpty() ? QStringLiteral("\u2013") : names.join(QStringLiteral(", "));
        };
        m_writer.line(
            formula("{corners}"), formula("{ends} + {screen_corners}"),
            {QT_TRANSLATE_NOOP("Derive", "The outline put together again: the ends that are left (%1), and the corners "
                                         "of the screen that lie inside the face (%2). Edges alone lose those."),
             {listed(ends), listed(screenCorners)}},
            {});
    }

    /// An edge that both its ends' codes let pass, and that is out all the same.
    void writeExample()
    {
        m_moment.reset(); // no corner of the face
        const glm::dvec2 from(-m_size.x / 4, m_size.y / 4);
        const glm::dvec2 to(m_size.x / 2, -m_size.y);
        const EdgeEnd begin{QStringLiteral("U"), from, regionOf(from), {}};
        const EdgeEnd end{QStringLiteral("V"), to, regionOf(to), {}};
        give(begin);
        give(end);
        m_writer.compare(formula("{code_U} & {code_V} == 0"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "A worked example, not of this face: from U left of the screen to V above "
                                           "it. The codes have no bit in common, yet the edge passes the corner of the "
                                           "screen by."),
                         {edgePart(QStringLiteral("UV"), from, to)});
        std::vector<QString> left;
        writeEdge(begin, end, left);
    }

    const FaceRecord& m_record;
    glm::dvec2 m_size; ///< of the screen, pixels
    DerivationWriter m_writer;
    std::optional<FaceMoment> m_moment; ///< of the step; nothing where nothing is cut at the sides of the screen
    int m_passing = 0;                  ///< new ends so far that are no corners
};

} // namespace

Derivation deriveCohenSutherland(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                 const std::stop_token& stop)
{
    Settings cutting = settings;
    cutting.clipping = Clipping::CohenSutherland;
    const FaceRecord record(scene, cutting, place, stop);
    return CohenSutherlandWriter(record).write();
}

} // namespace rasterlens
