"""What the tests of the program share: a scratch folder with a scene, and running the program."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import glb

PROGRAM = os.environ["CAUSTICS_PROGRAM"]
# Sizes at which a frame takes a fraction of a second.
SMALL = ["-r", "64x48", "--grid", "32", "--map", "32", "-D", "shadow=64"]


class ProgramTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "ball.glb").write_bytes(glb.scene())

    def run_program(self, *arguments, **options):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True,
                              capture_output=True, timeout=300, **options)

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def succeeds(self, *arguments, **options):
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def fails(self, code, *arguments, saying="", **options):
        """The program exits with this code, one line on stderr, nothing on stdout, no new files."""
        before = self.files()
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("caustics: "), lines[0])
        self.assertIn(saying, lines[0])
        self.assertEqual(self.files(), before)
        return lines[0]
