"""What runs for a scene is what the scene calls for: passes, bytes, invocations; and what becomes of the
light."""

import collections
import json
import math
import os
import pathlib
import re

import glb
from program import SMALL, ProgramTest, main

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
GRID, MAP, SHADOW, PICTURE, HALF, COARSE = 32 * 32, 32 * 32, 64 * 64, 64 * 48, 32 * 24, 16 * 12

# Targets a pass writes anew: texels and bytes of a texel (RGBA32F 16, R32F and depth 4, RGBA8 4), by its page
# in passes/. What several passes share is counted once (occluder_depth fills the depth of caster_map).
BYTES = {
    "occluder_depth": (GRID, 0), "caster_map": (GRID, 36), "caster_exit_map": (GRID, 36),
    "receiver_map": (MAP, 20), "landing": (GRID, 64), "cells": (GRID, 48), "caustic_cells": (MAP, 0),
    "shadow_map": (SHADOW, 8), "pane_light": (MAP, 16), "view_surfaces": (PICTURE, 68),
    "hidden_ends.behind": (HALF, 48), "hidden_ends.in_mirrors": (HALF, 48),
    "light_shading": (PICTURE, 0),
    "light_shading.behind": (HALF, 0), "light_shading.in_mirrors": (HALF, 0),
    "ambient_rays": (COARSE, 16), "ambient_occlusion": (COARSE, 16),
    "compose": (PICTURE, 16), "compose.behind": (HALF, 16), "compose.in_mirrors": (HALF, 16),
    "caster_map.camera": (PICTURE, 36), "glass": (PICTURE, 16),
    "tone_map": (PICTURE, 4), "caustic_map": (MAP, 0),
    "caustic_cells.cascade": (MAP, 0), "caustic_map.cascade": (MAP, 0), "receiver_map.far": (MAP, 20),
    "landing.far": (GRID, 64), "cells.far": (GRID, 48), "caustic_cells.far": (MAP, 0),
    "caustic_map.far": (MAP, 0),
}
# What one pass of each light, or all of the frame, add to: direct and caustic irradiance; and the caustic
# maps, bytes without and with colours.
SHARED = {"light_shading": 32 * PICTURE, "light_shading.behind": 32 * HALF,
          "light_shading.in_mirrors": 32 * HALF}
HIGHLIGHT = {"light_shading": 16 * PICTURE}
TEXEL = {"RGBA32F": 16, "R32F": 4, "Depth32F": 4, "RGBA8": 4}
MAPS = ("caustic_map", "caustic_map.cascade", "caustic_map.far")

CAMERA = ["view_surfaces", "light_shading", "ambient_rays", "ambient_occlusion", "compose", "tone_map"]
CAUSTIC = ["caster_map", "receiver_map", "landing", "cells", "caustic_cells", "caustic_map"]
# Of lights whose caustic is small in its map.
CASCADE = ["caustic_cells.cascade", "caustic_map.cascade"]
# Of receivers that are not one plane; both receiver maps are twice as wide and high then.
FAR = ["receiver_map.far", "landing.far", "cells.far", "caustic_cells.far", "caustic_map.far"]
SEEN = CAMERA + ["hidden_ends.behind", "hidden_ends.in_mirrors", "light_shading.behind",
                 "light_shading.in_mirrors", "compose.behind", "compose.in_mirrors", "caster_map.camera",
                 "glass"]
SOLID = ["caster_exit_map"]
SHADOWS = ["occluder_depth", "shadow_map"]
LIGHT_PASSES = set(CAUSTIC + CASCADE + FAR + SHADOWS + ["caster_exit_map", "light_shading",
                                                        "light_shading.behind", "light_shading.in_mirrors",
                                                        "pane_light"])
BRANCH_PASSES = set(CAUSTIC[2:] + CASCADE + FAR[1:])

# Scene: passes through two surfaces, number of lights, number of branches, whether something tints the
# caustic.
CALLED_FOR = {
    "glass_sphere": (CAUSTIC + CASCADE + SEEN + SOLID, 1, 1, False),
    "glass_figure": (CAUSTIC + CASCADE + SEEN + SOLID, 1, 1, True),  # green glass: three channels
    "metal_ring": (CAUSTIC + SEEN, 1, 1, True),                 # a mirror has no second surface; gold
    "prism": (CAUSTIC + SEEN + SOLID, 1, 3, True),              # the C, d and F lines
    "slab": (CAUSTIC + SEEN + SOLID, 1, 1, False),
    "slab_glass": (CAUSTIC + SEEN + SOLID, 1, 1, False),
    "spectrum": (CAUSTIC + FAR + SEEN + SOLID + SHADOWS, 1, 3, True),
    "sun_disk": (CAUSTIC + CASCADE + FAR + SEEN + SOLID + SHADOWS, 16, 1, False),
    "two_lights": (CAUSTIC + CASCADE + SEEN + SOLID, 2, 1, False),
    "water_patch": (CAUSTIC + SEEN, 1, 1, False),               # open water: no exit map
    "water_sine": (CAUSTIC + CAMERA, 1, 1, False),              # seen from under the water: no glass in view
}


def expected_passes(names, lights, branches):
    count = collections.Counter()
    for name in names:
        count[name] = (lights if name in LIGHT_PASSES else 1) * (branches if name in BRANCH_PASSES else 1)
    return count


def expected_bytes(count, lights, coloured):
    total = 0
    for name, times in count.items():
        texels, size = BYTES[name]
        if name.startswith("receiver_map") and "receiver_map.far" in count:
            texels *= 4
        total += times * texels * size
        # The picture's shading is one for all lights, a caustic map one for all branches.
        # Without casters there is no caustic irradiance.
        total += SHARED.get(name, 0) // (1 if "landing" in count else 2)
        # What surfaces mirror of the lights; and what glass and metal before them do.
        total += HIGHLIGHT.get(name, 0)
        if name == "light_shading" and "glass" in count:
            total += HIGHLIGHT[name]
        total += lights * (16 if coloured else 4) * MAP if name in MAPS else 0
    return total


def bytes_of(texture):
    return texture["width"] * texture["height"] * TEXEL[texture["format"]]


def least_bytes(passes):
    """Of textures that share memory with others of their kind: as many as live at one time. A texture lives
    from the first pass that writes it to the one that it is there until."""
    first, last, textures = {}, {}, {}
    numbers = {planned["pass"]: number for number, planned in enumerate(passes)}
    for number, planned in enumerate(passes):
        for texture in planned["writes"]:
            textures[texture["name"]] = texture
            first.setdefault(texture["name"], number)
            last[texture["name"]] = numbers[texture["until"]] if texture["until"] else len(passes)
        for name in planned["reads"]:
            assert last.get(name, number) >= number, f"{name} is gone before {planned['pass']} reads it"
    most = collections.Counter()
    for number in range(len(passes)):
        alive = collections.Counter()
        for name, texture in textures.items():
            if first[name] <= number <= last[name]:
                alive[texture["format"], texture["width"], texture["height"], bytes_of(texture)] += 1
        most |= alive
    return sum(kind[3] * times for kind, times in most.items())


def bare(label):
    """Pass and instance: "landing.far" of "landing[sun].far"."""
    return re.sub(r"\[.*\]", "", label)


class PlanTest(ProgramTest):
    def plan(self, scene, *options):
        return json.loads(self.succeeds("plan", str(scene), "--json", *SMALL, *options).stdout)

    def check(self, plan, names, lights, branches=1, coloured=False):
        expected = expected_passes(names, lights, branches)
        self.assertEqual(collections.Counter(bare(p["pass"]) for p in plan["passes"]), expected)
        written = {texture["name"]: bytes_of(texture) for p in plan["passes"] for texture in p["writes"]}
        self.assertEqual(sum(written.values()), expected_bytes(expected, lights, coloured))
        self.assertEqual(plan["texture_bytes"], least_bytes(plan["passes"]))


class SampleScenes(PlanTest):
    def test_each_sample_scene_runs_the_passes_it_calls_for_and_allocates_their_bytes(self):
        for scene, called_for in CALLED_FOR.items():
            with self.subTest(scene):
                options = ["-D", "further.share=1"]
                self.check(self.plan(SCENES / f"{scene}.glb", *options), *called_for)

    def test_light_is_followed_through_its_surfaces_branch_by_branch(self):
        # Two splits: nobody, mirrored 2, mirrored 1, drawn.
        options = ["-D", "splits=2", "-D", "bounces=5", "-D", "further.share=0.03"]
        plan = self.plan(SCENES / "glass" / "hollow_ball.glb", *options)
        labels = [p["pass"] for p in plan["passes"] if "sun" in p["pass"]]
        walks = [label for label in labels if label.startswith("walk[")]
        ways = ("", " mirrored 2", " mirrored 1", " drawn")
        self.assertEqual(walks, [f"walk[sun{way}]" for way in ways])
        self.assertEqual(plan["texture_bytes"], least_bytes(plan["passes"]))
        self.assertGreater(plan["further_shares"][0]["share"], 0.5)

    def test_a_cascade_can_be_done_without(self):
        self.check(self.plan(SCENES / "glass_sphere.glb", "-D", "cascades=off"), CAUSTIC + SEEN + SOLID, 1)

    def test_invocations_follow_from_grid_and_map(self):
        self.succeeds("render", str(SCENES / "glass_sphere.glb"), *SMALL, "--stats", "s.json", "--quiet")
        passes = {bare(p["pass"]): p for p in json.loads((self.folder / "s.json").read_text())["passes"]}
        # One triangle over all texels; a point a grid vertex, a point a cell.
        self.assertEqual(passes["landing"]["vertices"], 3)
        self.assertEqual(passes["landing"]["fragments"], GRID)
        self.assertEqual(passes["cells"]["fragments"], GRID)
        self.assertEqual(passes["caustic_cells"]["vertices"], 31 * 31)
        self.assertEqual(passes["caustic_map"]["vertices"], GRID)
        self.assertEqual(passes["caustic_cells.cascade"]["vertices"], 31 * 31)
        self.assertEqual(passes["caustic_map.cascade"]["vertices"], GRID)
        self.assertEqual(passes["light_shading"]["fragments"], PICTURE)
        # Where glass shows what the picture does not, on whole squares of 4 x 4 texels at most.
        self.assertLess(passes["light_shading.in_mirrors"]["fragments"], HALF)


class WithoutACaster(PlanTest):
    def setUp(self):
        super().setUp()
        plaster = {"name": "plaster", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}}
        (self.folder / "plain.glb").write_bytes(glb.scene(plaster))

    def test_caustics_cost_nothing(self):
        plan = self.plan("plain.glb")
        # The ball shadows the floor: one shadow map.
        self.check(plan, CAMERA + ["shadow_map"], 1)
        names = [name for p in plan["passes"] for name in p["reads"]]
        for name in names:  # ambient_rays asks what glass lets through
            if name != "caster_materials":
                self.assertFalse(name.startswith(("caster_", "receiver_", "landing", "caustic_map")), name)
        self.succeeds("render", "plain.glb", *SMALL, "--stats", "s.json", "--quiet")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual([bare(p["pass"]) for p in stats["passes"]],
                         [bare(p["pass"]) for p in plan["passes"]])
        self.assertEqual(stats["texture_bytes"], plan["texture_bytes"])
        self.assertEqual(stats["lights"], [])


class WhatBecomesOfTheLight(PlanTest):
    def expectation(self, *options, **scene):
        (self.folder / "case.glb").write_bytes(glb.scene(**scene))
        plan = self.plan("case.glb", *options)
        self.assertEqual(len(plan["expectations"]), 1)
        # `render` says the same.
        result = self.succeeds("render", "case.glb", *SMALL, *options)
        said = plan["expectations"][0]
        self.assertEqual(said["expected"], "caustic: none" not in result.stderr, result.stderr)
        if not said["expected"]:
            self.assertIn(said["reason"], result.stderr)
        return said

    def test_the_share_that_lands_is_told(self):
        said = self.expectation()
        self.assertTrue(said["expected"])
        # T^2 of a glass sphere is 0.8355 (Fresnel's equations, averaged over its disk); 24 segments and a
        # grid of 32 are a coarse sphere.
        landed = float(said["reason"].split("; ")[1].split("%")[0])
        self.assertAlmostEqual(landed, 83.6, delta=4)

    def test_what_the_passes_do_not_follow_is_told(self):
        scene = str(SCENES / "glass_sphere.glb")
        two = "-D", "further.share=1"
        said = self.succeeds("plan", scene, *two, "--json", "--camera", "floor").stdout
        told = json.loads(said)["model_error"]
        # A sphere mirrors 0.0918 of its disc's light, and 0.0727 is still inside after one pass (closed
        # form); half of either goes down.
        self.assertLess(told[0]["not_followed"], (0.0918 + 0.0727) / 0.8355)
        self.assertGreater(told[0]["not_followed"], 0.25 * (0.0918 + 0.0727))
        self.assertGreater(told[0]["error"], 0.005)
        self.assertIn("ways that are not followed", self.succeeds("plan", scene, *two).stdout)

    def test_a_prism_that_reflects_everything_throws_none(self):
        # 45 degrees are beyond the critical angle of 41.8.
        said = self.expectation(caster=glb.roof())
        self.assertFalse(said["expected"])
        self.assertIn("all of its light is totally reflected inside", said["reason"])

    def test_light_that_misses_every_receiver_throws_none(self):
        said = self.expectation("--ground", "off", floors=((50, 0, 0),))
        self.assertFalse(said["expected"])
        self.assertIn("all of its light goes past everything that could show it", said["reason"])

    def test_a_caster_in_the_dark_throws_none(self):
        said = self.expectation(floors=((0, 0, 0), (0, 3, 0)))
        self.assertFalse(said["expected"])
        self.assertEqual(said["reason"], "no light reaches it: 'floor' stands before it")


class LightThatMissesTheCasters(PlanTest):
    def test_its_passes_draw_nothing_and_those_of_a_small_thing_in_the_light_do(self):
        document, blob = glb.unpack(glb.scene())
        document["extensions"]["KHR_lights_punctual"]["lights"].append(
            {"name": "torch", "type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}})
        document["nodes"].append(document["nodes"][2] | {
            "name": "torch", "translation": [0, 4, -2.5],
            "extensions": {"KHR_lights_punctual": {"light": 1}}})
        # All of it a tenth as large: a hundredth of a square metre of sunlight meets the ball.
        top = len(document["nodes"])
        document["nodes"].append({"scale": [0.1] * 3, "children": list(range(top))})
        document["scenes"] = [{"nodes": [top]}]
        (self.folder / "two.glb").write_bytes(glb.pack(document, blob))
        idle = {p["pass"] for p in self.plan("two.glb")["passes"] if p["draws_nothing"]}
        self.assertLessEqual({"landing[torch]", "cells[torch]", "caustic_map[torch]"}, idle)
        self.assertEqual([label for label in idle if "torch" not in label], [])


class ManyLights(ProgramTest):
    """Of more than 16 lights, weak ones have smaller maps and the weakest no caustic; it is said."""

    # 60 lamps of 10 cd give about 1.7 % of the light each, one of .01 cd less than .5 %.
    def plan(self, *candelas, options=()):
        (self.folder / "lights.glb").write_bytes(glb.many_lights(candelas))
        text = self.succeeds("plan", "lights.glb", "--json", *SMALL, *options).stdout
        return json.loads(text)

    def effect(self, plan):
        return next(each for each in plan["effects"] if each["name"] == "dim lights")

    def test_few_lights_are_drawn_in_full(self):
        self.assertFalse(self.effect(self.plan(*[10] * 15, 0.01))["active"])

    def test_weak_lights_are_named_and_the_weakest_throw_no_caustic(self):
        plan = self.plan(*[10] * 60, 0.01)
        said = self.effect(plan)
        self.assertTrue(said["active"])
        self.assertIn("60 lights of 61", said["reason"])
        self.assertIn("1 light, together less than 0.5 %", said["reason"])
        without = [each for each in plan["expectations"] if not each["expected"]]
        self.assertEqual([each["light"] for each in without], [60])
        self.assertIn("weakest", without[0]["reason"])

    def test_settings_of_0_give_every_light_its_caustic_in_full(self):
        plan = self.plan(*[10] * 60, 0.01, options=["-D", "light.least=0", "-D", "light.full=0"])
        self.assertFalse(self.effect(plan)["active"])
        self.assertTrue(all(each["expected"] for each in plan["expectations"]))


class Environments(ProgramTest):
    def test_one_that_hides_or_lacks_light_is_told_with_the_strength_that_balances_it(self):
        # A sky that is even lights a floor with pi times its radiance: bytes 128 and 129 are 1 nit.
        (self.folder / "even.hdr").write_bytes(
            b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n" + b"\x80\x80\x80\x81" * 2048)
        lux = 900
        (self.folder / "sun.glb").write_bytes(glb.scene(light={"type": "directional", "intensity": lux}))
        for share in (0.02, 0.09, 0.11, 0.3, 1.9, 2.1, 2.4, 9.0):
            strength = share * lux / math.pi
            plan = json.loads(self.succeeds("plan", "sun.glb", *SMALL, "--json", "--environment", "even.hdr",
                                            "--environment-strength", strength).stdout)
            told = [note for note in plan["notes"] if note.startswith("The environment gives")]
            if 0.1 < share < 2:
                self.assertEqual(told, [], share)
                continue
            times, balance = re.fullmatch("The environment gives (.*) times what the lights give; "
                                          "--environment-strength (.*) would balance them.", *told).groups()
            self.assertAlmostEqual(float(times), share, delta=0.05 * share)
            # Whatever the strength is: three tenths of what the sun gives.
            self.assertAlmostEqual(float(balance), 0.3 * lux / math.pi, delta=0.02 * lux / math.pi)


class Colour(ProgramTest):
    def shown(self, **environment):
        code, lines = self.on_terminal("plan", "ball.glb", stream="stdout",
                                       env={**os.environ, "TERM": "xterm", **environment})
        self.assertEqual(code, 0)
        return "\n".join(lines)

    def test_a_terminal_is_shown_colours_unless_it_has_none_or_they_are_not_wanted(self):
        plain = self.succeeds("plan", "ball.glb").stdout
        self.assertNotIn("\x1b", plain)
        coloured = self.shown()
        self.assertIn("\x1b[", coloured)
        passes = [re.sub("\x1b\\[[0-9;]*m", "", line).split("  ")[0] for line in coloured.splitlines()]
        self.assertEqual(passes, [line.split("  ")[0] for line in plain.splitlines()])
        for unwanted in ({"TERM": "dumb"}, {"NO_COLOR": "1"}):
            self.assertNotIn("\x1b", self.shown(**unwanted))


if __name__ == "__main__":
    main()
