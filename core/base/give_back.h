#pragma once
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rasterlens
{

/// Gives memory that was freed back to the system, where the C library keeps it for later. For after work that needed
/// much more than what is left of it.
inline void giveBackFreedMemory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace rasterlens
