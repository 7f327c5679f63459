"""The pictures of the pages are what the program draws now, pixel by pixel: some, drawn by the commit's hash
(tests/support/drawn.py)."""

import os
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/images"), str(ROOT / "tests/support")]

import make  # noqa: E402: found by the line above
from drawn import drawn  # noqa: E402

REMEDY = "if that is meant: docs/images/make.py " + os.environ["CAUSTICS_PROGRAM"]


class DocsPictures(unittest.TestCase):
    def test_each_picture_is_what_the_program_draws(self):
        for name in (*drawn(make.PICTURES, 3), *drawn(make.PASSES, 3)):
            with self.subTest(picture=name):
                kept = make.read_png(make.path_of(name).read_bytes())
                now = make.picture(os.environ["CAUSTICS_PROGRAM"], name)
                self.assertEqual([len(row) for row in kept], [len(row) for row in now])
                differing = sum(a != b for row, other in zip(kept, now) for a, b in zip(row, other))
                self.assertEqual(differing, 0, f"values of {name}.png that differ; {REMEDY}")

    def test_no_picture_is_made_in_another_way(self):
        kept = {path.stem for path in (ROOT / "docs/images").iterdir() if path.suffix in (".png", ".svg")}
        self.assertEqual(kept, {*make.PICTURES, *make.TRACED, *make.MEASURED, *make.BROWSER})

    def test_each_pass_has_a_picture_and_shows_it(self):
        # No frame has light_step.
        others = {"shared", "template", "light_step"}
        folders = {path.parent.name for path in (ROOT / "passes").glob("*/*.glsl")} - others
        self.assertEqual(folders, set(make.PASSES))
        for name in make.PASSES:
            self.assertIn(f"]({name}.png)", (ROOT / f"passes/{name}/{name}.md").read_text())

    def test_a_picture_that_was_written_is_read_back_alike(self):
        rows = [bytes((7 * x * y + 90 * (x > y)) % 256 for x in range(3 * 17)) for y in range(11)]
        self.assertEqual(make.read_png(make.write_png(rows)), rows)


if __name__ == "__main__":
    unittest.main()
