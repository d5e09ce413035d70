#pragma once
#include "core/tiled/kernels.h"

namespace rasterlens::tiled
{

/// The same source with vectors of one lane: what every other target must do, bit for bit.
[[nodiscard]] const Kernels* scalarKernels();

} // namespace rasterlens::tiled
