"""render --dump: what a pass was fed with is enough to compute what it wrote, and --pictures show it."""

import json
import math
import pathlib
import sys

import pictures
from program import SMALL, ProgramTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/images"))

from make import read_png  # noqa: E402: found by the line above

SIZES = {"int": 1, "float": 1, "vec2": 2, "vec3": 3, "vec4": 4, "mat4": 16}


class DumpTest(ProgramTest):
    def dump(self, *options):
        self.succeeds("ball.glb", *SMALL, "--quiet", "--dump", "d", *options)
        self.manifest = json.loads((self.folder / "d/manifest.json").read_text())

    def one_pass(self, label):
        return next(each for each in self.manifest["passes"] if each["pass"] == label)

    def attachment(self, name, of=""):
        return next(each for each in self.manifest["attachments"]
                    if each["attachment"] == name and each["pass"].startswith(of))

    def texels(self, file):
        """{channel: values}, rows from the top."""
        return pictures.Exr((self.folder / "d" / file).read_bytes()).values()


class Inputs(DumpTest):
    def test_every_pass_has_its_state_its_inputs_and_its_draws(self):
        self.dump()
        labels = [each["pass"] for each in self.manifest["passes"]]
        self.assertEqual(labels, list(dict.fromkeys(a["pass"] for a in self.manifest["attachments"])))
        written = {}
        for each in self.manifest["passes"]:
            for read in each["reads"]:
                if read.get("of_material"):
                    continue
                if read["texture"] in written:  # as it is before this pass
                    self.assertEqual(read["file"], written[read["texture"]])
                elif read["texture"] is not None:
                    self.assertIn(read["file"], [table["file"] for table in self.manifest["tables"]])
            self.assertEqual(len(each["writes"]) > 0, True)
            for attachment in self.manifest["attachments"]:
                if attachment["pass"] == each["pass"]:
                    written[attachment["attachment"]] = attachment["file"]
        state = self.one_pass("caster_map[sun]")["state"]
        self.assertEqual(state["topology"], "triangles")
        self.assertEqual((state["depth_compare"], state["depth_write"]), ("less", True))
        drawn = [(draw["mesh"], draw["material"]) for draw in self.one_pass("caster_map[sun]")["draws"]]
        self.assertEqual(drawn, [("ball", "glass")])
        self.assertEqual(self.one_pass("caustic_map[sun]")["draws"][0]["vertices"], 32 * 32)
        self.assertEqual(self.one_pass("caustic_map[sun]")["writes"][0]["blend"],
                         {"equation": "add", "source": "one", "destination": "one"})

    def test_uniforms_have_the_names_of_the_shader_and_the_values_of_the_settings(self):
        self.dump("-D", "iterations=7")
        landing = self.one_pass("landing[sun]")
        declared = {each["name"]: each for each in landing["uniforms"]}
        values = landing["draws"][0]["uniforms"]
        self.assertEqual(list(declared), list(values))
        self.assertEqual((values["grid_side"], values["iterations"]), (32, 7))
        self.assertEqual(values["estimator"], 1)  # ESTIMATOR_SECANT
        self.assertEqual(values["caster.kind"], 0)  # VIEW_PARALLEL
        self.assertEqual([round(v, 6) for v in values["light"]], [0, -1, 0])
        self.assertEqual(declared["caster.from_scene"]["offset"], 0)
        self.assertEqual(declared["caster.scale"], {
            "name": "caster.scale", "type": "vec2", "offset": 64,
            "meaning": "the light's view of the casters: its grid"})
        end = 0
        for name, each in declared.items():
            self.assertGreaterEqual(each["offset"], end)
            end = each["offset"] + 4 * SIZES[each["type"]]
            value = values[name]
            self.assertEqual(len(value) if isinstance(value, list) else 1, SIZES[each["type"]])

    def test_tables_are_what_passes_read(self):
        self.dump()
        table = next(each for each in self.manifest["tables"] if each["name"] == "caster_materials")
        self.assertEqual((table["width"], table["height"]), (4, 2))
        texels = self.texels(table["file"])
        self.assertEqual(texels["R"][4], 1.5)  # the glass; the floor has a row before it: index of refraction
        self.assertEqual(texels["A"][4:], [0, 1, 0, 0])  # no mirror, two interfaces

    def test_a_pass_computed_from_its_inputs_gives_its_output(self):
        self.dump()
        tone_map = self.one_pass("tone_map")
        uniforms = tone_map["draws"][0]["uniforms"]
        names = ("exposure", "contrast", "contrast_in_dark")
        exposure, contrast, in_dark = (uniforms[name] for name in names)
        radiance = self.texels(tone_map["reads"][0]["file"])
        picture = self.texels(self.attachment("picture")["file"])
        checked = 0
        for red, green, blue, shown in zip(*(radiance[c] for c in "RGB"), picture["G"]):
            exposed = [exposure * value for value in (red, green, blue)]
            brightness = max(exposed) / 0.31
            power = (contrast if brightness >= 1 else in_dark) - 1
            exposed = [value * brightness**power for value in exposed]
            # The tone curve below its shoulder: all channels less the least one's toe.
            toe = min(exposed)
            offset = toe - 6.25 * toe * toe if toe < 0.08 else 0.04
            if max(exposed) - offset > 0.75:
                continue
            value = exposed[1] - offset
            encoded = 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
            self.assertAlmostEqual(shown, encoded, delta=0.51 / 255)
            checked += 1
        self.assertGreater(checked, 64 * 48 / 4)

    def test_kinds_follow_from_what_is_said_of_a_texel(self):
        self.dump()
        kinds = {each["attachment"].split("[")[0]: each["kind"] for each in self.manifest["attachments"]}
        expected = {"caster_position": "position", "caster_normal": "normal", "caster_depth": "depth",
                    "receiver_position": "position", "cell_far": "position", "landing": "position",
                    "landing_flux": "flux", "caustic_map": "flux", "cell_near": "position",
                    "view_normal": "normal", "view_albedo": "color", "direct": "radiance",
                    "caustic": "radiance", "beauty": "radiance", "picture": "display"}
        self.assertEqual({name: kinds.get(name) for name in expected}, expected)


class Pictures(DumpTest):
    def shown(self, file):
        rows = read_png((self.folder / "d" / file).read_bytes())
        return [tuple(row[i:i + 3]) for row in rows for i in range(0, len(row), 3)]

    def test_every_attachment_has_a_picture_and_a_caption(self):
        self.dump("--pictures")
        files = {"manifest.json", "index.html", "contact_sheet.png"}
        files |= {table["file"] for table in self.manifest["tables"]}
        page = (self.folder / "d/index.html").read_text()
        for attachment in self.manifest["attachments"]:
            files.add(attachment["file"])
            self.assertGreater(len(attachment["pictures"]), 0)
            for picture in attachment["pictures"]:
                files.add(picture["file"])
                self.assertEqual(len(self.shown(picture["file"])), attachment["width"] * attachment["height"])
                self.assertNotIn("\n", picture["caption"])
                self.assertNotIn("NaN", picture["caption"])
                self.assertIn(f'src="{picture["file"]}"', page)
        self.assertEqual(files, {path.name for path in (self.folder / "d").iterdir()})
        # Without pictures nothing says that there are some.
        self.dump()
        self.assertFalse((self.folder / "d/index.html").exists())

    def test_statuses_are_counted_and_coloured(self):
        self.dump("--pictures", "--stats", "s.json")
        counts = json.loads((self.folder / "s.json").read_text())["lights"][0]["vertices"]
        first, status = self.attachment("landing[0]", "landing[sun]")["pictures"]
        self.assertIn("position: red is x ", first["caption"])
        self.assertIn(f"landed {counts['landed']} (green)", status["caption"])
        self.assertEqual(self.shown(status["file"]).count((0, 158, 115)), counts["landed"])

    def test_flux_is_logarithmic_and_normals_are_about_the_middle(self):
        self.dump("--pictures")
        flux = self.attachment("caustic_map[0]", "caustic_map[sun]")
        values = self.texels(flux["file"])
        largest = [max(texel) for texel in zip(*(values[c] for c in values if c != "A"))]
        shown = self.shown(flux["pictures"][0]["file"])
        self.assertEqual(shown[largest.index(max(largest))], (255, 255, 255))
        self.assertEqual({shown[i] for i, value in enumerate(largest) if value == 0}, {(0, 0, 0)})
        normal = self.attachment("view_normal")
        values, shown = self.texels(normal["file"]), self.shown(normal["pictures"][0]["file"])
        for i, y in enumerate(values["G"]):
            if values["A"][i] > 0:
                self.assertAlmostEqual(shown[i][1] / 255, 0.5 + 0.5 * y, delta=0.51 / 255)

    def test_what_is_not_finite_is_striking(self):
        # The largest values that a Radiance file can hold: their sum over the sky overflows.
        (self.folder / "bright.hdr").write_bytes(
            b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" + b"\xff\xff\xff\xff" * 128)
        result = self.run_program("ball.glb", *SMALL, "--environment", "bright.hdr", "--quiet", "--dump", "d",
                                  "--pictures")
        self.assertEqual(result.returncode, 7, result.stderr)
        self.manifest = json.loads((self.folder / "d/manifest.json").read_text())
        beauty = self.attachment("beauty")
        values = self.texels(beauty["file"])
        broken = [not all(map(math.isfinite, texel)) for texel in zip(*(values[c] for c in "RGBA"))]
        self.assertGreater(sum(broken), 100)
        caption = beauty["pictures"][0]["caption"]
        self.assertTrue(caption.endswith(f"; {sum(broken):,} texels are NaN or infinite (magenta)"), caption)
        shown = self.shown(beauty["pictures"][0]["file"])
        self.assertEqual([texel == (255, 0, 255) for texel in shown], broken)

    def test_pictures_need_a_dump(self):
        self.fails(2, "ball.glb", "--pictures", saying="--dump DIR")

    def test_a_picture_that_cannot_be_written(self):
        (self.folder / "d/contact_sheet.png/in").mkdir(parents=True)
        self.fails(4, "ball.glb", *SMALL, "--quiet", "--dump", "d", "--pictures", saying="contact_sheet.png")


if __name__ == "__main__":
    main()
