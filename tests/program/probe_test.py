"""What probe tells of grid vertices, pixels and texels: the rendered values to the bit, on random texels of
half of the sample scenes, drawn by the commit's hash (tests/support/drawn.py; PROBED of each kind and scene,
unless given 40, and 4 where light is followed through real glass), and where their light comes from."""

import json
import os
import pathlib
import random
import sys

import glb
from program import SMALL, ProgramTest, main

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from drawn import drawn  # noqa: E402: found by the line above

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
PROBED = os.environ.get("PROBED")
SIZE, GRID = (64, 48), 32


class Probe(ProgramTest):
    def probe(self, scene, *arguments):
        return json.loads(self.succeeds("probe", scene, *SMALL, "--json", *arguments).stdout)

    def passes(self, scene):
        """(label, width, height) of each."""
        plan = json.loads(self.succeeds("plan", scene, *SMALL, "--json").stdout)
        return [(p["pass"], p["writes"][0]["width"], p["writes"][0]["height"])
                for p in plan["passes"] if not p.get("draws_nothing")]

    def test_equals_what_was_rendered_on_random_texels_and_pixels_of_sample_scenes(self):
        for scene in drawn(sorted(SCENES.rglob("*.glb")), 2):
            with self.subTest(scene=scene.stem):
                self.check_random_places(scene, int(PROBED or (4 if scene.parent.name == "glass" else 40)))

    def check_random_places(self, scene, count):
        pick = random.Random(scene.stem)
        passes = self.passes(scene)
        asked = []
        for _ in range(count):
            label, width, height = pick.choice(passes)
            if not label.startswith("water_"):  # before the frame's passes
                asked += ["--history", f"{label}:{pick.randrange(width)},{pick.randrange(height)}"]
            asked += ["--pixel", f"{pick.randrange(SIZE[0])},{pick.randrange(SIZE[1])}"]
        result = self.probe(scene, *asked)
        self.assertEqual(len(result["pixels"]), count)
        for probed in result["pixels"] + result["texels"]:
            self.assertTrue(probed["agrees"], probed)
        for light in (each for pixel in result["pixels"] for each in pixel["lights"]):
            # Sums in double precision of what single precision added up in the map.
            self.assertAlmostEqual(light["accounted"], 1.0, delta=1e-4, msg=light)
            self.assertAlmostEqual(light["explained"], 1.0, delta=1e-4, msg=light)

    def test_vertices_are_told_together(self):
        vertices = [(16, 16), (10, 20), (0, 0)]
        asked = [word for x, y in vertices for word in ("--texel", f"{x},{y}")]
        result = self.probe("ball.glb", *asked)
        self.assertEqual([tuple(each["vertex"]) for each in result["vertices"]], vertices)
        self.assertTrue(all(each["agrees"] for each in result["vertices"]))
        self.assertEqual(result["vertices"][0]["passes"][0]["status"], "landed")

    def test_a_history_ends_with_what_is_stored(self):
        result = self.probe("ball.glb", "--history", "caustic_cells[sun]:16,16")["texels"][0]
        flux = 0.0
        for fragment in result["fragments"]:
            self.assertEqual(fragment["outcome"], "passed")
            self.assertRegex(fragment["name"], r"\Acell \d+,\d+\Z")
            flux += fragment["gives"][0][0]
        self.assertGreater(len(result["fragments"]), 0)
        self.assertAlmostEqual(flux, result["rendered"][0][0], delta=1e-6 * flux)

    def test_a_pixel_in_the_caustic_names_cells_whose_shares_add_up(self):
        pixels = [f"{x},{y}" for x in range(0, SIZE[0], 4) for y in range(0, SIZE[1], 4)]
        asked = [word for pixel in pixels for word in ("--pixel", pixel)]
        lit = [light for pixel in self.probe("ball.glb", *asked)["pixels"] for light in pixel["lights"]
               if light["contributions"]]
        self.assertGreater(len(lit), 0)
        for light in lit:
            shares = [c["share"] for c in light["contributions"]]
            self.assertAlmostEqual(sum(shares), 1.0, delta=1e-9)
            self.assertEqual(shares, sorted(shares, reverse=True))
            self.assertGreater(light["caustic"][0], 0.0)
            for c in light["contributions"]:
                self.assertTrue(all(0 <= i < GRID for i in c.get("cell", c.get("vertex"))))

    def test_a_pixel_on_glass_says_so(self):
        text = self.succeeds("probe", SCENES / "glass_sphere.glb", *SMALL, "--pixel", "32,16").stdout
        self.assertIn("glass or metal", text)

    def test_what_is_not_there_is_refused(self):
        self.fails(2, "probe", "ball.glb", *SMALL, "--texel", "32,0", saying="0..31")
        self.fails(2, "probe", "ball.glb", *SMALL, saying="--texel")
        self.fails(2, "probe", "ball.glb", "--texel", "1,1", "--light", "1", saying="0..0")
        self.fails(2, "probe", "ball.glb", *SMALL, "--pixel", "64,0", saying="0..63,0..47")
        self.fails(2, "probe", "ball.glb", *SMALL, "--history", "16,16", saying="caustic_cells[sun]:200,100")
        self.fails(2, "probe", "ball.glb", *SMALL, "--history", "landin[sun]:1,1", saying="'landing[sun]'")
        self.fails(2, "probe", "ball.glb", *SMALL, "--history", "landing[sun]:32,1", saying="32x32")
        self.fails(2, "probe", "ball.glb", *SMALL, "--pixel", "1,1", "--backend", "gl", saying="--backend")
        (self.folder / "thin.glb").write_bytes(glb.scene(glb.glass()))
        self.fails(2, "probe", "thin.glb", "--texel", "1,1", saying="throws no caustic")


if __name__ == "__main__":
    main()
