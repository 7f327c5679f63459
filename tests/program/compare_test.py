"""compare: what makes two images different, what is said about it, and what is written."""

import json
import math
import pathlib
import struct
import subprocess

from pictures import exr
from program import PROGRAM, SMALL, ProgramTest, main
from shown import png_channels


class CompareTest(ProgramTest):
    def write(self, name, channels, width=2, height=2):
        (self.folder / name).write_bytes(exr(channels, width, height))

    def pair(self, a, b):
        """One channel Z of 2x2 texels in each of two files."""
        self.write("a.exr", {"Z": a})
        self.write("b.exr", {"Z": b})

    def different(self, *arguments):
        """Exit code 1; the last line printed."""
        result = self.run_program("compare", *arguments)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        verdict = result.stdout.splitlines()[-1]
        self.assertTrue(verdict.startswith("different: "), verdict)
        return verdict

    def equal(self, *arguments):
        result = self.succeeds("compare", *arguments)
        self.assertTrue(result.stdout.splitlines()[-1].startswith("equal: "), result.stdout)

    def document(self, code, *arguments):
        result = self.run_program("compare", *arguments, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)


class Values(CompareTest):
    def test_equal_files(self):
        self.pair([1, 2, 3, 4], [1, 2, 3, 4])
        self.equal("a.exr", "b.exr")

    def test_zeros_and_infinities_equal_themselves(self):
        self.pair([0.0, math.inf, -math.inf, 4], [-0.0, math.inf, -math.inf, 4])
        self.equal("a.exr", "b.exr")

    def test_one_changed_texel_is_named_from_the_top_left(self):
        self.pair([1, 2, 3, 4], [1, 2.5, 3, 4])
        self.assertEqual(self.different("a.exr", "b.exr"),
                         "different: 1 of 4 values fail; worst: Z at 1,0: A 2, B 2.5")

    def test_blocks_are_compared_by_their_means(self):
        # Means of 2 x 2 texels, the last column alone: 2.5 and 5, against 2.5 and 7.
        self.write("a.exr", {"Z": [1, 2, 5, 3, 4, 5]}, 3, 2)
        self.write("b.exr", {"Z": [4, 3, 6, 2, 1, 8]}, 3, 2)
        self.assertEqual(self.different("a.exr", "b.exr", "--blocks", "2"),
                         "different: 1 of 2 values fail; worst: Z at 1,0: A 5, B 7")
        self.fails(2, "compare", "a.exr", "b.exr", "--blocks", "2", "--mask", "a.exr", saying="--blocks")

    def test_one_bit_is_a_difference(self):
        self.pair([1, 2, 3, 4], [1, 2, 3, 4 + 2**-21])
        channel = self.document(1, "a.exr", "b.exr")["channels"][0]
        self.assertEqual(channel["ulps"]["maximum"], 1)
        self.assertEqual(channel["worst"], {"x": 1, "y": 1, "a": 4, "b": 4 + 2**-21})

    def test_tolerance_either_bound_suffices(self):
        self.pair([0, 100, 3, 4], [0.125, 101, 3, 4])
        self.different("a.exr", "b.exr", "--tolerance", "0.125")
        self.different("a.exr", "b.exr", "--relative", "0.01")
        result = self.succeeds("compare", "a.exr", "b.exr", "--tolerance=0.125", "--relative=0.01")
        self.assertIn("within tolerance: 2 of 4 values differ", result.stdout)

    def test_nan_fails_under_any_tolerance_also_in_both(self):
        for a, b in ((math.nan, 0), (0, math.nan), (math.nan, math.nan)):
            self.pair([1, 2, a, 4], [1, 2, b, 4])
            verdict = self.different("a.exr", "b.exr", "--tolerance", "1e30", "--relative", "9")
            self.assertIn("Z at 0,1", verdict)

    def test_infinity_fails_under_any_tolerance(self):
        for other in (-math.inf, 3e38):
            self.pair([1, 2, math.inf, 4], [1, 2, other, 4])
            self.different("a.exr", "b.exr", "--tolerance", "1e300", "--relative", "9")

    def test_json(self):
        self.pair([1, 2, math.nan, 4], [1, 2.5, 3, 4])
        document = self.document(1, "a.exr", "b.exr", "--tolerance", "1")
        self.assertEqual(document["verdict"], "different")
        self.assertEqual(document["tolerance"], {"absolute": 1, "relative": 0})
        channel = document["channels"][0]
        self.assertEqual((channel["values"], channel["differing"], channel["beyond_tolerance"]),
                         (4, 2, 1))
        self.assertEqual((channel["nan_only_a"], channel["nan_only_b"], channel["nan_both"]),
                         (1, 0, 0))
        # Over the three finite pairs.
        self.assertEqual(channel["absolute"]["maximum"], 0.5)
        self.assertAlmostEqual(channel["absolute"]["mean"], 0.5 / 3)
        self.assertEqual(channel["relative"]["maximum"], 0.2)
        self.assertEqual(channel["ulps"]["maximum"], 2**21)
        self.assertEqual(channel["first"], {"x": 1, "y": 0, "a": 2, "b": 2.5})
        self.assertEqual(channel["worst"], {"x": 0, "y": 1, "a": "nan", "b": 3})

    def test_same_output_for_the_same_input(self):
        self.pair([1, 2, 3, 4], [5, 6, 7, 9])
        first = self.run_program("compare", "a.exr", "b.exr").stdout
        self.assertEqual(self.run_program("compare", "a.exr", "b.exr").stdout, first)


    def test_a_mask_selects_any_texel_of_the_picture(self):
        self.write("a.exr", {"Z": [0] * 6}, 3, 2)
        self.write("b.exr", {"Z": [1] * 6}, 3, 2)
        for place in range(6):
            self.write("m.exr", {"Z": [float(i == place) for i in range(6)]}, 3, 2)
            self.assertEqual(self.different("a.exr", "b.exr", "--mask", "m.exr"),
                             f"different: 1 of 1 value fail; worst: Z at {place % 3},{place // 3}: A 0, B 1")

    def test_what_is_no_file_is_told(self):
        self.pair([1, 2, 3, 4], [1, 2, 3, 4])
        (self.folder / "c.exr").mkdir()
        self.fails(3, "compare", "a.exr", "none.exr", saying="none.exr: no such file")
        self.fails(3, "compare", "a.exr", "b.exr", "--mask", "c.exr", saying="c.exr: is not a plain file")


class Shapes(CompareTest):
    def test_size(self):
        self.write("a.exr", {"Z": [0, 0, 0, 0]}, 4, 1)
        self.write("b.exr", {"Z": [0, 0, 0, 0]}, 2, 2)
        self.different("a.exr", "b.exr")
        channel = self.document(1, "a.exr", "b.exr")["channels"][0]
        self.assertEqual(channel["mismatch"], "A is 4x1, B is 2x2")

    def test_channels_are_lined_up_by_name(self):
        four, zeros = [1, 2, 3, 4], [0, 0, 0, 0]
        self.write("a.exr", {"x.R": four, "x.G": zeros})
        self.write("b.exr", {"x.R": four, "y.G": zeros})
        channels = {c["channel"]: c for c in self.document(1, "a.exr", "b.exr")["channels"]}
        self.assertEqual(channels["x.R"]["verdict"], "equal")
        self.assertEqual(channels["x.G"]["mismatch"], "only in A")
        self.assertEqual(channels["y.G"]["mismatch"], "only in B")

    def test_pictures_and_layers_of_render(self):
        for name, estimator in (("a", "secant"), ("b", "secant"), ("c", "paper")):
            self.succeeds("ball.glb", *SMALL, "-o", name + ".png", "-o", name + ".exr", "--aov",
                          "beauty,caustic", "--estimator", estimator)
        for extension in (".png", ".exr"):
            self.equal("a" + extension, "b" + extension)
            self.different("a" + extension, "c" + extension)
        names = [c["channel"] for c in self.document(0, "a.exr", "b.exr")["channels"]]
        self.assertEqual(sorted(names), sorted(["R", "G", "B", "A", "caustic.R", "caustic.G",
                                                "caustic.B"]))


class DifferenceImages(CompareTest):
    def test_signed_and_coloured(self):
        self.pair([1, 2, 3, 4], [1, 2.5, 1, 4])
        result = self.run_program("compare", "a.exr", "b.exr", "--diff", "d")
        self.assertEqual(result.returncode, 1)
        self.assertIn("d_color.png: black is equal, white is a difference of 2,", result.stderr)
        self.write("expected.exr", {"Z": [0, -0.5, 2, 0]})
        self.equal("d_signed.exr", "expected.exr")
        # Black where equal, white where the difference is largest, between them elsewhere.
        self.write("black.exr", {c: [0, 0, 0, 0] for c in "RGB"})
        for channel in self.document(1, "d_color.png", "black.exr")["channels"]:
            self.assertEqual(channel["differing"], 2)
            self.assertEqual(channel["worst"], {"x": 0, "y": 1, "a": 1, "b": 0})

    def test_the_largest_difference_is_white_however_small_it_is(self):
        self.pair([1, 1, 1, 1], [1, 1 + 2**-10, 1 + 2**-7, 1])
        result = self.run_program("compare", "a.exr", "b.exr", "--diff", "d")
        self.assertIn("white is a difference of 0.00781,", result.stderr)
        width, height, channels = png_channels((self.folder / "d_color.png").read_bytes())
        self.assertEqual((width, height), (2, 2))
        for values in channels.values():
            self.assertEqual((values[0], values[2], values[3]), (0, 255, 0))
            self.assertGreater(values[1], 0)

    def test_same_bytes_again(self):
        self.pair([1, 2, 3, 4], [1, 2.5, 1, 4])
        for prefix in ("d", "e"):
            self.run_program("compare", "a.exr", "b.exr", "--diff", prefix)
        for name in ("_signed.exr", "_color.png"):
            self.assertEqual((self.folder / ("d" + name)).read_bytes(),
                             (self.folder / ("e" + name)).read_bytes())

    def test_nothing_to_draw_is_said(self):
        self.write("a.exr", {"Z": [0, 0, 0, 0]}, 4, 1)
        self.write("b.exr", {"Z": [0, 0, 0, 0]}, 2, 2)
        before = self.files()
        result = self.run_program("compare", "a.exr", "b.exr", "--diff", "d")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no difference images", result.stderr)
        self.assertEqual(self.files(), before)

    def test_unwritable(self):
        self.pair([1, 2, 3, 4], [1, 2.5, 1, 4])
        (self.folder / "e_color.png").mkdir()
        self.fails(4, "compare", "a.exr", "b.exr", "--diff", "missing/d", saying="no folder")
        self.fails(4, "compare", "a.exr", "b.exr", "--diff", "e", saying="it is a folder")

    def test_never_replaces_an_input(self):
        self.write("d_signed.exr", {"Z": [1, 2, 3, 4]})
        self.fails(2, "compare", "d_signed.exr", "d_signed.exr", "--diff", "d", saying="which is read")


class Likenesses(CompareTest):
    """Of an image of 8 x 4 texels, whose values are a third of 1, 2, 3, ..."""

    values = {c: [(32 * i + j + 1) / 3 for j in range(32)] for i, c in enumerate("RGB")}

    def looks(self, a, b=None, *options):
        for name, channels in (("a", a), ("b", b or self.values)):
            self.write(name + ".exr", channels, 8, 4)
        result = self.run_program("compare", "a.exr", "b.exr", *options)
        lines = [line for line in result.stdout.splitlines() if line.startswith("looks like: ")]
        document = json.loads(self.run_program("compare", "a.exr", "b.exr", *options, "--json").stdout)
        self.assertEqual(["looks like: " + each for each in document["looks_like"]], lines)
        return [line.removeprefix("looks like: ") for line in lines]

    def test_dim_images_are_judged_as_bright_ones(self):
        dim = {c: [1e-4 * v for v in values] for c, values in self.values.items()}
        for change, words in ((lambda c, i: dim[c][8 * (3 - i // 8) + i % 8], "upside down"),
                              (lambda c, i: dim[{"R": "B", "G": "G", "B": "R"}[c]][i], "swapped channels"),
                              (lambda c, i: 2.5 * dim[c][i], "off by a factor of 2.5")):
            found = self.looks({c: [change(c, i) for i in range(32)] for c in dim}, dim)
            self.assertEqual(len(found), 1)
            self.assertIn(words, found[0])

    def changed(self, change):
        return {c: [change(c, i, v) for i, v in enumerate(values)] for c, values in self.values.items()}

    def test_upside_down(self):
        turned = self.changed(lambda c, i, v: self.values[c][8 * (3 - i // 8) + i % 8])
        self.assertEqual(self.looks(turned), ["upside down (A's rows from below are B's from above)"])
        rounded = {c: [v * (1 + 1e-6) for v in values] for c, values in turned.items()}
        self.assertEqual(len(self.looks(rounded)), 1)

    def test_swapped_channels(self):
        r, g, b = self.values.values()
        self.assertEqual(self.looks({"R": b, "G": g, "B": r}), ["swapped channels (R and B)"])
        self.assertEqual(self.looks({"R": g, "G": b, "B": r}),
                         ["channels in another order (B of A is R of B, R of A is G of B, G of A is B of B)"])

    def test_half_precision(self):
        half = self.changed(lambda c, i, v: struct.unpack("<e", struct.pack("<e", v))[0])
        self.assertEqual(self.looks(half), ["half precision (A is B rounded to 16-bit floats)"])
        self.assertEqual(self.looks(self.values, half), ["half precision (B is A rounded to 16-bit floats)"])

    def test_a_constant_factor(self):
        self.assertEqual(self.looks(self.changed(lambda c, i, v: 2.5 * v)),
                         ["off by a factor of 2.5 (A is 2.5 times B, in R, G and B)"])
        one = self.changed(lambda c, i, v: v / 4 if c == "G" else v)
        self.assertEqual(self.looks(one), ["off by a factor of 0.25 (A is 0.25 times B, in G)"])

    def test_nothing_is_seen_where_nothing_is(self):
        self.assertEqual(self.looks(self.values), [])
        unrelated = self.changed(lambda c, i, v: (i * 7919 + ord(c) * 104729) % 101 / 7)
        noisy = self.changed(lambda c, i, v: v * (1 + 1e-3 * ((i * 7919) % 11 - 5)))
        last_bits = self.changed(lambda c, i, v: v * (1 + (i % 3 - 1) * 2**-23))
        shifted = self.changed(lambda c, i, v: v + 1)
        one_texel = self.changed(lambda c, i, v: v if i else 2 * v)
        black = self.changed(lambda c, i, v: 0.0)
        for image in (unrelated, noisy, last_bits, shifted, one_texel, black):
            self.assertEqual(self.looks(image), [])
            self.assertEqual(self.looks(self.values, image), [])
        broken = self.changed(lambda c, i, v: math.nan if i == 5 else 2 * v)
        self.assertEqual(self.looks(broken), [])
        self.assertEqual(self.looks(self.changed(lambda c, i, v: 1.001 * v), None, "--relative", "0.01"), [])

    def test_in_folders(self):
        for folder, channels in (("a", self.values), ("b", self.changed(lambda c, i, v: 3 * v))):
            (self.folder / folder).mkdir()
            self.write(folder + "/z.exr", channels, 8, 4)
            (self.folder / folder / "manifest.json").write_text(json.dumps(
                {"attachments": [{"pass": "p", "attachment": "z", "file": "z.exr"}]}))
        text = self.run_program("compare", "b", "a").stdout
        self.assertIn("p/z looks like: off by a factor of 3 (", text)


class Dumps(CompareTest):
    def dump(self, folder, *options):
        self.succeeds("ball.glb", *SMALL, "--quiet", "--dump", folder, *options)

    def edit(self, folder, change):
        manifest = self.folder / folder / "manifest.json"
        document = json.loads(manifest.read_text())
        change(document["attachments"])
        manifest.write_text(json.dumps(document))

    def test_attachment_by_attachment_worst_first(self):
        self.dump("a")
        self.dump("b", "--estimator", "paper")
        self.equal("a", "a")
        self.assertIn("the first in the order of the passes is landing[", self.different("a", "b"))
        document = self.document(1, "a", "b")
        verdicts = [entry["verdict"] for entry in document["attachments"]]
        self.assertEqual(verdicts, sorted(verdicts))  # "different" before "equal"
        self.assertEqual(set(verdicts), {"different", "equal"})
        text = self.run_program("compare", "a", "b").stdout
        for entry in document["attachments"]:
            self.assertIn("\n" + entry["attachment"] + " ", text)

    def test_a_missing_attachment_or_another_format_is_a_difference(self):
        self.dump("a")
        self.dump("b")
        self.edit("b", lambda attachments: attachments.pop(3))
        self.different("a", "b")
        self.assertEqual(self.document(1, "a", "b")["attachments"][0]["mismatch"], "only in A")
        self.assertEqual(self.document(1, "b", "a")["attachments"][0]["mismatch"], "only in B")
        self.edit("b", lambda attachments: attachments[0].update(format="RGBA16F"))
        self.edit("b", lambda attachments: attachments.append(attachments[0]))
        self.fails(3, "compare", "a", "b", saying="twice")

    def test_a_manifest_needs_three_words_an_attachment(self):
        # What a renderer of one's own writes: no format, no hash.
        for folder, value in (("a", 1), ("b", 2)):
            (self.folder / folder).mkdir()
            self.write(folder + "/z.exr", {"Z": [value] * 4})
            (self.folder / folder / "manifest.json").write_text(json.dumps(
                {"attachments": [{"pass": "p", "attachment": "z", "file": "z.exr"}]}))
        self.assertIn("p/z", self.different("a", "b"))

    def test_bad_manifests(self):
        (self.folder / "a").mkdir()
        self.fails(3, "compare", "a", "a", saying="no manifest.json")
        entry = {"pass": "p", "attachment": "z", "file": "../a.exr"}
        for text, saying in (("", ""), ("[]", ""), ("{", ""), ('{"attachments": 7}', ""),
                             ('{"attachments": [7]}', ": an attachment is no object"),
                             ('{"attachments": [{}]}', ": an attachment has no text 'file'"),
                             (json.dumps({"attachments": [entry]}),
                              ": '../a.exr' is no file of this folder")):
            (self.folder / "a" / "manifest.json").write_text(text)
            self.fails(3, "compare", "a", "a", saying="manifest.json" + saying)

    def write_dump(self, folder, **attachments):
        """A folder of 2x2 texels of Z each."""
        (self.folder / folder).mkdir()
        for name, values in attachments.items():
            self.write(f"{folder}/{name}.exr", {"Z": values})
        (self.folder / folder / "manifest.json").write_text(json.dumps(
            {"attachments": [{"pass": "p", "attachment": n, "file": n + ".exr"} for n in attachments]}))

    def test_pictures_of_the_attachments_that_differ(self):
        self.write_dump("a", same=[1, 2, 3, 4], other=[1, 2, 3, 4])
        self.write_dump("b", same=[1, 2, 3, 4], other=[1, 2, 5, 4])
        self.write("expected.exr", {"Z": [0, 0, -2, 0]})
        before = self.files()
        for diff, stem in (("d", "d_other"), ("e/", "e/other"), ("e", "e/other")):
            result = self.run_program("compare", "a", "b", "--diff", diff)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(stem + "_color.png: black is equal, white is a difference of 2,", result.stderr)
            self.equal(stem + "_signed.exr", "expected.exr")
        self.assertEqual(self.files(), sorted(before + ["d_other_color.png", "d_other_signed.exr", "e"]))
        self.assertEqual(sorted(p.name for p in (self.folder / "e").iterdir()),
                         ["other_color.png", "other_signed.exr"])
        self.fails(2, "compare", "a", "b", "--layer", "x", saying="two images")

    def test_pictures_that_cannot_be_written_or_would_replace_an_input(self):
        self.write_dump("a", p=[1, 2, 3, 4], p_signed=[1, 2, 3, 4])
        self.write_dump("b", p=[1, 2, 3, 5], p_signed=[1, 2, 3, 4])
        self.fails(2, "compare", "a", "b", "--diff", "a", saying="would replace an attachment")
        self.fails(4, "compare", "a", "b", "--diff", "missing/d", saying="no folder")
        self.fails(4, "compare", "a", "b", "--diff", "missing/d/", saying="no folder")

    def test_dumps_of_two_sizes(self):
        self.dump("a")
        self.dump("b", "--grid", "16")
        self.different("a", "b")
        result = self.run_program("compare", "a", "b", "--diff", "d")
        self.assertIn("/landing[0]: no difference images: ", result.stderr)
        self.assertIn("channel R: A is 32x32, B is 16x16", result.stdout)
        self.assertNotIn("looks like", result.stdout)

    def test_a_folder_that_is_no_dump(self):
        (self.folder / "a").mkdir()
        self.write_dump("b", z=[1, 2, 3, 4])
        for diff in ((), ("--diff", "d/")):
            self.fails(3, "compare", "a", "b", *diff, saying="a: has no manifest.json")
            self.fails(3, "compare", "b", "a", *diff, saying="a: has no manifest.json")


class Mistakes(CompareTest):
    def test_usage(self):
        self.pair([1, 2, 3, 4], [1, 2, 3, 4])
        self.fails(2, "compare", saying="two images")
        self.fails(2, "compare", "a.exr", saying="two images")
        self.fails(2, "compare", "a.exr", "b.exr", "a.exr", saying="unexpected argument")
        self.fails(2, "compare", "a.exr", ".", saying="is a folder")
        for value in ("-1", "nan", "inf", "x", "1e-3x", ""):
            for option in ("--tolerance", "--relative"):
                self.fails(2, "compare", "a.exr", "b.exr", f"{option}={value}")
        self.fails(2, "compare", "a.exr", "b.exr", "--tolerence", "1", saying="'--tolerance'")

    def test_unreadable(self):
        self.pair([1, 2, 3, 4], [1, 2, 3, 4])
        whole = (self.folder / "a.exr").read_bytes()
        self.fails(3, "compare", "a.exr", "missing.exr", saying="missing.exr")
        self.fails(3, "compare", "missing.exr", "a.exr", saying="missing.exr")
        self.fails(3, "compare", "a.exr", "ball.glb", saying="ball.glb")
        for length in (0, 3, 40, len(whole) // 2, len(whole) - 1):
            (self.folder / "cut.exr").write_bytes(whole[:length])
            self.fails(3, "compare", "a.exr", "cut.exr", saying="cut.exr")
        if pathlib.Path("/dev/null").exists():
            self.fails(3, "compare", "a.exr", "/dev/null", saying="plain file")

    def test_integers_that_floats_do_not_hold(self):
        pixel_type = b"Z\0" + struct.pack("<i", 2)
        (self.folder / "uint.exr").write_bytes(
            exr({"Z": [1, 2, 3, 4]}, 2, 2).replace(pixel_type, b"Z\0" + struct.pack("<i", 0)))
        self.fails(3, "compare", "uint.exr", "uint.exr", saying="32-bit integers")

    def test_a_report_that_does_not_arrive(self):
        if not pathlib.Path("/dev/full").exists():
            self.skipTest("no /dev/full here")
        self.pair([1, 2, 3, 4], [1, 2, 3, 5])
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "compare", "a.exr", "b.exr"], cwd=self.folder,
                                    stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 4, result.stderr)

    def test_sizes_that_only_a_header_promises(self):
        self.write("a.exr", {"Z": [1, 2, 3, 4]})
        huge = exr({"Z": [1, 2, 3, 4]}, 2, 2).replace(
            struct.pack("<iiii", 0, 0, 1, 1), struct.pack("<iiii", 0, 0, 99999999, 99999999))
        (self.folder / "huge.exr").write_bytes(huge)
        self.fails(3, "compare", "a.exr", "huge.exr", saying="huge.exr")


if __name__ == "__main__":
    main()
