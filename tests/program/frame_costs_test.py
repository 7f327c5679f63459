#!/usr/bin/env python3
"""What a frame of each sample scene takes, counted, not timed: passes, vertices, primitives, fragments,
operations on floats, textures and buffers made, and bytes of textures of the software device. frame_costs.csv
has the counts; with --update it is written anew. A count that rises needs a line at its head,
`# SCENE COUNT: why`."""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program import PROGRAM, main

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
KEPT = pathlib.Path(__file__).with_name("frame_costs.csv")
SIZES = ["-r", "160x90", "--grid", "64", "--map", "64", "-D", "shadow=256"]
OF_PASSES = ["vertices", "primitives", "fragments", "operations"]
MADE = ["textures", "buffers"]
COUNTS = ["passes", *OF_PASSES, *MADE, "texture_bytes"]


def counted(scene):
    with tempfile.TemporaryDirectory() as folder:
        stats = pathlib.Path(folder) / "stats.json"
        subprocess.run([PROGRAM, scene, *SIZES, "-o", pathlib.Path(folder) / "picture.exr", "--stats", stats],
                       check=True, capture_output=True, env=os.environ | {"CAUSTICS_LANES": "scalar"})
        said = json.loads(stats.read_text())
    drawn = [each for each in said["passes"] if not each["left_out"]]
    counts = {"passes": len(drawn), "texture_bytes": said["texture_bytes"]}
    counts |= {count: sum(each[count] for each in drawn) for count in OF_PASSES}
    return counts | {count: said["frames"]["made_by_first"][count] for count in MADE}


def counted_all():
    scenes = sorted(SCENES.glob("*.glb")) + sorted(SCENES.glob("glass/*.glb"))
    return {scene.stem: counted(scene) for scene in scenes}


def kept():
    """The counts by scene."""
    lines = KEPT.read_text().splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return {row["scene"]: {count: int(row[count]) for count in COUNTS} for row in rows}


def written(counts, before):
    """The file with these counts; of what has risen a reason is asked for."""
    lines = [line for line in KEPT.read_text().splitlines() if line.startswith("#")] if KEPT.exists() else []
    for scene, row in counts.items():
        lines += [f"# {scene} {count}: " for count in COUNTS if row[count] > before.get(scene, row)[count]]
    lines += [",".join(["scene", *COUNTS])]
    lines += [",".join([scene, *(str(row[count]) for count in COUNTS)]) for scene, row in counts.items()]
    return "\n".join(lines) + "\n"


class FrameCosts(unittest.TestCase):
    def test_no_count_of_a_sample_scene_changes_unseen(self):
        before = kept()
        now = counted_all()
        self.assertEqual(sorted(now), sorted(before), "frame_costs_test.py --update writes the list anew")
        for scene, row in now.items():
            for count in COUNTS:
                with self.subTest(scene=scene, count=count):
                    self.assertEqual(row[count], before[scene][count], "frame_costs_test.py --update, and "
                                     "if it has risen say why at the head of frame_costs.csv")

    def test_every_reason_is_given(self):
        for line in KEPT.read_text().splitlines():
            if line.startswith("#"):
                self.assertRegex(line, r"^# \S+ (" + "|".join(COUNTS) + r"): \S+ \S+", "say why it has risen")


if __name__ == "__main__":
    if "--update" in sys.argv:
        KEPT.write_text(written(counted_all(), kept() if KEPT.exists() else {}))
    else:
        main()
