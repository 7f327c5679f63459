"""What each pass of a frame takes, by `caustics bench`."""

import fcntl
import json
import os
import re
import signal
import subprocess
import termios
import time

from program import PROGRAM, SMALL, ProgramTest, main

SHORT = [*SMALL, "--frames", "3"]
# By arguments: half of a run's time is the measuring of the memory's bandwidth.
REPORTS = {}


class Bench(ProgramTest):
    def report(self, *arguments):
        if arguments not in REPORTS:
            REPORTS[arguments] = self.succeeds("bench", "ball.glb", *SHORT, "--json", *arguments).stdout
        return json.loads(REPORTS[arguments])

    def report_against_gl(self, *arguments):
        result = self.run_program("bench", "ball.glb", *SHORT, "--json", "--against", "gl", *arguments)
        if result.returncode == 5:
            self.skip_without_gl(result.stderr)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def check_times(self, times, frames):
        """A median lies between the ends; of three frames one lies on it, the other two no nearer to it than
        the deviation, which is the middle one of 0 and their distances: the smaller of these."""
        self.assertEqual(frames, 3)
        self.assertGreaterEqual(times["least"], 0.0)
        below, above = times["median"] - times["least"], times["most"] - times["median"]
        self.assertAlmostEqual(times["deviation"], min(below, above))

    def test_each_pass_that_render_runs_is_measured(self):
        run = self.report("-t", "1")["runs"][0]
        self.assertEqual((run["settings"]["width"], run["settings"]["grid"]), (64, 32))
        self.succeeds("render", "ball.glb", *SMALL, "-o", "ball.png", "--stats", "s.json")
        stats = json.loads((self.folder / "s.json").read_text())
        wanted = {p["pass"]: (p["vertices"], p["primitives"], p["fragments"]) for p in stats["passes"]}
        for each in run["passes"]:
            measured = each["software"]
            self.assertEqual(tuple(measured[c] for c in ("vertices", "primitives", "fragments")),
                             wanted[each["pass"]], each["pass"])
            self.check_times(measured["milliseconds"], run["frames"])
            self.check_times(measured["processor_milliseconds"], run["frames"])
            self.assertGreater(measured["milliseconds"]["least"], 0.0)
        self.assertGreater(sum(p["processor_milliseconds"] for p in stats["passes"]), 0.0)
        picture = next(each for each in run["passes"] if each["pass"] == "tone_map")
        # Reads beauty, 16 bytes a pixel as RGBA32F, and writes the picture, 4; both once.
        self.assertEqual(picture["bytes"], 64 * 48 * (16 + 4))
        seconds = 1e-3 * picture["software"]["milliseconds"]["median"]
        # The curve to sRGB takes powers of three channels: tens of operations a pixel, not thousands.
        self.assertTrue(30 < picture["operations"] / (64 * 48) < 1000, picture["operations"])
        self.assertAlmostEqual(picture["software"]["share_of_bound"],
                               max(picture["bytes"] / run["bandwidth_bytes_per_second"],
                                   picture["operations"] / run["operations_per_second"]) / seconds)

    def test_a_frame_is_no_shorter_than_its_passes(self):
        run = self.report("-t", "1")["runs"][0]
        software = run["devices"]["software"]
        self.assertGreaterEqual(software["frame"]["milliseconds"]["least"],
                                software["all_passes"]["milliseconds"]["least"])
        self.assertGreater(run["peak_memory_bytes"], 2**20)
        self.assertEqual(run["digest"]["differing"], 0)

    def test_threads_are_measured_one_number_after_the_other_and_give_the_same_bits(self):
        report = self.report("--threads", "1,2")
        self.assertEqual([run["threads"] for run in report["runs"]], [1, 2])
        one, two = (run["devices"]["software"]["description"] for run in report["runs"])
        self.assertTrue(one.endswith("1 thread") and two.endswith("2 threads"), (one, two))
        self.assertEqual(*(run["digest"] for run in report["runs"]))

    def test_both_backends_are_measured_by_turns_with_as_many_threads(self):
        report = self.report_against_gl("-t", "1,2", "--grid", "16", "--map", "16")
        for run in report["runs"]:
            self.assertEqual(list(run["devices"]), ["software", "gl"])
            self.assertIsNone(run["digest"]["fault"])
            if "llvmpipe" in run["devices"]["gl"]["description"]:
                times = run["devices"]["gl"]["frame"]
                # One thread cannot take more processor time than there is; a clock's tick of leeway.
                if run["threads"] == 1:
                    self.assertLess(times["processor_milliseconds"]["least"],
                                    times["milliseconds"]["most"] + 10)
            for each in run["passes"]:
                self.assertEqual(each["software"]["vertices"], each["gl"]["vertices"])

    def test_other_bits_are_told_and_are_wrong_only_where_the_driver_must_give_the_same(self):
        lines = self.succeeds("doctor").stdout.splitlines()
        backend = next(l for l in lines if l.startswith("gl backend"))
        if "OpenGL" not in backend:
            self.skip_without_gl(backend)
        if not any(l.startswith("gl driver class") and l.endswith(" llvmpipe, fused") for l in lines):
            self.skipTest("needs the driver class 'llvmpipe, fused', whose bits must be the same")
        command = ["bench", "ball.glb", *SHORT, "--json", "--against", "gl", "-t", "1"]
        # A driver that leaves blending out: the first pass that blends is the first that differs.
        wrong = self.run_program(*command, env=dict(os.environ, LP_PERF="no_blend"))
        self.assertEqual(wrong.returncode, 1)
        fault = json.loads(wrong.stdout)["runs"][0]["digest"]["fault"]
        self.assertIn("pass 'caustic_cells[", fault)
        self.assertIn(f"caustics: {fault}\n", wrong.stderr)
        # So is one of several numbers of threads, of which each has its own process.
        wrong = self.run_program(*command[:-1], "1,2", env=dict(os.environ, LP_PERF="no_blend"))
        self.assertEqual(wrong.returncode, 1)
        self.assertEqual([run["digest"]["fault"] for run in json.loads(wrong.stdout)["runs"]], [fault] * 2)
        # One without fused multiply-add, whose class may differ.
        other = self.succeeds(*command, env=dict(os.environ, GALLIUM_OVERRIDE_CPU_CAPS="sse4.1"))
        digest = json.loads(other.stdout)["runs"][0]["digest"]
        self.assertGreater(digest["differing"], 0)
        self.assertIsNone(digest["fault"])

    def test_of_several_thread_counts_each_process_may_write_to_a_terminal_that_stops_others(self):
        def own_terminal():
            fcntl.ioctl(2, termios.TIOCSCTTY, 0)
            modes = termios.tcgetattr(2)
            modes[3] |= termios.TOSTOP
            termios.tcsetattr(2, termios.TCSANOW, modes)
            signal.alarm(60)  # where a process is stopped, the program would wait for ever

        code, lines = self.on_terminal("bench", "ball.glb", *SMALL, "--frames", "1", "-t", "1,2",
                                       start_new_session=True, preexec_fn=own_terminal,
                                       stdout=subprocess.DEVNULL)
        self.assertEqual(code, 0, lines)
        shown = [line for line in lines if re.search(r"  [\d.]+ [mu]?s$", line)]
        self.assertGreater(len(shown), 2, lines)

    def test_the_table_has_a_row_for_each_pass_and_says_that_bits_are_the_same(self):
        text = self.succeeds("bench", "ball.glb", *SHORT, "-t", "1").stdout
        rows = [line.split()[0] for line in text.splitlines() if line.startswith("  ")]
        for name in ("pass", "caster_map", "landing", "tone_map", "all", "frame"):
            self.assertEqual(rows.count(name), 1, text)
        self.assertIn("the same before and after", text)

    def test_wrong_words_are_refused(self):
        self.fails(2, "bench", "ball.glb", "--against", "vulkan", saying="--against")
        self.fails(2, "bench", "ball.glb", "--against", "gl", "--backend", "gl", saying="--against")
        self.fails(2, "bench", "ball.glb", "--threads", "1,two", saying="--threads")
        self.fails(2, "bench", "ball.glb", "--frames", "0", saying="--frames")
        self.fails(3, "bench", "missing.glb", "--threads", "1,2", saying="missing.glb")

    def test_opengl_is_looked_for_alone_and_against_the_software_device(self):
        none = dict(os.environ, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent.json")
        for which in (["--backend", "gl"], ["--against", "gl"]):
            self.fails(5, "bench", "ball.glb", *SHORT, *which, saying="--backend software", env=none)

    def test_an_interruption_ends_the_processes_of_all_threads_counts(self):
        command = [PROGRAM, "bench", "ball.glb", "--frames", "10000", "--threads", "1,2"]
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        stdout, stderr = process.communicate(timeout=60)  # the pipes close when all of them have ended
        self.assertEqual((process.returncode, stdout), (130, ""))
        self.assertIn("interrupted", stderr)

    def test_off_a_terminal_progress_is_told_after_two_seconds_and_once_a_second_at_most(self):
        process = subprocess.Popen([PROGRAM, "bench", "ball.glb", *SMALL, "--frames", "10000", "-t", "1"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   text=True)
        # Most of the time it stands still, so that the machine is free for others.
        time.sleep(0.3)
        process.send_signal(signal.SIGSTOP)
        time.sleep(2)
        process.send_signal(signal.SIGCONT)
        first = process.stderr.readline()
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        *further, last = process.communicate(timeout=60)[1].splitlines()
        self.assertEqual(last, "caustics: interrupted; no incomplete file is left")
        seconds = [float(re.search(r"  ([\d.]+) s$", line)[1]) for line in (first.rstrip(), *further)]
        self.assertGreaterEqual(seconds[0], 2)
        for before, after in zip(seconds, seconds[1:]):
            self.assertGreaterEqual(after - before, 0.99)  # what is printed has three digits


if __name__ == "__main__":
    main()
