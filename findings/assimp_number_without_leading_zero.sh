#!/usr/bin/env bash
# Question: an OBJ file says `vt .5 1` or `v 1 .5 0`. Does a loader that half of the engines use read it?
# Usual guess: yes. `.5` is what strtod, printf("%g") without a zero, Fortran and hand-made files give; all parsers take it.
# Seen with assimp 5.2.5 (Debian 12, libassimp5 5.2.5~ds0-1+b1): components are counted by the words that begin with a digit
#   or a sign, so `.5` does not count. `vt .5 1` has too few: the whole file is refused. `v 1 .5 0` is worse: the vertex is
#   dropped in silence, all later ones move down by one, and only the last index is then out of range. With a w behind
#   (`v 1 .5 0 1`) three words count, and .5 is read as it stands.
# Why it matters: people who write OBJ files for a rasterizer by hand or with a short format string get a picture with
#   shifted corners or none, and look for the fault in their own code.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1 \
    >/dev/null 2>&1 || exit 2
for deb in *.deb; do dpkg -x "$deb" .; done
export LD_LIBRARY_PATH=$PWD/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
seen() # what assimp says about an OBJ text
{
    printf '%b' "$1" >in.obj
    ./usr/bin/assimp export in.obj out.obj >said 2>&1 || true
    grep -o 'ERROR.*' said || grep -c '^v ' out.obj
    rm -f out.obj
}
corners='v 0 0 0\nv 1 0.5 0\nv 0 1 0\n'
{
    echo "vt 0.5 1:         $(seen "${corners}vt 0.5 1\nf 1/1 2/1 3/1\n") vertices"
    echo "vt .5 1:          $(seen "${corners}vt .5 1\nf 1/1 2/1 3/1\n")"
    echo "v 1 .5 0:         $(seen 'v 0 0 0\nv 1 .5 0\nv 0 1 0\nf 1 2 3\n')"
    echo "v 1 .5 0, spare:  $(seen 'v 0 0 0\nv 1 .5 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\n') vertices, and the face has the wrong ones"
    echo "v 1 .5 0 1:       $(seen 'v 0 0 0 1\nv 1 .5 0 1\nv 0 1 0 1\nf 1 2 3\n') vertices"
} | tee seen
grep -q '^vt 0.5 1: *3 vertices' seen && grep -q '^vt .5 1: .*Invalid number of components' seen &&
    grep -q '^v 1 .5 0: .*index out of range' seen && grep -q 'spare: *3 vertices' seen || {
    echo "This changed."
    exit 1
}
