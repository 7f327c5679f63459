"""Lights with a size: drawn by samples, shown as the one light that they are."""

import json
import math
import re

import glb
from program import SMALL, ProgramTest, main

SUN = {"name": "sun", "type": "directional", "intensity": 1000}


class AreaLights(ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene("sun.glb", {"angular_diameter": 5})

    def scene(self, name, extras):
        (self.folder / name).write_bytes(glb.scene(light={**SUN, "extras": extras}))

    def stats(self, *options):
        self.succeeds("sun.glb", *SMALL, "--stats", "s.json", *options)
        return json.loads((self.folder / "s.json").read_text())

    def test_plan_shows_one_light_with_its_size(self):
        text = self.succeeds("plan", "sun.glb", *SMALL).stdout
        self.assertIn("disk of 5 degrees, 16 samples", text)
        self.assertEqual(text.count("  landing[sun"), 1)
        self.assertIn("landing[sun] x 16", text)
        self.assertIn("caustic_map[sun.00..sun.15] R32F", text)
        document = json.loads(self.succeeds("plan", "sun.glb", "-D", "further.share=1", "--json").stdout)
        self.assertEqual(len(document["lights"]), 1)
        self.assertEqual(document["lights"][0]["samples"], 16)
        self.assertEqual(document["lights"][0]["size"]["shape"], "disk")
        self.assertAlmostEqual(document["lights"][0]["size"]["angular_diameter_degrees"], 5)
        self.assertEqual(len(document["expectations"]), 1)
        self.assertTrue(any(p["pass"] == "landing[sun.15]" for p in document["passes"]))

    def test_the_ledger_is_one_and_does_not_depend_on_the_samples(self):
        entered = []
        for samples in (1, 4):
            stats = self.stats("-D", f"light.samples={samples}")
            self.assertEqual(len(stats["lights"]), 1)
            light = stats["lights"][0]
            self.assertEqual(light["intensity"], 1000)
            self.assertEqual(light["samples"], samples)
            self.assertEqual(sum(light["vertices"].values()), samples * 32 * 32)
            entered.append(light["flux"]["entered"][0])
        # A silhouette on a grid of 32 x 32 is good to a percent.
        self.assertAlmostEqual(entered[1] / entered[0], 1.0, delta=0.01)

    def check_textures_take_no_more_memory_with_more_samples(self):
        def textures(command, samples):
            if command == "plan":
                plan = self.succeeds("plan", "sun.glb", "--json", *SMALL, "-D", f"light.samples={samples}")
                return json.loads(plan.stdout)["texture_bytes"]
            return self.stats("-D", f"light.samples={samples}")["texture_bytes"]

        for command in ("plan", "render"):
            self.assertEqual(textures(command, 4), textures(command, 16))

    def test_textures_take_no_more_memory_with_more_samples(self):
        self.check_textures_take_no_more_memory_with_more_samples()

    def test_textures_take_no_more_memory_with_more_samples_in_haze(self):
        document, blob = glb.unpack((self.folder / "sun.glb").read_bytes())
        document["scenes"][0]["extras"] = {"medium": {"scattering": 0.5}}
        (self.folder / "sun.glb").write_bytes(glb.pack(document, blob))
        plan = json.loads(self.succeeds("plan", "sun.glb", "--json", *SMALL).stdout)
        passes = [p["pass"] for p in plan["passes"]]
        self.assertIn("light_shafts[sun.15]", passes)
        self.check_textures_take_no_more_memory_with_more_samples()

    def test_a_dump_has_the_textures_of_each_sample(self):
        self.succeeds("sun.glb", *SMALL, "-D", "light.samples=3", "--dump", "d")
        manifest = json.loads((self.folder / "d/manifest.json").read_text())
        hashes = {a["attachment"]: a["sha256"] for a in manifest["attachments"]}
        self.assertEqual(len({hashes[f"landing[{k}]"] for k in range(3)}), 3)
        digest = self.succeeds("digest", "sun.glb", *SMALL, "-D", "light.samples=3").stdout
        for k in range(3):
            self.assertIn(f" landing[{k}] {hashes[f'landing[{k}]']}", digest)

    def test_the_summary_has_a_line_a_light(self):
        result = self.succeeds("sun.glb", *SMALL, "-D", "light.samples=4")
        lines = [line for line in result.stderr.splitlines() if line.startswith("light ")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("light 'sun': "))

    def test_one_sample_is_the_light_without_a_size(self):
        self.succeeds("ball.glb", *SMALL, "-o", "a.exr")
        self.succeeds("sun.glb", *SMALL, "-D", "light.samples=1", "-o", "b.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_probe_follows_a_sample(self):
        probe = ["probe", "sun.glb", "--texel", "16,16", *SMALL, "-D", "light.samples=4"]
        first = self.succeeds(*probe).stdout
        last = self.succeeds(*probe, "--sample", "3").stdout
        self.assertIn("agree to the bit", last)
        self.assertNotEqual(first, last)
        self.fails(2, *probe, "--sample", "4", saying="--sample must be 0..3")

    def test_sizes_that_are_none_are_refused(self):
        for extras in ({"angular_diameter": -1}, {"angular_diameter": "wide"}):
            self.scene("bad.glb", extras)
            self.fails(3, "bad.glb", *SMALL, saying="extras.angular_diameter")


class ManyLights(ProgramTest):
    def said(self, name, lights, *options):
        """What render says of a ball under suns, [(lux, lean)]: the share of their light that makes a
        caustic, and its stated error, in percent."""
        document, blob = glb.unpack(glb.scene())
        document["extensions"]["KHR_lights_punctual"]["lights"] = [
            {"type": "directional", "intensity": lux} for lux, _ in lights]
        nodes, scene = document["nodes"], document["scenes"][0]
        shines = lambda i: "KHR_lights_punctual" in nodes[i].get("extensions", {})
        scene["nodes"] = [i for i in scene["nodes"] if not shines(i)]
        for i, (_, lean) in enumerate(lights):
            half = (lean - math.pi / 2) / 2
            scene["nodes"].append(len(nodes))
            nodes.append({"rotation": [math.sin(half), 0, 0, math.cos(half)],
                          "extensions": {"KHR_lights_punctual": {"light": i}}})
        (self.folder / name).write_bytes(glb.pack(document, blob))
        said = self.succeeds(name, *SMALL, "-D", "light.full=0", *options, "-v").stderr
        words = (r"caustic: ([\d.]+)% of", r"estimated ([\d.]+)%")
        return [float(re.search(each, said)[1]) for each in words]

    def test_what_is_said_of_all_weighs_a_caustic_with_those_that_it_stands_for(self):
        # One sun from above, and eighteen of half its strength from the side, as the caustic of one.
        lights = [(100, 0)] + [(50, 0.9 + 0.0005 * i) for i in range(18)]
        many = self.said("many.glb", lights, "-D", "light.most=2")
        two = self.said("two.glb", [(100, 0), (900, 0.904)])
        self.assertAlmostEqual(many[0], two[0], delta=1.5)
        self.assertAlmostEqual(many[1], two[1], delta=0.05 * two[1])


class EmissiveMeshes(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "lamp.glb").write_bytes(glb.scene(self.lamp(1)))
        for name, nit, scale in (("only_lamp.glb", 5000, 1), ("only_glow.glb", 1, 0.02)):
            document, blob = glb.unpack(glb.scene(self.lamp(nit)))
            del document["extensions"], document["nodes"][2]["extensions"]
            document["nodes"][0]["scale"] = [scale] * 3
            (self.folder / name).write_bytes(glb.pack(document, blob))

    def lamp(self, nit):
        return {"name": "lamp", "emissiveFactor": [1, 0.5, 0],
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": nit}},
                "pbrMetallicRoughness": {"metallicFactor": 0}}

    def plan(self, scene, *options):
        return json.loads(self.succeeds("plan", scene, "--json", *options).stdout)

    def reason(self, plan):
        return {e["name"]: e["reason"] for e in plan["effects"]}["emissive lights"]

    def first_lines(self, scene, *options):
        lines = self.succeeds(scene, *SMALL, *options).stderr.splitlines()
        return {line.split(":")[0]: line for line in lines}

    def test_light_a_scene_without_another_light_in_place_of_a_sun(self):
        plan = self.plan("only_lamp.glb")
        self.assertEqual([light["name"] for light in plan["lights"]], ["ball"])
        self.assertEqual(plan["lights"][0]["size"], {"shape": "mesh", "mesh": 0})
        self.assertRegex(self.reason(plan), r"mesh 'ball' \([0-9]+ samples\) lights the scene")
        said = self.first_lines("only_lamp.glb")
        self.assertNotIn("sun", said["added"])
        self.assertIn("mesh 'ball'", said["shining"])

    def test_that_only_glow_are_said_to_and_a_sun_is_added(self):
        said = self.first_lines("only_glow.glb")
        self.assertIn("a sun of 10 lux", said["added"])
        self.assertIn("mesh 'ball' shines, but does not light the scene: it adds less than a tenth",
                      said["shining"])
        self.assertEqual([light["name"] for light in self.plan("only_glow.glb")["lights"]], ["sun (added)"])
        plan = self.plan("only_glow.glb", "-D", "emissive.lights=on")
        self.assertEqual([light["name"] for light in plan["lights"]], ["ball"])

    def test_are_left_to_glow_beside_a_strong_sun_unless_asked_for(self):
        plan = self.plan("lamp.glb")
        self.assertEqual([light["name"] for light in plan["lights"]], ["sun"])
        self.assertIn("-D emissive.lights=on", self.reason(plan))
        plan = self.plan("lamp.glb", "-D", "emissive.lights=on")
        self.assertEqual([light["name"] for light in plan["lights"]], ["sun", "ball"])
        self.assertEqual(plan["lights"][1]["unit"], "cd")
        plan = self.plan("only_lamp.glb", "-D", "emissive.lights=off")
        self.assertEqual([light["name"] for light in plan["lights"]], ["sun (added)"])

    def test_change_the_picture(self):
        self.succeeds("lamp.glb", *SMALL, "-o", "off.exr")
        self.succeeds("lamp.glb", *SMALL, "-D", "emissive.lights=on", "-D", "light.samples=4",
                      "-o", "on.exr")
        self.assertNotEqual((self.folder / "on.exr").read_bytes(),
                            (self.folder / "off.exr").read_bytes())


if __name__ == "__main__":
    main()
