"""compare: figures of an image against a truth, masks and layers, and bounds that decide the exit code."""

import json
import math

from pictures import exr, png
from program import ProgramTest, main
from shown import png_channels


class MetricsTest(ProgramTest):
    def write(self, name, channels, width=2, height=2):
        (self.folder / name).write_bytes(exr(channels, width, height))

    def layers(self, a, b):
        """A file each with the layer `caustic` of 2x2 texels; B has its error beside it."""
        self.write("a.exr", {"caustic." + c: a for c in "RGB"})
        self.write("b.exr", {"caustic." + c: b for c in "RGB"} |
                   {"caustic_error." + c: [9, 9, 9, 9] for c in "RGB"})

    def document(self, code, *arguments):
        result = self.run_program("compare", *arguments, "--json")
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return json.loads(result.stdout, parse_constant=self.fail)  # NaN and Infinity are no JSON

    def last_line(self, code, *arguments):
        result = self.run_program("compare", *arguments)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout.splitlines()[-1]


class Figures(MetricsTest):
    def test_of_channels_and_of_a_layer(self):
        # R: differences 0, 1, -1, 2 against a sum of 10, as in lab/metrics/image_metrics_test.cpp; G equal;
        # B 0 against 10. Alpha is no colour.
        self.write("a.exr", {"R": [1, 3, 2, 6], "G": [1, 2, 3, 4], "B": [0] * 4, "A": [1] * 4})
        self.write("b.exr", {"R": [1, 2, 3, 4], "G": [1, 2, 3, 4], "B": [4, 3, 2, 1], "A": [2] * 4})
        document = self.document(1, "a.exr", "b.exr")
        self.assertFalse(document["passed"])
        channels = {c["channel"]: c["metrics"] for c in document["channels"]}
        self.assertAlmostEqual(channels["R"]["relative_l1"], 0.4)
        self.assertAlmostEqual(channels["R"]["rmse"], math.sqrt(1.5))
        self.assertAlmostEqual(channels["R"]["psnr"], 10 * math.log10(16 / 1.5))
        self.assertAlmostEqual(channels["R"]["flux_ratio"], 1.2)
        self.assertAlmostEqual(channels["R"]["relative_mse_4"], 0.25 / 6.250625)
        self.assertEqual(channels["G"]["rmse"], 0)
        self.assertIsNone(channels["G"]["psnr"])
        self.assertEqual(channels["B"]["relative_l1"], 1)
        self.assertEqual(channels["B"]["flux_error"], 1)
        (layer,) = document["layers"]
        self.assertEqual((layer["layer"], sorted(layer["channels"])), ("", ["B", "G", "R"]))
        self.assertEqual(layer["metrics"]["values"], 12)
        self.assertAlmostEqual(layer["metrics"]["relative_l1"], 14 / 30)
        self.assertAlmostEqual(layer["metrics"]["flux_ratio"], 22 / 30)
        self.assertNotIn("flip", layer)
        self.assertEqual(list(layer["metrics"]), [
            "values", "non_finite", "relative_l1", "rmse", "relative_mse_1", "relative_mse_4",
            "relative_mse_16", "clipped_relative_mse_1", "clipped_relative_mse_4",
            "clipped_relative_mse_16", "flux_ratio", "flux_error", "psnr", "clip"])

    def test_what_does_not_exist_is_null_and_a_dash(self):
        for a, b in (([1, 0, 0, 0], [0, 0, 0, 0]), ([1, 2, math.nan, 4], [1, 2, 3, 4]),
                     ([1, 2, math.inf, 4], [1, 2, math.inf, 4])):
            self.write("a.exr", {"Z": a})
            self.write("b.exr", {"Z": b})
            code = self.run_program("compare", "a.exr", "b.exr").returncode
            metrics = self.document(code, "a.exr", "b.exr")["layers"][0]["metrics"]
            for name in ("relative_l1", "relative_mse_1", "flux_ratio", "flux_error", "psnr"):
                self.assertIsNone(metrics[name], name)
            table = self.run_program("compare", "a.exr", "b.exr").stdout.split("relative L1")[1]
            self.assertNotIn("nan", table.splitlines()[1])
            self.assertIn(" - ", table.splitlines()[1])

    def test_other_sizes_have_no_figures(self):
        self.write("a.exr", {"Z": [0, 0, 0, 0]}, 4, 1)
        self.write("b.exr", {"Z": [0, 0, 0, 0]}, 2, 2)
        document = self.document(1, "a.exr", "b.exr")
        self.assertEqual(document["layers"], [])
        self.assertNotIn("metrics", document["channels"][0])


class Selections(MetricsTest):
    def test_one_layer_of_files_with_different_ones(self):
        self.layers([1, 2, 3, 4], [1, 2, 3, 4])
        self.last_line(1, "a.exr", "b.exr")
        self.assertTrue(self.last_line(0, "a.exr", "b.exr", "--layer", "caustic").startswith("equal"))
        self.assertIn("has no layer", self.fails(3, "compare", "a.exr", "b.exr", "--layer", "causti",
                                                 saying="it has caustic"))
        self.fails(3, "compare", "a.exr", "b.exr", "--layer", "caustic_error", saying="a.exr")

    def test_the_layer_without_a_name_is_beauty(self):
        self.write("a.exr", {"R": [1] * 4, "x.R": [1] * 4})
        self.write("b.exr", {"R": [1] * 4, "x.R": [2] * 4})
        self.last_line(0, "a.exr", "b.exr", "--layer", "beauty")
        self.last_line(1, "a.exr", "b.exr", "--layer", "x")

    def test_mask(self):
        self.layers([1, 2, math.nan, 6], [1, 2, 3, 4])
        self.write("m.exr", {"Y": [1, 0.5, 0, 0], "A": [1, 1, 1, 1]})
        self.write("all.exr", {"Y": [1, 1, 0, 1]})
        document = self.document(0, "a.exr", "b.exr", "--layer=caustic", "--mask=m.exr")
        self.assertEqual(document["selected"], {"texels": 2, "of": 4})
        self.assertEqual(document["layers"][0]["metrics"]["values"], 6)
        # Alpha selects nothing beside other channels; what is not above 0 neither.
        (self.folder / "m.png").write_bytes(png([(0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 9, 0)], 2, 2))
        document = self.document(1, "a.exr", "b.exr", "--layer=caustic", "--mask=m.png")
        self.assertEqual(document["layers"][0]["metrics"]["relative_l1"], 0.5)
        document = self.document(1, "a.exr", "b.exr", "--layer=caustic", "--mask=all.exr")
        self.assertAlmostEqual(document["layers"][0]["metrics"]["relative_l1"], 2 / 7)

    def test_region(self):
        self.layers([1, 2, 3, 5], [1, 2, 3, 4])
        only = ["a.exr", "b.exr", "--layer=caustic"]
        self.last_line(0, *only, "--region=0,0,2,1")
        document = self.document(1, *only, "--region=1,1,1,1")
        self.assertEqual(document["layers"][0]["metrics"]["relative_l1"], 0.25)
        self.write("m.exr", {"Y": [1, 1, 1, 0]})
        self.last_line(0, *only, "--region=0,1,2,1", "--mask=m.exr")
        self.fails(3, "compare", *only, "--region=1,1,1,1", "--mask=m.exr", saying="no texel")

    def test_difference_images_leave_out_what_is_not_selected(self):
        self.layers([1, 2, 3, 5], [2, 2, 3, 4])
        self.run_program("compare", "a.exr", "b.exr", "--layer=caustic", "--region=0,1,2,1",
                         "--diff=d")
        self.write("expected.exr", {"caustic." + c: [0, 0, 0, 1] for c in "RGB"})
        self.last_line(0, "d_signed.exr", "expected.exr")

    def test_mistakes(self):
        self.layers([1, 2, 3, 4], [1, 2, 3, 4])
        self.write("m.exr", {"Y": [1, 1, 1, 1]}, 4, 1)
        self.write("none.exr", {"Y": [0, -1, math.nan, 0]})
        only = ["compare", "a.exr", "b.exr", "--layer=caustic"]
        self.fails(3, *only, "--mask=m.exr", saying="must have their size")
        self.fails(3, *only, "--mask=none.exr", saying="selects no texel")
        self.fails(3, *only, "--mask=missing.exr", saying="missing.exr")
        for text in ("1,1,2,1", "0,0,1", "0,0,1,1,1", "0,0,0,1", "-1,0,1,1", "a", "",
                     "1073741824,0,1073741824,1"):
            self.fails(2, *only, f"--region={text}", saying="--region")
        (self.folder / "d").mkdir()
        for option in ("--layer=x", "--mask=m.exr", "--region=0,0,1,1", "--flip",
                       "--fail-above=rmse=1"):
            self.fails(2, "compare", "d", "d", option, saying="two images")


class Bounds(MetricsTest):
    def test_they_decide_instead_of_the_values(self):
        self.layers([1, 2, 3, 4.5], [1, 2, 3, 4])
        only = ["a.exr", "b.exr", "--layer=caustic"]
        self.last_line(1, *only)
        self.assertEqual(
            self.last_line(0, *only, "--fail-above", "relative_l1=0.05"),
            "within the bounds: relative_l1 of layer caustic is 0.05, bound 0.05")
        self.assertEqual(
            self.last_line(1, *only, "--fail-above=relative_l1=0.06", "--fail-above=rmse=0.2"),
            "beyond the bounds: rmse of layer caustic is 0.25, bound 0.2")
        document = self.document(1, *only, "--fail-above=relative_l1=0.06", "--fail-above=rmse=0.2")
        self.assertFalse(document["passed"])
        self.assertEqual(document["verdict"], "different")
        self.assertEqual(document["bounds"], [
            {"metric": "relative_l1", "bound": 0.06, "layer": "caustic", "value": 0.05, "holds": True},
            {"metric": "rmse", "bound": 0.2, "layer": "caustic", "value": 0.25, "holds": False}])
        self.assertTrue(self.document(0, *only, "--fail-above=rmse=1")["passed"])

    def test_the_worst_layer_counts(self):
        self.write("a.exr", {"x.Z": [1] * 4, "y.Z": [3] * 4, "z.Z": [2] * 4})
        self.write("b.exr", {"x.Z": [1] * 4, "y.Z": [2] * 4, "z.Z": [2] * 4})
        self.assertIn("layer y is 0.5", self.last_line(1, "a.exr", "b.exr",
                                                       "--fail-above=relative_l1=0.4"))
        self.last_line(0, "a.exr", "b.exr", "--fail-above=flux_error=0.5")

    def test_a_missing_channel_a_nan_and_another_size_fail_under_any_bound(self):
        anything = ["a.exr", "b.exr", "--fail-above=relative_l1=1e30"]
        self.layers([1, 2, 3, 4], [1, 2, 3, 4])
        self.assertIn("only in B", self.last_line(1, *anything))
        self.write("a.exr", {"Z": [1, 2, math.nan, 4]})
        self.write("b.exr", {"Z": [1, 2, math.nan, 4]})
        self.assertIn("has a NaN", self.last_line(1, *anything))
        self.last_line(0, *anything, "--region=0,0,2,1")
        self.write("b.exr", {"Z": [1, 2, 3, 4]}, 4, 1)
        self.assertIn("B is 4x1", self.last_line(1, *anything))

    def test_a_figure_that_does_not_exist_fails(self):
        self.write("a.exr", {"Z": [1, 0, 0, 0]})
        self.write("b.exr", {"Z": [0, 0, 0, 0]})
        self.assertIn("is undefined", self.last_line(1, "a.exr", "b.exr",
                                                     "--fail-above=relative_l1=1e30"))
        self.last_line(0, "a.exr", "b.exr", "--fail-above=rmse=0.5")
        self.assertIn("is of no layer here", self.last_line(1, "a.exr", "b.exr",
                                                       "--fail-above=flip_mean=1"))

    def test_mistakes(self):
        self.layers([1, 2, 3, 4], [1, 2, 3, 4])
        for text, saying in (("relative_l2=1", "did you mean 'relative_l1'?"), ("psnr=30", "psnr"),
                             ("rmse", "rmse=NUMBER"), ("rmse=", "rmse=NUMBER"), ("rmse=-1", "0 or"),
                             ("rmse=nan", "rmse"), ("rmse=1x", "rmse"), ("=1", "no metric")):
            self.fails(2, "compare", "a.exr", "b.exr", f"--fail-above={text}", saying=saying)


class Flip(MetricsTest):
    """What FLIP is, is checked in flip_test.py; here, what compare does with it."""

    def test_linear_layers_at_an_exposure_from_b(self):
        # Luminances above 0 are 1, 2, 4; the 99th percentile of three is 4, which becomes 0.8.
        self.layers([0, 1, 2, 5], [0, 1, 2, 4])
        only = ["a.exr", "b.exr", "--layer=caustic", "--flip"]
        (layer,) = self.document(1, *only)["layers"]
        self.assertAlmostEqual(layer["flip"]["exposure"], 0.2, places=6)
        self.assertGreater(layer["flip"]["mean"], 0)
        self.assertLessEqual(layer["flip"]["maximum"], 1)
        self.assertAlmostEqual(layer["flip"]["pixels_per_degree"], 67.0206, places=3)
        # The same light in other units looks the same.
        self.layers([0, 100, 200, 500], [0, 100, 200, 400])
        (other,) = self.document(1, *only)["layers"]
        self.assertEqual(other["flip"]["mean"], layer["flip"]["mean"])
        self.assertIn("FLIP of layer caustic: mean ", self.run_program("compare", *only).stdout)

    def test_is_null_for_what_is_no_picture(self):
        self.write("a.exr", {"Z": [1, 2, 3, 4]})
        self.assertIsNone(self.document(0, "a.exr", "a.exr", "--flip")["layers"][0]["flip"])
        self.write("b.exr", {c: [1, 2, math.nan, 4] for c in "RGB"})
        self.assertIsNone(self.document(1, "b.exr", "b.exr", "--flip")["layers"][0]["flip"])
        (self.folder / "c.png").write_bytes(png([(1, 2, 3)] * 4, 2, 2))
        self.assertIsNone(self.document(1, "c.png", "b.exr", "--flip",
                                        "--region=0,0,2,1")["layers"][0]["flip"])

    def test_bounds(self):
        (self.folder / "a.png").write_bytes(png([(0, 0, 0)] * 4, 2, 2))
        (self.folder / "b.png").write_bytes(png([(255, 255, 255)] * 4, 2, 2))
        pair = ["a.png", "b.png"]
        self.assertIn("is 0.9674", self.last_line(1, *pair, "--fail-above=flip_mean=0.9"))
        self.last_line(0, *pair, "--fail-above=flip_max=0.97", "--fail-above=flip_median=0.97")

    def test_map_with_its_scale(self):
        self.layers([0, 1, 2, 5], [0, 1, 2, 4])
        self.succeeds("compare", "a.exr", "b.exr", "--layer=caustic", "--flip", "--diff=d",
                      "--fail-above=rmse=9")
        self.assertIn("d_caustic_flip.png", self.files())
        # 2 rows of the map, then the scale: at least 180 wide, its ends black and white.
        black = {c: [0] * (180 * 42) for c in "RGB"}
        self.write("black.exr", black, 180, 42)
        for channel in self.document(1, "d_caustic_flip.png", "black.exr")["channels"]:
            self.assertNotIn("mismatch", channel)
            self.assertEqual(channel["worst"]["a"], 1)
        # A row of the bar, 12 pixels from either side, whose ends are black and white.
        _, _, channels = png_channels((self.folder / "d_caustic_flip.png").read_bytes())
        for values in channels.values():
            row = values[12 * 180:13 * 180]
            self.assertEqual(row[:12] + row[168:], 24 * [row[0]])
            self.assertEqual((row[12], row[167]), (0, 255))
        (self.folder / "e_flip.png").write_bytes(png([(0, 0, 0)] * 4, 2, 2))
        self.fails(2, "compare", "e_flip.png", "e_flip.png", "--flip", "--diff=e",
                   saying="--diff would replace an image")


if __name__ == "__main__":
    main()
