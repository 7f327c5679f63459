"""What ./caustics does before there is a program, in a copy of the repository's launchers with apt-get and
dpkg-query that only write down what they are asked."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = ["caustics", "CMakeLists.txt", "packages.txt", "cmake/setup.sh", "app/help.txt"]


class Launcher(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        for name in FILES:
            place = self.folder / name
            place.parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, place)
        self.tools = self.folder / "tools"
        self.tools.mkdir()
        self.tool("dpkg-query", "exit 0")
        self.tool("apt-get", f'echo "$*" >> "{self.folder}/asked"; [[ "$*" == *update* ]]')
        self.tool("sudo", 'shift $(($# > 0 && "$1" == "-n" ? 1 : 0)); exec "$@"')

    def tool(self, name, script):
        path = self.tools / name
        path.write_text(f"#!/usr/bin/env bash\n{script}\n")
        path.chmod(0o755)

    def run_launcher(self, *arguments):
        return subprocess.run([self.folder / "caustics", *arguments], text=True, capture_output=True,
                              env={**os.environ, "PATH": f"{self.tools}:{os.environ['PATH']}"},
                              stdin=subprocess.DEVNULL, timeout=60, check=False)

    def listed(self):
        """The packages of the first part of packages.txt."""
        lines = (self.folder / "packages.txt").read_text().partition("# For the tests")[0].splitlines()
        return [line for line in lines if line and not line.startswith("#")]

    def test_it_asks_for_the_packages_of_the_program_and_no_others(self):
        result = self.run_launcher("doctor")
        self.assertEqual(result.returncode, 5, result.stderr)
        asked = (self.folder / "asked").read_text().splitlines()
        install = [line for line in asked if " install " in line][-1]
        packages = install.split(" -y ")[1].split()
        self.assertEqual(packages, self.listed())
        self.assertIn("cmake", packages)
        self.assertNotIn("catch2", packages)

    def test_a_network_that_is_missing_is_said_in_one_line_and_nothing_is_built(self):
        self.tool("apt-get", "exit 100")
        result = self.run_launcher("doctor")
        self.assertEqual(result.returncode, 5)
        self.assertIn("no list of packages: is there a network?", result.stderr)
        self.assertFalse((self.folder / "build" / "release" / "CMakeCache.txt").exists())

    def test_help_and_version_need_nothing(self):
        for tool in ["apt-get", "dpkg-query", "cmake"]:
            self.tool(tool, "exit 1")
        helped = self.run_launcher("--help")
        self.assertEqual((helped.returncode, helped.stdout), (0, (ROOT / "app/help.txt").read_text()))
        version = self.run_launcher("--version")
        self.assertEqual(version.returncode, 0)
        self.assertRegex(version.stdout, r"^caustics \d+\.\d+\.\d+ \(not built yet")
        self.assertFalse((self.folder / "asked").exists())


if __name__ == "__main__":
    unittest.main()
