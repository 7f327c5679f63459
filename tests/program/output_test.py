"""What render and digest write: complete files, equal bytes, and nothing beside them."""

import json
import os
import pathlib
import re
import signal
import subprocess
import time

import glb
import pictures
from program import PROGRAM, SMALL, ProgramTest, main


class Outputs(ProgramTest):
    def test_default_output_is_named_after_the_scene(self):
        result = self.succeeds("ball.glb", *SMALL)
        self.assertEqual(self.files(), ["ball.glb", "ball.png"])
        self.assertEqual(result.stdout, "")
        self.assertIn("ball.png: 64x48, grid 32, map 32 in ", result.stderr)
        self.assertNotIn("\033", result.stderr)

    def test_quiet_says_nothing(self):
        for quiet in ("--quiet", "-q"):
            result = self.succeeds("ball.glb", *SMALL, quiet)
            self.assertEqual(result.stdout + result.stderr, "")

    def test_verbose_adds_effects_and_passes_with_time_and_reason(self):
        plain, verbose = (self.succeeds("ball.glb", *SMALL, *more) for more in ((), ("-v",)))
        self.assertEqual(verbose.stdout, "")
        self.assertRegex(verbose.stderr, r"(?m)^effects\n(  (yes|no) .*\n)+passes\n")
        self.assertRegex(verbose.stderr, r"(?m)^  tone_map +[0-9.]+ ms +a picture for a screen is wanted$")
        self.assertRegex(verbose.stderr, r"(?m)^not run\n(  \S+ .*\n)+")
        self.assertNotIn("\npasses\n", plain.stderr)

    def test_one_pixel(self):
        self.succeeds("ball.glb", "-r", "1x1", "--grid", "1", "--map", "1", "-o", "dot.png")
        self.assertTrue((self.folder / "dot.png").read_bytes().startswith(b"\x89PNG"))

    def test_too_large_for_the_machine_is_refused_before_rendering(self):
        if os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") > 64 << 30:
            self.skipTest("this machine can render it")
        self.fails(2, "ball.glb", "-r", "16384x16384", "--grid", "8192", "--map", "8192",
                   "-o", "all.exr", "--aov", "beauty,caustic,direct,position,normal",
                   saying="of memory")

    def test_bytes_do_not_depend_on_threads_or_run(self):
        files = []
        for number, threads in enumerate((1, 2, 7, 1)):
            png, exr = f"{number}.png", f"{number}.exr"
            self.succeeds("ball.glb", *SMALL, "-t", threads, "-o", png, "-o", exr,
                          "--aov", "beauty,caustic,direct,position,normal,depth,coverage")
            files.append([(self.folder / name).read_bytes() for name in (png, exr)])
        for other in files[1:]:
            self.assertEqual(files[0], other)

    def test_stats_and_dump(self):
        self.succeeds("ball.glb", *SMALL, "--stats", "s.json", "--dump", "passes/of/ball")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(stats["settings"]["grid"], 32)
        self.assertGreater(len(stats["passes"]), 4)
        light = stats["lights"][0]
        self.assertEqual(sum(light["vertices"].values()), 32 * 32)
        flux = light["flux"]
        lost = sum(flux[name][0] for name in flux
                   if name not in ("unit", "entered", "residual"))
        self.assertAlmostEqual(lost / flux["entered"][0], 1.0, places=3)
        folder = self.folder / "passes/of/ball"
        manifest = json.loads((folder / "manifest.json").read_text())
        self.assertEqual(sorted(each["file"] for each in manifest["attachments"] + manifest["tables"]),
                         sorted(p.name for p in folder.iterdir() if p.suffix == ".exr"))
        for attachment in manifest["attachments"]:
            self.assertRegex(attachment["sha256"], r"\A[0-9a-f]{64}\Z")

    def drawn(self, *arguments):
        self.succeeds("ball.glb", *SMALL, "-o", "a.png", *arguments)
        return (self.folder / "a.png").read_bytes()

    def test_what_is_only_looked_at_has_4_samples_a_pixel(self):
        one, four = self.drawn("-D", "samples=1"), self.drawn("-D", "samples=4")
        self.assertNotEqual(one, four)
        self.assertEqual(self.drawn(), four)
        self.assertEqual(self.drawn("-o", "b.png"), four)
        for measured in (["--stats", "s.json"], ["--dump", "passes"], ["-o", "a.exr"]):
            self.assertEqual(self.drawn(*measured), one, measured)
        demand = "--target-error", "50"
        self.assertEqual(self.drawn(*demand), self.drawn(*demand, "-D", "samples=1"))

    def test_layers_and_stated_error_are_those_of_one_sample(self):
        files = []
        for samples in (1, 4):
            self.drawn("-D", f"samples={samples}", "-o", "a.exr", "--aov",
                       "caustic,direct,position,normal,depth,coverage,error")
            files.append((self.folder / "a.exr").read_bytes())
        self.assertEqual(*files)

    def test_commands_that_look_at_a_pixel_take_one_sample(self):
        for command in (["probe", "--pixel", "1,1"], ["inspect"], ["inspect", "--against", "iterations=1"]):
            self.fails(2, command[0], "ball.glb", *SMALL, *command[1:], "-D", "samples=4",
                       saying="leave out -D samples")
        self.fails(2, "inspect", "ball.glb", *SMALL, "--against", "samples=4", saying="leave out -D samples")

    def test_replaces_a_file_and_keeps_a_link(self):
        (self.folder / "old.png").write_text("old")
        (self.folder / "link.png").symlink_to("old.png")
        self.succeeds("ball.glb", *SMALL, "-o", "link.png")
        self.assertTrue((self.folder / "link.png").is_symlink())
        self.assertTrue((self.folder / "old.png").read_bytes().startswith(b"\x89PNG"))


class Progress(ProgramTest):
    def test_says_what_is_left_of_a_picture_that_takes_seconds(self):
        for side in (1024, 2048, 4096):
            result = self.succeeds("ball.glb", "-r", f"{side}x{side}", "-t", "1")
            found = re.search(r"(?m)^pass (\d+) of (\d+): .+, about \d[0-9.]* (s|min \d+ s) left  \d",
                              result.stderr)
            if found:
                break
        self.assertTrue(found, result.stderr)
        self.assertLess(int(found[1]), int(found[2]))


class Formats(ProgramTest):
    """The same frame in every format: what the formats lose, and no more."""

    def differences(self, a, b):
        result = self.run_program("compare", a, b, "--json")
        return [channel["absolute"]["maximum"] for channel in json.loads(result.stdout)["channels"]
                if channel["channel"] in ("R", "G", "B")]

    def test_hold_the_picture_of_the_png_and_the_light_of_the_exr(self):
        names = ["a.png", "a.jpg", "a.jpeg", "a.tif", "a.TIFF", "a.exr", "a.hdr"]
        self.succeeds("ball.glb", *SMALL, *(word for name in names for word in ("-o", name)))
        # Sixteen bits: the picture before it was rounded to eight, so at most half a step of those away; and
        # of 9,216 values one by nearly as much.
        fine = max(self.differences("a.png", "a.tif"))
        self.assertTrue(0.4 / 255 < fine <= 0.501 / 255, fine)
        self.assertEqual(self.differences("a.tif", "a.TIFF"), [0, 0, 0])
        self.assertEqual((self.folder / "a.jpg").read_bytes(), (self.folder / "a.jpeg").read_bytes())
        jpeg = max(self.differences("a.png", "a.jpg"))
        self.assertTrue(0 < jpeg < 0.15, jpeg)
        # Eight bits of mantissa for the brightest channel, which is at most what the file holds anywhere.
        brightest = max(max(v) for c, v in pictures.Exr((self.folder / "a.exr").read_bytes()).values().items()
                        if c != "A")
        self.assertTrue(0 < max(self.differences("a.exr", "a.hdr")) <= brightest / 128)

    def test_bytes_do_not_depend_on_the_run(self):
        for stem in "ab":
            self.succeeds("ball.glb", *SMALL, "-o", stem + ".jpg", "-o", stem + ".tif", "-o", stem + ".hdr")
        for extension in ("jpg", "tif", "hdr"):
            self.assertEqual((self.folder / f"a.{extension}").read_bytes(),
                             (self.folder / f"b.{extension}").read_bytes())

    def test_are_numbered_in_a_row_of_frames(self):
        self.succeeds("ball.glb", *SMALL, "--frames", "8..9", "-o", "f%02d.jpg", "-o", "f%02d.tif")
        self.assertEqual(self.files(), ["ball.glb", "f08.jpg", "f08.tif", "f09.jpg", "f09.tif"])
        again = self.succeeds("ball.glb", *SMALL, "--frames", "8..9", "-o", "f%02d.jpg", "-o", "f%02d.tif",
                              "--resume")
        self.assertIn("nothing was drawn", again.stderr)


class StandardOutput(ProgramTest):
    def test_is_the_png_that_a_file_holds(self):
        self.succeeds("ball.glb", *SMALL)
        result = subprocess.run([PROGRAM, "ball.glb", *SMALL, "-o", "-"], cwd=self.folder,
                                capture_output=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, (self.folder / "ball.png").read_bytes())
        self.assertEqual(self.files(), ["ball.glb", "ball.png"])

    def test_that_is_a_terminal_is_refused(self):
        leader, follower = os.openpty()
        result = subprocess.run([PROGRAM, "ball.glb", "-r", "4096x4096", "-o", "-"], cwd=self.folder,
                                stdout=follower, stderr=subprocess.PIPE, text=True)
        os.close(leader)
        os.close(follower)
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)

    def test_that_is_full_is_said(self):
        if not pathlib.Path("/dev/full").exists():
            self.skipTest("no /dev/full here")
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "ball.glb", *SMALL, "--quiet", "-o", "-"], cwd=self.folder,
                                    stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (4, 1), result.stderr)

    def test_takes_one_picture(self):
        self.fails(2, "ball.glb", "-o", "-", "--frames", "0..1", saying="%04d")


class Layers(ProgramTest):
    """A red ball over a floor far from the world's origin, under an open sky."""

    def test_each_holds_what_its_name_says(self):
        origin = (300, 20, -500)
        red = {"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [0.8, 0.2, 0.05, 1]}}
        (self.folder / "far.glb").write_bytes(glb.scene(red, origin=origin))
        names = ["coverage", "depth", "normal", "position", "direct", "caustic", "beauty"]
        self.succeeds("far.glb", *SMALL, "-o", "far.exr", "--aov", ",".join(names))
        file = pictures.Exr((self.folder / "far.exr").read_bytes())
        self.assertEqual((file.width, file.height), (64, 48))
        channels = file.values()
        expected = ["R", "G", "B", "A", "depth.R", "coverage.R"] + [
            f"{name}.{c}" for name in ("caustic", "direct", "position", "normal") for c in "RGB"]
        self.assertEqual(sorted(channels), sorted(expected))
        ball, floor, sky = (self.texel(channels, 64 * row + 32) for row in (15, 45, 1))
        self.assertGreater(ball["R"], ball["G"])
        self.assertGreater(ball["G"], ball["B"])
        self.assertEqual([floor[f"normal.{c}"] for c in "RGB"], [0, 1, 0])
        self.assertAlmostEqual(floor["position.R"], origin[0], delta=0.1)
        self.assertAlmostEqual(floor["position.G"], origin[1], places=4)
        self.assertTrue(origin[2] < floor["position.B"] < origin[2] + 3)
        # The sun shines straight down, and the floor is nearer to the camera than the ball.
        self.assertEqual([floor[f"direct.{c}"] for c in "RGB"], [1000] * 3)
        self.assertTrue(1 < floor["depth.R"] < ball["depth.R"] < 4)
        self.assertEqual((floor["coverage.R"], ball["coverage.R"]), (1, 1))
        self.assertEqual({sky[name] for name in sky if "." in name}, {0})
        self.assertEqual(sky["A"], 1)

    def texel(self, channels, i):
        return {name: values[i] for name, values in channels.items()}


class NumericFault(ProgramTest):
    def test_names_the_pixel_and_writes_no_picture(self):
        # The largest values that a Radiance file can hold: their sum over the sky overflows.
        (self.folder / "bright.hdr").write_bytes(
            b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" + b"\xff\xff\xff\xff" * 128)
        self.fails(7, "ball.glb", *SMALL, "--environment", "bright.hdr", "--quiet",
                   saying="beauty is inf at pixel 0,")


class Unwritable(ProgramTest):
    def test_is_found_out_before_rendering(self):
        (self.folder / "folder.png").mkdir()
        os.mkfifo(self.folder / "pipe.png")
        for name in ("folder.png", "pipe.png", "missing/a.png", "/dev/null/a.png"):
            for option in ("-o", "--stats"):
                self.fails(4, "ball.glb", "-r", "4096x4096", option, name)
        (self.folder / "file").write_bytes(b"")
        self.fails(4, "ball.glb", *SMALL, "--dump", "file")

    def test_a_file_that_is_cut_short_by_a_limit_is_not_left(self):
        def limit_files():
            import resource
            resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))
        (self.folder / "old.png").write_text("old")
        self.fails(4, "ball.glb", *SMALL, "-o", "old.png", "--quiet", preexec_fn=limit_files)
        self.assertEqual((self.folder / "old.png").read_text(), "old")

    def test_full_standard_output(self):
        if not pathlib.Path("/dev/full").exists():
            self.skipTest("no /dev/full here")
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "plan", "ball.glb"], cwd=self.folder, stdout=full,
                                    stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("standard output cannot be written", result.stderr)

    def test_a_reader_that_has_had_enough_is_no_news(self):
        reading, writing = os.pipe()
        os.close(reading)
        with os.fdopen(writing, "w") as pipe:
            result = subprocess.run([PROGRAM, "plan", "ball.glb"], cwd=self.folder, stdout=pipe,
                                    stderr=subprocess.PIPE, text=True)
        self.assertEqual((result.returncode, result.stderr), (4, ""))


def wait_until_it_listens(process, number):
    """Until the program has a handler for the signal: the mask of caught signals in its status says so."""
    for _ in range(6000):
        for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
            if line.startswith("SigCgt:") and int(line.split()[1], 16) >> (number - 1) & 1:
                return
        time.sleep(0.01)
    raise AssertionError("the program never watched for the signal")


class Signals(ProgramTest):
    def test_stops_without_leaving_anything(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(signal=number):
                process = subprocess.Popen(
                    [PROGRAM, "ball.glb", "-r", "1600x1600", "--grid", "1024", "--map", "1024",
                     "-t", "1", "-o", "large.png", "-o", "large.exr"],
                    cwd=self.folder, stderr=subprocess.PIPE, text=True)
                wait_until_it_listens(process, number)
                process.send_signal(number)
                _, talk = process.communicate(timeout=120)
                self.assertEqual(process.returncode, code, talk)
                self.assertIn("interrupted", talk)
                self.assertEqual(self.files(), ["ball.glb"])


class Tools(ProgramTest):
    def test_digest_is_the_same_for_every_number_of_threads(self):
        first = self.succeeds("digest", "ball.glb", "ball.glb", "-t", "1").stdout.splitlines()
        self.assertEqual(first[:len(first) // 2], first[len(first) // 2:])
        for line in first:
            self.assertRegex(line, r"\Aball\.glb \S+ \S+ [0-9a-f]{64}\Z")
        second = self.succeeds("digest", "ball.glb", "-t", "3").stdout.splitlines()
        self.assertEqual(first[:len(first) // 2], second)

    def test_digest_has_four_words_a_line_whatever_the_names(self):
        glass = glb.glass(thicknessFactor=1)
        glass["extensions"]["KHR_materials_dispersion"] = {"dispersion": 1}
        document, blob = glb.unpack(glb.scene(glass))
        document["nodes"][2]["name"] = "the high sun"
        (self.folder / "two balls.glb").write_bytes(glb.pack(document, blob))
        lines = self.succeeds("digest", "two balls.glb").stdout.splitlines()
        for line in lines:
            self.assertRegex(line, r"\Atwo%20balls\.glb \S+ \S+ [0-9a-f]{64}\Z")
        self.assertIn("[the%20high%20sun%20", " ".join(lines))


if __name__ == "__main__":
    main()
