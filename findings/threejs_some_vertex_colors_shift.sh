#!/usr/bin/env bash
# Question: only some `v` lines of an OBJ file carry a colour behind the position. What happens to the others?
# Usual guess: they are white, or the reader refuses the colours.
# Seen with three.js r170 (npm three 0.170.0): OBJLoader lists the colours that there are, one behind the other. The colour
#   attribute is then shorter than the positions: the colour of the third vertex is found at the first one, and the rest
#   read beyond the buffer (0 in WebGL). No warning.
# Why it matters: two scans, one coloured and one not, joined by `cat` or by an exporter, come out coloured in the wrong
#   places; a reader that keeps one colour a vertex shows where the colours belong.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three@0.170.0 >/dev/null 2>&1 || exit 2
cat >read.mjs <<'JS'
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n';
const { position, color } = new OBJLoader().parse(text).children[0].geometry.attributes;
console.log(`${position.count} positions, ${color.count} colours`);
console.log(`the first colour is ${[...color.array].join(' ')}; red belongs to corner 3`);
JS
node read.mjs | tee seen
printf '3 positions, 1 colours\nthe first colour is 1 0 0; red belongs to corner 3\n' | diff - seen || { echo "This changed."; exit 1; }
