#pragma once
#include "core/scene/scene.h"

#include <QPointF>

namespace rasterlens
{

/// How the mouse and the keys move the camera: each takes the view there is and gives the next one.
///
/// in   drag distances in viewport pixels, y down

/// The eye goes round the scene; one viewport height is half a turn.
[[nodiscard]] View orbit(const View& view, QPointF drag, int viewportHeight);

/// The scene follows the mouse at the depth of its centre.
[[nodiscard]] View panCamera(const View& view, QPointF drag, int viewportHeight, const BoundingSphere& bounds);

/// The eye comes nearer (factor < 1) or goes away.
[[nodiscard]] View dolly(const View& view, double factor);

enum class AxisView { Front, Right, Top };
[[nodiscard]] View axisView(const View& view, AxisView axis);

} // namespace rasterlens
