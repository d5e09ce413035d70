#pragma once
#include "core/scene/scene.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// What an algorithm did to find the samples of a triangle. Comparisons and loop counters are not counted.
struct OperationCounts {
    std::uint64_t candidates = 0; ///< samples looked at
    std::uint64_t additions = 0;  ///< and subtractions
    std::uint64_t multiplications = 0;
    std::uint64_t divisions = 0;

    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// One sample of the run: edge equation looks at it, edge walking fills it.
struct RaceTick {
    int x = 0; ///< samples
    int y = 0;
    bool covered = false;
    OperationCounts soFar; ///< with this sample
};

struct RaceLane {
    Algorithm algorithm = Algorithm::EdgeEquation;
    std::vector<RaceTick> ticks;
    OperationCounts total; ///< also what was done after the last tick
};

struct RaceSample {
    int x = 0; ///< samples
    int y = 0;
    friend auto operator<=>(const RaceSample&, const RaceSample&) = default;
};

/// Both algorithms on one face, to be shown tick by tick beside each other.
struct AlgorithmRace {
    RaceLane walking;
    RaceLane equation;
    std::vector<RaceSample> onlyWalking; ///< chosen by one of them alone, by row
    std::vector<RaceSample> onlyEquation;
};

/// Runs both algorithms on a face and counts what their loops do, under the settings' number type and stepping.
///
/// in   a face of the mesh; settings for which unsupported() is empty
/// out  no ticks if the face is not drawn
/// errors  `stop` ends the work early; what is returned then means nothing
[[nodiscard]] AlgorithmRace raceAlgorithms(const Scene& scene, const Settings& settings, std::uint32_t face,
                                           const std::stop_token& stop = {});

} // namespace rasterlens
