#pragma once
#include "core/base/reason.h"
#include "core/observe/step_log.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

namespace rasterlens
{

/// An edge value in areas of samples: value / unitsPerArea.
///
/// exact  all decimals where unitsPerArea is 65536 (fixed point): -229376 gives -3.5; else as fullNumber
[[nodiscard]] QString edgeValueText(double value, double unitsPerArea);

/// `AB`, `BC`, `CA`: the edge of the setup by the vertices of the screen triangle. A triangle that was turned round has
/// A, C and B as its vertices.
[[nodiscard]] QString edgeName(const StepSetup& setup, int edge);

/// `CA`: the edge of the setup between two corners of edge walking, counted from 0 at the top.
[[nodiscard]] QString walkedEdgeName(const StepSetup& setup, const WalkedTriangle& walk, std::size_t from,
                                     std::size_t to);

/// How edge walking sorted the triangle of an event; null where the record does not hold it.
[[nodiscard]] const WalkedTriangle* walkOf(const StepLog& log, const StepEvent& event);

/// The mean of a pixel's samples written out, a text for each channel: `R = (240 + 240 + 0 + 1) / 4 = 120.25 -> 120`.
[[nodiscard]] QStringList meanSums(const ResolvedPixel& pixel);

/// `E_AB`, its value; `t_AB`, the smallest value that counts as inside.
[[nodiscard]] QString edgeValueName(const StepSetup& setup, int edge);
[[nodiscard]] QString thresholdName(const StepSetup& setup, int edge);
/// In areas of samples: `0`, or `1/65536` in fixed point.
[[nodiscard]] QString thresholdText(double threshold, double unitsPerArea);

/// Nothing to say.
[[nodiscard]] inline bool isEmpty(const Reason& said) { return said.text == nullptr && said.name.isEmpty(); }

/// What an event says; its texts are of the context "Steps". Each part may be empty.
struct StepParts {
    Reason what;    ///< `near`
    Reason numbers; ///< `3 -> 4 vertices`
};
[[nodiscard]] StepParts stepParts(const StepLog& log, std::size_t i);

/// One event in one line, as `rasterlens-cli steps` prints it: kind, face, place, numbers. Not translated.
[[nodiscard]] QString stepText(const StepLog& log, std::size_t i);

/// One event as a JSON object, with every number in full.
[[nodiscard]] QJsonObject stepJson(const StepLog& log, std::size_t i);

} // namespace rasterlens
