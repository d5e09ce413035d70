#pragma once
#include "core/pipeline/statistics.h"
#include "core/pipeline/types.h"

namespace rasterlens
{

/// Counts a face that was submitted, by what became of it.
inline void countFate(FaceFate fate, Statistics::Faces& faces)
{
    ++faces.submitted;
    switch (fate) {
    case FaceFate::Rejected: ++faces.rejected; break;
    case FaceFate::CulledBack: ++faces.culledBack; break;
    case FaceFate::CulledFront: ++faces.culledFront; break;
    case FaceFate::Degenerate: ++faces.degenerate; break;
    case FaceFate::NonFinite: ++faces.nonFinite; break;
    case FaceFate::Rasterized: ++faces.rasterized; break;
    }
}

} // namespace rasterlens
