"""What inspect writes: a page that holds its recording, says what it leaves out, and bad input refused. The
page itself is driven in a browser by tests/inspect."""

import base64
import json
import pathlib
import re
import struct
import zlib

import glb
import pictures
from program import SMALL, ProgramTest, main


class Page:
    def __init__(self, text):
        self.text = text
        self.recording = json.loads(re.search(r'id="recording">(.*?)</script>', text, re.S)[1])
        self.blobs = re.findall(r'<script type="text/plain" id="blob-\d+">([^<]*)</script>', text)

    def array(self, array):
        kind = {"u8": "B", "u16": "H", "u32": "I", "f32": "f"}[array["type"]]
        size, count = struct.calcsize(kind), array["count"]
        planes = zlib.decompress(base64.b64decode(self.blobs[array["blob"]]))
        whole = b"".join(bytes(planes[k * count + i] for k in range(size)) for i in range(count))
        if array.get("channels"):
            whole = self.summed_up(struct.unpack(f"<{count}I", whole), array["channels"], array["beside"])
        return struct.unpack(f"<{count}{kind}", whole)

    @staticmethod
    def summed_up(coded, channels, beside):
        """Of words that lie channel after channel, each as the difference from the texel before it."""
        texels, words = len(coded) // channels, [0] * len(coded)
        for c in range(channels):
            word = first = 0
            for i in range(texels):
                folded = coded[c * texels + i]
                word += (folded >> 1) ^ -(folded & 1)
                if beside and c in (1, 2):
                    word += words[i * channels] - first
                    first = words[i * channels]
                word &= 0xFFFFFFFF
                words[i * channels + c] = word
        return struct.pack(f"<{len(words)}I", *words)


class Inspect(ProgramTest):
    def page(self, *arguments):
        self.succeeds("inspect", "ball.glb", *SMALL, "-o", "page.html", *arguments)
        return Page((self.folder / "page.html").read_text())

    def test_the_page_holds_the_rendered_values(self):
        page = self.page()
        run = page.recording["runs"][0]
        self.succeeds("ball.glb", *SMALL, "-o", "ball.exr", "--aov", "caustic")
        rendered = pictures.Exr((self.folder / "ball.exr").read_bytes())
        found = next(a for a in run["attachments"] if a["texture"] == "caustic")
        values = page.array(found["data"])
        self.assertTrue(found["data"]["beside"], "the channels of a grey light's caustic are alike")
        # The layer is 0 on casters, the pass's attachment is what lies behind them.
        for channel, name in enumerate(("caustic.R", "caustic.G", "caustic.B")):
            layer = rendered.values()[name]
            top_first = [values[4 * ((47 - y) * 64 + x) + channel] for y in range(48) for x in range(64)]
            self.assertTrue(any(value > 0 for value in layer))
            for a, b in zip(top_first, layer):
                self.assertTrue(a == b or b == 0.0)

    def test_shares_in_the_page_add_up_to_the_map(self):
        page = self.page("-D", "cascades=off")
        run = page.recording["runs"][0]
        light = run["lights"][0]
        of_map = light["maps"][0]
        flux = sum(page.array(run["attachments"][of_map["attachment"]]["data"]))
        given = sum(sum(sum(page.array(values)) for values in run["histories"][h]["values"].values())
                    for h in of_map["histories"])
        self.assertGreater(flux, 0.0)
        self.assertAlmostEqual(given, flux, delta=1e-5 * flux)

    def test_textures_bear_the_light_s_name_and_its_unit(self):
        run = self.page("-D", "reflections=yes").recording["runs"][0]
        of_map = [a for a in run["attachments"] if a["name"] == "caustic_map"]
        self.assertEqual({(a["texture"], a["label"]) for a in of_map},
                         {("caustic_map[0]", "caustic_map[sun]"),
                          ("caustic_map.cascade[0]", "caustic_map[sun].cascade")})
        self.assertEqual({a["channels"][0]["unit"] for a in of_map}, {"square metres"})
        labels = {a["label"] for a in run["attachments"]}
        self.assertIn("landing[sun reflected]", labels)
        self.assertIn("caster_position.camera", labels)

    def test_each_branch_of_a_light_bears_the_name_of_its_own_landings(self):
        run = self.page("-D", "reflections=yes").recording["runs"][0]
        labels = {a["id"]: a["label"] for a in run["attachments"]}
        for light in run["lights"]:
            names = [branch["name"] for branch in light["branches"]]
            self.assertEqual(names, ["", "reflected"])
            for branch in light["branches"]:
                self.assertTrue(branch["landing"])
                of_branch = f"[{light['name']} {branch['name']}".rstrip() + "]"
                for landing in branch["landing"]:
                    self.assertIn(of_branch, labels[landing])

    def test_a_light_without_a_name_keeps_its_number(self):
        unnamed = {"type": "point", "intensity": 1000}
        document, blob = glb.unpack(glb.scene(light=unnamed))
        del document["nodes"][2]["name"]
        (self.folder / "ball.glb").write_bytes(glb.pack(document, blob))
        run = self.page().recording["runs"][0]
        (label,) = {a["label"] for a in run["attachments"] if a["texture"] == "caustic_map[0]"}
        self.assertEqual([p["label"] for p in run["passes"] if p["name"] == "caustic_map"][0], label)
        of_map = next(a for a in run["attachments"] if a["label"] == label)
        self.assertEqual(of_map["channels"][0]["unit"], "steradians")

    def test_names_cannot_end_the_script(self):
        document, blob = glb.unpack(glb.scene())
        document["nodes"][0]["name"] = "</script><script>alert(1)</script>"
        (self.folder / "ball.glb").write_bytes(glb.pack(document, blob))
        self.assertNotIn("<script>alert", self.page().text)

    def test_what_does_not_fit_is_said_with_the_command_that_gives_it(self):
        page = self.page("-D", "shadow=1100", "-r", "1100x1100")
        left_out = page.recording["runs"][0]["left_out"]
        self.assertTrue(any("picture" in each and "caustics render --dump" in each for each in left_out),
                        left_out)

    def test_of_many_branches_the_map_that_they_come_to_is_kept(self):
        scene = pathlib.Path(__file__).resolve().parents[2] / "scenes/glass/drinking_glass.glb"
        self.succeeds("inspect", scene, "-r", "32x24", "--grid", "256", "--map", "32", "-D", "bounces=4",
                      "-o", "page.html")
        run = Page((self.folder / "page.html").read_text()).recording["runs"][0]
        maps = [each for each in run["attachments"] if each["texture"] == "caustic_map[0]"]
        left_out = [each for each in maps if each["data"] is None]
        self.assertIsNotNone(maps[-1]["data"])
        self.assertTrue(left_out)
        for each in left_out:
            self.assertIn("earlier branches of its light fill the page", each["left_out"])

    def test_sections_leave_out_a_mesh_of_too_many_triangles(self):
        document, blob = glb.unpack(glb.scene(caster=glb.sphere(rings=320, segments=340)))
        document["meshes"][0]["name"] = "ball"
        (self.folder / "fine.glb").write_bytes(glb.pack(document, blob))
        self.succeeds("inspect", "fine.glb", *SMALL, "-o", "page.html")
        run = Page((self.folder / "page.html").read_text()).recording["runs"][0]
        shown = [mesh["positions"] is not None for mesh in run["meshes"]]
        self.assertEqual(sorted(shown), [False, True], [mesh["name"] for mesh in run["meshes"]])
        left_out = run["meshes"][shown.index(False)]["name"]
        self.assertIn(f"mesh '{left_out}': sections do not show it, they hold 200000 triangles at most",
                      run["left_out"])

    def test_what_two_runs_have_alike_is_there_once(self):
        page = self.page("--against", "iterations=1")
        first, second = (run["attachments"] for run in page.recording["runs"])
        same = [one["name"] for one, other in zip(first, second) if one["data"] == other["data"]]
        self.assertIn("receiver_position", same)  # before the first iteration
        self.assertNotIn("landing", same)
        self.assertEqual(len(set(page.blobs)), len(page.blobs))

    def test_a_dump_beside_the_run(self):
        self.succeeds("ball.glb", *SMALL, "--iterations", "1", "--dump", "other", "--quiet")
        one, other = self.page("--against", "other").recording["runs"]
        hashes = {a["texture"]: a["sha256"] for a in one["attachments"]}
        same = {a["texture"]: a["sha256"] == hashes[a["texture"]] for a in other["attachments"]
                if a["texture"] in hashes}
        self.assertTrue(same["receiver_position[0]"])
        self.assertFalse(same["landing[0]"])

    def test_an_attachment_that_the_run_lacks_is_shown_with_what_its_file_tells(self):
        self.succeeds("ball.glb", *SMALL, "--dump", "other", "--quiet")
        manifest = json.loads((self.folder / "other/manifest.json").read_text())
        foreign = next(a for a in manifest["attachments"] if a["attachment"] == "landing[0]")
        size = foreign["width"], foreign["height"]
        foreign["pass"], foreign["attachment"] = "other_pass[moon]", "heat[0]"
        (self.folder / "other/manifest.json").write_text(json.dumps(manifest))
        run = self.page("--against", "other").recording["runs"][1]
        heat = next(a for a in run["attachments"] if a["texture"] == "heat[0]")
        self.assertEqual((heat["name"], heat["label"], heat["kind"], heat["meaning"], heat["codes"]),
                         ("heat[0]", "heat[0]", "scalar", "", None))
        self.assertEqual([(c["name"], c["meaning"], c["unit"]) for c in heat["channels"]],
                         [(name, "", "") for name in "RGBA"])
        self.assertEqual((heat["width"], heat["height"]), size)
        self.assertEqual(run["passes"][heat["pass"]]["label"], "other_pass[moon]")
        self.assertEqual(run["passes"][heat["pass"]]["writes"], [heat["id"]])
        self.assertEqual(len(set(a["id"] for a in run["attachments"])), len(run["attachments"]))
        self.assertEqual(run["device"], "a dump")
        self.assertEqual((run["histories"], run["lights"], run["meshes"]), ([], [], []))
        self.assertIsNotNone(heat["data"])

    def test_bad_input_is_refused(self):
        (self.folder / "empty").mkdir()
        self.fails(2, "inspect", "ball.glb", "-o", "page.txt", saying=".html")
        self.fails(2, "inspect", "ball.glb", *SMALL, "--against", "nothing", saying="iterations=1")
        self.fails(2, "inspect", "ball.glb", *SMALL, "--against", "iterations=0", saying="iterations")
        self.fails(3, "inspect", "ball.glb", *SMALL, "--against", "empty", saying="manifest.json")
        self.fails(3, "inspect", "missing.glb", saying="missing.glb")
        self.fails(4, "inspect", "ball.glb", "-o", "no/page.html", saying="no/page.html")


if __name__ == "__main__":
    main()
