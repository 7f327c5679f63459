"""The files that a run reads and writes: no output replaces an input or another output, - is standard
output, and a dump's folder belongs to its manifest."""

import json
import os
import pty
import subprocess

import glb
from program import PROGRAM, SMALL, ProgramTest, main

TRACED = ["--batches", "2", "--rays", "8", "-r", "16x16", "-q"]


class Clashes(ProgramTest):
    def refused(self, *arguments, saying, **options):
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        self.fails(2, *arguments, saying=saying, **options)
        after = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        self.assertEqual(before, after)

    def test_the_scene_is_kept(self):
        os.link(self.folder / "ball.glb", self.folder / "hard.json")
        (self.folder / "soft.json").symlink_to("ball.glb")
        (self.folder / "below").mkdir()
        for name in ("ball.glb", "hard.json", "soft.json", "below/../ball.glb", self.folder / "ball.glb"):
            self.refused("ball.glb", *SMALL, "--stats", name, saying="--stats would replace the scene")
        self.refused("reference", "ball.glb", *TRACED, "--stats", "ball.glb",
                     saying="--stats would replace the scene")
        (self.folder / "page.html").write_bytes(glb.scene())
        self.refused("inspect", "page.html", *SMALL, "-o", "page.html", saying="-o would replace the scene")
        with open(self.folder / "ball.glb", "rb") as scene:
            self.refused("render", "-", *SMALL, "--stats", "ball.glb", stdin=scene,
                         saying="--stats would replace the scene")

    def test_what_the_scene_refers_to_is_kept_whether_it_is_used_or_not(self):
        document, data = glb.unpack(glb.scene())
        document["buffers"][0]["uri"] = "points%20here.bin"
        document["images"] = [{"uri": "picture.png"}, {"uri": "tables/other.exr"}]
        (self.folder / "scene.gltf").write_text(json.dumps(document))
        (self.folder / "points here.bin").write_bytes(data)
        (self.folder / "tables").mkdir()
        for name in ("picture.png", "tables/other.exr"):
            (self.folder / name).write_bytes(b"an image")
            self.refused("scene.gltf", *SMALL, "-o", name, saying="-o would replace a file of the scene")
        self.refused("scene.gltf", *SMALL, "--stats", "points here.bin",
                     saying="--stats would replace a file of the scene")
        self.succeeds("scene.gltf", *SMALL, "-o", "tables/picture.png")

    def test_the_environment_is_kept(self):
        self.succeeds("ball.glb", *SMALL, "-o", "sky.exr", "-o", "sky.hdr")
        for sky in ("sky.exr", "sky.hdr"):
            self.refused("ball.glb", *SMALL, "--environment", sky, "-o", sky,
                         saying="-o would replace the image of --environment")

    def test_two_outputs_are_two_files(self):
        self.refused("ball.glb", *SMALL, "-o", "a.png", "--stats", "a.png",
                     saying="--stats and -o would both")
        self.refused("reference", "ball.glb", *TRACED, "-o", "r.exr", "--stats", "r.exr",
                     saying="would both")
        self.refused("reference", "ball.glb", *TRACED, "-o", "r.exr", "--stats", "r.exr.state",
                     saying="would both")
        self.refused("ball.glb", *SMALL, "--dump", "d", "-o", "d/00_caster_map.position.exr",
                     saying="--dump and -o would both")
        self.refused("ball.glb", *SMALL, "--dump", "d", "--stats", "d/manifest.json", saying="would both")
        self.refused("ball.glb", *SMALL, "--dump", "a.png", "-o", "a.png", saying="would both")
        (self.folder / "d").mkdir()
        self.succeeds("ball.glb", *SMALL, "--dump", "d", "-o", "d/a.png")

    def test_so_are_the_frames_of_a_row(self):
        row = ["ball.glb", *SMALL, "--frames", "0..12"]
        self.refused(*row, "-o", "a.%d.png", "--stats", "a.11.png",
                     saying="a.11.png: --stats and -o would both")
        self.refused(*row, "-o", "a.%d.png", "-o", "a.%02d.png", saying="a.10.png: -o names it twice")

    def test_compare_keeps_what_it_compares(self):
        self.succeeds("ball.glb", *SMALL, "-o", "a_color.png", "-o", "b.png")
        self.refused("compare", "a_color.png", "b.png", "--diff", "a", saying="--diff would replace an image")

    def test_study_keeps_its_truth_and_its_mask(self):
        (self.folder / "study/img").mkdir(parents=True)
        self.succeeds("ball.glb", *SMALL, "-o", "study/img/mask.png")
        self.refused("study", "ball.glb", *SMALL, "--mask", "study/img/mask.png", "-o", "study",
                     saying="-o would replace the mask")


class StandardOutput(ProgramTest):
    def binary(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True,
                              timeout=300)

    def test_text_and_images_go_there(self):
        stats = self.binary("ball.glb", *SMALL, "-o", "a.png", "--stats", "-")
        self.assertEqual(json.loads(stats.stdout)["settings"]["grid"], 32)
        self.assertIn(b"a.png: 64x48", stats.stderr)
        picture = self.binary("ball.glb", *SMALL, "-o", "-")
        self.assertTrue(picture.stdout.startswith(b"\x89PNG") and picture.stdout.endswith(b"IEND\xaeB`\x82"))
        page = self.binary("inspect", "ball.glb", *SMALL, "-o", "-")
        self.assertTrue(page.stdout.startswith(b"<!DOCTYPE html>"), page.stderr)
        self.assertEqual(self.files(), ["a.png", "ball.glb"])

    def test_so_do_the_layers_of_the_reference(self):
        self.need_ray_queries()
        layers = self.binary("reference", "ball.glb", *TRACED, "-o", "-")
        self.assertTrue(layers.stdout.startswith(b"v/1\x01"), layers.stderr)
        self.assertEqual(self.files(), ["ball.glb"])
        self.fails(2, "reference", "ball.glb", *TRACED, "-o", "-", "--resume", saying="none beside -")

    def test_what_is_more_than_one_file_cannot(self):
        self.succeeds("ball.glb", *SMALL, "-o", "a.png")
        for arguments in (["ball.glb", "--dump", "-"], ["parity", "ball.glb", "--dump", "-"],
                          ["study", "ball.glb", "-o", "-"], ["paper", "-o", "-"],
                          ["compare", "a.png", "a.png", "--diff", "-"]):
            self.fails(2, *arguments, saying="cannot be -, standard output")
        self.fails(2, "ball.glb", *SMALL, "-o", "-", "--stats", "-", saying="standard output: ")
        self.fails(2, "ball.glb", *SMALL, "-o", "-", "-o", "-", saying="-o names it twice")
        self.fails(2, "ball.glb", *SMALL, "--frames", "0..1", "-o", "-", saying="written over by each frame")

    def test_a_terminal_is_shown_text_alone(self):
        for arguments, code in ((["-o", "-"], 2), (["-o", "a.png", "--stats", "-", "-q"], 0)):
            ours, its = pty.openpty()
            self.addCleanup(os.close, ours)
            result = subprocess.run([PROGRAM, "ball.glb", *SMALL, *arguments], cwd=self.folder, stdout=its,
                                    stderr=subprocess.PIPE, text=True, timeout=300)
            os.close(its)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertEqual("standard output is a terminal" in result.stderr, code == 2)


class Dumps(ProgramTest):
    def dump(self, *arguments):
        self.succeeds("ball.glb", *SMALL, "-o", "a.png", "--dump", "d", *arguments)
        return json.loads((self.folder / "d/manifest.json").read_text())

    def names(self):
        return {path.name for path in (self.folder / "d").iterdir()}

    def test_a_new_dump_takes_away_the_older_one(self):
        more = set(self.dump("--pictures")["files"])
        (self.folder / "d/notes.txt").write_text("mine")
        (self.folder / "d/photo.png").write_text("mine")
        fewer = self.dump("-D", "samples=1")["files"]
        self.assertLess(len(fewer), len(more))
        self.assertEqual(self.names(), set(fewer) | {"manifest.json", "notes.txt", "photo.png"})
        for name, size in fewer.items():
            self.assertEqual((self.folder / "d" / name).stat().st_size, size)

    def test_foreign_files_are_never_touched(self):
        (self.folder / "d").mkdir()
        (self.folder / "d/index.html").write_text("mine")
        self.fails(4, "ball.glb", *SMALL, "--dump", "d", "--pictures", saying="d/index.html: is not listed")
        self.dump()  # has no page, so the file is in nobody's way
        self.fails(4, "ball.glb", *SMALL, "--dump", "d", "--pictures", saying="d/index.html: is not listed")
        self.assertEqual((self.folder / "d/index.html").read_text(), "mine")
        (self.folder / "d/00_mine.texture.exr").write_text("mine")
        self.fails(4, "ball.glb", *SMALL, "--dump", "d", saying="d/00_mine.texture.exr: is not listed")

    def test_what_was_changed_since_is_foreign(self):
        file = self.folder / "d" / next(iter(self.dump()["files"]))
        file.write_text("mine")
        self.fails(4, "ball.glb", *SMALL, "--dump", "d", saying="was changed since")
        self.assertEqual(file.read_text(), "mine")

    def test_another_s_manifest_is_foreign(self):
        (self.folder / "d").mkdir()
        for text in ("no JSON", "{}", '{"attachments": []}', '{"files": {"../ball.glb": 1}, "x": 1'):
            (self.folder / "d/manifest.json").write_text(text)
            self.fails(4, "ball.glb", *SMALL, "--dump", "d", saying="is not the manifest of a dump")
        # No more than names in the folder that a dump may write.
        size = (self.folder / "ball.glb").stat().st_size
        (self.folder / "d/notes.txt").write_text("mine")
        (self.folder / "d/manifest.json").write_text(
            json.dumps({"files": {"../ball.glb": size, "notes.txt": 4}}))
        self.dump()
        self.assertTrue((self.folder / "ball.glb").exists() and (self.folder / "d/notes.txt").exists())

    def test_a_dump_that_fails_leaves_nothing(self):
        self.fails(4, "ball.glb", *SMALL, "--dump", "d", "-o", "nowhere/a.png", saying="nowhere")
        self.assertFalse((self.folder / "d").exists())


if __name__ == "__main__":
    main()
