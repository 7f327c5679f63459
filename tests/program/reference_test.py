"""caustics reference: layers, going on after a break, refusals."""

import json
import math
import pathlib
import re
import signal
import subprocess

import glb
from pictures import png
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


class Notes(ProgramTest):
    def test_normal_textures_are_said_to_be_left_out_where_a_receiver_has_one_whichever_it_is(self):
        self.need_ray_queries()
        (self.folder / "bumps.png").write_bytes(png([(128, 128, 255)] * 4, 2, 2))
        few = ["-r", "8x8", "--rays", "4", "--batches", "2", "-o", "t.exr"]
        for bumpy in (None, "ball", "floor", "wall"):
            for order in (("wall", "ball", "floor"), ("floor", "ball", "wall")):
                document, blob = glb.unpack(glb.scene())
                nodes = {node["name"]: node for node in document["nodes"]}
                document["materials"].append(document["materials"][1] | {"name": "wall"})
                wall = document["meshes"][1]["primitives"][0] | {"material": 2}
                document["meshes"].append({"primitives": [wall]})
                nodes["wall"] = {"name": "wall", "mesh": 2, "translation": [0, -1, 0]}
                document["nodes"] = [nodes[name] for name in (*order, "sun", "eye")]
                document["scenes"] = [{"nodes": [0, 1, 2, 3, 4]}]
                if bumpy:
                    document["images"], document["textures"] = [{"uri": "bumps.png"}], [{"source": 0}]
                    material = ("ball", "floor", "wall").index(bumpy)
                    document["materials"][material]["normalTexture"] = {"index": 0}
                (self.folder / "bumps.glb").write_bytes(glb.pack(document, blob))
                said = "normal textures of receivers are left out" in self.succeeds(
                    "reference", "bumps.glb", *few).stderr
                self.assertEqual(said, bumpy in ("floor", "wall"), (bumpy, order))


class Help(ProgramTest):
    """Its options are those of render where both have them."""

    def groups(self, command):
        """{option: the heading that it stands below}."""
        heading, found = "", {}
        for line in self.succeeds(command, "--help").stdout.splitlines():
            if option := re.match(r"  (?:-\w,)?(-[-\w]+)", line):
                found[option[1]] = heading
            elif line[:1].strip() and line.endswith(":"):
                heading = line[:-1]
        return found

    def test_what_the_picture_shows_stands_in_the_groups_in_which_render_has_it(self):
        render, reference = self.groups("render"), self.groups("reference")
        shared = {option for option, heading in render.items()
                  if heading in ("View", "Light", "Output") and option in reference}
        self.assertGreater(len(shared), 8)
        # There going on is of a row of frames, and here of what was traced.
        for option in shared - {"--resume"}:
            self.assertEqual(reference[option], render[option], option)

    def test_each_setting_is_named_beside_d_or_listed_or_refused(self):
        values = json.loads(self.succeeds("plan", "ball.glb", "--json").stdout)["settings"]
        for command in ("render", "reference"):
            text = self.succeeds(command, "--help").stdout
            named = re.search(r"one of those listed below, or (.*?) as above;", " ".join(text.split()))
            named = named[1].split(", ")
            listed = text.split("\nSettings for -D:\n")[1].split("\n\n")[0]
            listed = re.findall(r"^  (\S+)", listed, re.MULTILINE)
            self.assertEqual(len({*named, *listed}), len(named) + len(listed))
            self.assertLessEqual({*named, *listed}, {*values})
            options = {"--" + name.replace("_", "-") for name in named} - {"--width", "--height"}
            self.assertLessEqual(options | {"--resolution"}, {*self.groups(command)})
            assigned = {name: ["-D", f"{name}={value}"] for name, value in values.items()}
            known = [word for name in (*named, *listed) for word in assigned[name]]
            # Nothing is wrong but that there is no such scene.
            self.fails(3, command, "none.glb", *known, "-o", "t.exr", saying="none.glb")
            for name in {*values} - {*named, *listed}:
                self.fails(2, command, "none.glb", *assigned[name], "-o", "t.exr", saying=name)


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
