"""What runs for a scene is what the scene calls for: passes, bytes, invocations; and what becomes of the light."""

import collections
import json
import pathlib
import unittest

import glb
from program import SMALL, ProgramTest

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
GRID, MAP, SHADOW, PICTURE, WIDE = 32 * 32, 32 * 32, 64 * 64, 64 * 48, 32 * 24

# Targets a pass writes anew: texels and bytes of a texel (RGBA32F 16, R32F and depth 4, RGBA8 4), by its page in
# passes/. What several passes share is counted once (occluder_depth fills the depth of caster_map).
BYTES = {
    "occluder_depth": (GRID, 0), "caster_map": (GRID, 36), "caster_exit_map": (GRID, 36),
    "receiver_map": (MAP, 20), "landing": (GRID, 64), "cells": (GRID, 48), "caustic_cells": (MAP, 0),
    "caustic_cells_grey": (MAP, 0), "shadow_map": (SHADOW, 8), "pane_light": (MAP, 16),
    "view_surfaces": (PICTURE, 68), "wide_surfaces": (WIDE, 68), "light_shading": (PICTURE, 0),
    "wide_shading": (WIDE, 0), "compose": (PICTURE, 16), "compose_beauty": (PICTURE, 16), "wide_compose": (WIDE, 16),
    "view_caster_map": (PICTURE, 36), "view_exit_map": (PICTURE, 36), "glass": (PICTURE, 16),
    "view_panes": (PICTURE, 0), "view_pane_mirror": (PICTURE, 0), "tone_map": (PICTURE, 4),
    "caustic_map": (MAP, 0), "caustic_map_grey": (MAP, 0), "cascade_cells": (MAP, 0), "cascade_cells_grey": (MAP, 0),
    "cascade_map": (MAP, 0), "cascade_map_grey": (MAP, 0), "far_receiver_map": (MAP, 20), "far_landing": (GRID, 64),
    "far_cells": (GRID, 48), "far_caustic_cells": (MAP, 0), "far_caustic_cells_grey": (MAP, 0),
    "far_caustic_map": (MAP, 0), "far_caustic_map_grey": (MAP, 0),
}
# What one pass of each light, or all of the frame, add to: direct and caustic irradiance, the caustic map.
SHARED = {"light_shading": 32 * PICTURE, "wide_shading": 32 * WIDE, "caustic_map": 16 * MAP, "caustic_map_grey": 4 * MAP,
          "cascade_map": 16 * MAP, "cascade_map_grey": 4 * MAP, "far_caustic_map": 16 * MAP,
          "far_caustic_map_grey": 4 * MAP}

CAMERA = ["view_surfaces", "light_shading", "tone_map"]
CAUSTIC = ["caster_map", "receiver_map", "landing", "cells"]
GREY, COLOURED = ["caustic_cells_grey", "caustic_map_grey"], ["caustic_cells", "caustic_map"]
# Of lights whose caustic is small in its map.
GREY_CASCADE, CASCADE = ["cascade_cells_grey", "cascade_map_grey"], ["cascade_cells", "cascade_map"]
# Of receivers that are not one plane; both receiver maps are twice as wide and high then.
FAR = ["far_receiver_map", "far_landing", "far_cells"]
FAR_GREY = FAR + ["far_caustic_cells_grey", "far_caustic_map_grey"]
FAR_COLOURED = FAR + ["far_caustic_cells", "far_caustic_map"]
SEEN = CAMERA + ["wide_surfaces", "wide_shading", "compose", "wide_compose", "view_caster_map", "glass"]
SOLID = ["caster_exit_map", "view_exit_map"]
SHADOWS = ["occluder_depth", "shadow_map"]
PANES = ["pane_light", "view_panes", "view_pane_mirror"]
LIGHT_PASSES = set(CAUSTIC + GREY + COLOURED + GREY_CASCADE + CASCADE + FAR_GREY + FAR_COLOURED + SHADOWS + ["caster_exit_map", "light_shading", "wide_shading", "pane_light"])
BRANCH_PASSES = set(["landing", "cells"] + GREY + COLOURED + GREY_CASCADE + CASCADE + FAR_GREY[1:] + FAR_COLOURED[1:])

# Scene: passes, number of lights, number of branches.
CALLED_FOR = {
    "glass_sphere": (CAUSTIC + GREY + GREY_CASCADE + SEEN + SOLID, 1, 1),
    "glass_figure": (CAUSTIC + COLOURED + CASCADE + SEEN + SOLID, 1, 1),  # green glass: three channels
    "metal_ring": (CAUSTIC + COLOURED + SEEN, 1, 1),            # a mirror has no second surface; gold
    "prism": (CAUSTIC + COLOURED + SEEN + SOLID, 1, 3),         # the C, d and F lines
    "slab": (CAUSTIC + GREY + SEEN + SOLID, 1, 1),
    "slab_glass": (CAUSTIC + GREY + SEEN + SOLID, 1, 1),
    "spectrum": (CAUSTIC + COLOURED + FAR_COLOURED + SEEN + SOLID + SHADOWS, 1, 3),
    "sun_disk": (CAUSTIC + GREY + GREY_CASCADE + FAR_GREY + SEEN + SOLID + SHADOWS, 16, 1),
    "two_lights": (CAUSTIC + GREY + GREY_CASCADE + SEEN + SOLID, 2, 1),
    "water_patch": (CAUSTIC + GREY + SEEN, 1, 1),               # open water: no exit map
    "water_sine": (CAUSTIC + GREY + SEEN, 1, 1),
}


def expected_passes(names, lights, branches):
    count = collections.Counter()
    for name in names:
        count[name] = (lights if name in LIGHT_PASSES else 1) * (branches if name in BRANCH_PASSES else 1)
    return count


def expected_bytes(count, lights):
    total = 0
    for name, times in count.items():
        texels, size = BYTES[name]
        if name.endswith("receiver_map") and "far_receiver_map" in count:
            texels *= 4
        total += times * texels * size
        # The picture's shading is one for all lights, a caustic map one for all branches.
        total += SHARED.get(name, 0) * (lights if name.startswith(("caustic", "cascade", "far_caustic")) else 1)
    return total


def bare(label):
    return label.split("[")[0]


class PlanTest(ProgramTest):
    def plan(self, scene, *options):
        return json.loads(self.succeeds("plan", str(scene), "--json", *SMALL, *options).stdout)

    def check(self, plan, names, lights, branches=1):
        expected = expected_passes(names, lights, branches)
        self.assertEqual(collections.Counter(bare(p["pass"]) for p in plan["passes"]), expected)
        self.assertEqual(plan["texture_bytes"], expected_bytes(expected, lights))


class SampleScenes(PlanTest):
    def test_each_sample_scene_runs_the_passes_it_calls_for_and_allocates_their_bytes(self):
        for scene, (names, lights, branches) in CALLED_FOR.items():
            with self.subTest(scene):
                self.check(self.plan(SCENES / f"{scene}.glb"), names, lights, branches)

    def test_a_cascade_can_be_done_without(self):
        self.check(self.plan(SCENES / "glass_sphere.glb", "-D", "cascades=off"), CAUSTIC + GREY + SEEN + SOLID, 1)

    def test_invocations_follow_from_grid_and_map(self):
        self.succeeds("render", str(SCENES / "glass_sphere.glb"), *SMALL, "--stats", "s.json", "--quiet")
        passes = {bare(p["pass"]): p for p in json.loads((self.folder / "s.json").read_text())["passes"]}
        # One triangle over all texels; a point a grid vertex, a point a cell.
        self.assertEqual(passes["landing"]["vertices"], 3)
        self.assertEqual(passes["landing"]["fragments"], GRID)
        self.assertEqual(passes["cells"]["fragments"], GRID)
        self.assertEqual(passes["caustic_cells_grey"]["vertices"], 31 * 31)
        self.assertEqual(passes["caustic_map_grey"]["vertices"], GRID)
        self.assertEqual(passes["cascade_cells_grey"]["vertices"], 6 * 31 * 31)
        self.assertEqual(passes["cascade_map_grey"]["vertices"], GRID)
        self.assertEqual(passes["light_shading"]["fragments"], PICTURE)
        self.assertEqual(passes["wide_shading"]["fragments"], WIDE)


class WithoutACaster(PlanTest):
    def setUp(self):
        super().setUp()
        plaster = {"name": "plaster", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}}
        (self.folder / "plain.glb").write_bytes(glb.scene(plaster))

    def test_caustics_cost_nothing(self):
        plan = self.plan("plain.glb")
        # The ball shadows the floor: one shadow map.
        self.check(plan, CAMERA + ["shadow_map", "compose_beauty"], 1)
        names = [name for p in plan["passes"] for name in p["reads"]]
        self.assertFalse([n for n in names if n.startswith(("caster_", "receiver_", "landing", "caustic_map"))])
        self.succeeds("render", "plain.glb", *SMALL, "--stats", "s.json", "--quiet")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual([bare(p["pass"]) for p in stats["passes"]], [bare(p["pass"]) for p in plan["passes"]])
        self.assertEqual(stats["texture_bytes"], plan["texture_bytes"])
        self.assertEqual(stats["lights"], [])


class WhatBecomesOfTheLight(PlanTest):
    def expectation(self, **scene):
        (self.folder / "case.glb").write_bytes(glb.scene(**scene))
        plan = self.plan("case.glb")
        self.assertEqual(len(plan["expectations"]), 1)
        # `render` says the same.
        result = self.succeeds("render", "case.glb", *SMALL)
        said = plan["expectations"][0]
        self.assertEqual(said["expected"], "no caustic:" not in result.stderr, result.stderr)
        if not said["expected"]:
            self.assertIn(said["reason"], result.stderr)
        return said

    def test_the_share_that_lands_is_told(self):
        said = self.expectation()
        self.assertTrue(said["expected"])
        # T^2 of a glass sphere is 0.8355 (Fresnel's equations, averaged over its disk); 24 segments and a grid of 32 are a coarse sphere.
        landed = float(said["reason"].split("; ")[1].split("%")[0])
        self.assertAlmostEqual(landed, 83.6, delta=4)

    def test_a_prism_that_reflects_everything_throws_none(self):
        # 45 degrees are beyond the critical angle of 41.8.
        said = self.expectation(caster=glb.roof())
        self.assertFalse(said["expected"])
        self.assertEqual(said["reason"], "all of its light is totally reflected inside")

    def test_light_that_misses_every_receiver_throws_none(self):
        said = self.expectation(floors=((50, 0, 0),))
        self.assertFalse(said["expected"])
        self.assertEqual(said["reason"], "all of its light misses every receiver")

    def test_a_caster_in_the_dark_throws_none(self):
        said = self.expectation(floors=((0, 0, 0), (0, 3, 0)))
        self.assertFalse(said["expected"])
        self.assertIn("no light reaches it", said["reason"])


if __name__ == "__main__":
    unittest.main()
