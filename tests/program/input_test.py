"""Files that are no scenes: exit code 3, one line, and nothing written."""

import json
import os
import re
import subprocess

import glb
import pictures
from program import PROGRAM, SMALL, ProgramTest, main


class BadInput(ProgramTest):
    def refuses(self, name, content, saying=""):
        (self.folder / name).write_bytes(content)
        self.fails(3, name, *SMALL, saying=saying)
        self.fails(3, "plan", name, saying=name)

    def test_missing_file(self):
        self.fails(3, "nothing.glb", saying="nothing.glb")

    def test_folder(self):
        (self.folder / "folder.glb").mkdir()
        self.fails(3, "folder.glb")

    def test_folder_with_one_scene_names_it(self):
        (self.folder / "export").mkdir()
        (self.folder / "export/readme.txt").write_text("a vase")
        self.fails(3, "export", saying="a folder with no glTF file")
        (self.folder / "export/Scene.GLTF").write_text("{}")
        self.fails(3, "export", saying="name the glTF file in it: export/Scene.GLTF")
        (self.folder / "export/other.glb").write_text("")
        self.fails(3, "export", saying="a folder with several glTF files")

    def test_empty(self):
        self.refuses("empty.glb", b"")
        self.refuses("empty.gltf", b"")

    def test_truncated_everywhere(self):
        whole = glb.scene()
        for length in (4, 11, 12, 19, 40, len(whole) // 2, len(whole) - 1):
            self.refuses("cut.glb", whole[:length])

    def test_wrong_json(self):
        self.refuses("wrong.gltf", b"{")
        self.refuses("wrong.gltf", b"[]")
        self.refuses("wrong.gltf", b'{"asset": 7}')
        self.refuses("wrong.glb", glb.pack({"asset": {"version": "1.0"}}))

    def test_text_that_is_no_scene(self):
        self.refuses("text.glb", b"This is a letter, and not a scene at all.\n" * 40)

    def test_unknown_required_extension_is_named(self):
        document = {"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_texture_avif"],
                    "extensionsRequired": ["EXT_texture_avif"]}
        self.refuses("avif.gltf", json.dumps(document).encode(), "EXT_texture_avif")

    def test_environment(self):
        self.fails(3, "ball.glb", "--environment", "missing.hdr", saying="missing.hdr")
        (self.folder / "bad.hdr").write_bytes(b"no picture")
        self.fails(3, "ball.glb", "--environment", "bad.hdr", saying="bad.hdr")


class OtherFormats(ProgramTest):
    """Told by what is in them, or else by the name: a line with what it is and how to get a glTF file."""

    def says(self, name, content, what, advice):
        (self.folder / name).write_bytes(content)
        line = self.fails(3, name, saying=f"{name}: this is {what}; caustics reads glTF 2.0 (.glb, .gltf): ")
        self.assertIn(advice, line)

    def test_models_of_other_programs(self):
        export = "File > Export > glTF 2.0"
        for what, content in (
                ("a Wavefront OBJ file", b"# by hand\n\nmtllib a.mtl\nv 0 0 0\n"),
                ("a Wavefront OBJ file", b"v 0 0 0\n"), ("a PLY file", b"ply\nformat ascii 1.0\n"),
                ("an STL file", b"solid cube\n"), ("an FBX file", b"Kaydara FBX Binary  \0\x1a\0"),
                ("an FBX file", b"; FBX 7.3.0 project file\n"), ("a USD file", b"PXR-USDC\0\0"),
                ("a USD file", b"#usda 1.0\n"), ("a Blender file", b"BLENDER-v303"),
                ("a COLLADA file", b'<?xml version="1.0"?>\n<COLLADA version="1.4.1">')):
            self.says("model.glb", content, what, export)
        for what, extension in (("a Wavefront OBJ file", "obj"), ("a PLY file", "ply"),
                                ("an STL file", "STL"), ("an FBX file", "fbx"), ("a USD file", "usd"),
                                ("a Blender file", "blend"), ("a 3D Studio file", "3ds"),
                                ("a COLLADA file", "dae")):
            self.says("model." + extension, b"\x01\x02 of no known kind", what, export)
        self.says("model.usdz", b"PK\3\4", "a USD file", export)

    def test_archives_and_pictures(self):
        self.says("model.bin", b"PK\3\4", "a zip archive", "unpack it")
        for what, content in (("a PNG picture", b"\x89PNG\r\n"), ("a JPEG picture", b"\xff\xd8\xff\xe0"),
                              ("a TIFF picture", b"II*\0")):
            self.says("model.gltf", content, what, "name the scene")
        for what, content in (("a Radiance HDR picture", b"#?RADIANCE\n"),
                              ("an OpenEXR picture", b"\x76\x2f\x31\x01")):
            self.says("sky.glb", content, what, "--environment")

    def test_a_scene_is_a_scene_whatever_its_name(self):
        (self.folder / "ball.obj").write_bytes(glb.scene())
        self.succeeds("plan", "ball.obj")
        document = json.dumps({"asset": {"version": "1.0"}}).encode()
        for name in ("old.fbx", "old.zip"):
            (self.folder / name).write_bytes(b"\n " + document)
            self.fails(3, name, saying="only glTF 2.0 can be read")


class StandardInput(ProgramTest):
    def from_input(self, content, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, input=content,
                              capture_output=True, timeout=300)

    def test_draws_what_the_file_draws(self):
        self.succeeds("ball.glb", *SMALL)
        result = self.from_input(glb.scene(), "-", *SMALL)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.folder / "stdin.png").read_bytes(), (self.folder / "ball.png").read_bytes())

    def test_is_read_once_for_many_frames(self):
        result = self.from_input(glb.scene(), "-", *SMALL, "--time-budget", "1000", "-o", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(result.stdout.startswith(b"\x89PNG"))

    def test_cannot_refer_to_other_files(self):
        document, blob = glb.unpack(glb.scene())
        document["buffers"][0]["uri"] = "ball.bin"
        (self.folder / "ball.bin").write_bytes(blob)
        result = self.from_input(json.dumps(document).encode(), "-")
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"standard input: buffers[0].uri: refers to another file", result.stderr)

    def test_that_is_no_scene(self):
        for content, saying in ((b"", b"is empty"), (b"hello", b"is not a glTF file"),
                                (b"ply\n", b"a PLY file")):
            result = self.from_input(content, "-")
            self.assertEqual((result.returncode, result.stderr.count(b"\n")), (3, 1), result.stderr)
            self.assertIn(b"caustics: standard input: ", result.stderr)
            self.assertIn(saying, result.stderr)

    def test_that_is_a_terminal_is_refused(self):
        leader, follower = os.openpty()
        result = self.run_program("-", stdin=follower)
        os.close(leader)
        os.close(follower)
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)
        self.assertIn("terminal", result.stderr)


class Names(ProgramTest):
    """What a terminal or a page is spared: C0, DEL, C1, and marks of the direction of writing."""

    NAME = "a\x1b[31m\x9b31m\u202eb\u2066\u2028c\x7f\r\nFAKE: line"
    SHOWN = "a\\x1b[31m\\u009b31m\\u202eb\\u2066\\u2028c\\x7f\\x0d\\x0aFAKE: line"
    SPARED = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]")

    def setUp(self):
        super().setUp()
        document, data = glb.unpack(glb.scene())
        for kind in ("nodes", "materials", "cameras", "meshes"):
            for each in document[kind]:
                each["name"] = self.NAME
        document["extensions"]["KHR_lights_punctual"]["lights"][0]["name"] = self.NAME
        document["asset"]["generator"] = self.NAME
        (self.folder / "named\x9b\u202e.glb").write_bytes(glb.pack(document, data))

    def test_are_shown_as_escapes_by_every_command(self):
        scene = "named\x9b\u202e.glb"
        shown = ""
        for command in (["plan", scene], ["plan", scene, "--json"], ["render", scene, *SMALL, "-v"],
                        ["probe", scene, *SMALL, "--texel", "9,9", "--pixel", "30,20"],
                        ["probe", scene, *SMALL, "--texel", "9,9", "--json"],
                        ["digest", scene, *SMALL], ["bench", scene, *SMALL, "--frames", "1"],
                        ["render", scene, *SMALL, "--dump", "d", "--pictures", "--stats", "-"],
                        ["inspect", scene, *SMALL, "-o", "-"]):
            result = self.succeeds(*command)
            self.assertEqual(self.SPARED.findall(result.stdout.replace("\n", "")), [], command)
            self.assertEqual(self.SPARED.findall(result.stderr), [], command)
            shown += result.stdout
            if "--json" in command:
                json.loads(result.stdout)
                self.assertIn(json.dumps(self.SHOWN)[1:-1], result.stdout)
        self.assertIn(self.SHOWN, shown)
        page = (self.folder / "d/index.html").read_text()
        self.assertEqual(self.SPARED.findall(page), [])
        self.assertIn("FAKE", page)
        json.loads((self.folder / "d/manifest.json").read_text())

    def test_are_whole_in_json_whatever_stands_beside_a_character_that_is_spared(self):
        beside = ["", "", '"', "\\", "n", "\u00e9", "\u20ac", "\U0001f701", "~", ""]
        names = ["".join(spared.join(beside) for spared in half)
                 for half in (("\x01", "\x1f", "\x80", "\x7f"), ("\x9f", "\u202e", "\ufeff", "\x7f"))]
        for name in names:
            (self.folder / name).write_bytes(pictures.png([(1, 2, 3)], 1, 1))
        said = self.succeeds("compare", *names, "--json").stdout
        self.assertEqual(self.SPARED.findall(said), [])
        told = json.loads(said)
        self.assertEqual([told["a"], told["b"]], names)

    def test_in_images_and_manifests_too(self):
        self.succeeds("ball.glb", *SMALL, "-o", "a.png", "--dump", "d")
        for name in ("d", "e"):
            (self.folder / name).mkdir(exist_ok=True)
            file = next(self.folder.glob("d/*.exr"))
            (self.folder / name / "x.exr").write_bytes(file.read_bytes())
            (self.folder / name / "manifest.json").write_text(json.dumps({"attachments": [
                {"pass": self.NAME, "attachment": name + self.NAME, "file": "x.exr"}]}))
        for more in ([], ["--json"]):
            result = self.run_program("compare", "d", "e", *more)
            self.assertEqual(result.returncode, 1)
            self.assertEqual(self.SPARED.findall(result.stdout), [])
            self.assertIn("FAKE", result.stdout)
            if more:
                for attachment in json.loads(result.stdout)["attachments"]:
                    self.assertIn(self.NAME, attachment["attachment"])


class Reasons(ProgramTest):
    """Why there is no caustic: said by plan, and by render's closing lines."""

    def expectation(self, material=None, light=None, options=()):
        (self.folder / "case.glb").write_bytes(glb.scene(material, light))
        document = json.loads(self.succeeds("plan", "case.glb", "--json", *options).stdout)
        self.assertEqual(len(document["expectations"]), 1)
        return document["expectations"][0]

    def test_solid_glass(self):
        self.assertTrue(self.expectation()["expected"])

    def test_thin_glass(self):
        thin = self.expectation(glb.glass())
        self.assertFalse(thin["expected"])
        self.assertIn("thin wall", thin["reason"])
        self.assertIn("--assume-solid", thin["reason"])
        self.assertTrue(self.expectation(glb.glass(), options=["--assume-solid"])["expected"])

    def test_rough_glass_throws_a_caustic_too(self):
        rough = glb.glass(thicknessFactor=1)
        rough["pbrMetallicRoughness"]["roughnessFactor"] = 0.4
        self.assertTrue(self.expectation(rough)["expected"])

    def test_ior_that_never_refracts(self):
        solid = glb.glass(thicknessFactor=1)
        solid["extensions"]["KHR_materials_ior"]["ior"] = 0
        self.assertIn("never refracts", self.expectation(solid)["reason"])

    def test_mirror(self):
        mirror = {"name": "steel",
                  "pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.05}}
        self.assertIn("mirrored onto what stands around", self.expectation(mirror)["reason"])

    def test_light_without_intensity(self):
        dark = self.expectation(light={"type": "directional", "intensity": 0})
        self.assertFalse(dark["expected"])

    def test_narrow_spot_that_looks_elsewhere(self):
        spot = {"type": "spot", "intensity": 100, "spot": {"outerConeAngle": 0.5}}
        self.assertTrue(self.expectation(light=spot)["expected"])

    def first_lines(self, *options):
        """From "added:" on; progress may come before."""
        lines = self.succeeds("ball.glb", *SMALL, *options).stderr.splitlines()
        first = next(i for i, line in enumerate(lines) if line.startswith("added: "))
        return lines[first:first + 3]

    def test_three_lines_come_first(self):
        added, caustic, error = self.first_lines()
        self.assertEqual(added, "added: the light of a studio")
        # The ball stands in the middle, 1 m above its caustic.
        self.assertRegex(caustic, r"^caustic: [78]\d.\d% of the light onto 'ball' makes one; brightest "
                                  r"in the middle of the picture \(x 3[0-4], y \d+\), [1-9.]+ times as")
        self.assertRegex(error, r"^error: estimated \d+.\d%, most of it by ")

    def test_a_caustic_outside_the_picture_is_told_with_what_to_do(self):
        caustic = self.first_lines("--zoom", "60")[1]
        self.assertIn("but the picture does not show it: --view 37,34", caustic)

    def test_a_preview_is_small_and_estimates_no_error_and_other_options_override_it(self):
        said = self.succeeds("ball.glb", "-r", "64x48", "--preview").stderr
        self.assertIn("caustic: 'ball' makes one; brightest", said)
        self.assertIn("error: not estimated", said)
        self.assertIn("64x48, grid 192, map 256", said)

    def test_where_there_is_none_the_second_line_says_why(self):
        (self.folder / "ball.glb").write_bytes(glb.scene(glb.glass()))
        self.assertRegex(self.first_lines()[1], r"^caustic: none; 'ball': thin wall .*--assume-solid")


if __name__ == "__main__":
    main()
