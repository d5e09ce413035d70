#!/usr/bin/env bash
# Question: a mesh that is mirrored (scale.x = -1) looks right in three.js. Is it right in the OBJ file that OBJExporter writes?
# Usual guess: yes. Positions and normals are transformed, and the picture in the browser culls the right faces.
# Seen with three.js r170 (npm three 0.170.0): positions are mirrored and the normals point outside, but the corners keep
#   their order, so all faces are clockwise: vn says +z, the winding says -z. In the browser the renderer swaps the front
#   face where the matrix has a negative determinant; in the file nothing does.
# Why it matters: with back-face culling each mirrored part of a model is invisible or shows its far wall, lit as if it were
#   the near one. Half of all hand-modelled scenes are mirrored somewhere.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three@0.170.0 >/dev/null 2>&1 || exit 2
cat >write.mjs <<'JS'
import * as THREE from 'three';
import { OBJExporter } from 'three/examples/jsm/exporters/OBJExporter.js';
for (const scale of [1, -1]) {
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2));
    mesh.scale.x = scale;
    mesh.updateMatrixWorld();
    const lines = new OBJExporter().parse(mesh).split('\n').map((l) => l.split(' '));
    const v = lines.filter((l) => l[0] === 'v').map((l) => l.slice(1).map(Number));
    const vn = lines.filter((l) => l[0] === 'vn').map((l) => l.slice(1).map(Number));
    for (const face of lines.filter((l) => l[0] === 'f')) {
        const [a, b, c] = face.slice(1, 4).map((corner) => v[corner.split('/')[0] - 1]);
        const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        console.log(`scale.x ${scale}: winding ${Math.sign(area) > 0 ? '+z' : '-z'}, vn ${vn[0][2] > 0 ? '+z' : '-z'}`);
    }
}
JS
node write.mjs | tee seen
[ "$(grep -c 'scale.x 1: winding +z, vn +z' seen)" = 2 ] && [ "$(grep -c 'scale.x -1: winding -z, vn +z' seen)" = 2 ] || {
    echo "This changed."
    exit 1
}
