"""Geometry in the ways in which a glTF file may hold and move it."""
import math
import struct

from golden_parts import bumps, diffuse, floors, noise, png, texture, turn, view
from making.gltf_scene import Scene, glass
from making.shapes import icosphere


def accessor(s, form, kind, rows, view=None, **more):
    """An accessor of rows in the format of `struct`, each padded to four bytes; `kind` is glTF's component
    type."""
    if view is None:
        rows = [struct.pack("<" + form, *row) for row in rows]
        stride = -(-len(rows[0]) // 4) * 4
        view = s.view(b"".join(row.ljust(stride, b"\0") for row in rows), None)
        if len(rows[0]) != stride or kind in (5120, 5122):
            s.gltf["bufferViews"][view]["byteStride"] = stride
    shape = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[len(form.lstrip("0123456789")) * int(
        form.rstrip("fbhBHI") or 1)]
    return s.accessor(bufferView=view, componentType=kind, type=shape, count=len(rows), **more)


def indices(s, form, kind, numbers):
    return s.accessor(bufferView=s.view(struct.pack(f"<{len(numbers)}{form}", *numbers), None),
                      componentType=kind, type="SCALAR", count=len(numbers))


def node_of(s, primitives, material, **node):
    """A node with a mesh of these primitives."""
    if material not in s.gltf["materials"]:
        s.gltf["materials"].append(material)
    weights = {"weights": node.pop("weights")} if "weights" in node else {}
    number = s.gltf["materials"].index(material)
    of_material = [{**primitive, "material": number} for primitive in primitives]
    s.gltf["meshes"].append({"primitives": of_material, **weights})
    s.node(mesh=len(s.gltf["meshes"]) - 1, **node)


def leaf(k=0):
    """Corners of a bent strip, and what goes with them."""
    return [(0.15 * (i % 2) + 0.01 * i, 0.1 * (i // 2), 0.05 * math.sin(i + k)) for i in range(8)]


def stored_shapes(s):
    """Primitives in the ways that files may hold them."""
    painted = diffuse("painted", (0.9, 0.9, 0.8))
    painted["doubleSided"] = True
    corners = leaf()
    positions = accessor(s, "3f", 5126, corners)
    colors = accessor(s, "3B", 5121, [(40 * i % 256, 255 - 30 * i, 90 + 20 * i) for i in range(8)],
                      normalized=True)
    node_of(s, [{"attributes": {"POSITION": positions, "COLOR_0": colors}, "mode": 5}], painted, name="strip",
            translation=[-0.9, 0.05, 0.9], rotation=turn((0, 1, 0.2), 40), scale=[1.5, 1.2, 1.0])
    node_of(s, [{"attributes": {"POSITION": positions}, "mode": 6,
                 "indices": indices(s, "B", 5121, [0, 1, 3, 5, 7])}], painted, name="fan",
            matrix=[1.2, 0.1, 0, 0, -0.2, 1.1, 0.1, 0, 0, 0.1, -0.9, 0, -0.5, 0.05, 1.0, 1])
    short_corners = accessor(s, "3h", 5122, [[round(30000 * c) for c in p] for p in corners], normalized=True)
    normals = accessor(s, "3b", 5120, [(10 * i - 30, 20, 120) for i in range(8)], normalized=True)
    uvs = accessor(s, "2H", 5123, [(8000 * i, 60000 - 7000 * i) for i in range(8)], normalized=True)
    patterned = {"name": "patterned", "doubleSided": True, "pbrMetallicRoughness": {
        "metallicFactor": 0.0, "baseColorTexture": texture(s, png(6, 4, noise(60, 3, (0,), (1,)), bits=16))}}
    triangles = [k for i in range(6) for k in ((i, i + 1, i + 2) if i % 2 == 0 else (i + 1, i, i + 2))]
    node_of(s, [{"attributes": {"POSITION": short_corners, "NORMAL": normals, "TEXCOORD_0": uvs},
                 "indices": indices(s, "I", 5125, triangles)},
                {"attributes": {"POSITION": accessor(s, "3f", 5126, [corners[k] for k in triangles])}}],
            patterned, name="quantized", translation=[0.9, 0.1, 0.9], rotation=turn((0.1, 1, 0), -50),
            scale=[2.0, 1.5, 1.5])
    sparse = accessor(s, "3f", 5126, corners)
    s.gltf["accessors"][sparse]["sparse"] = {
        "count": 2,
        "indices": {"bufferView": s.view(struct.pack("<2H", 1, 6), None), "componentType": 5123},
        "values": {"bufferView": s.view(struct.pack("<6f", 0.3, 0.0, 0.1, -0.1, 0.35, 0.05), None)}}
    fade = {"name": "fade", "doubleSided": True, "pbrMetallicRoughness": {
        "metallicFactor": 0.0, "baseColorTexture": texture(s, png(4, 4, noise(61, 4, (0, 0), (1, 1))))},
        "normalTexture": texture(s, png(4, 6, bumps(0.6)), scale=-0.7)}
    tangents = accessor(s, "4f", 5126, [
        (math.cos(i), 0.0, math.sin(i), 1.0 - 2.0 * (i % 2)) for i in range(8)])
    up = accessor(s, "3f", 5126, [(0.1, 0.2, 0.97)] * 8)
    node_of(s, [{"attributes": {"POSITION": sparse, "NORMAL": up, "TANGENT": tangents, "TEXCOORD_0": uvs},
                 "indices": indices(s, "H", 5123, triangles)}], fade, name="sparse",
            translation=[0.5, 0.2, 0.8], scale=[-1.3, 1.2, 1.1])
    s.node(name="hidden", mesh=0, translation=[0, 0.5, 0],
           extensions={"KHR_node_visibility": {"visible": False}})
    places = accessor(s, "3f", 5126, [(0, 0, 0), (0.25, 0.05, -0.1), (0.4, 0.0, 0.15)])
    sizes = accessor(s, "3f", 5126, [(1, 1, 1), (0.6, 1.2, 0.8), (-0.8, 0.7, 1.0)])
    turns = accessor(s, "4h", 5122, [[round(32767 * c) for c in turn((k, 1, 0.3), 30 * k)] for k in range(3)],
                     normalized=True)
    s.node(name="row", mesh=1, translation=[-0.9, 0.1, -0.7], extensions={"EXT_mesh_gpu_instancing": {
        "attributes": {"TRANSLATION": places, "ROTATION": turns, "SCALE": sizes}}})
    s.extensions |= {"KHR_mesh_quantization", "KHR_node_visibility", "EXT_mesh_gpu_instancing"}
    return triangles


def moving_shapes(s, triangles):
    """What is morphed and what joints pull at, and their animation."""
    corners = leaf(1)
    positions, material = accessor(s, "3f", 5126, corners), diffuse("moving", (0.4, 0.6, 0.9))
    material["doubleSided"] = True
    targets = [{"POSITION": accessor(s, "3f", 5126, [(0.02 * i * k, 0.05, -0.03 * k) for i in range(8)])}
               for k in (1, 2)]
    faces = indices(s, "H", 5123, triangles)
    node_of(s, [{"attributes": {"POSITION": positions}, "indices": faces, "targets": targets}], material,
            name="morphed", weights=[0.3, 0.6], translation=[0.0, 0.1, 0.95], scale=[1.5, 1.5, 1.5])
    joints = accessor(s, "4B", 5121, [(0, 1, 0, 0)] * 8)
    weights = accessor(s, "4f", 5126, [(1 - i / 8, i / 8, 0, 0) for i in range(8)])
    node_of(s, [{"attributes": {"POSITION": positions, "JOINTS_0": joints, "WEIGHTS_0": weights},
                 "indices": faces}], material, name="skinned", skin=0)
    first = len(s.gltf["nodes"])
    s.node(name="root", translation=[-0.3, 0.1, 0.8], rotation=turn((0, 1, 0), 20), children=[first + 1])
    s.gltf["nodes"].append({"name": "tip", "translation": [0.05, 0.3, 0.0],
                            "rotation": turn((1, 0, 0.3), 35)})
    bind = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.02, -0.2 * k, 0.01, 1] for k in (0, 1)]
    s.gltf["skins"] = [{"joints": [first, first + 1], "inverseBindMatrices": accessor(s, "16f", 5126, bind)}]
    s.keyframes("tip", "rotation", [0.0, 0.5, 1.5], [turn((1, 0, 0.3), d) for d in (35, -20, 60)])
    s.keyframes("root", "scale", [0.2, 1.0], [(1.0, 1.0, 1.0), (1.4, 0.7, 1.2)], "STEP")
    s.keyframes("quantized", "translation", [0.0, 1.0], [
        (0.1, 0, 0), (0.9, 0.1, 0.9), (0.3, -0.2, 0.1), (0, 0.1, 0), (0.6, 0.3, 0.7), (0, 0, 0)],
        "CUBICSPLINE")


def stored():
    """Geometry in all the ways in which a file may hold it, still and moving, beside a ball of glass."""
    s = Scene()
    floors(s)
    s.mesh("ball", icosphere((0.1, 0.5, 0.1), 0.2, 1), glass("ball", 1.5))
    s.light((0.5, -1.0, 0.15), name="sun", type="directional", intensity=5.0, color=[1.0, 0.8, 0.5])
    triangles = stored_shapes(s)
    moving_shapes(s, triangles)
    view(s)
    return s
