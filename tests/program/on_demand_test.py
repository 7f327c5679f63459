"""A frame's own error estimate, and sizes chosen for an error or a time that was asked for."""

import json
import re

from pictures import exr
from program import ProgramTest, main

VIEW = ["-r", "64x48"]
CHOSEN = re.compile(r"asked for .*: chose --grid (\d+) --map (\d+), found ([0-9.]+)%")


class OnDemand(ProgramTest):
    def chosen(self, stderr):
        found = CHOSEN.search(stderr)
        self.assertTrue(found, stderr)
        return int(found[1]), int(found[2]), float(found[3])

    def test_every_render_estimates_its_error(self):
        result = self.succeeds("render", "ball.glb", *VIEW, "--grid", "128", "--map", "128", "--stats",
                               "s.json")
        error = json.loads((self.folder / "s.json").read_text())["lights"][0]["estimated_error"]
        parts = ("map", "grid", "missing", "model")
        self.assertAlmostEqual(error["total"], sum(error[part] for part in parts))
        self.assertGreater(error["total"], 0.001)
        self.assertLess(error["total"], 0.5)
        said = float(result.stderr.split("error: estimated ")[1].split("%")[0])
        self.assertAlmostEqual(said, 100 * error["total"], delta=0.11)  # cut after one digit

    def mean_of(self, layer, width=64, height=48):
        zeros = [0.0] * (width * height)
        (self.folder / "zero.exr").write_bytes(exr({f"{layer}.{c}": zeros for c in "RGB"}, width, height))
        result = self.run_program("compare", "e.exr", "zero.exr", "--layer", layer, "--json")
        channels = json.loads(result.stdout)["channels"]
        return sum(channel["absolute"]["mean"] for channel in channels) / 3

    def test_the_layer_error_is_what_is_stated_pixel_by_pixel(self):
        self.succeeds("ball.glb", *VIEW, "-o", "e.exr", "--aov", "caustic,error", "--stats", "s.json")
        stated = json.loads((self.folder / "s.json").read_text())["lights"][0]["estimated_error"]
        # The layer's sum is over the frame's light, the statement's over true light, with less noise.
        share = self.mean_of("error") / self.mean_of("caustic")
        self.assertGreater(share, 0.5 * stated["total"])
        self.assertLess(share, 2.0 * stated["total"])
        quiet = self.succeeds("ball.glb", *VIEW, "-o", "q.exr", "--aov", "caustic,error", "--quiet")
        self.assertEqual(quiet.stderr, "")
        self.succeeds("compare", "e.exr", "q.exr")

    def test_what_the_model_leaves_out_is_not_bought_with_finer_maps(self):
        result = self.run_program("render", "ball.glb", *VIEW, "-D", "further.share=1", "--target-error",
                                  "0.5%", "-o", "m.png")
        self.assertEqual(result.returncode, 6, result.stderr)
        self.assertIn("is light that takes ways which are not followed", result.stderr)
        grid, map_, _ = self.chosen(result.stderr)
        self.assertLessEqual(max(grid, map_), 1024)  # of 2048

    def test_a_target_error_that_can_be_reached_is_reached(self):
        code, shown = self.on_terminal("render", "ball.glb", *VIEW, "--target-error", "15%", "--stats",
                                       "s.json")
        self.assertEqual(code, 0)
        shown = "\n".join(shown)
        grid, map_, found = self.chosen(shown)
        self.assertIn((str(grid), str(map_)), re.findall(r"trying grid (\d+) and map (\d+)", shown))
        self.assertLessEqual(found, 15.0)
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual((stats["settings"]["grid"], stats["settings"]["map"]), (grid, map_))
        self.assertLessEqual(stats["lights"][0]["estimated_error"]["total"], 0.15)

    def test_a_budget_that_no_frame_can_keep_is_missed_with_its_own_code_and_the_picture_written(self):
        result = self.run_program("render", "ball.glb", *VIEW, "--time-budget", "0.01", "-o", "late.png")
        self.assertEqual(result.returncode, 6, result.stderr)
        self.assertIn("missed: asked for passes within", result.stderr)
        self.assertTrue(self.chosen(result.stderr))
        self.assertTrue((self.folder / "late.png").read_bytes().startswith(b"\x89PNG"))

    def test_wrong_demands_are_refused(self):
        self.fails(2, "render", "ball.glb", "--target-error", "0", saying="--target-error")
        self.fails(2, "render", "ball.glb", "--target-error", "two", saying="--target-error")
        self.fails(2, "render", "ball.glb", "--target-error", "2", "--time-budget", "5", saying="exclude")
        self.fails(2, "render", "ball.glb", "--time-budget", "5", "--frames", "0..3", "-o", "f.%04d.png",
                   saying="one frame")


if __name__ == "__main__":
    main()
