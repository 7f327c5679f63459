"""What the tests of the program share: a scratch folder with a scene, running the program, and a main that
names the tests that were skipped."""

import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import unittest

import glb

PROGRAM = os.environ["CAUSTICS_PROGRAM"]
# Sizes at which a frame takes a fraction of a second.
# Through two surfaces, in few passes.
SMALL = ["-r", "64x48", "--grid", "32", "--map", "32", "-D", "shadow=64", "-D", "further.share=1"]


# What ctest takes for skipped, as in tests/support/skip.hpp.
ALL_SKIPPED = 4


def name_of(test):
    """A method counts once, however many parts it has."""
    return getattr(test, "test_case", test).id().removeprefix("__main__.")


def main():
    """Runs the tests of the file that calls it, and prints what ./test reads: a line for each method that was
    skipped, wholly or in part, with the cause, and how many there are of each kind."""
    result = unittest.main(exit=False).result
    failed = {name_of(test) for test, _ in result.failures + result.errors}
    skipped = {name_of(test): cause for test, cause in reversed(result.skipped)}
    skipped = {name: cause for name, cause in skipped.items() if name not in failed}
    for name, cause in sorted(skipped.items()):
        print(f"skipped: {name}: {cause}")
    passed = result.testsRun - len(failed) - len(skipped)
    print(f"methods: {passed} passed, {len(failed)} failed, {len(skipped)} skipped")
    sys.exit(1 if failed else ALL_SKIPPED if skipped and not passed else 0)


class ProgramTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "ball.glb").write_bytes(glb.scene())

    def run_program(self, *arguments, **options):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True,
                              capture_output=True, timeout=300, **options)

    def skip_without_gl(self, cause):
        """Skips the test; where the environment says that OpenGL must be there, it fails instead."""
        if os.environ.get("CAUSTICS_REQUIRE_GL") == "1":
            self.fail(cause)
        self.skipTest("no OpenGL: " + " ".join(cause.removeprefix("caustics: ").split()))

    def need_ray_queries(self):
        """Skips the test where the program has no light tracer."""
        line = next(l for l in self.succeeds("doctor").stdout.splitlines() if l.startswith("Embree"))
        if "not in this build" in line:
            self.skipTest("no Embree: this build traces no rays")

    def on_terminal(self, *arguments, stream="stderr", **options):
        """The exit code of a run of which one stream is a terminal, and each line that it showed there."""
        controller, terminal = pty.openpty()
        command = [PROGRAM, *map(str, arguments)]
        with subprocess.Popen(command, cwd=self.folder, **{stream: terminal}, **options) as run:
            os.close(terminal)
            shown = b""
            try:
                while block := os.read(controller, 4096):
                    shown += block
            except OSError:  # the terminal's other end is closed
                pass
        os.close(controller)
        return run.returncode, re.split(r"\r\n|\r\x1b\[K", shown.decode())

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
