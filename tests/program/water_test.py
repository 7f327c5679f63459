"""Water that moves: frames of a film, each the same alone; bad extras."""

import json
import pathlib
import struct

from program import SMALL, ProgramTest, main

POOL = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "water_plops.glb"


def with_water(water, **material):
    """The sample pool with other extras.water; `material` changes the water's."""
    data = POOL.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    document = json.loads(data[20:20 + length])
    document["nodes"][0]["extras"]["water"] = water
    document["materials"][0].update(material)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    return struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)) + struct.pack("<I4s", len(text),
                                                                                      b"JSON") + \
        text + rest


class Water(ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene("pool.glb", {"cells": 32, "start": 1.0})

    def scene(self, name, water, **material):
        (self.folder / name).write_bytes(with_water(water, **material))

    def picture(self, name):
        return (self.folder / name).read_bytes()

    def test_a_frame_alone_is_the_same_as_in_a_film(self):
        self.succeeds("pool.glb", *SMALL, "--frames", "0..6", "-o", "film.%d.exr")
        self.succeeds("pool.glb", *SMALL, "--frames", "6", "-o", "alone.%d.exr")
        self.assertEqual(self.picture("film.6.exr"), self.picture("alone.6.exr"))
        self.assertNotEqual(self.picture("film.0.exr"), self.picture("film.6.exr"))

    def test_without_frames_the_scene_shows_frame_0(self):
        self.succeeds("pool.glb", *SMALL, "--frames", "0", "-o", "a.%d.exr")
        self.succeeds("pool.glb", *SMALL, "-o", "b.exr")
        self.assertEqual(self.picture("a.0.exr"), self.picture("b.exr"))

    def test_a_moment_is_what_the_frame_that_falls_on_it_shows(self):
        shown = []
        for frame in (0, 3, 8):
            self.succeeds("pool.glb", *SMALL, "--frames", frame, "--fps", "8", "-o", "f.%d.exr", "-q")
            self.succeeds("pool.glb", *SMALL, "--time", frame / 8, "-o", "t.exr", "-q")
            shown.append(self.picture("t.exr"))
            self.assertEqual(shown[-1], self.picture(f"f.{frame}.exr"))
        self.assertEqual(len(set(shown)), 3)
        # Of a row that is there already no moment is looked at.
        row = ["pool.glb", *SMALL, "--frames", "8", "--fps", "8", "-o", "f.%d.exr", "--resume"]
        self.assertIn("nothing was drawn", self.succeeds(*row).stderr)

    def test_plan_and_stats_name_the_pass(self):
        plan = json.loads(self.succeeds("plan", "pool.glb", "--json").stdout)
        effect = next(e for e in plan["effects"] if e["name"] == "water waves")
        self.assertTrue(effect["active"])
        self.assertIn("pass water_step", effect["reason"])
        self.assertEqual(plan["passes"][0]["pass"], "water_step[water]")
        self.assertEqual(plan["passes"][0]["writes"][0]["width"], 32)
        self.succeeds("pool.glb", *SMALL, "--stats", "s.json")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(stats["passes"][0]["pass"], "water_step[water]")
        # A step may take half a cell's way, 31 mm or 62.5 ms at 0.5 m/s, and a plop's interval of 0.4 s
        # holds 7 of 57 ms; a second from rest are 17.5 of those, each a triangle.
        self.assertEqual(stats["passes"][0]["primitives"], 18)

    def test_scenes_without_water_have_none_of_it(self):
        plan = json.loads(self.succeeds("plan", "ball.glb", "--json").stdout)
        self.assertFalse(next(e for e in plan["effects"] if e["name"] == "water waves")["active"])
        self.assertFalse(any("water" in p["pass"] for p in plan["passes"]))
        self.assertFalse(any("water" in w["name"] for p in plan["passes"] for w in p["writes"]))

    def test_bad_water_is_refused_in_one_line(self):
        for water, saying in (({"speed": -1}, "speed must be"), ({"plops": {"radius": 9}}, "plops.radius"),
                              ({"color": 1}, "extras.water.color: is not known"), (7, "is no object")):
            self.scene("bad.glb", water)
            self.fails(3, "bad.glb", *SMALL, saying=saying)
        self.scene("bad.glb", {}, extensions={})
        self.fails(3, "bad.glb", *SMALL, saying="is no refractor (material ")
        self.fails(3, "bad.glb", *SMALL, saying=": diffuse); give it a smooth material")

    def test_a_moment_that_takes_too_many_steps_is_refused_before_the_first(self):
        for late in (["--time", "1e6", "-o", "out.png"],
                     ["--frames", "0..999999", "--fps", "1", "-o", "f_%06d.png"]):
            self.fails(2, POOL, *SMALL, *late, saying="choose an earlier --time or --frames")
        self.assertEqual(list(self.folder.glob("*.png")), [])


if __name__ == "__main__":
    main()
