#!/usr/bin/env bash
# Question: Babylon.js exports a half transparent red box, `OBJExport.OBJ(mesh, true, "box.mtl")` and `OBJExport.MTL(mesh)`. Which
#   colour and opacity does another program find?
# Usual guess: those of the box.
# Seen with @babylonjs/serializers 9.28.0 (npm): none. The OBJ names the library "box.mtl.mtl" and the material by its own
#   name, `usemtl paint`; the MTL calls it `newmtl mat1`. Opacity is written twice, once as `d 0.5` and once as `Tr 0`, which by
#   the usual reading is opaque: assimp takes the later line, three.js keeps the first.
# Why it matters: the model is drawn grey, and whoever repairs the two names by hand gets an opaque or a transparent box
#   depending on the reader.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund @babylonjs/core@9.35.0 @babylonjs/serializers@9.28.0 >/dev/null 2>&1 || exit 2
cat >write.mjs <<'JS'
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { CreateBox } from '@babylonjs/core/Meshes/Builders/boxBuilder.js';
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js';
import { Color3 } from '@babylonjs/core/Maths/math.color.js';
import { OBJExport } from '@babylonjs/serializers/OBJ/index.js';
const scene = new Scene(new NullEngine());
const box = CreateBox('box', { size: 2 }, scene);
box.material = new StandardMaterial('paint', scene);
box.material.diffuseColor = new Color3(1, 0, 0);
box.material.alpha = 0.5;
const text = OBJExport.OBJ([box], true, 'box.mtl') + '\n' + OBJExport.MTL(box);
process.stdout.write(text.split('\n').filter((l) => /^ *(mtllib|usemtl|newmtl|d|Tr) /.test(l)).map((l) => l.trim() + '\n').join(''));
process.exit(0);
JS
node write.mjs | grep -v '^BJS' | tee seen # the engine greets
printf 'mtllib box.mtl.mtl\nusemtl paint\nnewmtl mat1\nd 0.5000\nTr 0.0000\n' | diff - seen || { echo "This changed."; exit 1; }
