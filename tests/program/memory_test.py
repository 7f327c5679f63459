#!/usr/bin/env python3
"""The memory that `plan` says a picture takes, against what `render` took at its peak, over scenes that are
made here: many lights, meshes, triangles, texels, samples, cells, pixels, branches, layers. The first scenes
are a test; `memory_test.py --table [--backend gl] [SCENE ...]` prints a row for each of them all. And what
needs more than is there is refused, before it is taken."""

import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import glb
from program import PROGRAM, SMALL, ProgramTest, main

MB = 1 << 20
# Of the peak; libraries take some 20 MB more or less by how they were built and loaded.
SHARE, LIBRARIES = 0.15, 10e6


def png(side, height=None, bits=8, channels=3):
    """A picture of noise-like rows; a decoder cannot know that they are all alike."""
    height = height or side
    values = bytes((i * 73 + 41) % 256 for i in range(side * channels * bits // 8))
    packer = zlib.compressobj(1)
    data = b"".join([packer.compress(b"\0" + values) for _ in range(height)] + [packer.flush()])

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    kind = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    head = struct.pack(">IIBBBBB", side, height, bits, kind, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
            chunk(b"IDAT", data) + chunk(b"IEND", b""))


def with_lights(count):
    """A glass ball under so many lamps around it."""
    document, blob = glb.unpack(glb.scene())
    nodes = document["nodes"]
    nodes[2] = {"name": "lamps", "children": []}
    document["extensions"]["KHR_lights_punctual"]["lights"] = [
        {"name": "lamp", "type": "point", "intensity": 100}]
    for i in range(count):
        turn = 2.4 * i
        away = 1 + 2 * (i + 1) / count
        nodes[2]["children"].append(len(nodes))
        nodes.append({"translation": [away * math.cos(turn), 3.0, away * math.sin(turn)],
                      "extensions": {"KHR_lights_punctual": {"light": 0}}})
    return glb.pack(document, blob)


def with_meshes(count):
    """A glass ball amid so many small opaque ones."""
    document, blob = glb.unpack(glb.scene())
    small = dict(document["meshes"][0]["primitives"][0], material=1)
    document["meshes"].append({"primitives": [small]})
    for i in range(count):
        document["scenes"][0]["nodes"].append(len(document["nodes"]))
        document["nodes"].append({"mesh": 2, "scale": [0.1] * 3,
                                  "translation": [i % 20 * 0.2 - 2, 0, i // 20 % 20 * 0.2 - 2]})
    return glb.pack(document, blob)


def with_textures(side, count=1, bits=8):
    """A floor of a colour texture, and of a normal and a metallic-roughness texture too, of noise."""
    document, blob = glb.unpack(glb.scene())
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": 32})
    blob += struct.pack("<8f", 0, 0, 1, 0, 1, 1, 0, 1)
    document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126,
                                  "count": 4, "type": "VEC2"})
    document["meshes"][1]["primitives"][0]["attributes"]["TEXCOORD_0"] = len(document["accessors"]) - 1
    document["images"], document["textures"] = [], []
    for i in range(count):
        data = png(side, bits=bits)
        data += b"\0" * (-len(data) % 4)
        document["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
        blob += data
        document["images"].append({"bufferView": len(document["bufferViews"]) - 1, "mimeType": "image/png"})
        document["textures"].append({"source": i})
    floor = document["materials"][1]
    floor["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    if count > 1:
        floor["normalTexture"] = {"index": 1}
    if count > 2:
        floor["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {"index": 2}
    document["buffers"][0]["byteLength"] = len(blob)
    return glb.pack(document, blob)


def with_triangles(rings):
    """A ball of 4 rings^2 triangles."""
    return glb.scene(caster=glb.sphere(rings, 2 * rings))


def dispersive():
    material = glb.glass(thicknessFactor=1)
    material["extensions"]["KHR_materials_dispersion"] = {"dispersion": 1}
    document, blob = glb.unpack(glb.scene(material))
    document["extensionsUsed"].append("KHR_materials_dispersion")
    return glb.pack(document, blob)


def environment(folder, width=2048):
    """A Radiance image without compression, grey, of so many columns."""
    path = folder / f"sky{width}.hdr"
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (width // 2, width))
        file.write(bytes([128, 128, 128, 128]) * (width * width // 2))
    return path


# Name, scene, options. The first few are the test's.
CASES = [
    ("1 light, small", lambda: with_lights(1), SMALL),
    ("10 lights, small", lambda: with_lights(10), SMALL),
    ("a picture's default", glb.scene, []),
    ("textures, 2048", lambda: with_textures(2048, 3), SMALL),
    ("grid and map of 1024", glb.scene, ["-r", "320x180", "--grid", 1024, "--map", 1024]),
    ("--dump", glb.scene, [*SMALL, "--dump", "dumped"]),
    ("200 thousand triangles", lambda: with_triangles(220), SMALL),
    ("40 lights, small", lambda: with_lights(40), SMALL),
    ("samples of a light, 16", lambda: with_lights(1), [*SMALL, "-D", "light.samples=16"]),
    ("map of 2048", glb.scene, ["-r", "320x180", "--grid", 128, "--map", 2048]),
    ("10 lights", lambda: with_lights(10), ["-r", "640x360"]),
    ("100 lights, small", lambda: with_lights(100), SMALL),
    ("1000 meshes", lambda: with_meshes(1000), SMALL),
    ("10000 meshes", lambda: with_meshes(10000), SMALL),
    ("a million triangles", lambda: with_triangles(500), SMALL),
    ("texture of 8192", lambda: with_textures(8192), SMALL),
    ("texture of 4096, 16 bits", lambda: with_textures(4096, 2, bits=16), SMALL),
    ("samples of 16", glb.scene, ["-r", "640x360", "-D", "samples=16"]),
    ("map of 4096", glb.scene, ["-r", "640x360", "--map", 4096]),
    ("grid of 4096", glb.scene, ["-r", "640x360", "--grid", 4096, "--map", 512]),
    ("picture of 4096x2160", glb.scene, ["-r", "4096x2160"]),
    ("EXR of all layers", glb.scene, ["-r", "1280x720", "-o", "a.exr", "--aov",
                                      "beauty,caustic,direct,position,normal,depth"]),
    ("16 wavelengths", dispersive, ["-r", "640x360", "--wavelengths", 16]),
    ("environment of 4096", glb.scene, [*SMALL, "--environment", "sky4096.hdr"]),
    ("--dump of a default", glb.scene, ["--dump", "dumped"]),
]
TESTED = 10
TESTED_WITH_OPENGL = ("10 lights, small", "textures, 2048", "--dump", "map of 2048")
ONLY_RENDER = {"-o": 2, "--dump": 2, "--stats": 2, "--aov": 2}


def for_plan(options):
    """The options of render that plan has too."""
    kept = list(options)
    for option, count in ONLY_RENDER.items():
        if option in kept:
            at = kept.index(option)
            del kept[at:at + count]
    return kept


# A process begins with as much memory at its peak as what has begun it had: a small one begins the program.
STARTER = """import os, sys
child = os.spawnv(os.P_NOWAIT, sys.argv[1], sys.argv[1:])
_, status, used = os.wait4(child, 0)
print(used.ru_maxrss * 1024, os.waitstatus_to_exitcode(status), file=sys.__stderr__)
"""


def peak(folder, *arguments):
    """Of one run of the program: bytes and exit code."""
    run = subprocess.run([sys.executable, "-ISc", STARTER, PROGRAM, *map(str, arguments)], cwd=folder,
                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True)
    taken, code = run.stderr.splitlines()[-1].split()
    return int(taken), int(code)


def write_scene(folder, case):
    (folder / "scene.glb").write_bytes(case[1]())
    if "sky4096.hdr" in case[2]:
        environment(folder, 4096)


def said_and_taken(folder, case, backend="software"):
    """Bytes: what plan says of a PNG picture, what render states with its outputs, and what it took."""
    name, _, options = case
    write_scene(folder, case)
    one_sample = [] if any("samples=" in str(o) for o in options) else ["-D", "samples=1"]
    options = ["--backend", backend, *options, *one_sample, *(["-o", "a.png"] if "-o" not in options else [])]
    plan = subprocess.run([PROGRAM, "plan", "scene.glb", "--json", *map(str, for_plan(options))], cwd=folder,
                          capture_output=True, check=True)
    planned = json.loads(plan.stdout)["memory_bytes"]
    taken, code = peak(folder, "render", "scene.glb", "--stats", "stats.json", *options, "-t", 2)
    if code != 0:
        raise RuntimeError(f"{name}: render exits with {code}")
    stated = json.loads((folder / "stats.json").read_text())["memory_bytes"]
    return planned, stated["stated"], taken


def table(backend, names):
    print(f"{'scene':32} {'plan, MB':>9} {'stated':>9} {'taken':>9} {'off':>7}")
    for case in CASES:
        if names and not any(name in case[0] for name in names):
            continue
        with tempfile.TemporaryDirectory() as folder:
            planned, stated, taken = said_and_taken(pathlib.Path(folder), case, backend)
        print(f"{case[0]:32} {planned / MB:9.1f} {stated / MB:9.1f} {taken / MB:9.1f} "
              f"{stated / taken - 1:+7.1%}", flush=True)


def only_a_head(width, height, bits):
    """A PNG that announces its size and holds no texel."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, 6, 0, 0, 0)) +
            chunk(b"IDAT", b"") + chunk(b"IEND", b""))


class Memory(ProgramTest):
    def check_what_is_stated(self, cases, backend):
        for case in cases:
            with self.subTest(case[0]), tempfile.TemporaryDirectory() as folder:
                planned, stated, taken = said_and_taken(pathlib.Path(folder), case, backend)
                near = max(SHARE * taken, LIBRARIES)
                self.assertAlmostEqual(stated, taken, delta=near)
                if "--dump" not in case[2]:
                    self.assertAlmostEqual(planned, taken, delta=near)

    def test_what_is_stated_is_taken(self):
        self.check_what_is_stated(CASES[:TESTED], "software")

    def test_what_is_stated_is_taken_by_a_driver_without_a_gpu(self):
        doctor = self.succeeds("doctor").stdout
        if "llvmpipe" not in doctor:
            self.skip_without_gl(doctor)
            self.skipTest("needs llvmpipe, whose textures lie in the process")
        self.check_what_is_stated([c for c in CASES if c[0] in TESTED_WITH_OPENGL], "gl")

    def test_plan_says_that_render_would_refuse(self):
        sizes = ["ball.glb", "-r", "4096x4096", "--memory", 500]
        line = self.fails(2, "render", *sizes, "-o", "a.png", saying="500 MiB of --memory; lower -r")
        plan = json.loads(self.succeeds("plan", *sizes, "--json").stdout)
        self.assertGreater(plan["memory_bytes"], plan["memory_budget_bytes"])
        self.assertEqual(plan["memory_budget_bytes"], 500 * MB)
        self.assertEqual(plan["refused"].split("memory", 1)[1], line.split("memory", 1)[1])
        self.assertIn("render would refuse it: these sizes need", self.succeeds("plan", *sizes).stdout)
        self.assertIsNone(json.loads(self.succeeds("plan", "ball.glb", *SMALL, "--json").stdout)["refused"])

    def test_what_the_reference_needs_is_taken(self):
        self.need_ray_queries()
        (self.folder / "fine.glb").write_bytes(with_triangles(220))
        for scene, size in (("ball.glb", "64x48"), ("fine.glb", "64x48"), ("ball.glb", "800x600")):
            with self.subTest(scene=scene, size=size):
                traced = ["reference", scene, "-r", size, "-q", "-t", 2, "-o", "a.exr", "--batches", 2]
                taken, code = peak(self.folder, *traced)
                self.assertEqual(code, 0)
                enough = math.ceil((1 + SHARE) * taken / MB)
                self.assertEqual(peak(self.folder, *traced, "--memory", enough)[1], 0)
                self.fails(2, *traced, "--memory", int((1 - SHARE) * taken / MB), saying="lower -r")

    def test_images_are_refused_by_their_heads(self):
        head = only_a_head(16384, 8192, 16)
        document, blob = glb.unpack(with_textures(4, 3))
        for image in document["images"]:
            image.pop("bufferView")
            image["uri"] = "bomb.png"
        for use in ("emissiveTexture", "occlusionTexture"):
            document["materials"][1][use] = {"index": 0}
        (self.folder / "bomb.png").write_bytes(head)
        (self.folder / "bomb.glb").write_bytes(glb.pack(document, blob))
        for command in ("plan", "render"):
            self.fails(2, command, "bomb.glb", "--memory", 1000, saying="its images need")
        taken, code = peak(self.folder, "plan", "bomb.glb", "--memory", 1000)
        self.assertEqual(code, 2)
        self.assertLess(taken, 100e6)

    def test_meshes_are_refused_before_they_are_made(self):
        (self.folder / "fine.glb").write_bytes(with_triangles(220))
        self.fails(2, "plan", "fine.glb", "--memory", 40, saying="its meshes need")

    def test_the_limit_of_the_process_counts(self):
        import resource
        self.fails(2, "render", "ball.glb", "-r", "4096x4096", "-t", 1, saying="that ulimit -d can spare",
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (600 * MB, 600 * MB)))


if __name__ == "__main__":
    if "--table" in sys.argv:
        names = sys.argv[sys.argv.index("--table") + 1:]
        backend = names[1] if names[:1] == ["--backend"] else "software"
        table(backend, names[2:] if names[:1] == ["--backend"] else names)
    else:
        main()
