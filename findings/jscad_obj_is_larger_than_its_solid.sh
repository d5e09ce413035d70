#!/usr/bin/env bash
# Question: a cuboid of side 4 with a hole of side 1 is written as OBJ by JSCAD. How large is it in the file?
# Usual guess: 4 by 4; its corners are whole numbers, and snapping to a fine grid keeps those.
# Seen with @jscad/modeling 2.13.0 and @jscad/obj-serializer 2.1.23 (npm): 4.00002 by 4.00002, with a hole of 1.00002. Before it
#   writes, the serializer snaps each coordinate to multiples of an epsilon made of the solid's own size, and 2 is no
#   multiple of it. A plain cuboid of side 2 stays 2; the same solid somewhere else comes out at another size.
# Why it matters: two solids that share a wall get two grids, so the common wall is at 2 in one and at 2.00001 in the other:
#   a gap or an overlap of a fraction of a pixel, which is where rasterizers flicker.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund @jscad/modeling@2.13.0 @jscad/obj-serializer@2.1.23 >/dev/null 2>&1 || exit 2
cat >write.cjs <<'JS'
const { serialize } = require('@jscad/obj-serializer');
const { primitives, booleans, transforms } = require('@jscad/modeling');
const plate = booleans.subtract(primitives.cuboid({ size: [4, 4, 1] }), primitives.cuboid({ size: [1, 1, 2] }));
const neighbour = transforms.translate([3, 0, 0], primitives.cuboid({ size: [2, 2, 2] })); // from x = 2 to x = 4
const span = (solid) => {
    const x = serialize({ triangulate: false }, solid).join('').split('\n')
        .filter((l) => l.startsWith('v ')).map((l) => Number(l.split(' ')[1]));
    return `x from ${Math.min(...x)} to ${Math.max(...x)}`;
};
console.log('cuboid of side 2: ' + span(primitives.cuboid({ size: [2, 2, 2] })));
console.log('plate with a hole, -2 to 2: ' + span(plate));
console.log('its neighbour, 2 to 4: ' + span(neighbour));
JS
node write.cjs | tee seen
grep -q 'side 2: x from -1 to 1$' seen && grep -q 'hole, -2 to 2: x from -2.00001 to 2.00001' seen &&
    grep -q 'neighbour, 2 to 4: x from 2 to 4$' seen || {
    echo "This changed."
    exit 1
}
