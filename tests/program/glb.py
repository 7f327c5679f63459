"""Small glTF scenes for the tests, made from nothing but the standard library."""

import json
import math
import struct


def sphere(rings=12, segments=24, radius=0.5, height=1.0):
    """A closed sphere around (0, height, 0): positions and triangles."""
    positions = [(0.0, height + radius, 0.0)]
    for ring in range(1, rings):
        polar = math.pi * ring / rings
        for segment in range(segments):
            turn = 2.0 * math.pi * segment / segments
            positions.append((radius * math.sin(polar) * math.cos(turn),
                              height + radius * math.cos(polar),
                              radius * math.sin(polar) * math.sin(turn)))
    positions.append((0.0, height - radius, 0.0))
    south = len(positions) - 1
    triangles = []
    for segment in range(segments):
        after = (segment + 1) % segments
        triangles.append((0, 1 + after, 1 + segment))
        for ring in range(rings - 2):
            a, b = 1 + ring * segments + segment, 1 + ring * segments + after
            triangles += [(a, b, b + segments), (a, b + segments, a + segments)]
        last = 1 + (rings - 2) * segments
        triangles.append((last + segment, last + after, south))
    return positions, triangles


def floor(half=3.0):
    positions = [(-half, 0.0, -half), (half, 0.0, -half), (half, 0.0, half), (-half, 0.0, half)]
    return positions, [(0, 2, 1), (0, 3, 2)]


def glass(**volume):
    """A smooth, transmissive material; `glass(thicknessFactor=1)` is solid."""
    material = {"name": "glass",
                "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
                "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
                               "KHR_materials_ior": {"ior": 1.5}}}
    if volume:
        material["extensions"]["KHR_materials_volume"] = volume
    return material


def roof():
    """A closed prism, flat above and with two faces of 45 degrees below, one metre above the floor."""
    positions = [(-1, 2, -1), (1, 2, -1), (0, 1, -1), (-1, 2, 1), (1, 2, 1), (0, 1, 1)]
    triangles = [(0, 1, 2), (3, 5, 4), (0, 3, 4), (0, 4, 1), (0, 2, 5), (0, 5, 3), (1, 4, 5), (1, 5, 2)]
    # A corner of its own for each face: flat normals.
    apart = [positions[i] for t in triangles for i in t]
    return apart, [(i, i + 1, i + 2) for i in range(0, len(apart), 3)]


def scene(material=None, light=None, caster=None, floors=((0, 0, 0),), origin=(0, 0, 0)):
    """A sphere of `material` (solid glass unless given), or another closed `caster`, above a floor, or floors
    moved so, under a light from above; all of it around `origin`."""
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_transmission",
                           "KHR_materials_ior", "KHR_materials_volume"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            light or {"name": "sun", "type": "directional", "intensity": 1000}]}},
        "scene": 0,
        "scenes": [{"nodes": list(range(3 + len(floors)))}],
        "nodes": [
            {"name": "ball", "mesh": 0},
            {"name": "floor", "mesh": 1, "translation": list(floors[0])},
            {"name": "sun", "translation": [0, 4, 0],
             "rotation": [-math.sqrt(0.5), 0, 0, math.sqrt(0.5)],
             "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"name": "eye", "camera": 0, "translation": [0, 1.2, 4],
             "rotation": [-0.1, 0, 0, math.sqrt(1 - 0.01)]},
        ] + [{"name": "floor", "mesh": 1, "translation": list(place)} for place in floors[1:]],
        "cameras": [{"name": "front", "type": "perspective",
                     "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "materials": [material or glass(thicknessFactor=1),
                      {"name": "floor", "pbrMetallicRoughness":
                       {"metallicFactor": 0, "roughnessFactor": 1,
                        "baseColorFactor": [0.8, 0.8, 0.8, 1]}}],
        "meshes": [], "accessors": [], "bufferViews": [],
    }
    for node in document["nodes"] if any(origin) else ():
        node["translation"] = [a + b for a, b in zip(node.get("translation", (0, 0, 0)), origin)]
    blob = b""
    for number, (positions, triangles) in enumerate([caster or sphere(), floor()]):
        vertices = b"".join(struct.pack("<3f", *p) for p in positions)
        indices = b"".join(struct.pack("<3I", *t) for t in triangles)
        for data, target in ((vertices, 34962), (indices, 34963)):
            document["bufferViews"].append(
                {"buffer": 0, "byteOffset": len(blob), "byteLength": len(data), "target": target})
            blob += data
        document["accessors"] += [
            {"bufferView": 2 * number, "componentType": 5126, "count": len(positions),
             "type": "VEC3",
             "min": [min(p[i] for p in positions) for i in range(3)],
             "max": [max(p[i] for p in positions) for i in range(3)]},
            {"bufferView": 2 * number + 1, "componentType": 5125, "count": 3 * len(triangles),
             "type": "SCALAR"}]
        document["meshes"].append({"primitives": [
            {"attributes": {"POSITION": 2 * number}, "indices": 2 * number + 1,
             "material": number}]})
    document["buffers"] = [{"byteLength": len(blob)}]
    return pack(document, blob)


def many_lights(candelas):
    """The sphere of glass under as many point lights as there are candelas given, 4 m up in a row."""
    document, blob = unpack(scene(light={"type": "point"}))
    sun = document["nodes"].pop(2)
    document["extensions"]["KHR_lights_punctual"]["lights"] = [
        {"name": f"lamp {i}", "type": "point", "intensity": candela} for i, candela in enumerate(candelas)]
    for i in range(len(candelas)):
        place = 4 * (i / len(candelas) - 0.5)
        document["nodes"].append({"name": f"lamp {i}", "translation": [place, sun["translation"][1], 0],
                                  "extensions": {"KHR_lights_punctual": {"light": i}}})
    document["scenes"] = [{"nodes": list(range(len(document["nodes"])))}]
    return pack(document, blob)


def pack(document, blob=b""):
    """The bytes of a binary glTF file."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text
    if blob:
        body += struct.pack("<II", len(blob), 0x004E4942) + blob
    return struct.pack("<III", 0x46546C67, 2, 12 + len(body)) + body


def unpack(data):
    """The document and the binary chunk of a binary glTF file."""
    size, = struct.unpack_from("<I", data, 12)
    return json.loads(data[20:20 + size]), data[28 + size:]
