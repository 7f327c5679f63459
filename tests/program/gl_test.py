"""The OpenGL backend from outside: the same pictures, the comparison of both, and what happens without it."""

import json
import os
import pathlib
import re
import shutil
import subprocess

from pictures import Exr
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
        self.driver_class = next(line for line in lines if line.startswith("gl driver class"))[22:].strip()
        # Whose values must all be those of the software device.
        self.is_exact = self.driver_class == "llvmpipe, fused"

    def report(self, *arguments, **options):
        """The parity reports, all within the bounds of the driver's class."""
        result = self.run_program("parity", "--json", *arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)["scenes"]


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
        if self.is_exact:
            self.assertEqual(rows[0]["figures"], rows[1]["figures"])
            self.assertEqual(rows[2]["figures"], rows[3]["figures"])


class Pictures(GlTest):
    def test_png_and_exr_are_those_of_the_software_device(self):
        if not self.is_exact:
            self.skipTest(f"this driver's class is '{self.driver_class}', whose pictures may differ")
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
        # The report of one scene has them in lines of its own.
        alone = self.run_program("parity", "ball.glb", *SMALL).stdout.splitlines()
        self.assertEqual([line for line in alone if "software, " in line], alone[1:2])
        self.assertEqual([line for line in alone if "OpenGL, " in line], alone[2:3])
        self.assertEqual(alone[0], "ball.glb")

    def test_compiling_shaders_shows_progress_on_a_terminal(self):
        cold = dict(os.environ, MESA_SHADER_CACHE_DISABLE="true")
        # The passes up to the caustic: the others' shaders take the driver as long again.
        code, shown = self.on_terminal("ball.glb", *SMALL, "--backend", "gl", "--aov", "caustic", "-o",
                                       "caustic.exr", env=cold)
        self.assertEqual(code, 0)
        counts = re.findall(r"compiling shaders (\d+) of (\d+): \w+", "\n".join(shown))
        self.assertGreater(len(counts), 5)
        self.assertEqual([int(n) for n, _ in counts], list(range(1, len(counts) + 1)))
        self.assertEqual({int(of) for _, of in counts}, {len(counts)})

    def test_a_study_names_each_shader_that_it_compiles(self):
        code, shown = self.on_terminal("study", "ball.glb", *SMALL, "--repeat", "1", "--vary", "grid=32",
                                       "--backend", "gl", "-o", "out", stdout=subprocess.DEVNULL)
        self.assertEqual(code, 0)
        named = re.findall(r"compiling shader (.*?) {2}", "\n".join(shown))
        plan = json.loads(self.succeeds("plan", "ball.glb", *SMALL, "--json").stdout)
        # A pass of several lights, branches or views has one shader.
        names = {re.split(r"[.\[]", each["pass"])[0] for each in plan["passes"]}
        self.assertEqual(names - set(named), set())
        # A study reads the caustic from the layers beside the picture, for which plan was not asked.
        self.assertLessEqual(set(named) - names, {"first_hit"})


class Parity(GlTest):
    def test_sample_scenes_are_equal_on_both_backends(self):
        # Of light that is followed, a few surfaces: each more is the same passes again.
        small = ["-r", "160x90", "--grid", "64", "--map", "64", "-D", "shadow=256"]
        for report in self.report("-D", "bounces=4", *small):
            with self.subTest(scene=report["scene"]):
                self.assertGreater(len(report["isolated"]), 10)
                self.assertGreater(len(report["whole_frame"]), 10)
                self.assertEqual(report["driver_class"], self.driver_class)
                self.assertTrue(report["within_bounds"])
                self.assertEqual(report["missing"], [])
                if self.is_exact:
                    self.assertEqual(report["differing_values"], 0)

    def test_rough_and_pierced_casters_are_followed_alike(self):
        for name in ("frosted_tumbler", "pierced_ball"):
            scene = SCENES[0].parent / "glass" / f"{name}.glb"
            [report] = self.report(scene, "-D", "bounces=4", "-r", "80x45", "--grid", "32", "--map", "64")
            with self.subTest(scene=name):
                self.assertTrue(any(part["pass"].startswith("walk") for part in report["isolated"]))
                if self.is_exact:
                    self.assertEqual(report["differing_values"], 0)

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

    def without_fused(self, **more):
        """The environment of llvmpipe on a processor without fused multiply-add."""
        if not self.is_llvmpipe:
            self.skipTest("needs llvmpipe, which can be made to compute otherwise")
        return dict(os.environ, GALLIUM_OVERRIDE_CPU_CAPS="sse4.1", **more)

    def test_a_driver_that_rounds_otherwise_is_judged_by_its_own_class(self):
        unfused = self.without_fused()
        self.assertIn("llvmpipe, unfused", self.succeeds("doctor", env=unfused).stdout)
        sphere = next(s for s in SCENES if s.name == "glass_sphere.glb")
        report = self.report(sphere, "-r", "160x90", "--grid", "64", "--map", "64", env=unfused)[0]
        self.assertEqual(report["driver_class"], "llvmpipe, unfused")
        self.assertGreater(report["differing_values"], 1000)
        self.assertTrue(report["within_bounds"])
        verdicts = {a["kind"]: a["verdict"] for a in report["isolated"] if a["differing_values"] > 0}
        # Since Mesa 25 llvmpipe's points cover other texels, fused or not.
        kinds = ["rasterized map"] + ["flux map"] * ("other points" in self.driver_class)
        self.assertEqual(verdicts, dict.fromkeys(kinds, "within"))

    def test_differences_are_found_told_and_dumped(self):
        # A driver that leaves blending out, in a class that allows no difference and in one that allows some.
        for env in (dict(os.environ, LP_PERF="no_blend"), self.without_fused(LP_PERF="no_blend")):
            result = self.run_program("parity", "ball.glb", "-r", "61x47", "--dump", "d", env=env)
            self.assertEqual(result.returncode, 1)
            self.assertIn("BEYOND the bounds of the class 'llvmpipe, ", result.stdout)
            names = sorted(p.name for p in (self.folder / "d").iterdir())
            self.assertIn("manifest.json", names)
            exrs = [n for n in names if n.endswith(".exr")]
            self.assertGreater(len(exrs), 0)
            self.assertEqual(len(exrs) % 3, 0)
            self.check_dumped(result.stdout, exrs)
            same = self.run_program("compare",
                                    *(f"d/{n}" for n in exrs if n.startswith("00_") and "mask" not in n))
            self.assertEqual(same.returncode, 1)
            shutil.rmtree(self.folder / "d")

    def check_dumped(self, report, exrs):
        """The mask marks the texels that differ, and the report tells the values of the first of them."""
        stem = next(n for n in exrs if n.startswith("00_")).rsplit(".", 2)[0]
        parts = [self.folder / f"d/{stem}.{part}.exr" for part in ("software", "gl", "mask")]
        files = [Exr(part.read_bytes()) for part in parts]
        software, gl, mask = (file.values() for file in files)
        differ = [any(software[c][i] != gl[c][i] for c in software) for i in range(len(gl["R"]))]
        # A list of what is wrong: unittest would compare whole lists for minutes to show their difference.
        marked = next(iter(mask.values()))
        self.assertEqual([i for i, v in enumerate(differ) if v != (marked[i] != 0)][:9], [])
        number = r"((?:[-+.\de]+ ?)+)"
        x, y, a, b = re.search(
            rf"first at (\d+),(\d+) from the bottom left: software {number} \| gl {number}", report).groups()
        place = (files[0].height - 1 - int(y)) * files[0].width + int(x)
        for told, values in ((a, software), (b, gl)):
            held = sorted(values[c][place] for c in values)
            for one, other in zip(sorted(map(float, told.split())), held, strict=True):
                self.assertAlmostEqual(one, other, delta=1e-8 * max(abs(other), 1e-30))

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

    def test_drivers_that_cannot_be_trusted_are_refused_with_the_cause(self):
        if "Mesa" not in self.succeeds("doctor").stdout:
            self.skipTest("needs Mesa, which has them")
        claims = dict(GALLIUM_DRIVER="softpipe", MESA_GL_VERSION_OVERRIDE="4.5",
                      MESA_GLSL_VERSION_OVERRIDE="450")
        for name, advice, variables in (("softpipe", "unset GALLIUM_DRIVER", claims),
                                        ("512 bits", "unset LP_NATIVE_VECTOR_WIDTH",
                                         dict(LP_NATIVE_VECTOR_WIDTH="512"))):
            with self.subTest(name):
                env = dict(os.environ, **variables)
                self.assertIn(name, self.succeeds("doctor", env=env).stdout)
                self.fails(5, "ball.glb", "--backend", "gl", saying=name, env=env)
                self.fails(5, "parity", "ball.glb", saying=advice, env=env)

    def test_a_driver_that_is_too_old(self):
        old = dict(os.environ, MESA_GL_VERSION_OVERRIDE="4.4")
        result = self.run_program("ball.glb", *SMALL, "--backend", "gl", env=old)
        if "Mesa" not in self.succeeds("doctor").stdout:
            self.skipTest("needs Mesa, which can be made to look old")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertIn("4.5", result.stderr)


if __name__ == "__main__":
    main()
