#!/usr/bin/env bash
# Question: CloudCompare opens an OBJ file in which only some faces have texture coordinates and normals, and saves it. Do
#   the others still have none?
# Usual guess: yes, as `f 5 6 7`.
# Seen with CloudCompare 2.11.3 (Debian 12): they become `f 5/-1/-1 6/-1/-1 7/-1/-1`. It means "none" by -1, its own value; in an OBJ
#   file -1 is the last vt and the last vn so far. Every reader that follows the format gives these corners the texture
#   coordinate and the normal of an unrelated vertex. On the way the normal (0, 0, 1) became (0.00097752, 0.00097752,
#   0.99999905): normals are kept in few bits.
# Why it matters: part of the model gets one texel and one wrong, constant shade. The file passes every check, since each
#   index is within range.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had (apt-get install cloudcompare xvfb xauth).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg-query -Wf '${Version}' cloudcompare 2>/dev/null) == 2.11.3* ]] && command -v xvfb-run >/dev/null || exit 2
printf 'newmtl wood\nKd 1 1 1\nmap_Kd t.ppm\nnewmtl paint\nKd 1 0 0\n' >in.mtl
printf 'P3 1 1 255 200 120 40\n' >t.ppm
cat >in.obj <<'OBJ'
mtllib in.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vt 0 0
vt 1 0
vt 0 1
vn 0 0 1
g first
usemtl wood
f 1/1/1 2/2/1 3/3/1
g second
usemtl paint
f 1 2 4
OBJ
xvfb-run -a CloudCompare -SILENT -AUTO_SAVE OFF -O in.obj -M_EXPORT_FMT OBJ -SAVE_MESHES FILE out.obj >said 2>&1 || true
grep -E '^(vn|f) ' out.obj | tee seen
grep -q '^f 1/-1/-1 2/-1/-1 4/-1/-1' seen && grep -q '^vn 0.0009' seen || { echo "This changed."; exit 1; }
