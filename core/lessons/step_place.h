#pragma once
#include "core/observe/step_log.h"
#include "core/observe/step_record.h"

#include <QPoint>
#include <QString>

#include <memory>
#include <optional>

namespace rasterlens
{

/// A place in a step log, by number or by what happens there.
struct StepPlace {
    std::optional<std::size_t> position; ///< the number itself; then nothing below counts
    bool end = false;                    ///< the finished picture; then nothing below counts
    std::optional<StepStop::Kind> stop;  ///< the first event that a run stops at
    std::optional<std::uint32_t> face;   ///< only events of this face
    std::optional<StepKind> kind;        ///< only events of this kind
    std::optional<QPoint> pixel;         ///< only what happens at this pixel
    int nth = 1;                         ///< the how manyth of these events

    friend bool operator==(const StepPlace&, const StepPlace&) = default;
};

/// Reads what `rasterlens --step` takes, and more: `12`; `tie`, `sign-change`, `depth-fail`, `clip` or `nan`, the first
/// of its kind; `end`; or any of `face N`, the name of a kind of step (`sample`, `clip-plane`), a pixel `x,y` and `#n`,
/// in this order: `face 1 sample 3,4`, `face 0 clip-plane #2`. A stop may follow the face: `face 1 tie`.
///
/// errors  nothing for any other text
[[nodiscard]] std::optional<StepPlace> stepPlaceFromText(const QString& text);

/// The text that is read as this place.
[[nodiscard]] QString textOf(const StepPlace& place);

/// The position just after the event, or nothing where the log has no event like it.
[[nodiscard]] std::optional<std::size_t> positionOf(const StepPlace& place, const StepLog& log);
[[nodiscard]] std::optional<std::size_t> positionOf(const StepPlace& place,
                                                    const std::shared_ptr<const StepRecord>& record);

/// What a step is told by, for error messages: `a number, tie, ..`.
[[nodiscard]] QString stepPlaceHelp();

} // namespace rasterlens
