"""caustics reference: layers, going on after a break, refusals."""

import json
import math
import pathlib
import re
import signal
import subprocess

from program import PROGRAM, ProgramTest, main

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
FAST = ["-r", "48x32", "--rays", "32"]


class Reference(ProgramTest):
    def setUp(self):
        super().setUp()
        self.need_ray_queries()

    def test_writes_its_layers_and_statistics(self):
        result = self.succeeds("reference", "ball.glb", "-o", "t.exr", *FAST, "--batches", "3", "--stats",
                               "t.json")
        self.assertEqual(result.stdout, "")
        self.assertIn("3 batches of 32 x 32 rays", result.stderr)
        self.assertEqual(self.files(), ["ball.glb", "t.exr", "t.exr.state", "t.json"])
        stats = json.loads((self.folder / "t.json").read_text())
        self.assertEqual(stats["batches"], 3)
        self.assertEqual(stats["rays"], 3 * 32 * 32)
        flux = stats["lights"][0]["flux"]
        for channel in range(3):
            parts = sum(flux[name][channel] for name in ("landed", "fresnel", "absorbed", "total_reflection",
                                                         "missed", "lost", "cut"))
            self.assertAlmostEqual(parts, flux["entered"][channel], delta=1e-12)

    def test_has_the_surfaces_of_render(self):
        self.succeeds("reference", "ball.glb", "-o", "t.exr", *FAST, "--batches", "2", "--aov",
                      "depth,coverage")
        self.succeeds("render", "ball.glb", "-o", "r.exr", "-r", "48x32", "--grid", "16", "--map", "16",
                      "--aov", "depth,coverage")
        result = self.run_program("compare", "t.exr", "r.exr", "--json")
        channels = {c["channel"]: c for c in json.loads(result.stdout)["channels"]}
        # Triangles' corners are snapped to 1/256 pixel there, so that an edge may take another pixel.
        self.assertLessEqual(channels["coverage.R"]["differing"], 4)
        self.assertLess(channels["depth.R"]["absolute"]["mean"], 0.01)

    def test_goes_on_to_the_same_bytes(self):
        self.succeeds("reference", "ball.glb", "-o", "whole.exr", *FAST, "--batches", "6", "--quiet", "-t",
                      "1")
        self.succeeds("reference", "ball.glb", "-o", "t.exr", *FAST, "--batches", "2", "--quiet")
        result = self.succeeds("reference", "ball.glb", "-o", "t.exr", *FAST, "--batches", "6", "--resume",
                               "-t", "3")
        self.assertIn("6 batches", result.stderr)
        for end in ("", ".state"):
            self.assertEqual((self.folder / ("whole.exr" + end)).read_bytes(),
                             (self.folder / ("t.exr" + end)).read_bytes())
        self.fails(3, "reference", "ball.glb", "-o", "t.exr", "-r", "48x32", "--rays", "33", "--resume",
                   saying="rays: 32 there, rays: 33 here")
        (self.folder / "t.exr.state").write_text("nonsense")
        self.fails(3, "reference", "ball.glb", "-o", "t.exr", *FAST, "--resume", saying="is no state")

    def test_keeps_its_state_when_it_is_interrupted(self):
        process = subprocess.Popen([PROGRAM, "reference", "ball.glb", "-o", "t.exr", *FAST, "--batches",
                                    "1000000"],
                                   cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        # Off a terminal a line a second says how far it is; at the second batch one is done.
        for line in process.stderr:
            number = re.search(r"batch ([\d,]+) of", line)
            if number and number.group(1) != "1":
                break
        process.send_signal(signal.SIGINT)
        _, talk = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, talk)
        self.assertIn("--resume goes on", talk)
        self.assertEqual(self.files(), ["ball.glb", "t.exr.state"])
        result = self.succeeds("reference", "ball.glb", "-o", "t.exr", *FAST, "--seconds", "0", "--resume")
        self.assertIn("t.exr:", result.stderr)

    def test_shows_the_error_so_far_and_how_long_it_takes_yet(self):
        small = ["-r", "16x16", "--rays", "16", "--aov", "caustic"]
        self.succeeds("reference", "ball.glb", "-o", "two.exr", *small, "--batches", "2", "--stats", "t.json")
        error = json.loads((self.folder / "t.json").read_text())["noise"]
        code, shown = self.on_terminal("reference", "ball.glb", "-o", "t.exr", *small, "--batches", "12",
                                       "--error", "0.01%")
        self.assertEqual(code, 6)
        told = re.compile(r"batch (\d+) of 12(?:, error ([^,]*)%)?(?:, ([^,]*) left)?  ")
        shown = [found.groups() for found in map(told.match, shown) if found]
        self.assertEqual({said for batch, said, _ in shown if batch in ("1", "2")}, {None})
        self.assertEqual({said for batch, said, _ in shown if batch == "3"},
                         {f"{math.floor(1000 * error) / 10:.1f}"})
        # So small an error is far off: all batches but those that are done are still to come.
        self.assertNotIn("0 ms", [left for batch, _, left in shown if int(batch) < 9])

    def test_misses_an_error_that_takes_longer(self):
        result = self.run_program("reference", "ball.glb", "-o", "t.exr", *FAST, "--batches", "4", "--error",
                                  "0.01%")
        self.assertEqual(result.returncode, 6, result.stderr)
        self.assertIn("not the 0.01% asked for", result.stderr)
        self.assertIn("t.exr", self.files())
        self.succeeds("reference", "ball.glb", "-o", "t.exr", *FAST, "--error", "1000%", "--quiet")

    def test_traces_the_shapes_that_the_sample_scenes_state(self):
        few = ["-r", "32x24", "--rays", "32", "--batches", "2", "--aov", "caustic", "--quiet"]
        for name, mesh, shape in (("glass_sphere", "sphere", "sphere"), ("metal_ring", "ring", "cylinder"),
                                  ("water_sine", "water", "waves")):
            scene = SCENES / (name + ".glb")
            self.succeeds("reference", scene, "-o", "t.exr", *few, "--exact", "scene", "--stats", "t.json")
            self.assertEqual(json.loads((self.folder / "t.json").read_text())["exact"],
                             [{"mesh": mesh, "shape": shape}])
        # Another request than that of the mesh.
        self.fails(3, "reference", scene, "-o", "t.exr", *few, "--resume",
                   saying="is the state of another request")


class Refusals(ProgramTest):
    def test_refusals(self):
        self.fails(2, "reference", saying="no scene given")
        self.fails(2, "reference", "ball.glb", "-o", "t.png", saying=".exr only")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--aov", "beauty", saying="no layer 'beauty'")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--aov", "caustics",
                   saying="did you mean 'caustic'?")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "-D", "grid=64", saying="has no maps")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "-D", "gird=64", saying="did you mean 'grid'?")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--physics", "half", saying="single or full")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--batches", "1", saying="2..")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--error", "x", saying="--error")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--exact", "ball", saying="NAME=sphere")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--exact", "ball=cube", saying="NAME=cylinder")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--exact", "scene", saying="states no shape")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--exact", "ball=sphere", "--exact",
                   "ball=sphere", saying="twice")
        self.fails(2, "reference", "ball.glb", "-o", "t.exr", "--exact", "bell=sphere",
                   saying="did you mean 'ball'?")
        self.fails(3, "reference", "ball.glb", "-o", "t.exr", "--exact", "floor=sphere",
                   saying="is no sphere")
        self.fails(3, "reference", "ball.glb", "-o", "t.exr", "--exact", "ball=cylinder",
                   saying="is no cylinder")
        self.fails(3, "reference", "ball.glb", "-o", "t.exr", "--exact", "ball=waves",
                   saying="extras.exact_shape")
        self.fails(3, "reference", "none.glb", "-o", "t.exr", saying="none.glb")
        self.fails(4, "reference", "ball.glb", "-o", "none/t.exr", saying="none/t.exr")


if __name__ == "__main__":
    main()
