#!/usr/bin/env python3
"""The processor seconds that `plan` says a picture takes, against what `render` took: `plan_seconds.py
[NAME ...]` prints a row for each scene and exits with 1 where one is off by more than a factor of two. No
test of every run: another program's work on the machine changes what a second buys."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

import glb
from memory_test import with_lights, with_meshes, with_textures, with_triangles, dispersive
from program import PROGRAM

FACTOR = 2.0
RUNS = 3
CASES = [
    ("a picture's default", glb.scene, []),
    ("a small picture", glb.scene, ["-r", "160x90"]),
    ("one sample", glb.scene, ["-D", "samples=1"]),
    ("16 samples", glb.scene, ["-r", "640x360", "-D", "samples=16"]),
    ("picture of 2560x1440", glb.scene, ["-r", "2560x1440"]),
    ("grid of 2048", glb.scene, ["-r", "640x360", "--grid", "2048", "--map", "512"]),
    ("map of 4096", glb.scene, ["-r", "640x360", "--map", "4096"]),
    ("10 lights", lambda: with_lights(10), ["-r", "640x360"]),
    ("100 small lights", lambda: with_lights(100), ["-r", "64x48", "--grid", "32", "--map", "32"]),
    ("1000 meshes", lambda: with_meshes(1000), ["-r", "640x360"]),
    ("200 thousand triangles", lambda: with_triangles(220), ["-r", "640x360"]),
    ("textures of 2048", lambda: with_textures(2048, 3), ["-r", "640x360"]),
    ("16 wavelengths", dispersive, ["-r", "640x360", "--wavelengths", "16"]),
]


def processor_seconds(folder, *arguments):
    """Of one run of the program: with its threads, and what the system did for them."""
    process = subprocess.Popen([PROGRAM, *arguments], cwd=folder, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL)
    output = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(arguments)} exits with {process.returncode}")
    return used.ru_utime + used.ru_stime, output


def main(names):
    honest = True
    print(f"{'scene':26} {'plan says, s':>12} {'render took':>12} {'factor':>7} {'plan took':>10}")
    for name, scene, options in CASES:
        if names and not any(part in name for part in names):
            continue
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.glb").write_bytes(scene())
            plans = [processor_seconds(folder, "plan", "scene.glb", "--json", *options) for _ in range(RUNS)]
            renders = [processor_seconds(folder, "render", "scene.glb", "-o", "a.png", *options)
                       for _ in range(RUNS)]
        # The least: what else runs on the machine only adds.
        planning, took = min(plans)[0], min(renders)[0]
        said = min(json.loads(document)["seconds"] for _, document in plans)
        honest &= took / FACTOR <= said <= took * FACTOR
        print(f"{name:26} {said:12.2f} {took:12.2f} {said / took:7.2f} {planning:10.2f}", flush=True)
    return 0 if honest else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
