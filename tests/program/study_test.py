"""caustics study: its rows, files and refusals, going on after an interruption, and a truth of one's own."""

import base64
import csv
import json
import re
import signal
import subprocess
import time
import xml.etree.ElementTree as xml

import glb
from pictures import exr, png
from program import PROGRAM, ProgramTest, main

SMALL = ["-r", "64x48", "--repeat", "1", "-D", "shadow=64", "-D", "further.share=1"]
GRIDS = ["--vary", "grid=16,32", "--grid", "32", "--map", "32"]
FIGURES = ["relative_l1", "rmse", "relative_mse_1", "relative_mse_4", "relative_mse_16", "flux_ratio",
           "flip_mean"]
XHTML = "{http://www.w3.org/2000/svg}"


class StudyTest(ProgramTest):
    def study(self, *arguments):
        return self.succeeds("study", "ball.glb", *SMALL, *arguments)

    def document(self, folder="study"):
        return json.loads((self.folder / folder / "study.json").read_text())

    def rows(self, folder="study"):
        return self.document(folder)["rows"]

    def table(self, folder="study"):
        return list(csv.DictReader((self.folder / folder / "study.csv").read_text().splitlines()))

    def page(self, folder="study"):
        # Well-formed as XML too, so that any parser can read it.
        text = (self.folder / folder / "report.html").read_text()
        return xml.fromstring(text.replace("<!DOCTYPE html>", "")), text


class Rows(StudyTest):
    def test_every_row_is_in_every_output(self):
        result = self.study(*GRIDS, "--vary", "splat=cell,point", "-o", "out")
        document, rows, table = self.document("out"), self.rows("out"), self.table("out")
        self.assertEqual([r["values"] for r in rows],
                         [{"grid": "32", "splat": "cell"}, {"grid": "16", "splat": "cell"},
                          {"grid": "32", "splat": "point"}])
        self.assertEqual([(r["grid"], r["splat"]) for r in table],
                         [("32", "cell"), ("16", "cell"), ("32", "point")])
        clocks = [f"ms_{what}{which}" for what in ("frame", "caustic") for which in ("", "_least", "_most")]
        self.assertEqual(list(table[0]), ["group", "backend", "grid", "splat", *FIGURES, *clocks,
                                          "texture_bytes", "pareto", "reference_limited", "picture",
                                          "problem"])
        self.assertEqual(document["planned"], 3)
        for row, line in zip(rows, table):
            self.assertEqual(row["settings"]["grid"], int(row["values"]["grid"]))
            for figure in FIGURES:
                self.assertEqual(float(line[figure]), row["figures"][figure])
            self.assertGreater(row["figures"]["relative_l1"], 0)
            times = row["milliseconds"]
            self.assertGreater(times["caustic"]["median"], 0)
            self.assertLess(times["caustic"]["median"], times["frame"]["median"])
            self.assertTrue((self.folder / "out" / row["picture"]).exists())
            # One frame: its passes are its time.
            self.assertAlmostEqual(sum(p["milliseconds"] for p in row["passes"]), times["frame"]["median"],
                                   places=6)
            made = {p["pass"] for p in row["passes"] if p["caustic"]}
            self.assertTrue({"caster_map", "receiver_map", "landing"} <= made)
            self.assertFalse({"light_shading", "view_surfaces", "tone_map", "first_hit"} & made)
        self.assertEqual([d["backend"] for d in document["drift"]], ["software"])
        self.assertEqual(document["drift"][0]["before"], rows[0]["milliseconds"]["caustic"]["median"])
        self.assertIn("The machine's drift (software): base, timed again at the end, took ", result.stdout)
        self.assertEqual(len(document["sentences"]), 2)
        for sentence in document["sentences"]:
            self.assertIn(sentence, result.stdout)
        self.assertIn("grid from 16 to 32: error ", result.stdout)
        self.assertIn("splat from cell to point: error ", result.stdout)

    def test_the_page_stands_alone(self):
        self.study(*GRIDS)
        page, text = self.page()
        drawing = page.find(f".//{XHTML}svg")
        # a point and the legend's
        self.assertEqual(len(drawing.findall(f".//{XHTML}path[@class='mark g0']")), 2)
        self.assertIn("grid 16", "".join(drawing.itertext()))
        self.assertIsNone(page.find(".//script"))
        self.assertNotIn("http://", text.replace("http://www.w3.org/2000/svg", ""))
        self.assertNotIn("https://", text)
        images = page.findall(".//img")
        self.assertEqual(len(images), 3)  # the truth, and two rows
        files = ["img/truth.png"] + [r["picture"] for r in self.rows()]
        for image, file in zip(images, files):
            kind, data = image.get("src").split(",")
            self.assertEqual(kind, "data:image/png;base64")
            self.assertEqual(base64.b64decode(data), (self.folder / "study" / file).read_bytes())
            self.assertTrue(image.get("alt"))
        self.assertEqual(sorted(p.name for p in (self.folder / "study").iterdir()),
                         ["error_time.svg", "img", "report.html", "study.csv", "study.json"])

    def test_what_is_left_is_told_from_the_time_that_the_rows_before_took(self):
        grids = [64, 16, 128]
        code, lines = self.on_terminal("study", "ball.glb", *SMALL[2:], "-r", "16x16", "--map", "16",
                                       "--cross", "--vary", "grid=" + ",".join(map(str, grids)),
                                       stdout=subprocess.DEVNULL)
        self.assertEqual(code, 0, lines)
        duration = r"([\d.]+ [mu]?s)"
        seconds = lambda text: float(text.split()[0]) * {"us": 1e-6, "ms": 1e-3, "s": 1}[text.split()[1]]
        text = "\n".join(lines)
        shown = lambda head, step: seconds(re.search(f"(?m)^{head}.*: {step}  {duration}$", text)[1])
        works = [grid * grid + 16 * 16 + 16 * 16 for grid in grids]  # grid, map, picture
        for number in range(1, 4):
            told, = set(re.findall(f"(?m)^row {number} of 3(.*): grid {grids[number - 1]} ", text))
            if number == 1:
                self.assertEqual(told, "")
                continue
            left = seconds(re.fullmatch(f", {duration} left", told)[1])
            took = left * sum(works[:number - 1]) / sum(works[number - 1:])
            # The rows before began between these two steps, and ended between those.
            least = shown(f"row {number - 1} of 3", "measuring") - shown("row 1 of 3", "finding where .*")
            most = shown(f"row {number} of 3", "warming up") - shown("the truth", "rendering")
            self.assertTrue(0.99 * least - 0.01 <= took <= 1.01 * most + 0.01, (number, least, took, most))

    def test_one_key_at_a_time_and_the_product_of_grid_and_map(self):
        base = ["--grid", "32", "--map", "32", "--vary", "grid=16,32", "--vary", "map=16,32"]
        self.study(*base)
        self.assertEqual([r["group"] for r in self.rows()], ["base", "grid", "map", "grid, map"])
        self.study("--grid", "32", "--map", "32", "--vary", "iterations=1,2", "--vary",
                   "estimator=paper,newton", "--cross")
        self.assertEqual([tuple(r["values"].values()) for r in self.rows()],
                         [("1", "paper"), ("1", "newton"), ("2", "paper"), ("2", "newton")])

    def test_the_finest_setting_is_said_to_be_the_programs_own_limit(self):
        result = self.study(*GRIDS)
        document, (page, text) = self.document(), self.page()
        self.assertFalse(document["independent_truth"])
        self.assertEqual(document["identity"]["truth"]["finest"]["grid"], 64)
        self.assertEqual(document["identity"]["truth"]["finest"]["map"], 64)
        for where in (result.stdout, document["truth"], text):
            self.assertIn("not an independent truth", where)

    def test_a_settings_figures_are_those_of_compare(self):
        options = ["-r", "64x48", "-D", "shadow=64", "-D", "further.share=1", "--map", "32"]
        self.succeeds("render", "ball.glb", *options, "--grid", "64", "-o", "truth.exr", "--aov", "caustic")
        self.succeeds("render", "ball.glb", *options, "--grid", "16", "-o", "a.exr", "--aov", "caustic")
        right = [(255 * (i % 64 > 20),) * 3 for i in range(64 * 48)]
        (self.folder / "mask.png").write_bytes(png(right, 64, 48))
        self.study("--map", "32", "--vary", "grid=16", "--grid", "64", "--truth", "truth.exr", "--mask",
                   "mask.png")
        compared = self.run_program("compare", "a.exr", "truth.exr", "--mask", "mask.png", "--flip", "--json")
        layer = json.loads(compared.stdout)["layers"][0]
        figures = self.rows()[1]["figures"]
        metrics = layer["metrics"] | {"flip_mean": layer["flip"]["mean"]}
        self.assertEqual(figures, {name: metrics[name] for name in FIGURES})
        self.assertGreater(figures["relative_l1"], 0)
        # The base is the truth itself.
        self.assertEqual(self.rows()[0]["figures"]["relative_l1"], 0)
        self.assertTrue(self.document()["independent_truth"])

    def test_every_setting_is_in_a_row_so_that_resume_knows_it_again(self):
        text = self.succeeds("study", "--help-markdown").stdout
        keys = re.findall(r"^\| `(\S+)` \|", text[text.index("| Settings for -D |"):], re.MULTILINE)
        self.assertIn("shadow", keys)
        self.study(*GRIDS)
        self.assertEqual([k for k in keys if k not in self.rows()[0]["settings"]], [])


class Effects(StudyTest):
    def test_each_effect_that_the_scene_calls_for_is_left_out_once(self):
        self.study("--effects", "--grid", "32", "--map", "32", "-o", "out")
        document, (_, page) = self.document("out"), self.page("out")
        effects = {e["effect"]: e for e in document["effects"]}
        self.assertLessEqual({"fresnel", "second surface", "cells", "pixel means"}, set(effects))
        self.assertFalse({"absorption", "dispersion", "medium", "normal maps"} & set(effects))
        self.assertEqual(document["planned"], 1 + len(effects))
        for name, effect in effects.items():
            row = next(r for r in document["rows"] if r["values"] == {"without": name})
            self.assertEqual(effect["error_without"], row["figures"]["relative_l1"])
            self.assertEqual(effect["error_with"], document["rows"][0]["figures"]["relative_l1"])
            self.assertIn(f"<td class=\"left\">{name}</td>", page)
        # Through one surface the ball's light lands elsewhere; without Fresnel's losses there is more of it:
        # a ball of index 1.5 mirrors 16 % (docs/accuracy.md).
        self.assertGreater(effects["second surface"]["error_without"], 0.5)
        flux = {r["values"]["without"]: r["figures"]["flux_ratio"] for r in document["rows"]}
        self.assertAlmostEqual(flux["nothing"] / flux["fresnel"], 0.84, delta=0.02)
        table = list(csv.DictReader((self.folder / "out/effects.csv").read_text().splitlines()))
        self.assertEqual([r["effect"] for r in table], [e["effect"] for e in document["effects"]])
        errors = [float(r["error_without"]) for r in table]
        self.assertEqual(errors, sorted(errors, reverse=True))

    def test_rows_without_an_effect_are_kept_by_resume(self):
        options = ["--effects", "--grid", "16", "--map", "16"]
        self.study(*options)
        before = self.rows()
        result = self.study(*options, "--resume")
        self.assertIn(f"{len(before)} of them from before", result.stderr)
        self.assertEqual(self.rows(), before)

    def test_it_varies_no_settings(self):
        for other in (["--vary", "grid=16,32"], ["--cross"]):
            self.fails(2, "study", "ball.glb", *SMALL, "--effects", *other, saying="--effects excludes")


class Truth(StudyTest):
    def write(self, error=None):
        channels = {f"caustic.{c}": [1.0] * (64 * 48) for c in "RGB"}
        if error is not None:
            channels |= {f"caustic_error.{c}": [error] * (64 * 48) for c in "RGB"}
        (self.folder / "even.exr").write_bytes(exr(channels, 64, 48))

    def test_where_its_own_noise_rules_rows_are_reference_limited(self):
        # An even truth of 1 lux, which all settings miss by about ten times as much light.
        for error, limited in ((9.0, True), (1e-3, False)):
            self.write(error)
            result = self.study(*GRIDS, "--truth", "even.exr")
            document = self.document()
            self.assertAlmostEqual(document["truth_noise"], error, places=6)
            for row in document["rows"]:
                self.assertEqual(row["reference_limited"], limited, row["figures"])
                self.assertEqual(limited, error > row["figures"]["relative_l1"] / 3)
            self.assertEqual("reference-limited\n" in result.stdout, limited)

    def test_without_noise_it_says_so(self):
        self.write()
        self.assertIn("says nothing of its own noise", self.study(*GRIDS, "--truth", "even.exr").stdout)
        self.assertIsNone(self.document()["truth_noise"])

    def test_what_cannot_be_one_is_refused(self):
        self.write()
        self.fails(3, "study", "ball.glb", *GRIDS, "-r", "32x32", "--truth", "even.exr",
                   saying="use -r 64x48")
        direct = {f"direct.{c}": [1.0] * (64 * 48) for c in "RGB"}
        (self.folder / "b.exr").write_bytes(exr(direct, 64, 48))
        self.fails(3, "study", "ball.glb", *GRIDS, *SMALL, "--truth", "b.exr", saying="no layer 'caustic'")
        black = {f"caustic.{c}": [0.0] * (64 * 48) for c in "RGB"}
        (self.folder / "black.exr").write_bytes(exr(black, 64, 48))
        self.fails(3, "study", "ball.glb", *GRIDS, *SMALL, "--truth", "black.exr", saying="is black")
        holes = {f"caustic.{c}": [float("nan")] * (64 * 48) for c in "RGB"}
        (self.folder / "holes.exr").write_bytes(exr(holes, 64, 48))
        self.fails(3, "study", "ball.glb", *GRIDS, *SMALL, "--truth", "holes.exr", saying="not finite")
        self.fails(3, "study", "ball.glb", *GRIDS, *SMALL, "--truth", "none.exr", saying="no such file")
        self.fails(3, "study", "ball.glb", *GRIDS, *SMALL, "--mask", "none.png", saying="none.png")

    def test_it_can_be_traced(self):
        self.need_ray_queries()
        traced = ["--truth", "traced", "--truth-error", "40%"]
        result = self.study(*GRIDS, *traced)
        document = self.document()
        self.assertTrue(document["independent_truth"])
        self.assertTrue(0 < document["truth_noise"] <= 0.4)
        self.assertIn("truth.exr", result.stdout)
        # Gone on with, nothing is traced anew and no row measured again.
        again = self.study(*GRIDS, *traced, "--resume")
        self.assertIn("2 rows, 2 of them from before", again.stderr)
        self.assertEqual(self.document()["identity"], document["identity"])
        # Nor where it has missed what was asked for, which is said: rows belong to the truth that they were
        # measured against.
        missed = ["--truth", "traced", "--truth-error", "1e-4%", "--truth-seconds", "0"]
        first = self.study(*GRIDS, *missed, "-o", "out")
        self.assertIn("not the 0.0001% of --truth-error", first.stderr)
        self.assertIn("2 rows, 2 of them from before",
                      self.study(*GRIDS, *missed, "-o", "out", "--resume").stderr)
        # Of another view it is traced anew.
        other = self.succeeds("study", "ball.glb", *SMALL[2:], "-r", "32x24", *GRIDS, *traced, "--resume")
        self.assertIn("traced anew", other.stderr)

    def test_where_nothing_can_be_traced_no_folder_is_left(self):
        self.fails(2, "study", "ball.glb", *GRIDS, *SMALL, "--truth", "exact", saying="states no shape")
        self.fails(3, "study", "ball.glb", *GRIDS, *SMALL, "--truth", "traced", "--mask", "none.png",
                   saying="none.png")
        self.fails(2, "study", "ball.glb", *GRIDS, *SMALL, "--truth-seconds", "3",
                   saying="for --truth traced")
        # What says how long is for what is traced; and what is traced is looked for.
        for truth in ([], ["--truth", "traced"], ["--truth", "traced", "--truth-error", "5%"]):
            self.fails(3, "study", "none.glb", *truth, saying="none.glb")
        self.assertFalse((self.folder / "study").exists())


class Refusals(StudyTest):
    def test_unknown_keys_and_values_name_what_was_meant(self):
        self.fails(2, "study", "ball.glb", "--vary", "gird=1,2", saying="did you mean 'grid'?")
        self.fails(2, "study", "ball.glb", "--vary", "estimator=paper,newtom",
                   saying="paper|secant|newton|impostor")
        self.fails(2, "study", "ball.glb", "--vary", "grid=64,", saying="grid cannot be ''")
        self.fails(2, "study", "ball.glb", "--vary", "grid", saying="KEY=a,b,c")
        self.fails(2, "study", "ball.glb", "--vary", "grid=1", "--vary", "grid=2", saying="given twice")
        self.fails(2, "study", "ball.glb", "--vary", "camera=0,1", saying="cannot change camera")
        self.fails(2, "study", "ball.glb", "--repeat", "0", saying="--repeat")
        self.fails(2, "study", saying="no scene given")
        self.fails(2, "study", "ball.glb", "--vary", "estimator=impostor", "--map", "8", saying="map is 8")

    def test_too_many_runs_are_counted(self):
        grids = ",".join(map(str, range(1, 52)))
        self.fails(2, "study", "ball.glb", "--vary", "grid=" + grids, "--vary",
                   "map=" + ",".join(map(str, range(1, 22))),
                   "--cross", saying="1,071 runs")
        self.fails(2, "study", "ball.glb", "--vary", "grid=" + grids, "--vary", "map=" + grids, saying="runs")

    def test_a_scene_without_a_caustic_has_nothing_to_study(self):
        plaster = {"name": "plaster", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}}
        (self.folder / "plaster.glb").write_bytes(glb.scene(plaster))
        self.fails(3, "study", "plaster.glb", *SMALL, *GRIDS, saying="is black")

    def test_a_place_that_cannot_be_written(self):
        (self.folder / "file").write_text("")
        self.fails(4, "study", "ball.glb", *SMALL, *GRIDS, "-o", "file/out")

    def test_files_of_somebody_else_are_left_alone(self):
        (self.folder / "study").mkdir()
        report = self.folder / "study/report.html"
        report.write_text("mine")
        saying = "report.html: is not of an earlier report, which study.json would show; "
        self.fails(4, "study", "ball.glb", *SMALL, *GRIDS, "-o", "study", saying=saying)
        self.assertEqual(report.read_text(), "mine")
        report.rename(self.folder / "study/page.html")  # in nobody's way
        pictures = self.folder / "study/img"
        pictures.mkdir()
        (pictures / "holiday.png").write_text("mine")
        self.fails(4, "study", "ball.glb", *SMALL, *GRIDS, "-o", "study",
                   saying="img: is not of an earlier report, which study.json would show; ")
        self.assertEqual((pictures / "holiday.png").read_text(), "mine")
        (pictures / "holiday.png").unlink()  # an empty folder holds nothing to lose
        self.study(*GRIDS)
        self.study(*GRIDS)
        self.assertEqual((self.folder / "study/page.html").read_text(), "mine")


class GoingOn(StudyTest):
    def test_rows_that_still_hold_are_kept(self):
        self.study(*GRIDS)
        before = self.rows()
        result = self.study("--grid", "32", "--map", "32", "--vary", "grid=16,32", "--vary", "splat=point",
                            "--resume")
        self.assertIn("3 rows, 2 of them from before", result.stderr)
        after = self.rows()
        self.assertEqual([r["milliseconds"] for r in after[:2]], [r["milliseconds"] for r in before])
        # Nothing left to do: the same rows again, word for word.
        text, drift = (self.folder / "study/study.csv").read_text(), self.document()["drift"]
        self.study("--grid", "32", "--map", "32", "--vary", "grid=16,32", "--vary", "splat=point", "--resume")
        self.assertEqual((self.folder / "study/study.csv").read_text(), text)
        self.assertEqual(self.document()["drift"], drift)

    def test_another_truth_moment_or_scene_starts_anew(self):
        self.study(*GRIDS)
        for other in (["--vary", "grid=16,64"], ["--vary", "grid=16,32", "--time", "1"]):
            result = self.study("--grid", "32", "--map", "32", *other, "--resume")
            self.assertIn("all rows are run", result.stderr)
        with open(self.folder / "ball.glb", "ab") as scene:
            scene.write(b"    ")  # the same picture of another file
        result = self.run_program("study", "ball.glb", *SMALL, *GRIDS, "--resume")
        self.assertNotIn("from before", result.stderr)

    def test_other_settings_and_another_repeat_are_other_rows(self):
        self.study(*GRIDS)
        self.assertNotIn("from before", self.study(*GRIDS, "--resume", "-D", "outside_share=0.1").stderr)
        result = self.succeeds("study", "ball.glb", *SMALL, *GRIDS, "-D", "outside_share=0.1", "--repeat",
                               "2", "--resume")
        self.assertNotIn("from before", result.stderr)

    def test_a_damaged_study_starts_anew(self):
        self.study(*GRIDS)
        path = self.folder / "study/study.json"
        path.write_text(path.read_text()[:-400])
        self.assertIn("cannot be read", self.study(*GRIDS, "--resume").stderr)
        self.assertEqual(len(self.rows()), 2)

    def test_a_lost_picture_is_made_again(self):
        self.study(*GRIDS)
        lost = self.folder / "study" / self.rows()[1]["picture"]
        picture = lost.read_bytes()
        lost.unlink()
        self.assertIn("1 of them from before", self.study(*GRIDS, "--resume").stderr)
        self.assertEqual(lost.read_bytes(), picture)

    def test_an_interruption_leaves_what_is_done(self):
        many = ["--map", "32", "--grid", "32", "--vary", "grid=" + ",".join(map(str, range(16, 216)))]
        process = subprocess.Popen([PROGRAM, "study", "ball.glb", *SMALL, *many], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        until = time.monotonic() + 60
        while time.monotonic() < until and len(list(self.folder.glob("study/img/grid*.png"))) < 3:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertEqual(out, "")
        done = len(self.rows())
        self.assertIn(f"note: {done} of 200 rows are in study; --resume goes on\n", err)
        self.assertGreaterEqual(done, 3)
        self.assertLess(done, 200)
        self.assertEqual(self.document()["planned"], 200)
        self.assertEqual(len(self.table()), done)
        self.assertIn("Not complete", self.page()[1])
        # No temporary file is left.
        self.assertEqual([p for p in (self.folder / "study").rglob("*")
                          if not re.search(r"\.(png|svg|json|csv|html)$|img$", p.name)],
                         [])


if __name__ == "__main__":
    main()
