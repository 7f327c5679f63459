"""caustics paper: rows made again, checked and reported."""

import json
import pathlib
import re
import shutil
import subprocess

import doc_figures
import glb
from program import PROGRAM, ProgramTest, main

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"


class Paper(ProgramTest):
    def with_scenes(self, scenes, *arguments):
        """A run of a copy of the program, beside which lie these sample scenes, {name: bytes}."""
        (self.folder / "scenes").mkdir()
        for name, data in scenes.items():
            (self.folder / "scenes" / name).write_bytes(data)
        program = shutil.copy(PROGRAM, self.folder / "caustics")
        return subprocess.run([program, "paper", "-o", "out", *arguments], cwd=self.folder, text=True,
                              capture_output=True, timeout=300)

    def test_a_row_is_made_checked_and_reported(self):
        result = self.succeeds("paper", "-o", "out", "--row", "21")
        self.assertIn("holds", result.stdout)
        rows = json.loads((self.folder / "out/paper.json").read_text())["rows"]
        self.assertEqual([(r["row"], r["holds"]) for r in rows], [("21", True)])
        # The command is one that a person can type.
        self.assertTrue(rows[0]["commands"][0].startswith("caustics render scenes/glass_sphere.glb"))
        self.assertTrue((self.folder / "out/paper_weights.png").exists())
        report = (self.folder / "out/paper.md").read_text()
        self.assertIn("| 21 |", report)
        self.assertIn("\n    " + rows[0]["commands"][0] + "\n", report)

    def test_rays_through_a_slab_land_where_the_page_says(self):
        self.succeeds("paper", "-o", "out", "--row", "3", "--row", "35")
        rows = json.loads((self.folder / "out/paper.json").read_text())["rows"]
        self.assertEqual([(r["row"], r["holds"]) for r in rows], [("3", True), ("35", True)])
        self.assertEqual(doc_figures.unprinted(doc_figures.PAGE.read_text(), rows), [])

    def test_pictures_layers_are_compared_as_compare_does(self):
        self.succeeds("paper", "-o", "out", "--row", "11")
        (row,) = json.loads((self.folder / "out/paper.json").read_text())["rows"]
        self.assertEqual((row["found"], row["holds"]), ("equal", True))
        files = ["out/row_of_frames.0003.exr", "out/alone.0003.exr", "out/row_of_frames.0002.exr"]
        same = self.succeeds("compare", *files[:2], "--layer", "caustic").stdout.splitlines()[-1]
        self.assertTrue(same.startswith("equal: "), same)
        self.assertEqual(self.run_program("compare", *files[1:], "--layer", "caustic").returncode, 1)

    def test_traced_light_is_told_with_its_own_statistics(self):
        self.need_ray_queries()
        # A plate above the ball keeps nearly all light from it, so that few rays take long.
        document, blob = glb.unpack(glb.scene(floors=((0, 0, 0), (2.6, 2, 0))))
        document["nodes"][3]["name"] = "floor"  # the camera
        result = self.with_scenes({"receivers.glb": glb.pack(document, blob)}, "--row", "29")
        self.assertIn(result.returncode, (0, 1), result.stderr)
        (row,) = json.loads((self.folder / "out/paper.json").read_text())["rows"]
        told = [float(share) for share in re.findall(r"([0-9.]+)%", row["found"])[:2]]
        for share, (name, account) in zip(told, (("default", "in_map"), ("traced", "landed"))):
            stats = json.loads((self.folder / f"out/receivers_{name}.json").read_text())
            flux = stats["lights"][0]["flux"]
            self.assertGreater(share, 0)
            self.assertAlmostEqual(share, 100 * sum(flux[account]) / sum(flux["entered"]), delta=0.11)
        self.assertEqual(row["holds"], result.returncode == 0)

    def test_a_figure_that_is_not_printed_is_named(self):
        page = "| 3 | rays | within 3e-7 m; 12 %, 1.20 |\n"
        found = {"row": "3", "thing": "", "expected": "", "found": "3.4e-7 m, 12.4 %, 1.23"}
        self.assertEqual(len(doc_figures.unprinted(page, [found])), 1)  # 1.23 is not 1.20

    def test_a_row_that_does_not_hold_is_the_answer_no(self):
        # A sample scene whose sphere is too small.
        document, blob = glb.unpack((SCENES / "glass_sphere.glb").read_bytes())
        for node in document["nodes"]:
            if node["name"] == "sphere":
                node["scale"] = [0.5, 0.5, 0.5]
        lamp = (SCENES / "glass_sphere_lamp.glb").read_bytes()
        small = glb.pack(document, blob)
        result = self.with_scenes({"glass_sphere.glb": small, "glass_sphere_lamp.glb": lamp}, "--row", "21")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("FAILS", result.stdout)
        self.assertIn("does not hold", (self.folder / "out/paper.md").read_text())

    def test_a_folder_of_somebody_elses_files_is_left_alone(self):
        own = self.folder / "own"
        own.mkdir()
        (own / "notes.txt").write_text("mine")
        self.fails(4, "paper", "-o", "own", "--row", "21",
                   saying="notes.txt: is not of an earlier report, which paper.json would show; ")
        # Nor does a file of the report's name make the folder a report's.
        (own / "notes.txt").rename(own / "paper.json")
        self.fails(4, "paper", "-o", "own", "--row", "21", saying="paper.json: is not of an earlier report")
        self.assertEqual([f.read_text() for f in own.iterdir()], ["mine"])
        (own / "paper.json").write_text('{"program": "caustics 0.0.1 (g++)"}')
        self.succeeds("paper", "-o", "own", "--row", "21")

    def test_an_unknown_row_is_refused_before_anything_is_made(self):
        self.fails(2, "paper", "-o", "out", "--row", "99", saying="there is no row '99'")
        self.assertFalse((self.folder / "out").exists())

    def test_a_row_is_called_by_its_name_or_one_of_its_numbers(self):
        for name, code in (("5, 31, 32", 4), ("31", 4), ("32", 4), ("31, 5", 2), ("3, 35", 2)):
            self.fails(code, "paper", "-o", "ball.glb/out", "--row", name)


if __name__ == "__main__":
    main()
