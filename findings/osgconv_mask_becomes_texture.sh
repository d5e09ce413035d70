#!/usr/bin/env bash
# Question: a leaf has `map_d mask.png` and no map_Kd. osgconv reads the OBJ and writes an OBJ. What becomes of the mask?
# Usual guess: it is kept or dropped.
# Seen with OpenSceneGraph 3.6.5 (Debian 12): it comes out as `map_Kd mask.png`. The leaf is painted with its own mask, white on
#   black, and has no hole. The model is also turned, y and z changing places: unless both ways use the plugin's option
#   noRotation, (x, y, z) is (x, -z, y) afterwards.
# Why it matters: a material that says one thing is read as saying another, and nothing warns. In a rasterizer this looks like an
#   alpha test that is off.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had (apt-get install openscenegraph).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg-query -Wf '${Version}' openscenegraph 2>/dev/null) == 3.6.5* ]] || exit 2
printf 'P6\n1 1\n255\n\200\200\200' >mask.ppm
printf 'newmtl leaf\nKd 0 0.5 0\nmap_d mask.ppm\n' >in.mtl
printf 'mtllib in.mtl\nv 0 0 0\nv 1 0 0\nv 0 2 3\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl leaf\nf 1/1 2/2 3/3\n' >in.obj
osgconv in.obj out.obj >said 2>&1
{
    grep -E 'map_' out.mtl | sed 's/^ *//'
    grep '^v ' out.obj
} | tee seen
grep -q '^map_Kd .*mask' seen && ! grep -q map_d seen && grep -q '^v 0 3 -2\|^v 0 -3 2' seen || { echo "This changed."; exit 1; }
