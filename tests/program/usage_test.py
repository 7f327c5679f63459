"""Help, versions, misspelt words, sizes out of range: what is said before anything is rendered."""

import os
import unittest

from program import ProgramTest

COMMANDS = ["render", "plan", "probe", "digest", "parity", "compare", "reference", "study", "doctor"]


class Help(ProgramTest):
    def test_goes_to_stdout_with_examples_first(self):
        for command in COMMANDS:
            for arguments in ([command, "--help"], [command, "-h"], ["help", command]):
                result = self.succeeds(*arguments)
                self.assertEqual(result.stderr, "")
                self.assertLess(result.stdout.index("Examples:"), result.stdout.index("Usage:"))
                self.assertIn("caustics " + command, result.stdout)

    def test_lists_every_command(self):
        text = self.succeeds("--help").stdout
        for command in COMMANDS:
            self.assertIn("\n  " + command, text)

    def test_every_valued_option_of_render_has_its_default(self):
        for line in self.succeeds("render", "--help").stdout.splitlines():
            words = line.split()
            if line.startswith("  -") and len(words) > 1 and words[1].isupper():
                if words[0] not in ("-D", "--environment"):
                    self.assertIn("default", line)

    def test_lines_fit_a_terminal(self):
        for command in COMMANDS:
            for line in self.succeeds(command, "--help").stdout.splitlines():
                self.assertLessEqual(len(line), 112, line)

    def test_version_is_one_line(self):
        self.assertRegex(self.succeeds("--version").stdout, r"\Acaustics \d+\.\d+\.\d+ .*\n\Z")


class Mistakes(ProgramTest):
    def test_nothing_given(self):
        self.fails(2, saying="no scene given")
        for command in ("render", "plan", "probe"):
            self.fails(2, command, saying="no scene given")

    def test_misspelt_command(self):
        self.fails(2, "rendr", "ball.glb", saying="'render'")

    def test_misspelt_option(self):
        for typed, meant in (("--gird", "--grid"), ("--resolutoin", "--resolution"),
                             ("--assume-solids", "--assume-solid")):
            self.fails(2, "ball.glb", typed, "7", saying=f"did you mean '{meant}'?")
            self.fails(2, "ball.glb", typed + "=7", saying=f"did you mean '{meant}'?")

    def test_unknown_lanes(self):
        wrong = dict(os.environ, CAUSTICS_LANES="avx3")
        self.fails(2, "ball.glb", saying="CAUSTICS_LANES is 'avx3'; this build and processor have: scalar", env=wrong)

    def test_misspelt_key(self):
        self.fails(2, "ball.glb", "-D", "splat.sigam=1", saying="did you mean 'splat.sigma'?")

    def test_missing_value(self):
        self.fails(2, "ball.glb", "--grid", saying="--grid")

    def test_values_out_of_range(self):
        for option, value in (("--grid", "0"), ("--grid", "8193"), ("--grid", "12x"),
                              ("--grid", "99999999999999999999"), ("--map", "-1"),
                              ("--iterations", "1001"), ("--estimator", "newtom"),
                              ("--splat", "cells"), ("--interfaces", "3"), ("-r", "0x1"),
                              ("-r", "16385x1"), ("-r", "640"), ("-r", "640x"), ("-t", "0"),
                              ("--exposure", "nan"), ("-D", "grid"), ("-D", "map=1e3"),
                              ("-D", "light.samples=0"), ("-D", "light.samples=257"),
                              ("-D", "emissive.lights=yes"),
                              ("--aov", "deph"), ("--backend", "vulkan")):
            with self.subTest(option=option, value=value):
                self.fails(2, "ball.glb", option, value)

    def test_frames_need_a_place_for_their_number(self):
        self.fails(2, "ball.glb", "--frames", "0..3", "-o", "a.png", saying="%04d")
        self.fails(2, "ball.glb", "--frames", "3..0", saying="first frame comes first")
        self.fails(2, "ball.glb", "--frames", "0..x", saying="--frames")
        self.fails(2, "ball.glb", "--frames", "0..1", "--dump", "d", saying="one frame")

    def test_second_scene(self):
        self.fails(2, "ball.glb", "ball.glb", saying="unexpected argument")

    def test_unknown_camera_names_the_nearest(self):
        self.fails(2, "ball.glb", "--camera", "eey", saying="'eye'")

    def test_control_characters_do_not_break_the_line(self):
        self.fails(3, "a\nb\033.glb")

    def test_outputs_of_unknown_format_or_named_twice(self):
        self.fails(2, "ball.glb", "-o", "a.jpg", saying=".png or .exr")
        self.fails(2, "ball.glb", "-o", "a", saying=".png or .exr")
        self.fails(2, "ball.glb", "-o", "a.png", "-o", "a.png", saying="named twice")
        self.fails(2, "ball.glb", "-o", "a.png", "--aov", "depth", saying="-o FILE.exr")


class Plan(ProgramTest):
    def test_says_what_is_to_be_expected(self):
        result = self.succeeds("plan", "ball.glb")
        self.assertIn("'sun'", result.stdout)
        self.assertIn("closed mesh: light enters and leaves", result.stdout)
        self.assertNotIn("\033", result.stdout)
        self.assertEqual(result.stderr, "")

    def test_doctor_tells_what_opengl_is_there_or_why_there_is_none(self):
        lines = [line for line in self.succeeds("doctor").stdout.splitlines() if line.startswith("gl backend")]
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, "OpenGL [0-9]|cannot be used|--backend software")


if __name__ == "__main__":
    unittest.main()
