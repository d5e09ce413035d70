#pragma once
#include "core/derive/face_record.h"

namespace rasterlens
{

// One function a topic. Each throws NoDerivation where the place has nothing to derive.

[[nodiscard]] Derivation deriveBresenham(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                         const std::stop_token& stop);
[[nodiscard]] Derivation deriveEdgeFunction(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                            const std::stop_token& stop);
[[nodiscard]] Derivation deriveBounds(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                      const std::stop_token& stop);
[[nodiscard]] Derivation deriveInside(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                      const std::stop_token& stop);
[[nodiscard]] Derivation deriveBarycentric(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                           const std::stop_token& stop);
[[nodiscard]] Derivation derivePerspective(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                           const std::stop_token& stop);
[[nodiscard]] Derivation deriveDepthCurve(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                          const std::stop_token& stop);
[[nodiscard]] Derivation deriveCut(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                   const std::stop_token& stop);
[[nodiscard]] Derivation deriveCohenSutherland(const Scene& scene, const Settings& settings,
                                               const DerivationPlace& place, const std::stop_token& stop);
[[nodiscard]] Derivation deriveTwoPoint(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                        const std::stop_token& stop);
[[nodiscard]] Derivation deriveFlatLight(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                         const std::stop_token& stop);
[[nodiscard]] Derivation derivePainter(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                       const std::stop_token& stop);
[[nodiscard]] Derivation deriveAttribute(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                         const std::stop_token& stop);
[[nodiscard]] Derivation deriveBlend(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                                     const std::stop_token& stop);

} // namespace rasterlens
