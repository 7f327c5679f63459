"""Every number that a run prints or writes, computed a second way: from the textures of its dump, from
another file, or from another command. On a scene of two lights of different kinds, colours and strengths,
through coloured glass, so that no number stands for another."""

import json
import pathlib
import re
import subprocess
import tempfile

import glb
import pictures
from program import PROGRAM, SMALL, ProgramTest, main

LAMP = {"name": "lamp", "type": "point", "intensity": 700, "color": [1, 0.5, 0.25]}
SIZES = ["-r", "64x48", "--grid", "32", "--map", "24", "-D", "shadow=64", "-D", "further.share=1"]


def scene_of_two_lights():
    amber = glb.glass(thicknessFactor=1, attenuationDistance=1.5, attenuationColor=[0.9, 0.6, 0.3])
    document, blob = glb.unpack(glb.scene(amber))
    document["extensions"]["KHR_lights_punctual"]["lights"].append(LAMP)
    document["scenes"][0]["nodes"].append(len(document["nodes"]))
    document["nodes"].append({"name": "lamp", "translation": [1.5, 3, 0.5],
                              "extensions": {"KHR_lights_punctual": {"light": 1}}})
    return glb.pack(document, blob)


def percents(text):
    """The numbers before each % of a text, as shares."""
    return [float(number) / 100 for number in re.findall(r"([\d.]+)%", text)]


class Numbers(ProgramTest):
    """One run of render for all of them."""

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.of_class = pathlib.Path(cls.kept.name)
        (cls.of_class / "two.glb").write_bytes(scene_of_two_lights())
        run = subprocess.run([PROGRAM, "two.glb", *SIZES, "--stats", "s.json", "--dump", "d", "-o", "a.exr",
                              "--aov", "beauty,caustic,direct"], cwd=cls.of_class, capture_output=True,
                             text=True, timeout=300)
        assert run.returncode == 0, run.stderr
        cls.said = run.stderr
        cls.stats = json.loads((cls.of_class / "s.json").read_text())
        cls.manifest = json.loads((cls.of_class / "d/manifest.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def texture(self, name):
        """Its last state in the dump, {channel: values}."""
        entry = [each for each in self.manifest["attachments"] if each["attachment"] == name][-1]
        return pictures.Exr((self.of_class / "d" / entry["file"]).read_bytes()).values()

    def assert_near(self, a, b, tolerance=1e-9):
        self.assertAlmostEqual(a, b, delta=tolerance * max(abs(a), abs(b), 1e-30))

    def assert_said(self, said, true):
        """A tenth of a percent is cut off, not rounded: 99.97 % is not all."""
        self.assertTrue(-1e-9 < true - said < 0.001 + 1e-9, (said, true))

    def test_each_lights_ledger_is_the_sum_of_its_own_textures(self):
        for k, light in enumerate(self.stats["lights"]):
            landing, left = self.texture(f"landing[{k}]"), self.texture(f"landing_flux[{k}]")
            fresnel, absorbed = self.texture(f"landing_fresnel[{k}]"), self.texture(f"landing_absorbed[{k}]")
            flux, statuses = light["flux"], list(light["vertices"])
            for status, name in enumerate(statuses):
                cells = [i for i, code in enumerate(landing["A"]) if code == status]
                self.assertEqual(light["vertices"][name], len(cells), name)
                if name in ("missed", "outside", "total_reflection", "not_converged", "exit_not_found"):
                    for channel, letter in enumerate("RGB"):
                        self.assert_near(flux[name][channel], sum(left[letter][i] for i in cells))
            for channel, letter in enumerate("RGB"):
                self.assert_near(flux["entered"][channel], sum(fresnel["A"]))
                self.assert_near(flux["fresnel"][channel], sum(fresnel[letter]))
                self.assert_near(flux["absorbed"][channel], sum(absorbed[letter]))
                self.assert_near(flux["in_map"][channel], sum(self.texture(f"caustic_map[{k}]")[letter]))
        ledgers = [light["flux"] for light in self.stats["lights"]]
        self.assertGreater(ledgers[0]["absorbed"][2], 2 * ledgers[0]["absorbed"][0])
        self.assertNotEqual(ledgers[0]["entered"], ledgers[1]["entered"])

    def test_the_accounts_of_each_ledger_add_up_to_what_entered(self):
        for light in self.stats["lights"]:
            flux = light["flux"]
            for channel in range(3):
                rest = flux["entered"][channel] - sum(
                    values[channel] for name, values in flux.items()
                    if name not in ("unit", "entered", "residual", "rounding_bound"))
                self.assertLess(abs(rest), 1e-6 * flux["entered"][channel])
            self.assertLess(flux["residual"], 1e-6)
            for channel in range(3):
                self.assertLessEqual(abs(flux["rounding"][channel]), flux["rounding_bound"][channel])

    def test_lights_are_those_of_the_file(self):
        self.assertEqual([(light["light"], light["name"], light["intensity"], light["intensity_unit"],
                           light["flux"]["unit"], light["samples"]) for light in self.stats["lights"]],
                         [(0, "sun", 1000, "lx", "m2 (lumen per lux)", 1),
                          (1, "lamp", 700, "cd", "sr (lumen per candela)", 1)])

    def test_the_parts_of_an_error_make_its_sum(self):
        for light in self.stats["lights"]:
            error = light["estimated_error"]
            parts = [error[name] for name in ("map", "grid", "missing", "model")]
            self.assertTrue(max(parts) <= error["total"] <= sum(parts) + 1e-12, error)

    def test_the_summary_has_the_numbers_of_the_statistics(self):
        lines = [line for line in self.said.splitlines() if line.startswith("light '")]
        self.assertEqual(len(lines), 2, self.said)
        for line, light in zip(lines, self.stats["lights"]):
            flux, error = light["flux"], light["estimated_error"]
            entered = sum(flux["entered"])
            ledger, _, stated = line.partition("; error ")
            self.assertTrue(ledger.startswith(f"light '{light['name']}': "), line)
            kept, _, lost = ledger.partition("; lost: ")
            self.assert_said(percents(kept)[0], sum(flux["in_map"]) / entered)
            said = {part.rsplit(" ", 1)[0].replace(" ", "_"): percents(part)[0] for part in lost.split(", ")}
            true = {name: sum(values) / entered for name, values in flux.items()
                    if isinstance(values, list) and name not in ("entered", "in_map", "rounding",
                                                                 "rounding_bound")}
            large = sorted(name for name, share in true.items() if share > 0.001)
            self.assertEqual(sorted(said), large, line)
            for name, share in said.items():
                self.assert_said(share, true[name])
            parts = ("total", "map", "grid", "missing", "model", "sampling")
            for number, name in zip(percents(stated), parts):
                self.assert_said(number, error[name])

    def test_the_line_of_the_caustic_weighs_the_lights_by_their_lumens(self):
        lumens = {"entered": 0.0, "in_map": 0.0}
        for light, color in zip(self.stats["lights"], ([1, 1, 1], LAMP["color"])):
            for account in lumens:
                lumens[account] += sum(value * share * light["intensity"]
                                       for value, share in zip(light["flux"][account], color))
        line = next(line for line in self.said.splitlines() if line.startswith("caustic: "))
        self.assert_said(percents(line)[0], lumens["in_map"] / lumens["entered"])
        self.assertIn("of the light onto 'ball' makes one", line)
        # The brightest pixel is lit by the caustic, and said to be where it is.
        x, y = map(int, re.search(r"\(x (\d+), y (\d+)\)", line).groups())
        picture = pictures.Exr((self.of_class / "a.exr").read_bytes()).values()
        caustic = [sum(picture[f"caustic.{letter}"][i] for letter in "RGB") for i in range(64 * 48)]
        self.assertGreater(caustic[64 * y + x], 0.3 * max(caustic))
        across, down = ("left", "", "right")[3 * x // 64], ("upper", "", "lower")[3 * y // 48]
        where = {("", ""): "in the middle", ("", "upper"): "at the top", ("", "lower"): "at the bottom"}.get(
            (across, down), f"at the {down + ' ' if down else ''}{across}")
        self.assertIn(f"brightest {where} of the picture", line)

    def test_the_line_of_the_output_has_the_sizes_that_were_asked_for(self):
        self.assertRegex(self.said, r"(?m)^a\.exr: 64x48, grid 32, map 24 in ")
        sizes = {"width": 64, "height": 48, "grid": 32, "map": 24, "shadow": 64}
        self.assertEqual({name: self.stats["settings"][name] for name in sizes}, sizes)

    def test_passes_take_a_fragment_a_pixel_of_what_they_draw_into(self):
        sides = {each["pass"]: (each["width"], each["height"]) for each in self.manifest["passes"]}
        counts = {each["pass"]: each for each in self.stats["passes"]}
        self.assertEqual(list(counts), list(sides))
        whole = [name for name, count in counts.items() if count["vertices"] == 3]
        self.assertIn("landing[lamp]", whole)
        self.assertIn("compose", whole)
        for name in whole:
            if re.match(r"(light_shading|compose).*(behind|in_mirrors)$", name):  # what only glass shows
                self.assertLess(counts[name]["fragments"], sides[name][0] * sides[name][1], name)
                continue
            self.assertEqual(counts[name]["fragments"], sides[name][0] * sides[name][1], name)
            self.assertEqual(counts[name]["primitives"], 1, name)
        self.assertEqual(counts["caster_map[sun]"]["vertices"], 3 * counts["caster_map[sun]"]["primitives"])
        # A point for each vertex of the grid, a rectangle for each of its cells.
        self.assertEqual(counts["caustic_map[lamp]"]["vertices"], 32 * 32)
        self.assertEqual(counts["caustic_cells[lamp]"]["vertices"], 31 * 31)

    def test_layers_of_the_picture_are_textures_of_the_dump(self):
        picture = pictures.Exr((self.of_class / "a.exr").read_bytes()).values()
        for layer, texture in (("caustic.", "aov_caustic"), ("direct.", "aov_direct"), ("", "beauty")):
            dumped = self.texture(texture)
            for letter in "RGB":
                self.assertEqual(picture[layer + letter], dumped[letter], texture)

    def test_the_picture_is_the_sum_of_what_the_lights_give(self):
        """Alone, each light gives its part of direct light and of caustic."""
        parts = []
        for light in (0, 1):
            document, blob = glb.unpack(scene_of_two_lights())
            document["extensions"]["KHR_lights_punctual"]["lights"][1 - light]["intensity"] = 0
            (self.folder / "one.glb").write_bytes(glb.pack(document, blob))
            self.succeeds("one.glb", *SIZES, "-o", "one.exr", "--aov", "caustic,direct")
            parts.append(pictures.Exr((self.folder / "one.exr").read_bytes()).values())
        both = pictures.Exr((self.of_class / "a.exr").read_bytes()).values()
        for channel in ("caustic.R", "caustic.B", "direct.G"):
            most = max(both[channel])
            for a, b, c in zip(parts[0][channel], parts[1][channel], both[channel]):
                self.assertAlmostEqual(a + b, c, delta=1e-5 * most)

    def test_plan_has_the_sizes_and_names_of_what_was_drawn(self):
        plan = json.loads(self.succeeds("plan", self.of_class / "two.glb", *SIZES, "--json").stdout)
        self.assertEqual([light["name"] for light in plan["lights"]], ["sun", "lamp"])
        self.assertEqual([(light["intensity"], light["unit"]) for light in plan["lights"]],
                         [(1000, "lx"), (700, "cd")])
        self.assertEqual(plan["lights"][1]["color"], LAMP["color"])
        written = {each["attachment"]: each for each in self.manifest["attachments"]}
        labels = {"sun": "0", "lamp": "1"}
        for each in plan["passes"]:
            for write in each["writes"]:
                name = re.sub(r"\[(\w+)\]", lambda m: f"[{labels.get(m[1], m[1])}]", write["name"])
                if name in written:
                    self.assertEqual((write["width"], write["height"], write["format"]),
                                     tuple(written[name][key] for key in ("width", "height", "format")), name)
        self.assertEqual(plan["scene"]["triangles"], len(glb.sphere()[1]) + 2)

    def test_probe_shows_the_texels_of_the_dump(self):
        for light, name in ((0, "sun"), (1, "lamp")):
            probe = json.loads(self.succeeds("probe", self.of_class / "two.glb", *SIZES, "--texel", "16,14",
                                             "--light", light, "--json").stdout)
            landing = self.texture(f"landing[{light}]")
            place = [landing[letter][(32 - 1 - 14) * 32 + 16] for letter in "RGB"]
            self.assertIn(json.dumps(place), json.dumps(probe), name)


if __name__ == "__main__":
    main()
