#define HWY_COMPILE_ONLY_SCALAR
#include "core/tiled/kernels.h"
#include "core/tiled/tile-inl.h"

namespace rasterlens::tiled
{

const Kernels* scalarKernels() { return &HWY_NAMESPACE::kKernels; }

} // namespace rasterlens::tiled
