"""The OpenGL backend from outside: the same pictures, the comparison of both, and what happens without it."""

import json
import os
import pathlib
import pty
import re
import shutil
import subprocess

from program import PROGRAM, SMALL, ProgramTest, main

SCENES = sorted((pathlib.Path(__file__).resolve().parents[2] / "scenes").glob("*.glb"))


class GlTest(ProgramTest):
    def setUp(self):
        super().setUp()
        lines = self.succeeds("doctor").stdout.splitlines()
        works = [line for line in lines if line.startswith("gl backend") and "OpenGL" in line]
        if not works:
            self.skip_without_gl(next(l for l in lines if l.startswith("gl backend")))
        self.is_llvmpipe = "llvmpipe" in works[0]

    def report(self, *arguments, code=0, **options):
        """The parity report of one scene; on a driver that nobody measured the exit code is not judged."""
        result = self.run_program("parity", "--json", *arguments, **options)
        report = json.loads(result.stdout)["scenes"]
        if report[0]["driver"]["measured"]:
            self.assertEqual(result.returncode, code, result.stderr)
        else:
            self.assertIn("nobody has measured", result.stderr)
        return report


class Study(GlTest):
    def test_both_backends_have_rows_of_their_own(self):
        self.succeeds("study", "ball.glb", *SMALL, "--repeat", "1", "--vary", "grid=16", "--backend", "both",
                      "-o", "out")
        document = json.loads((self.folder / "out/study.json").read_text())
        rows = document["rows"]
        self.assertEqual([(r["values"]["grid"], r["backend"]) for r in rows],
                         [(grid, backend) for grid in ("32", "16") for backend in ("software", "gl")])
        self.assertIn("OpenGL", rows[1]["device"])
        self.assertEqual(len(document["sentences"]), 2)
        self.assertTrue(document["sentences"][1].startswith("gl: grid from 16 to 32: "))
        for name in ("software", "gl"):
            self.assertTrue(any(r["pareto"] for r in rows if r["backend"] == name))
        if self.is_llvmpipe:
            self.assertEqual(rows[0]["figures"], rows[1]["figures"])
            self.assertEqual(rows[2]["figures"], rows[3]["figures"])


class Pictures(GlTest):
    def test_png_and_exr_are_those_of_the_software_device(self):
        if not self.report("ball.glb", *SMALL)[0]["driver"]["measured"]:
            self.skipTest("nobody has measured this driver")
        files = []
        for backend in ("software", "gl"):
            names = [f"{backend}.png", f"{backend}.exr"]
            self.succeeds("ball.glb", *SMALL, "--backend", backend, "-o", names[0], "-o", names[1],
                          "--aov", "beauty,caustic,direct,position,normal,depth,coverage")
            files.append([(self.folder / name).read_bytes() for name in names])
        self.assertEqual(files[0], files[1])

    def test_a_frame_loop_makes_nothing_after_its_first_frame(self):
        self.succeeds("ball.glb", *SMALL, "--backend", "gl", "--frames", "7..10", "-o", "f.%03d.png",
                      "--stats", "s.json")
        pictures = [(self.folder / f"f.{n:03}.png").read_bytes() for n in range(7, 11)]
        self.assertEqual(pictures, pictures[:1] * 4)
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertIn("OpenGL", stats["device"])
        self.assertTrue(any(p["milliseconds"] > 0 for p in stats["passes"]))
        frames = stats["frames"]
        self.assertEqual(frames["count"], 4)
        first, last = frames["made_by_first"], frames["made_by_all"]
        self.assertEqual(first.pop("read_backs"), 0)
        self.assertGreater(last.pop("read_backs"), 0)  # what is written to files
        self.assertEqual(first, last)


class Talk(GlTest):
    def test_summaries_name_the_device_that_ran(self):
        for backend, name in (("software", "on software, "), ("gl", "on OpenGL, ")):
            closing = self.succeeds("ball.glb", *SMALL, "--backend", backend).stderr.splitlines()[-1]
            self.assertIn(name, closing)
        compared = self.run_program("parity", "ball.glb", "ball.glb", *SMALL).stdout.splitlines()
        self.assertRegex(compared[0], "^software: software, .*; gl: OpenGL, ")

    def test_compiling_shaders_shows_progress_on_a_terminal(self):
        controller, terminal = pty.openpty()
        cold = dict(os.environ, MESA_SHADER_CACHE_DISABLE="true")
        command = [PROGRAM, "ball.glb", *SMALL, "--backend", "gl"]
        with subprocess.Popen(command, cwd=self.folder, env=cold, stderr=terminal) as run:
            os.close(terminal)
            shown = b""
            try:
                while block := os.read(controller, 4096):
                    shown += block
            except OSError:  # the terminal's other end is closed
                pass
        os.close(controller)
        self.assertEqual(run.returncode, 0)
        counts = re.findall(r"compiling shaders (\d+) of (\d+): \w+", shown.decode())
        self.assertGreater(len(counts), 5)
        self.assertEqual([int(n) for n, _ in counts], list(range(1, len(counts) + 1)))
        self.assertEqual({int(of) for _, of in counts}, {len(counts)})


class Parity(GlTest):
    def test_sample_scenes_are_equal_on_both_backends(self):
        for report in self.report():
            with self.subTest(scene=report["scene"]):
                self.assertGreater(len(report["isolated"]), 10)
                self.assertGreater(len(report["whole_frame"]), 10)
                if report["driver"]["measured"]:
                    self.assertTrue(report["within_allowances"])
                    self.assertTrue(all(count["equal"] for count in report["counts"]))

    def test_odd_sizes_and_other_settings(self):
        sphere = next(s for s in SCENES if s.name == "glass_sphere.glb")
        for settings in (["-r", "333x217", "--grid", "101", "--map", "151"],
                         ["-r", "1x1", "--grid", "1", "--map", "1"],
                         ["--splat", "point", "--estimator", "paper", "--weights", "paper"],
                         ["--interfaces", "1"]):
            with self.subTest(settings=settings):
                self.report(sphere, *settings)

    def test_text_has_a_row_for_each_attachment(self):
        result = self.run_program("parity", "ball.glb", *SMALL)
        for words in ("caustic_map", "landing_flux", "samples passed", "the whole frame"):
            self.assertIn(words, result.stdout)

    def test_differences_are_found_told_and_dumped(self):
        if not self.is_llvmpipe:
            self.skipTest("needs llvmpipe, which can be made to compute otherwise")
        # Without fused multiply-add llvmpipe interpolates otherwise.
        unfused = dict(os.environ, GALLIUM_OVERRIDE_CPU_CAPS="sse4.1")
        result = self.run_program("parity", "ball.glb", "-r", "61x47", "--dump", "d", env=unfused)
        self.assertEqual(result.returncode, 1)
        self.assertIn("nobody has measured", result.stderr)
        self.assertIn("more than is allowed", result.stdout)
        names = sorted(p.name for p in (self.folder / "d").iterdir())
        self.assertIn("manifest.json", names)
        exrs = [n for n in names if n.endswith(".exr")]
        self.assertGreater(len(exrs), 0)
        self.assertEqual(len(exrs) % 3, 0)
        same = self.run_program("compare",
                                *(f"d/{n}" for n in exrs if n.startswith("00_") and "mask" not in n))
        self.assertEqual(same.returncode, 1)

    def test_wrong_usage(self):
        self.fails(2, "parity", "ball.glb", "ball.glb", "--dump", "d", saying="one scene")
        self.fails(3, "parity", "missing.glb", saying="missing.glb")


class Absence(ProgramTest):
    def test_a_device_that_does_not_exist(self):
        self.fails(5, "ball.glb", "--backend", "gl", "--gl-device", "99", saying="--backend software")

    def test_no_driver(self):
        # GLVND, which finds the drivers, is told to look where there are none.
        none = dict(os.environ, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent.json")
        for command in (["ball.glb", "--backend", "gl"], ["parity", "ball.glb"]):
            self.fails(5, *command, saying="--backend software", env=none)
        self.succeeds("ball.glb", *SMALL, env=none)

    def test_no_libraries(self):
        # In a mount namespace of its own, where that is allowed, empty files lie over the libraries.
        if not shutil.which("unshare") or not os.path.exists("/sbin/ldconfig"):
            self.skipTest("needs unshare and ldconfig")
        if "built without OpenGL" in self.succeeds("doctor").stdout:
            self.skipTest("built without OpenGL")
        libraries = subprocess.run(["/sbin/ldconfig", "-p"], text=True, capture_output=True).stdout
        for hidden, missing in ((["libEGL.so.1"], "libEGL.so.1 is missing"),
                                (["libOpenGL.so.0", "libGL.so.1"],
                                 "libOpenGL.so.0 and libGL.so.1 are missing")):
            paths = [line.split()[-1]
                     for line in libraries.splitlines() if line.split()[:1] and line.split()[0] in hidden]
            mounts = "".join(f"mount --bind /dev/null {path} && " for path in paths)
            if subprocess.run(["unshare", "-m", "sh", "-c", mounts + "true"],
                              capture_output=True).returncode != 0:
                self.skipTest("no mount namespaces here")
            for backend, code in (("gl", 5), ("software", 0)):
                command = [PROGRAM, "ball.glb", *SMALL, "--backend", backend]
                result = subprocess.run(["unshare", "-m", "sh", "-c", mounts + 'exec "$0" "$@"', *command],
                                        text=True,
                                        capture_output=True, cwd=self.folder)
                self.assertEqual(result.returncode, code, result.stderr)
                if code:
                    self.assertIn(missing, result.stderr)
                    self.assertIn("--backend software", result.stderr)

    def test_a_driver_that_is_too_old(self):
        old = dict(os.environ, MESA_GL_VERSION_OVERRIDE="4.4")
        result = self.run_program("ball.glb", *SMALL, "--backend", "gl", env=old)
        if "Mesa" not in self.succeeds("doctor").stdout:
            self.skipTest("needs Mesa, which can be made to look old")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertIn("4.5", result.stderr)


if __name__ == "__main__":
    main()
