#include "core/settings/view_planes.h"

#include <QCoreApplication>

namespace rasterlens
{

std::optional<Reason> whyNotPlanes(std::optional<double> near, std::optional<double> far)
{
    if (near && !(*near > 0))
        return Reason(QT_TRANSLATE_NOOP("Diagnostic",
                                        "the near plane is at %1, but must lie before the eye, at more than "
                                        "0: with n = 0, z' = n + f - nf/z is f for every z, and x' = nx/z "
                                        "is 0 for every x"),
                      {QString::number(*near)});
    if (far && !(*far > 0))
        return Reason(
            QT_TRANSLATE_NOOP("Diagnostic", "the far plane is at %1, but must lie before the eye, at more than 0"),
            {QString::number(*far)});
    if (near && far && !(*near < *far))
        return Reason(QT_TRANSLATE_NOOP("Diagnostic",
                                        "the far plane is at %2, but must lie beyond the near plane at %1: "
                                        "z' = n + f - nf/z runs from n to f, which leaves no depth between"),
                      {QString::number(*near), QString::number(*far)});
    return std::nullopt;
}

} // namespace rasterlens
