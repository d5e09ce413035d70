#pragma once
#include "core/derive/face_record.h"

namespace rasterlens
{

/// The edge of a face that a place names, as it lies on the canvas.
class PlaceEdge
{
public:
    explicit PlaceEdge(const FaceRecord& record) : m_record(&record), m_first(record.edge()), m_last((m_first + 1) % 3)
    {
    }

    [[nodiscard]] const VertexRow& start() const { return m_record->corners()[m_first]; }
    [[nodiscard]] const VertexRow& end() const { return m_record->corners()[m_last]; }
    [[nodiscard]] QString startName() const { return cornerLetter(m_first); }
    [[nodiscard]] QString endName() const { return cornerLetter(m_last); }

    [[nodiscard]] CanvasPart startPart() const { return {CanvasKind::Corner, startName(), {start().screen}}; }
    [[nodiscard]] CanvasPart endPart() const { return {CanvasKind::Corner, endName(), {end().screen}}; }
    [[nodiscard]] CanvasPart part() const { return edgePart(startName() + endName(), start().screen, end().screen); }
    /// What the ends are called where they are seen on the screen: `A'`.
    [[nodiscard]] QString startSeen() const { return startName() + QLatin1Char('\''); }
    [[nodiscard]] QString endSeen() const { return endName() + QLatin1Char('\''); }
    /// The point at the part m of the way on the screen.
    [[nodiscard]] CanvasPart seenPart() const { return pointPart(QStringLiteral("P'"), m_record->place().m); }
    /// A formula with the names of the start and the end in place of %1 and %2.
    [[nodiscard]] QString named(const char* pattern) const { return formula(pattern, startName(), endName()); }
    /// Gives m, the w of both ends by a name, and their place along the axis on which they are further apart on the
    /// screen, which is the one that a view from the side shows.
    void giveSideView(DerivationWriter& writer, const QString& w) const
    {
        const glm::dvec2 apart = glm::abs(end().screen - start().screen);
        const int axis = apart.x >= apart.y ? 0 : 1;
        writer.given(QStringLiteral("m"), m_record->place().m, seenPart());
        writer.given(w + QLatin1Char('1'), start().clip.w, startPart());
        writer.given(w + QLatin1Char('2'), end().clip.w, endPart());
        writer.given(QStringLiteral("X1"), start().clip[axis], startPart());
        writer.given(QStringLiteral("X2"), end().clip[axis], endPart());
        writer.show(startSeen(), startPart());
        writer.show(endSeen(), endPart());
        writer.show(QStringLiteral("P'"), seenPart());
    }
    /// The point at a part of the way on the screen: 0 is the start, 1 the end.
    [[nodiscard]] CanvasPart pointPart(const QString& name, double part) const
    {
        return {CanvasKind::Point, name, {start().screen + part * (end().screen - start().screen)}};
    }

private:
    const FaceRecord* m_record;
    std::size_t m_first;
    std::size_t m_last;
};

} // namespace rasterlens
