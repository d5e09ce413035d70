#include "core/derive/topic_list.h"

#include "core/pipeline/clipping.h"
#include "core/pipeline/unsnapped.h"

#include <QCoreApplication>

#include <cmath>

namespace rasterlens
{
namespace
{

constexpr const char* kAxes[] = {"x", "y", "z", "w"};

/// `+x`, `-z`: the plane in ids.
QString signOf(ClipPlane plane)
{
    return QString::fromUtf8(infoOf(plane).sign).replace(QChar(0x2212), QLatin1Char('-'));
}

/// Writes how the edges of a face are cut by the planes of the view volume.
class CutWriter
{
public:
    explicit CutWriter(const FaceRecord& record)
        : m_record(record), m_volume(clipVolume(record.rules())), m_writer(DerivationTopic::Cut, faceReason(record))
    {
        for (std::size_t i = 0; i < 3; ++i)
            giveCorner(cornerLetter(i), record.corners()[i].clip);
    }

    Derivation write()
    {
        writeBehindEye();
        writeSevenFormulas();
        std::vector<QString> names{cornerLetter(0), cornerLetter(1), cornerLetter(2)};
        for (const std::uint32_t i : m_record.log().eventsOf(StepKind::ClipPlane))
            names = writePlane(m_record.log().payload<ClipStep>(m_record.log().event(i)), names);
        if (const ClippedStep* fan = m_record.first<ClippedStep>(); fan != nullptr && fan->pieces > 0) {
            m_writer.given(QStringLiteral("corners"), double(names.size()));
            m_writer.line(
                formula("{triangles}"), formula("{corners} - 2"),
                QT_TRANSLATE_NOOP("Derive", "What is left is drawn as a fan: each triangle takes one corner more."));
        }
        return m_writer.take();
    }

private:
    /// A corner of clip space on the canvas; it has no place there if it is not in front of the eye.
    [[nodiscard]] CanvasPart partOf(const QString& name, const glm::dvec4& clip) const
    {
        CanvasPart part{CanvasKind::Corner, name, {}};
        if (clip.w > 0)
            part.points.push_back(m_record.pixels(unsnappedPosition(clip, m_record.rules())));
        return part;
    }

    void giveCorner(const QString& name, const glm::dvec4& clip)
    {
        for (int i = 0; i < 4; ++i)
            m_writer.given(QLatin1String(kAxes[i]) + QLatin1Char('_') + name, clip[i], partOf(name, clip));
    }

    /// How far a corner is inside of a plane: `{w_A} - {x_A}`.
    QString distanceOf(const PlaneEquation& plane, const QString& sign, const QString& corner)
    {
        QString text;
        if (plane.normal.w == 1) {
            text = formula("{w_%1}", corner);
        } else if (plane.normal.w != 0) {
            m_writer.given(QStringLiteral("g_") + sign, plane.normal.w);
            text = formula("{g_%1} * {w_%2}", sign, corner);
        }
        for (int axis = 0; axis < 3; ++axis)
            if (plane.normal[axis] != 0)
                text += formula(text.isEmpty() ? "%1{%2_%3}" : " %1 {%2_%3}",
                                plane.normal[axis] < 0 ? QStringLiteral("-")
                                : text.isEmpty()       ? QString()
                                                       : QStringLiteral("+"),
                                QLatin1String(kAxes[axis]), corner);
        if (plane.offset != 0) {
            m_writer.given(QStringLiteral("e_") + sign, plane.offset);
            text += formula(" - {e_%1}", sign);
        }
        return text;
    }

    /// The conditions -w <= x <= w of corners behind the eye: no x fulfils both.
    void writeBehindEye()
    {
        for (std::size_t i = 0; i < 3; ++i)
            if (const glm::dvec4& clip = m_record.corners()[i].clip; clip.w < 0)
                m_writer.compare(
                    formula("-{w_%1} <= {w_%1}", cornerLetter(i)),
                    {QT_TRANSLATE_NOOP("Derive", "Corner %1 lies behind the eye. -w <= x and x <= w cannot both "
                                                 "hold where w is negative, so it is outside of every view volume. "
                                                 "Divided by w first, -1 <= x / w <= 1, the conditions would "
                                                 "turn round and let mirrored corners in."),
                     {cornerLetter(i)}},
                    {partOf(cornerLetter(i), clip)});
    }

    /// t of the seven planes along one edge of the face, from its start to its end.
    void writeSevenFormulas()
    {
        const std::size_t first = m_record.edge();
        const QString from = cornerLetter(first);
        const QString to = cornerLetter((first + 1) % 3);
        const glm::dvec4& start = m_record.corners()[first].clip;
        const glm::dvec4& end = m_record.corners()[(first + 1) % 3].clip;
        for (int i = 0; i < kClipPlanes; ++i) {
            const auto plane = static_cast<ClipPlane>(i);
            const PlaneEquation& equation = m_volume.view[std::size_t(i)];
            const QString sign = signOf(plane);
            const QString d1 = distanceOf(equation, sign, from);
            const QString d2 = distanceOf(equation, sign, to);
            const CanvasPart mark{CanvasKind::Plane, QLatin1String(clipPlaneId(plane)), {}};
            const double distance1 = equation.distance(start);
            const double distance2 = equation.distance(end);
            if (distance1 == distance2) {
                m_writer.compare(
                    formula("%1 == %2", d1, d2),
                    {QT_TRANSLATE_NOOP("Derive", "Plane %1: both ends are equally far from it, so the edge never "
                                                 "meets it."),
                     {sign}},
                    {mark});
                continue;
            }
            m_writer.show(QStringLiteral("t_") + sign, mark);
            m_writer.line(formula("{t_%1}", sign), formula("(%1) / (%1 - (%2))", d1, d2),
                          sevenWords(sign, distance1 >= 0, distance2 >= 0), {mark});
        }
    }

    [[nodiscard]] static Reason sevenWords(const QString& sign, bool startInside, bool endInside)
    {
        if (startInside && endInside)
            return {QT_TRANSLATE_NOOP("Derive",
                                      "Plane %1: both ends are inside; the line meets it beyond them, with t outside "
                                      "of 0 to 1."),
                    {sign}};
        if (!startInside && !endInside)
            return {QT_TRANSLATE_NOOP("Derive", "Plane %1: both ends are outside; nothing of the edge is kept."),
                    {sign}};
        return {QT_TRANSLATE_NOOP("Derive",
                                  "Plane %1: the edge crosses it. t counts from the start of the edge to its end: the "
                                  "distance of the start over the difference of both."),
                {sign}};
    }

    /// One plane of Sutherland-Hodgman: the distances, then each edge. Returns the names of the corners that are left.
    std::vector<QString> writePlane(const ClipStep& step, const std::vector<QString>& names)
    {
        const QString sign = signOf(step.plane);
        const PlaneEquation& equation = m_volume.cut[static_cast<std::size_t>(step.plane)];
        const CanvasPart mark{CanvasKind::Plane, QLatin1String(clipPlaneId(step.plane)), {}};
        for (std::size_t i = 0; i < names.size(); ++i) {
            const QString id = formula("d_%1_%2", sign, names[i]);
            m_writer.given(id, step.distances[i], partOf(names[i], step.before[i].positionClip));
            m_writer.line(formula("{%1}", id), distanceOf(equation, sign, names[i]),
                          {QT_TRANSLATE_NOOP("Derive", "Plane %1: how far corner %2 is inside; outside is negative."),
                           {sign, names[i]}},
                          {mark});
        }
        std::vector<QString> kept;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::size_t next = (i + 1) % names.size();
            writeEdge(step, names, i, next, kept);
            if (step.distances[next] >= 0)
                kept.push_back(names[next]);
        }
        // The stage begins with the first corner it keeps, the walk above with the end of the first edge.
        if (!kept.empty() && step.distances[0] >= 0) {
            kept.insert(kept.begin(), kept.back());
            kept.pop_back();
        }
        return kept;
    }

    void writeEdge(const ClipStep& step, const std::vector<QString>& names, std::size_t i, std::size_t next,
                   std::vector<QString>& kept)
    {
        const bool isInside = step.distances[i] >= 0;
        const bool nextInside = step.distances[next] >= 0;
        const QString sign = signOf(step.plane);
        const QString& from = names[i];
        const QString& to = names[next];
        const QString end = formula("d_%1_%2", sign, to);
        const CanvasPart mark = edgeMark(step, names, i, next);
        if (isInside && nextInside) {
            m_writer.compare(
                formula("{%1} >= 0", end),
                {QT_TRANSLATE_NOOP("Derive", "Edge %1%2, inside to inside: its end %2 is kept."), {from, to}}, {mark});
        } else if (!isInside && !nextInside) {
            m_writer.compare(
                formula("{%1} < 0", end),
                {QT_TRANSLATE_NOOP("Derive", "Edge %1%2, outside to outside: nothing is kept."), {from, to}}, {mark});
        } else {
            kept.push_back(writeCut(step, names, isInside ? i : next, isInside ? next : i, isInside, mark));
        }
    }

    [[nodiscard]] CanvasPart edgeMark(const ClipStep& step, const std::vector<QString>& names, std::size_t i,
                                      std::size_t next) const
    {
        CanvasPart edge{CanvasKind::Edge, names[i] + names[next], {}};
        for (const std::size_t end : {i, next})
            for (const glm::dvec2& point : partOf(names[end], step.before[end].positionClip).points)
                edge.points.push_back(point);
        return edge;
    }

    /// The new corner on an edge; its name.
    QString writeCut(const ClipStep& step, const std::vector<QString>& names, std::size_t inside, std::size_t outside,
                     bool startsInside, const CanvasPart& mark)
    {
        const QString name = QStringLiteral("I%1").arg(++m_cuts);
        const QString sign = signOf(step.plane);
        const QString& in = names[inside];
        const QString& out = names[outside];
        for (const ClipCut& cut : step.cuts)
            if (std::size_t(cut.inside) == inside && std::size_t(cut.outside) == outside) {
                m_writer.given(QStringLiteral("t_") + name, cut.t);
                if (cut.corner >= 0)
                    giveCorner(name, step.after[std::size_t(cut.corner)].positionClip);
            }
        m_writer.line(
            formula("{t_%1}", name), formula("{d_%2_%3} / ({d_%2_%3} - {d_%2_%4})", name, sign, in, out),
            startsInside ? Reason(QT_TRANSLATE_NOOP("Derive", "Edge %1%2, inside to outside: the cut is kept, its end "
                                                              "%2 is not. t runs from the inside to the outside."),
                                  {in, out})
                         : Reason(QT_TRANSLATE_NOOP("Derive", "Edge %2%1, outside to inside: the cut is kept, and then "
                                                              "its end %1. t runs from the inside to the outside."),
                                  {in, out}),
            {mark});
        if (!startsInside)
            m_writer.line(formula("{t_%1_start}", name), formula("1 - {t_%1}", name),
                          QT_TRANSLATE_NOOP("Derive",
                                            "Counted from the start of the edge, as a text counts it. The program "
                                            "counts from the inside, so that both faces at an edge make the same "
                                            "corner."),
                          {mark});
        m_writer.line(
            formula("({x_%1}, {y_%1}, {z_%1}, {w_%1})", name),
            formula("(lerp({x_%2}, {x_%3}, {t_%1}), lerp({y_%2}, {y_%3}, {t_%1}), lerp({z_%2}, {z_%3}, {t_%1}), "
                    "lerp({w_%2}, {w_%3}, {t_%1}))",
                    name, in, out),
            {QT_TRANSLATE_NOOP("Derive", "The new corner %1, in all four coordinates: clip space is linear."), {name}},
            {mark});
        return name;
    }

    const FaceRecord& m_record;
    ClipVolume m_volume;
    DerivationWriter m_writer;
    int m_cuts = 0; ///< new corners so far
};

} // namespace

Derivation deriveCut(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                     const std::stop_token& stop)
{
    const FaceRecord record(scene, settings, place, stop);
    for (const VertexRow& corner : record.corners())
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(corner.clip[i]))
                throw NoDerivation{
                    Reason(QT_TRANSLATE_NOOP("Derive", "a corner of face %1 is no number"), {place.face})};
    return CutWriter(record).write();
}

} // namespace rasterlens
