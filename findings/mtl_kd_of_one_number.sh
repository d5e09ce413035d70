#!/usr/bin/env bash
# Question: a material says `Kd 0.5`. What colour is it?
# Usual guess: grey, (0.5, 0.5, 0.5): the MTL text says that g and b are optional and then equal r.
# Seen: assimp 5.2.5 reads (0.5, 0, 0), a dark red; tinyobjloader 2.0rc10 too; three.js r170 reads (0.214, NaN, NaN), 0.214
#   being 0.5 as linear light. (Blender 3.4.1: its newer importer keeps its default, (0.5, 0.8, 0.8), its older one is grey.)
#   Nobody says a word.
# Why it matters: a NaN in a uniform makes whole triangles black or white depending on the driver, and blending or a mean
#   over samples then spreads it to what lies beneath.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 \
    libminizip1=1.1-8+deb12u1 libtinyobjloader-dev=2.0.0~rc10+dfsg-2+b1 libtinyobjloader2rc10=2.0.0~rc10+dfsg-2+b1 \
    >/dev/null 2>&1 || exit 2
for deb in *.deb; do dpkg -x "$deb" .; done
npm install --silent --no-audit --no-fund three@0.170.0 >/dev/null 2>&1 || exit 2
lib=$PWD/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
export LD_LIBRARY_PATH=$lib
printf 'newmtl half_grey\nKd 0.5\n' >m.mtl
printf 'mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl half_grey\nf 1 2 3\n' >m.obj
./usr/bin/assimp export m.obj out.obj >/dev/null
cat >read.mjs <<'JS'
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { readFileSync } from 'node:fs';
const materials = new MTLLoader().parse(readFileSync('m.mtl', 'utf8'), '');
materials.preload();
console.log(materials.materials.half_grey.color.toArray().map((c) => c.toFixed(3)).join(' '));
JS
cat >read.cpp <<'CPP'
#include <cstdio>
#include <tiny_obj_loader.h>
int main()
{
    tinyobj::ObjReader reader;
    reader.ParseFromFile("m.obj");
    const auto& kd = reader.GetMaterials().at(0).diffuse;
    std::printf("%g %g %g\n", double(kd[0]), double(kd[1]), double(kd[2]));
}
CPP
g++ -std=c++17 -isystem usr/include read.cpp "$lib"/libtinyobjloader.so.* -o read
{
    echo "assimp: $(sed -n '/half_grey/,$p' out.mtl | grep -m1 Kd)"
    echo "three.js: $(node read.mjs)"
    echo "tinyobjloader: $(./read)"
} | tee seen
printf 'assimp: Kd 0.5 0 0\nthree.js: 0.214 NaN NaN\ntinyobjloader: 0.5 0 0\n' | diff - seen || { echo "This changed."; exit 1; }
