#pragma once
#include <QIcon>

namespace rasterlens
{

/// The signs on the transport's buttons, growing with the way they go.
enum class TransportSign { Play, Pause, Step, Row, Face, Stage, End };

/// in  backward: mirrored
[[nodiscard]] QIcon transportIcon(TransportSign sign, bool backward, const QColor& ink, const QColor& faded);

} // namespace rasterlens
