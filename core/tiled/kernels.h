#pragma once
#include "core/tiled/frame_job.h"

#include <cstddef>
#include <cstdint>

namespace rasterlens::tiled
{

/// The stages that are written in vector instructions.
struct Kernels {
    void (*processVertices)(const FrameJob& job, std::size_t begin, std::size_t end);
    void (*processFaces)(const FrameJob& job, Chunk& chunk, std::uint32_t begin, std::uint32_t end);
    void (*drawTiles)(const FrameJob& job, Worker& worker, int columnBegin, int columnEnd, int row);
};

/// The stages for an instruction set, or nothing where the machine does not have it. Auto is the best there is.
[[nodiscard]] const Kernels* kernelsFor(Simd simd);

/// The instruction set Auto stands for on this machine; the others stand for themselves.
[[nodiscard]] Simd simdFor(Simd simd);

/// The kernels with vectors of one lane (kernels_scalar.cpp): what every other target must do, bit for bit.
[[nodiscard]] const Kernels* scalarKernels();

} // namespace rasterlens::tiled
