#!/usr/bin/env bash
# Question: Highway's Compress() moves the chosen lanes of a vector to its front. AVX-512 has an instruction for it
#   (vpcompressq, two cycles). What does a call with lanes of 64 bits cost?
# Usual guess: about that instruction; or, with a table, a load from the table.
# Seen with Highway 1.0.3 and GCC 12.2.0 (Debian 12, x86-64, -O3): 2,048 bytes copied to the stack, at each call. The table
#   is a constexpr array inside the function, but not static, and one is as new as every local variable: GCC makes it anew
#   from its read-only twin before it reads 8 bytes of it. Lanes of 32 bits have the instruction and no table.
# Why it matters: a loop that packs what passed a test (particles, triangles, rows of a table) gets slower by the function
#   it was given to be fast with: RasterLens' faces took 1.7 times as long.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg --print-architecture) == amd64 ]] || exit 2
command -v g++-12 >/dev/null || exit 2
apt-get download -q libhwy-dev=1.0.3-3+deb12u1 >/dev/null 2>&1 || exit 2
for deb in *.deb; do dpkg -x "$deb" .; done

compress() # writes the assembly of compressing a vector of numbers of this type
{
    cat >compress.cpp <<TEXT
#define HWY_COMPILE_ONLY_STATIC
#include <hwy/highway.h>
namespace hn = hwy::HWY_NAMESPACE;
void compress(const $1* from, unsigned char bits, $1* to)
{
    const hn::CappedTag<$1, 8> tag;
    hn::StoreU(hn::Compress(hn::LoadU(tag, from), hn::LoadMaskBits(tag, &bits)), tag, to);
}
TEXT
    g++-12 -std=c++17 -O3 -march=skylake-avx512 -maes -mpclmul -isystem usr/include -S -o - compress.cpp
}
narrow=$(compress float)
wide=$(compress double)
echo "32 bits a lane: $(grep -oE 'v(pcompressd|compressps)' <<<"$narrow")"
echo "64 bits a lane: $(grep -oE 'movl.*\$2048.*|rep movsq|call.*memcpy|v(pcompressq|compresspd)' <<<"$wide" | tr -s '\t\n' ' ')"
grep -qE 'rep movsq|call.*memcpy' <<<"$wide"
