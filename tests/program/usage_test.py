"""Help, versions, misspelt words, sizes out of range: what is said before anything is rendered."""

import json
import os
import re

from program import SMALL, ProgramTest, main

COMMANDS = ["render", "plan", "probe", "digest", "parity", "compare", "reference", "study", "bench",
            "doctor"]


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
        rows = [line for line in self.succeeds("render", "--help-markdown").stdout.splitlines()
                if line.startswith("| `-")]
        valued = [row for row in rows if " " in row.split(" | ")[0][2:].replace("`, `", "")]
        self.assertGreater(len(valued), 20)
        for row in valued:
            if "-D KEY" not in row:
                self.assertTrue(row.split(" | ")[-2].strip(), row)

    def test_smaller_sizes_of_digest_are_its_defaults_in_the_help(self):
        text = self.succeeds("digest", "--help").stdout
        self.assertIn("1..16384 pixels each (default 320x180)", text)
        self.assertIn("Sizes are small unless given: width 320, height 180, grid 128, map 128, shadow 512.",
                      text)

    def tables(self, command):
        """The rows of a command's help by the headings over them: {heading: names}."""
        _, *tables = self.succeeds(command, "--help-markdown").stdout.rstrip("\n").split("\n\n")
        head = lambda table: re.match(r"\| (.*?) \|", table)[1]
        return {head(table): re.findall(r"(?m)^\| `(.*?)` \| ", table) for table in tables}

    def test_what_is_a_commands_own_stands_before_what_frames_have_in_common(self):
        of_frames = ["View", "Method", "Running", "Settings for -D"]
        own = {"render": ["Output", "On demand"], "plan": ["Output"], "inspect": ["Page"],
               "probe": ["What to probe"], "study": ["Study", "Output"], "digest": ["Options"],
               "parity": ["Options"], "bench": ["Options"]}
        common = self.tables("plan")
        for command, headings in own.items():
            tables = self.tables(command)
            named = [heading for heading in tables if heading not in ("Arguments", "Help")]
            first = named.index("View")
            self.assertEqual(named[:first], headings, command)
            self.assertEqual([each for each in named[first:] if each in of_frames], of_frames, command)
            for heading in of_frames[:2]:
                self.assertEqual(tables[heading], common[heading], (command, heading))
            names = [name for table in tables.values() for name in table]
            self.assertEqual(len(names), len(set(names)), command)

    def test_a_setting_has_an_option_or_a_row_of_its_own(self):
        keys = set(self.settings_of_stats())
        for command in ("render", "plan", "inspect", "probe", "study", "digest", "parity", "bench",
                        "reference"):
            tables = self.tables(command)
            listed = tables["Settings for -D"]
            options = [word.split(" ")[0] for name, rows in tables.items() if name != "Settings for -D"
                       for row in rows for word in row.split("`, `")]
            text = self.succeeds(command, "--help-markdown").stdout
            own = re.search(r"`-D KEY=VALUE`.*listed below, or (.*) as above", text)[1].split(", ")
            self.assertEqual(set(own) & set(listed), set(), command)
            self.assertLessEqual(set(own) | set(listed), keys, command)
            if command != "reference":  # which has no maps
                self.assertEqual(set(own) | set(listed), keys, command)
            option = lambda key: "--" + key.replace("_", "-")
            self.assertEqual([key for key in listed if option(key) in options], [], command)
            self.assertEqual([key for key in own if option(key) not in options], ["width", "height"], command)
            self.assertIn("--resolution", options, command)

    def settings_of_stats(self):
        self.succeeds("ball.glb", *SMALL, "--stats", "s.json")
        return json.loads((self.folder / "s.json").read_text())["settings"]

    def test_lines_fit_a_terminal(self):
        for command in COMMANDS:
            for line in self.succeeds(command, "--help").stdout.splitlines():
                self.assertLessEqual(len(line), 112, line)

    def test_version_names_the_backends_that_work(self):
        self.assertRegex(self.succeeds("--version").stdout,
                         r"\Acaustics \d+\.\d+\.\d+ .*\nsoftware: .*\nOpenGL: .*\n\Z")
        self.assertEqual(self.succeeds("-V").stdout, self.succeeds("--version").stdout)


class Settings(ProgramTest):
    def settings_of_help(self):
        text = self.succeeds("render", "--help-markdown").stdout
        listed = re.findall(r"^\| `([a-z._]+)` \|", text[text.index("| Settings for -D |"):], re.MULTILINE)
        options = re.search(r"-D KEY=VALUE.*listed below, or (.*) as above", text)[1].split(", ")
        return sorted(listed + options)

    def test_keys_of_stats_are_those_of_the_help(self):
        stats = self.stats(*SMALL)
        self.assertEqual(sorted(stats), self.settings_of_help())

    def test_values_of_stats_can_be_given_back(self):
        stats = self.stats(*SMALL, "-D", "splat.sigma=0.9", "-D", "exposure=-1.5", "--estimator", "paper")
        self.assertEqual((stats["splat.sigma"], stats["exposure"], stats["estimator"]), (0.9, -1.5, "paper"))
        again = [word for key, value in stats.items() for word in ("-D", f"{key}={value}") if key != "camera"]
        self.assertEqual(self.stats(*again), stats)

    def stats(self, *arguments):
        self.succeeds("ball.glb", *arguments, "--stats", "s.json")
        return json.loads((self.folder / "s.json").read_text())["settings"]


class Mistakes(ProgramTest):
    def test_nothing_given(self):
        self.fails(2, saying="no scene given")
        for command in ("render", "plan", "probe"):
            self.fails(2, command, saying="no scene given")

    def test_misspelt_command(self):
        self.fails(2, "rendr", "ball.glb", saying=", did you mean 'render'?")
        line = self.fails(2, "banana", "ball.glb", saying="see 'caustics --help'")
        self.assertNotIn("did you mean", line)

    def test_nothing_is_suggested_that_is_not_near(self):
        for saying, arguments in (("; see 'caustics render --help'", ("--banana", "7")),
                                  ("; see 'caustics render --help'", ("-x",)),
                                  ("; see 'caustics render --help'", ("-D", "banana=7")),
                                  ("; known: 'beauty', 'caustic', ", ("--aov", "banana")),
                                  ("; known: 'eye'", ("--camera", "banana"))):
            line = self.fails(2, "ball.glb", *arguments, saying=saying)
            self.assertNotIn("did you mean", line)

    def test_misspelt_option(self):
        for typed, meant in (("--gird", "--grid"), ("--resolutoin", "--resolution"),
                             ("--assume-solids", "--assume-solid")):
            self.fails(2, "ball.glb", typed, "7", saying=f"did you mean '{meant}'?")
            self.fails(2, "ball.glb", typed + "=7", saying=f"did you mean '{meant}'?")

    def test_unknown_lanes(self):
        wrong = dict(os.environ, CAUSTICS_LANES="avx3")
        self.fails(2, "ball.glb", saying="CAUSTICS_LANES is 'avx3'; this build and processor have: scalar",
                   env=wrong)

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
        self.fails(3, "a\nb\033.glb", saying="a\\x0ab\\x1b.glb")

    def test_outputs_of_unknown_format_or_named_twice(self):
        for name in ("a.bmp", "a", ".png", "a.png "):
            self.fails(2, "ball.glb", "-o", name, saying=".png, .jpg, .tif, .exr, .hdr, .mp4")
        self.fails(2, "ball.glb", "-o", "a.png", "-o", "a.png", saying="-o names it twice")
        self.fails(2, "ball.glb", "-o", "a.png", "--aov", "depth", saying="-o FILE.exr")


class Plan(ProgramTest):
    def test_says_what_is_to_be_expected(self):
        result = self.succeeds("plan", "ball.glb")
        self.assertIn("'sun'", result.stdout)
        self.assertIn("closed mesh: light enters and leaves", result.stdout)
        self.assertNotIn("\033", result.stdout)
        self.assertEqual(result.stderr, "")

    def test_a_setting_that_changes_nothing_is_named_with_the_reason(self):
        nothing = "splits=4 changes nothing here: "
        self.assertIn("  " + nothing, self.succeeds("plan", "ball.glb", *SMALL, "-D", "splits=4").stdout)
        said = self.succeeds("plan", "ball.glb", *SMALL, "-D", "splits=4", "--json").stdout
        notes = json.loads(said)["notes"]
        self.assertEqual([note.startswith(nothing) for note in notes].count(True), 1)
        self.assertIn("note: " + nothing, self.succeeds("ball.glb", *SMALL, "-D", "splits=4").stderr)
        followed = "-D", "further.share=0", "-D", "splits=4"
        self.assertNotIn("changes nothing", self.succeeds("ball.glb", *SMALL, *followed).stderr)
        # What comes with a preset was not given.
        self.assertNotIn("changes nothing", self.succeeds("ball.glb", "--preview").stderr)

    def test_doctor_goes_on_without_openimageio(self):
        (self.folder / "broken").mkdir()
        for version in ("2.2", "2.3", "2.4", "2.5", "3.0", "3.1"):
            (self.folder / f"broken/libOpenImageIO.so.{version}").write_text("")
        result = self.succeeds("doctor", env={**os.environ, "LD_LIBRARY_PATH": str(self.folder / "broken")})
        self.assertRegex(result.stdout, r"(?m)^OpenImageIO +cannot be used: images need .*OpenImageIO: .")
        self.assertRegex(result.stdout, r"(?m)^Embree  ")

    def test_doctor_tells_what_opengl_is_there_or_why_there_is_none(self):
        lines = [line
                 for line in self.succeeds("doctor").stdout.splitlines() if line.startswith("gl backend")]
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, "OpenGL [0-9]|cannot be used|--backend software")


if __name__ == "__main__":
    main()
