#!/usr/bin/env bash
# Question: a scene has a red plate and behind it one without a material. Blender exports both to OBJ. Which colour has the
#   second one for the reader?
# Usual guess: the reader's default. The exporter of old wrote `usemtl None` for it.
# Seen with Blender 3.4.1 (Debian 12), the exporter in C++ that became the standard one: nothing is written for an object
#   without a material, and `usemtl` holds until the next one. The plate becomes red in every reader, in Blender's own two
#   importers as well. Whether it does depends on the order of the objects' names.
# Why it matters: one reads this as a bug of one's own reader, whose state seems to leak from object to object; resetting
#   the material at `o` mends this file and breaks those of all other programs.
# Exits 0 if this is still so, 1 if it changed, 2 if the package cannot be had (apt-get install --no-install-recommends blender).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
blender --version 2>/dev/null | grep -q '^Blender 3\.4\.1' || exit 2
cat >write.py <<'PY'
import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)
red = bpy.data.materials.new("red")
for name, material in (("a painted", red), ("b bare", None)):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    if material:
        mesh.materials.append(material)
    bpy.context.collection.objects.link(bpy.data.objects.new(name, mesh))
bpy.ops.wm.obj_export(filepath="new.obj")
bpy.ops.export_scene.obj(filepath="old.obj")
for file in ("new.obj", "old.obj"):
    for reader in (bpy.ops.wm.obj_import, bpy.ops.import_scene.obj):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        reader(filepath=file)
        bare = [o for o in bpy.data.objects if o.name.startswith("b")][0]
        print("SEEN", file, "bare has", [m.name for m in bare.data.materials if m])
PY
blender -b --factory-startup -noaudio -P write.py 2>&1 | sed -n 's/^SEEN //p' >lines
{
    grep -E '^(o|usemtl)' new.obj
    cat lines
} | tee seen
[ "$(grep -c "new.obj bare has \['red'\]" seen)" = 2 ] && [ "$(grep -c "old.obj bare has \['red'\]" seen)" = 0 ] &&
    [ "$(grep -c usemtl new.obj)" = 1 ] || { echo "This changed."; exit 1; }
