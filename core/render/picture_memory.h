#pragma once
#include "core/settings/settings.h"

#include <QString>

#include <cstdint>

namespace rasterlens
{

/// From so many samples on, the programs say what a picture takes before they draw it, and the window keeps no memory
/// of such pictures for later ones.
constexpr std::int64_t kLargePicture = std::int64_t(1) << 26;

[[nodiscard]] std::int64_t samplesOf(const Settings& settings);
[[nodiscard]] inline bool isLarge(const Settings& settings) { return samplesOf(settings) >= kLargePicture; }

/// Bytes that a picture takes at most, while it is being counted: colour, depth and face of every pixel; with several
/// samples a pixel also depth and face of every sample.
[[nodiscard]] std::int64_t pictureBytes(const Settings& settings);

/// Bytes that the system can still give, swap included; the largest number there is where it does not tell.
[[nodiscard]] std::int64_t freeMemoryBytes();

/// `5.4 GB`
[[nodiscard]] QString gigabytesText(std::int64_t bytes);

} // namespace rasterlens
