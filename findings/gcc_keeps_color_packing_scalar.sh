#!/usr/bin/env bash
# Question: the loop that ends every software renderer clamps a colour to 0..1, takes 255 times it plus a half, and stores
#   a byte. Does a compiler at -O3 make vector instructions of it?
# Usual guess: yes, it is two comparisons and a product, and vectors have max and min. If not, -ffast-math is to blame for
#   being off, which nobody wants for its other effects.
# Seen with GCC 12.2.0 (Debian 12, x86-64; 14.2.0 says the same): no. "not vectorized: control flow in loop", every channel
#   by itself, also with std::max and std::min. Of -ffast-math only one word is missing: -fno-trapping-math, which changes
#   no value, only which floating-point exception flags stand afterwards. Clang 14 behaves as if it were given.
# Why it matters: people who rasterize compare compilers by this loop, or write it by hand in intrinsics, and do not know
#   that one harmless option is all that GCC asks for.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg --print-architecture) == amd64 ]] || exit 2
apt-get download -q g++-12=12.2.0-14+deb12u1 libisl23=0.25-1.1 libmpc3=1.3.1-1 libmpfr6=4.2.0-1 \
    libgmp10=2:6.2.1+dfsg1-1.1 clang-14=1:14.0.6-12 libclang-cpp14=1:14.0.6-12 libllvm14=1:14.0.6-12 \
    libz3-4=4.8.12-3.1 libedit2=3.1-20221030-2 libbsd0=0.11.7-2 libmd0=1.0.4-2 libxml2 libicu72 \
    >/dev/null 2>&1 || exit 2
for deb in *.deb; do dpkg -x "$deb" .; done
export LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu:$PWD/lib/x86_64-linux-gnu:$PWD/usr/lib/llvm-14/lib

pack() # writes NAME.cpp, a loop with this clamp to 0 and this clamp to 1
{
    cat >"$1.cpp" <<TEXT
template <class T> constexpr const T& max(const T& a, const T& b) { return a < b ? b : a; } // as the standard says
template <class T> constexpr const T& min(const T& a, const T& b) { return b < a ? b : a; }
void pack(const float* color, unsigned char* out, int count)
{
    for (int i = 0; i < count; ++i) {
        const float held = $2;
        out[i] = static_cast<unsigned char>(static_cast<int>(($3) * 255.0F + 0.5F));
    }
}
TEXT
}
pack by_conditions 'color[i] > 0.0F ? color[i] : 0.0F' 'held < 1.0F ? held : 1.0F'
pack by_functions 'max(color[i], 0.0F)' 'min(held, 1.0F)'
gcc=usr/lib/gcc/x86_64-linux-gnu/12/cc1plus
conversions() { grep -q cvttps2dq "$1" && echo 'four at once' || { grep -q cvttss2si "$1" && echo 'one by one'; }; }
{
    for source in by_conditions by_functions; do
        for option in '' -fno-trapping-math; do
            "$gcc" -quiet -O3 $option "$source.cpp" -o out.s
            echo "GCC 12 -O3 $option, $source: $(conversions out.s)"
        done
        ./usr/lib/llvm-14/bin/clang -O3 -S -x c++ "$source.cpp" -o out.s
        echo "Clang 14 -O3, $source: $(conversions out.s)"
    done
} | tee seen
[[ $(grep -c '^GCC 12 -O3 , .*: one by one$' seen) == 2 && $(grep -c 'no-trapping-math, .*: four at once$' seen) == 2 &&
    $(grep -c '^Clang .*: four at once$' seen) == 2 ]] || {
    echo "This changed."
    exit 1
}
