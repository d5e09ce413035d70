#!/usr/bin/env bash
# Question: vtkOBJExporter writes an opaque cube. Do other programs see it?
# Usual guess: yes; and a polyline beside it does no harm.
# Seen with VTK 9.1 (python3-vtk9 9.1.0, Debian 12): the MTL says `Tr 1`, with Tr for opacity. Everybody else takes Tr for
#   transparency, 1 - d: in three.js r170 and assimp 5.2.5 the cube has opacity 0. Half transparent is the only cube that
#   comes through. A polyline with texture coordinates is worse: its corners are written without blanks, `l 1/12/23/3`,
#   and assimp refuses the file.
# Why it matters: an invisible model looks like a wrong matrix or a wrong cull mode, and is searched for there.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had (apt-get install python3-vtk9 xvfb xauth).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg-query -Wf '${Version}' python3-vtk9 2>/dev/null) == 9.1.0* ]] && command -v xvfb-run >/dev/null || exit 2
apt-get download -q assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 \
    libminizip1=1.1-8+deb12u1 >/dev/null 2>&1 || exit 2
for deb in *.deb; do dpkg -x "$deb" .; done
npm install --silent --no-audit --no-fund three@0.170.0 >/dev/null 2>&1 || exit 2
cat >write.py <<'PY'
import vtk

def export(data, name, opacity):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(opacity)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.AddRenderer(renderer)
    window.Render()
    exporter = vtk.vtkOBJExporter()
    exporter.SetFilePrefix(name)
    exporter.SetRenderWindow(window)
    exporter.Write()

cube = vtk.vtkCubeSource()
cube.Update()
export(cube.GetOutput(), "opaque", 1.0)
export(cube.GetOutput(), "half", 0.5)
points = vtk.vtkPoints()
uvs = vtk.vtkFloatArray()
uvs.SetNumberOfComponents(2)
line = vtk.vtkCellArray()
line.InsertNextCell(3)
for i, p in enumerate([(0, 0, 0), (1, 0, 0), (1, 1, 0)]):
    points.InsertNextPoint(*p)
    uvs.InsertNextTuple2(p[0], p[1])
    line.InsertCellPoint(i)
data = vtk.vtkPolyData()
data.SetPoints(points)
data.SetLines(line)
data.GetPointData().SetTCoords(uvs)
export(data, "line", 1.0)
PY
for attempt in 1 2 3 4 5; do # the X server sometimes goes first
    xvfb-run -a /usr/bin/python3 write.py >/dev/null 2>&1 && break
done
[[ -s line.obj ]] || exit 2
cat >read.mjs <<'JS'
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { readFileSync } from 'node:fs';
for (const name of ['opaque', 'half']) {
    const text = readFileSync(name + '.mtl', 'utf8');
    const loaded = new MTLLoader().parse(text, '');
    loaded.preload();
    console.log(`${name}: ${text.match(/Tr .*/)[0]}, three.js' opacity ${Object.values(loaded.materials)[0].opacity}`);
}
JS
export LD_LIBRARY_PATH=$PWD/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
{
    node read.mjs
    ./usr/bin/assimp export opaque.obj o.gltf gltf2 >/dev/null
    echo "opaque: assimp's opacity $(node -p 'const all = JSON.parse(fs.readFileSync("o.gltf")).materials;
        all.at(-1).pbrMetallicRoughness.baseColorFactor[3]')"
    echo "line: $(grep '^l' line.obj); $(./usr/bin/assimp export line.obj l.obj 2>&1 | grep -o 'OBJ: .*')"
} | tee seen
grep -q "opaque: Tr 1, three.js' opacity 0" seen && grep -q "half: Tr 0.5, three.js' opacity 0.5" seen &&
    grep -q "assimp's opacity 0$" seen && grep -q 'line: l 1/12/23/3; OBJ: Invalid' seen || { echo "This changed."; exit 1; }
