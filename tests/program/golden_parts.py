"""What the scenes of golden_scenes.py are made of: textures, places, lights and a floor, all away from their
defaults, turned and off centre."""
import math
import pathlib
import random
import struct
import sys
import zlib

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "scenes"))

from making.gltf_scene import diffuse  # noqa: E402
from making.shapes import box, square  # noqa: E402

CLAMP, MIRROR, REPEAT, NEAREST = 33071, 33648, 10497, 9728


def turn(axis, degrees):
    """The quaternion of a rotation."""
    x, y, z = axis
    length = math.sqrt(x * x + y * y + z * z)  # sum() rounds otherwise from Python 3.12 on
    half = math.radians(degrees) / 2
    return [c / length * math.sin(half) for c in axis] + [math.cos(half)]


def png(width, height, texel, bits=8):
    """Of as many channels as `texel` gives: grey, grey and alpha, RGB or RGBA. Stored uncompressed."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    most, form = (255, ">B") if bits == 8 else (65535, ">H")
    rows, channels = b"", 0
    for y in range(height):
        rows += b"\0"
        for x in range(width):
            values = texel((x + 0.5) / width, (y + 0.5) / height)
            channels = len(values)
            rows += b"".join(struct.pack(form, min(most, max(0, round(most * c)))) for c in values)
    head = struct.pack(">IIBBBBB", width, height, bits, {1: 0, 2: 4, 3: 2, 4: 6}[channels], 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 0)) +
            chunk(b"IEND", b""))


def noise(seed, side, low=(0.0,) * 4, high=(1.0,) * 4):
    """A texel function of random squares."""
    chance = random.Random(seed)
    squares = [[chance.random() for _ in low] for _ in range(side * side)]

    def texel(u, v):
        values = squares[int(v * side) * side + int(u * side)]
        return [a + (b - a) * c for a, b, c in zip(low, high, values)]
    return texel


def bumps(strength):
    """A normal texture with waves that differ along u and v."""
    def texel(u, v):
        x = strength * math.sin(2 * math.pi * (2 * u + v) + 0.4)
        y = strength * math.cos(2 * math.pi * (3 * v - u) + 1.1)
        return [0.5 * x + 0.5, 0.5 * y + 0.5, 0.5 * math.sqrt(1 - x * x - y * y) + 0.5]
    return texel


def texture(s, image, wrap=(REPEAT, REPEAT), mag=None, **more):
    """What a material says of a texture."""
    index = s.texture(image)
    sampler = {"wrapS": wrap[0], "wrapT": wrap[1], **({"magFilter": mag} if mag else {})}
    s.gltf.setdefault("samplers", []).append(sampler)
    s.gltf["textures"][index]["sampler"] = len(s.gltf["samplers"]) - 1
    if "extensions" in more:
        s.extensions.add("KHR_texture_transform")
    return {"index": index, **more}


def moved(offset, scale, rotation):
    return {"KHR_texture_transform": {"offset": offset, "scale": scale, "rotation": rotation}}


def around(shape):
    """Texture coordinates that wind around the y axis, beyond 0..1 on both sides."""
    return [(math.atan2(p[2], p[0]) / math.pi + 0.3, 1.7 * p[1] - 0.4 * p[0]) for p in shape[0]]


def above(shape, scale=0.6):
    return [(scale * p[0] + 0.31, scale * p[2] - 0.27 * p[0]) for p in shape[0]]


def place(s, translation=(0, 0, 0), axis=(0, 1, 0), degrees=0.0, scale=(1, 1, 1)):
    """Of the node added last."""
    s.gltf["nodes"][-1].update(translation=list(translation), rotation=turn(axis, degrees), scale=list(scale))


def carried(s, translation, axis, degrees, scale):
    """All nodes become children of one that is moved, turned and scaled."""
    nodes = s.gltf["scenes"][0]["nodes"]
    s.gltf["nodes"].append({"name": "carrier", "children": nodes, "translation": list(translation),
                            "rotation": turn(axis, degrees), "scale": [scale] * 3})
    s.gltf["scenes"][0]["nodes"] = [len(s.gltf["nodes"]) - 1]
    return s


def view(s):
    s.camera("view", (0.9, 1.5, 2.0), (0.1, 0.25, 0.05), 43)
    s.camera_down("floor", (0.2, 0.05, 0.1), 0.9)


def three_lights(s):
    s.light((0.5, -1.0, 0.15), name="sun", type="directional", intensity=5.0, color=[1.0, 0.8, 0.5])
    s.light((-0.7, -1.0, -0.3), (0.9, 1.6, 0.5), name="spot", type="spot", intensity=20.0, range=6.5,
            color=[0.4, 0.6, 1.0], spot={"innerConeAngle": 0.25, "outerConeAngle": 0.6})
    s.light((0, -1, 0), (-0.8, 1.4, 0.7), name="point", type="point", intensity=6.0, range=5.0,
            color=[0.7, 1.0, 0.6])


def floors(s):
    """A floor with a texture of its own sampling, a step and a ball on it."""
    base = texture(s, png(9, 7, noise(1, 4, (0.2,) * 3, (0.9,) * 3)), (MIRROR, CLAMP),
                   extensions=moved([0.2, -0.3], [1.3, 0.7], 0.5))
    shape = square(2.5)
    s.mesh("floor", shape, {"name": "floor", "pbrMetallicRoughness": {
        "baseColorTexture": base, "baseColorFactor": [0.9, 0.8, 0.7, 1], "metallicFactor": 0.1,
        "roughnessFactor": 0.6}}, above(shape))
    s.mesh("step", box((-0.2, 0.0, -0.15), (0.2, 0.12, 0.15)), diffuse("step", (0.5, 0.7, 0.6)))
    place(s, (0.45, 0.01, 0.2), (0.1, 1, 0.05), 25, (1.2, 0.9, 0.8))
