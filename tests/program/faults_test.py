"""What goes wrong around the program: signals in every long command, sudden death, disks that fill up.
Nothing half-written may stay under a name that was asked for."""

import json
import os
import pathlib
import random
import resource
import signal
import struct
import subprocess
import time

import glb
import pictures
from output_test import wait_until_it_listens
from program import PROGRAM, SMALL, ProgramTest, main

WATER = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "water_plops.glb"

# A minute of work each, were they left alone. `reference` and `study` keep what they have for --resume.
LONG = {
    "render": ["ball.glb", "-r", "2000x2000", "--grid", "2048", "--map", "2048", "-o", "out.png", "--stats",
               "out.json"],
    "frames": ["ball.glb", *SMALL, "--frames", "0..9999", "--fps", "24", "-o", "f_%05d.png"],
    "dump": ["ball.glb", "-r", "2000x2000", "--grid", "2048", "-D", "further.share=1", "--dump",
             "dumped"],
    "digest": ["digest", "ball.glb", "-r", "2000x2000", "--grid", "2048", "-D", "further.share=1"],
    "reference": ["reference", "ball.glb", "-r", "256x256", "--seconds", "1000", "--error", "0.0001%", "-o",
                  "out.exr"],
    "study": ["study", "ball.glb", "-r", "512x512", "--repeat", "50", "-o", "studied"],
    "target": ["ball.glb", "-r", "1500x1500", "--target-error", "0.001%", "-o", "out.png"],
    "paper": ["paper", "-o", "papers"],
    "many lights": ["plan", "lights.glb"],
    "water": [str(WATER), "--time", "3000", "-o", "out.png"],
    "inspect": ["inspect", "ball.glb", "-o", "page.html"],
}

# Processor time that a command may take after a signal, seconds: work asks several times a second, and what
# is under way on each thread ends first. The wall clock would tell nothing on a busy machine.
MOST_AFTER = 2.0


def processor_time(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def of_ended_processes():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def is_whole(path):
    """Whether a file of the kinds written here can be read to its end."""
    data = path.read_bytes()
    if path.suffix == ".png":
        end = struct.pack(">I", 0) + b"IEND\xae\x42\x60\x82"
        return data.startswith(b"\x89PNG\r\n\x1a\n") and data.endswith(end)
    if path.suffix == ".json":
        json.loads(data)
    if path.suffix == ".exr":
        list(pictures.Exr(data).chunks())
    return True


def wait_for(process, folder, pattern):
    """Until there is such a file: the work has begun, however busy the machine is."""
    while not any(folder.glob(pattern)):
        if process.poll() is not None:
            raise AssertionError(f"the program ended without writing {pattern}")
        time.sleep(0.005)


class Signals(ProgramTest):
    def check_whole(self):
        for path in self.folder.rglob("*"):
            self.assertNotIn(".tmp", path.name)
            if path.is_file():
                self.assertTrue(is_whole(path), path)

    def test_every_long_command_stops_soon_and_leaves_whole_files(self):
        moments = random.Random(1)
        (self.folder / "lights.glb").write_bytes(glb.many_lights([10.0] * 800))
        for name, arguments in LONG.items():
            for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
                with self.subTest(command=name, signal=number):
                    if name == "reference":
                        self.need_ray_queries()
                    process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder,
                                               stdout=subprocess.DEVNULL,
                                               stderr=subprocess.PIPE, text=True)
                    wait_until_it_listens(process, number)
                    time.sleep(moments.uniform(0.0, 0.6))
                    ended = of_ended_processes()
                    used = processor_time(process)
                    process.send_signal(number)
                    _, talk = process.communicate(timeout=120)
                    self.assertEqual(process.returncode, code, talk)
                    self.assertLess(of_ended_processes() - ended - used, MOST_AFTER, name)
                    self.assertIn("interrupted", talk)
                    self.check_whole()


class Impatience(ProgramTest):
    def test_a_second_signal_ends_the_program_at_once_with_that_signals_exit_code(self):
        for first, second in ((signal.SIGINT, signal.SIGTERM), (signal.SIGTERM, signal.SIGINT)):
            process = subprocess.Popen([PROGRAM, *LONG["render"]], cwd=self.folder, stderr=subprocess.PIPE)
            wait_until_it_listens(process, signal.SIGINT)
            wait_until_it_listens(process, signal.SIGTERM)
            process.send_signal(first)
            process.send_signal(second)
            process.communicate(timeout=120)
            # Of two that wait together the system chooses which is first.
            self.assertIn(process.returncode, (130, 143))
            self.assertEqual([path.name for path in self.folder.rglob("*.tmp*")], [])


class Death(ProgramTest):
    def test_a_killed_program_leaves_no_half_written_file_under_its_name(self):
        moments = random.Random(2)
        arguments = ["ball.glb", *SMALL, "--frames", "0..999", "--fps", "24", "-o", "f_%05d.png"]
        for _ in range(12):
            process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            wait_for(process, self.folder, "f_*.png")
            time.sleep(moments.uniform(0.0, 0.3))
            process.kill()
            process.wait()
            for path in self.folder.glob("f_*.png"):
                self.assertTrue(is_whole(path), path)
                path.unlink()


class FullDisk(ProgramTest):
    """A limit on the size of files stands in for a disk that fills up: the write fails in the middle."""

    OUTPUTS = {
        "png": ["ball.glb", *SMALL, "-o", "out.png"],
        "exr": ["ball.glb", *SMALL, "-o", "out.exr"],
        "stats": ["ball.glb", *SMALL, "-o", "out.png", "--stats", "out.json"],
        "dump": ["ball.glb", *SMALL, "--dump", "dumped"],
        "frames": ["ball.glb", *SMALL, "--frames", "0..2", "--fps", "24", "-o", "f_%05d.png"],
        "reference": ["reference", "ball.glb", "-r", "64x48", "--seconds", "1", "-o", "out.exr"],
        "study": ["study", "ball.glb", *SMALL, "--repeat", "1", "--vary", "grid=16,32", "-o", "studied"],
    }

    def test_every_output_says_so_and_keeps_what_was_there(self):
        for name, arguments in self.OUTPUTS.items():
            with self.subTest(output=name):
                if name == "reference":
                    self.need_ray_queries()
                for old in ("out.png", "out.exr", "out.json"):
                    (self.folder / old).write_text("old")
                result = self.run_program(*arguments, "--quiet", preexec_fn=lambda: resource.setrlimit(
                    resource.RLIMIT_FSIZE, (700, 700)))
                self.assertEqual(result.returncode, 4, result.stderr)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertTrue(result.stderr.startswith("caustics: "), result.stderr)
                for old in ("out.png", "out.exr", "out.json"):
                    self.assertEqual((self.folder / old).read_text(), "old", f"{name}: {old}")
                for path in self.folder.rglob("*"):
                    self.assertNotIn(".tmp", path.name)

    def test_of_a_dump_that_does_not_fit_no_file_is_left(self):
        (self.folder / "dumped").mkdir()
        (self.folder / "dumped/notes.txt").write_text("mine")
        limit = (20000, 20000)
        result = self.run_program("ball.glb", *SMALL, "--dump", "dumped", "--quiet",
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit))
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertNotIn("/00_", result.stderr, "the first files fit")
        self.assertEqual([path.name for path in (self.folder / "dumped").iterdir()], ["notes.txt"])


if __name__ == "__main__":
    main()
