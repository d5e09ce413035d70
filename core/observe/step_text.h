#pragma once
#include "core/observe/step_log.h"

#include <QJsonObject>
#include <QString>

namespace rasterlens
{

/// A number as people read it: 6 significant digits, `nan`, `inf`. Not translated.
[[nodiscard]] QString shortNumber(double value);

/// The shortest text that reads back as the same double.
[[nodiscard]] QString fullNumber(double value);

/// An edge value in areas of samples: value / unitsPerArea.
///
/// exact  all decimals where unitsPerArea is 65536 (fixed point): -229376 gives -3.5; else as fullNumber
[[nodiscard]] QString edgeValueText(double value, double unitsPerArea);

/// `AB`, `BC`, `CA`: the edge of the setup by the vertices of the screen triangle. A triangle that was turned round has
/// A, C and B as its vertices.
[[nodiscard]] QString edgeName(const StepSetup& setup, int edge);

/// Stable ids. Not translated.
[[nodiscard]] const char* clipPlaneId(ClipPlane plane); ///< `near`
[[nodiscard]] const char* faceFateId(FaceFate fate);    ///< `culled-back`
[[nodiscard]] const char* facingId(Facing facing);      ///< `screen`
[[nodiscard]] QString colorText(std::uint32_t color);   ///< `#rrggbb`
[[nodiscard]] QString planesText(std::uint32_t planes); ///< names of a set of planes, `none` if empty

/// `face 12 (line 345)`: a triangle and the line of the `f` in the scene's file that it is a part of; `face 12` where
/// `line` is -1. Not translated.
[[nodiscard]] QString faceText(std::uint32_t face, std::int32_t line);

/// One event in one line, as `rasterlens-cli steps` prints it: kind, face, place, numbers. Not translated.
[[nodiscard]] QString stepText(const StepLog& log, std::size_t i);

/// The same with every number in full.
[[nodiscard]] QJsonObject stepJson(const StepLog& log, std::size_t i);

} // namespace rasterlens
