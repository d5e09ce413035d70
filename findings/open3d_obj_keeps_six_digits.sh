#!/usr/bin/env bash
# Question: a triangle of one metre in UTM coordinates, (500000.25, 4649776.5, 10.125), is held by Open3D in doubles and written
#   as OBJ, as text PLY and as binary PLY. How much is left of it?
# Usual guess: at worst float32, half a metre of rounding, the same in all three.
# Seen with Open3D 0.16.1 (Debian 12, python3-open3d): the OBJ has six digits, whatever the type, `v 500000 4.64978e+06 10.125`:
#   three corners on one line, a triangle without area. So has the text PLY, whose header says double. The binary PLY has all.
# Why it matters: a surveyed model disappears without a message. The pixels are empty because the area is exactly zero,
#   which looks like culling.
# Exits 0 if this is still so, 1 if it changed, 2 if the package cannot be had (apt-get install python3-open3d).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg-query -Wf '${Version}' python3-open3d 2>/dev/null) == 0.16.1* ]] || exit 2
cat >write.py <<'PY'
import open3d as o3d

x, y, z = 500000.25, 4649776.5, 10.125
mesh = o3d.geometry.TriangleMesh(
    o3d.utility.Vector3dVector([(x, y, z), (x + 1, y, z), (x, y + 1.25, z)]), o3d.utility.Vector3iVector([(0, 1, 2)]))
o3d.io.write_triangle_mesh("far.obj", mesh)
o3d.io.write_triangle_mesh("far.ply", mesh, write_ascii=True)
o3d.io.write_triangle_mesh("bin.ply", mesh)
top = max(v[1] for v in o3d.io.read_triangle_mesh("bin.ply").vertices)
open("bin.txt", "w").write(f"binary PLY: highest y {top}\n")
PY
/usr/bin/python3 write.py >/dev/null 2>&1
{
    grep '^v ' far.obj | sed 's/^/OBJ: /'
    sed -n '/end_header/,$p' far.ply | sed -n '2,4s/^/PLY: /p'
    cat bin.txt
} | tee seen
[ "$(grep -c 'OBJ: v 50000[01] 4.64978e+06 10.125' seen)" = 3 ] && [ "$(grep -c '^PLY: 50000[01] 4.64978e+06 10.125' seen)" = 3 ] &&
    grep -q 'highest y 4649777.75' seen || {
    echo "This changed."
    exit 1
}
