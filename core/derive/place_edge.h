#pragma once
#include "core/derive/face_record.h"

namespace rasterlens
{

/// The edge of a face that a place names, as it lies on the canvas.
class PlaceEdge
{
public:
    explicit PlaceEdge(const FaceRecord& record)
        : m_record(&record), m_first(std::size_t(record.place().edge)), m_last((m_first + 1) % 3)
    {
    }

    [[nodiscard]] const VertexRow& start() const { return m_record->corners()[m_first]; }
    [[nodiscard]] const VertexRow& end() const { return m_record->corners()[m_last]; }
    [[nodiscard]] QString startName() const { return cornerLetter(m_first); }
    [[nodiscard]] QString endName() const { return cornerLetter(m_last); }

    [[nodiscard]] CanvasPart startPart() const { return {CanvasKind::Corner, startName(), {start().screen}}; }
    [[nodiscard]] CanvasPart endPart() const { return {CanvasKind::Corner, endName(), {end().screen}}; }
    [[nodiscard]] CanvasPart part() const { return edgePart(startName() + endName(), start().screen, end().screen); }
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
