"""Scenes that move: frames, moments, resuming, films, and being interrupted."""

import json
import os
import shutil
import signal
import struct
import subprocess
import time
import unittest

import glb
from pictures import Exr
from program import PROGRAM, SMALL, ProgramTest, main

FFMPEG = shutil.which("ffmpeg")


BALL_AND_SUN = [([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], "VEC3", 0, "translation"),
                ([-0.7, 0.0, 0.0, 0.714], [-0.7, 0.1, 0.0, 0.707], "VEC4", 2, "rotation")]
CAMERA = [([0.0, 1.2, 4.0], [1.0, 1.2, 4.0], "VEC3", 3, "translation")]


def moving(seconds=1.0, channels=BALL_AND_SUN, camera=True):
    """glb.scene(), whose ball goes from x = 0 to x = 1 and whose sun turns a little."""
    document, blob = glb.unpack(glb.scene())
    if not camera:
        del document["cameras"], document["nodes"][3]["camera"]
    animation = {"name": "go", "samplers": [], "channels": []}
    for first, last, kind, node, path in channels:
        for values, shape in (([0.0, seconds], "SCALAR"), (first + last, kind)):
            packed = struct.pack(f"<{len(values)}f", *values)
            document["bufferViews"].append(
                {"buffer": 0, "byteOffset": len(blob), "byteLength": len(packed)})
            blob += packed
            document["accessors"].append(
                {"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126, "count": 2,
                 "type": shape})
        count = len(document["accessors"])
        animation["samplers"].append({"input": count - 2, "output": count - 1})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": node, "path": path}})
    document["animations"] = [animation]
    document["buffers"] = [{"byteLength": len(blob)}]
    return glb.pack(document, blob)


class MovingTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "go.glb").write_bytes(moving())

    def picture(self, name):
        return (self.folder / name).read_bytes()


class Frames(MovingTest):
    def test_a_frame_alone_equals_the_frame_of_a_row(self):
        for more in ([], ["-t", "1"]):
            self.succeeds("go.glb", *SMALL, "--frames", "0..5", "--fps", "6", "-o", "row.%d.png",
                          "-o", "row.%d.exr", *more)
            row = [self.picture(f"row.{n}.png") for n in range(6)]
            self.assertEqual(len(set(row)), 6)
            for n in (0, 2, 5):
                self.succeeds("go.glb", *SMALL, "--frames", n, "--fps", "6", "-o", "one.%03d.png",
                              "-o", "one.%d.exr")
                self.assertEqual(self.picture(f"one.{n:03}.png"), row[n])
                self.assertEqual(self.picture(f"one.{n}.exr"), self.picture(f"row.{n}.exr"))
            self.succeeds("go.glb", *SMALL, "--time", "0.5", "-o", "still.png", "-o", "still.exr")
            self.assertEqual(self.picture("still.png"), row[3])

    def test_the_animation_begins_again(self):
        self.succeeds("go.glb", *SMALL, "--frames", "1..9", "--fps", "4", "-o", "f.%d.png")
        for n in (1, 2, 3):
            self.assertEqual(self.picture(f"f.{n}.png"), self.picture(f"f.{n + 4}.png"))
        self.assertEqual(self.picture("f.4.png"), self.picture("f.8.png"))

    def test_the_device_keeps_what_it_made(self):
        # But for the hierarchy of what moves, which is made anew; and for the rays of pilots, of which each
        # frame has its own, on the software device.
        for backend in ("software", "gl"):
            result = self.run_program("go.glb", *SMALL, "--backend", backend, "--frames", "0..3", "-D",
                                      "samples=4", "-D", "ambient.occlusion=off", "-o", "f.%d.png", "--stats",
                                      "s.json", "--quiet")
            if result.returncode == 5 and backend == "gl":
                self.skip_without_gl(result.stderr)
            self.assertEqual(result.returncode, 0, result.stderr)
            frames = json.loads((self.folder / "s.json").read_text())["frames"]
            first, last = frames["made_by_first"], frames["made_by_all"]
            first.pop("read_backs"), last.pop("read_backs")
            of_hierarchies = 3 * 3  # tables, frames after the first
            if backend == "software":
                first.pop("textures"), last.pop("textures")
            else:
                first["textures"] += of_hierarchies
            self.assertEqual(first, last, backend)
            self.succeeds("go.glb", *SMALL, "--backend", backend, "--frames", "3", "-D", "samples=4", "-D",
                          "ambient.occlusion=off", "-o", "one.%d.png")
            self.assertEqual(self.picture("one.3.png"), self.picture("f.3.png"), backend)

    def test_the_times_of_a_row_are_those_of_all_its_frames(self):
        self.succeeds("go.glb", *SMALL, "--frames", "0..7", "--fps", "8", "-o", "f.%d.png",
                      "--stats", "s.json")
        times = json.loads((self.folder / "s.json").read_text())["milliseconds"]
        parts = [times[part] for part in ("load", "prepare", "passes", "write")]
        for part in parts:
            self.assertGreater(part, 0)
        self.assertLessEqual(sum(parts), times["total"])

    def test_both_backends_draw_the_same_moment(self):
        result = self.run_program("parity", "go.glb", *SMALL, "--time", "0.7")
        if result.returncode == 5:
            self.skip_without_gl(result.stderr)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_a_camera_moves_as_its_file_says_and_one_that_is_added_stands_still(self):
        depth = ["-r", "32x24", "-o", "f.%d.exr", "--aov", "position", "--frames", "0..1", "--fps", "2"]
        for scene, moves in ((moving(channels=CAMERA), True), (moving(camera=False), False)):
            (self.folder / "go.glb").write_bytes(scene)
            self.succeeds("go.glb", *depth)
            first, then = (Exr(self.picture(f"f.{n}.exr")).values() for n in (0, 1))
            self.assertNotEqual(first, then)
            # Where only the ball moves, the last row shows the same floor.
            last = [{name: values[-32:] for name, values in each.items()} for each in (first, then)]
            self.assertEqual(last[0] != last[1], moves)

    def test_a_name_holds_the_frame_where_it_has_a_field_and_as_wide_as_that_says(self):
        names = {"a%d.png": "a7.png", "b%04d.png": "b0007.png", "c%01d.png": "c7.png", "%%d.png": "%7.png",
                 "%x%02d.png": "%x07.png", "%09dd%d.png": "000000007d%d.png"}
        names |= {name: name for name in ("d%0d.png", "e%00d.png", "f%05.png", "g%12d.png", "h%05x.png",
                                          "i%0:d.png", "j%.png")}
        outputs = [word for name in names for word in ("-o", name)]
        self.succeeds("ball.glb", "-r", "16x16", "--grid", "8", "--map", "8", "--frames", "7", *outputs)
        self.assertEqual(self.files(), sorted(["ball.glb", "go.glb", *names.values()]))

    def test_a_still_scene_says_once_that_nothing_moves(self):
        result = self.succeeds("ball.glb", *SMALL, "--frames", "0..2", "-o", "f.%d.png")
        self.assertEqual(result.stderr.count("nothing moves"), 1)
        self.assertEqual(self.picture("f.0.png"), self.picture("f.2.png"))
        self.assertNotIn("nothing moves", self.succeeds(
            "go.glb", *SMALL, "--frames", "0..1", "-o", "f.%d.png").stderr)

    def test_wrong_wishes_are_refused(self):
        self.fails(2, "go.glb", "--time", "1", "--frames", "0..1", "-o", "f.%d.png", saying="--time")
        self.fails(2, "go.glb", "--time", "-1", saying="0..1e6")
        self.fails(2, "go.glb", "--time", "nan", saying="--time")
        self.fails(2, "go.glb", "--fps", "0", saying="--fps")
        self.fails(2, "go.glb", *SMALL, "--animation", "stop", "--quiet", saying="0 'go'")
        self.fails(2, "ball.glb", *SMALL, "--animation", "1", "--quiet", saying="the file has none")
        self.fails(2, "go.glb", "--resume", saying="--frames")

    def test_plan_says_what_moves(self):
        self.assertIn("for 1 s, then again; 1 mesh", self.succeeds("plan", "go.glb").stdout)
        document = json.loads(self.succeeds("plan", "go.glb", "--json").stdout)
        self.assertEqual(document["animation"], {"seconds": 1.0, "meshes": [0]})
        (self.folder / "long.glb").write_bytes(moving(1.23456))
        self.assertIn("for 1.235 s, then again; 1 mesh", self.succeeds("plan", "long.glb").stdout)
        self.assertNotIn("moves ", self.succeeds("plan", "go.glb", "--animation", "none").stdout)


class Resume(MovingTest):
    ROW = ["go.glb", *SMALL, "--frames", "0..3", "--fps", "4", "-o", "f.%d.png", "-o", "f.%d.exr"]

    def test_draws_what_is_missing_or_of_another_size(self):
        self.succeeds(*self.ROW)
        whole = {name: self.picture(name) for name in self.files() if name.startswith("f.")}
        (self.folder / "f.1.png").unlink()
        (self.folder / "f.2.exr").write_bytes(whole["f.2.exr"][:20])
        (self.folder / "f.0.png").write_bytes(whole["f.1.png"])
        result = self.succeeds(*self.ROW, "--resume")
        self.assertIn("2 frames were there already", result.stderr)
        for name in ("f.1.png", "f.2.png", "f.2.exr", "f.3.exr"):
            self.assertEqual(self.picture(name), whole[name])
        self.assertEqual(self.picture("f.0.png"), whole["f.1.png"])  # it is whole: that is all asked
        self.assertIn("nothing was drawn", self.succeeds(*self.ROW, "--resume").stderr)
        other = [*self.ROW, "--resume", "-r", "32x24"]
        self.assertNotIn("already", self.succeeds(*other).stderr)

    def test_a_film_cannot_be_resumed(self):
        self.fails(2, "go.glb", "--frames", "0..3", "-o", "a.mp4", "--resume", saying="--resume")


class Films(MovingTest):
    def probe(self, name):
        self.assertTrue(shutil.which("ffprobe"))
        text = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
             "stream=width,height,nb_read_frames,pix_fmt,r_frame_rate", "-of", "json", name],
            cwd=self.folder, capture_output=True, text=True, check=True).stdout
        return json.loads(text)["streams"][0]

    @unittest.skipUnless(FFMPEG and shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_every_kind_has_all_frames_at_their_rate(self):
        for kind, rate in (("mp4", "12/1"), ("mkv", "12/1"), ("webm", "12/1"), ("gif", "12/1")):
            with self.subTest(kind=kind):
                self.succeeds("go.glb", *SMALL, "-r", "33x21", "--frames", "2..5", "--fps", "12",
                              "-o", f"a.{kind}")
                stream = self.probe(f"a.{kind}")
                size = (33, 21) if kind == "gif" else (34, 22)
                self.assertEqual((stream["width"], stream["height"]), size)
                self.assertEqual(stream["nb_read_frames"], "4")
                if kind in ("mp4", "mkv"):
                    self.assertEqual(stream["pix_fmt"], "yuv420p")
                    self.assertEqual(stream["r_frame_rate"], rate)
        self.assertEqual([n for n in self.files() if n.startswith(".")], [])

    @unittest.skipUnless(FFMPEG and shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_without_frames_it_shows_the_whole_animation(self):
        self.succeeds("go.glb", *SMALL, "--fps", "8", "-o", "a.mp4", "-o", "f.%02d.png")
        self.assertEqual(self.probe("a.mp4")["nb_read_frames"], "8")
        self.assertEqual(len([n for n in self.files() if n.startswith("f.")]), 8)
        self.fails(2, "ball.glb", *SMALL, "-o", "b.mp4", "--quiet", saying="--frames A..B")

    @unittest.skipUnless(FFMPEG, "ffmpeg is not installed")
    def test_colours_are_those_of_the_pictures(self):
        self.succeeds("go.glb", *SMALL, "--frames", "1..1", "-o", "a.mkv", "-o", "a.%d.png")
        def pixels(name):
            return subprocess.run([FFMPEG, "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt",
                                   "gray", "pipe:1"], cwd=self.folder, capture_output=True,
                                  check=True).stdout
        film, picture = pixels("a.mkv"), pixels("a.1.png")
        self.assertEqual(len(film), len(picture))
        mean = [sum(values) / len(values) for values in (film, picture)]
        self.assertLess(abs(mean[0] - mean[1]), 3.0)

    def test_without_ffmpeg_it_is_refused_beforehand(self):
        self.fails(2, "go.glb", "-r", "4096x4096", "-o", "a.mp4", env={**os.environ, "PATH": "/none"},
                   saying="ffmpeg, which is not installed")

    def fake_ffmpeg(self, text):
        tools = self.folder / "tools"
        tools.mkdir(exist_ok=True)
        (tools / "ffmpeg").write_text("#!/bin/sh\n" + text)
        (tools / "ffmpeg").chmod(0o755)
        return {**os.environ, "PATH": f"/none::{tools}:/usr/bin:/bin"}

    def test_a_film_is_what_ffmpeg_makes_of_the_pictures(self):
        self.succeeds("go.glb", *SMALL, "--frames", "0..2", "-o", "a.mp4", "--quiet",
                      env=self.fake_ffmpeg('for file; do :; done; cat >"${file#file:}"'))
        self.assertEqual(len(self.picture("a.mp4")), 3 * 64 * 48 * 3)

    def test_what_ffmpeg_prints_is_not_among_what_the_program_prints(self):
        env = self.fake_ffmpeg('echo printed; for file; do :; done; cat >"${file#file:}"; echo said >&2')
        row = "go.glb", *SMALL, "--frames", "0..1", "-o", "a.mp4", "--quiet"
        silent = self.succeeds(*row, env=env)
        self.assertEqual(silent.stdout + silent.stderr, "")
        stats = json.loads(self.succeeds(*row, "--stats", "-", env=env).stdout)
        self.assertEqual(stats["frames"]["count"], 2)

    def test_a_failure_of_ffmpeg_is_one_line(self):
        for script in ("echo first >&2; echo 'no such encoder' >&2; exit 1",
                       "cat >/dev/null; echo 'no such encoder' >&2; exit 1"):
            env = self.fake_ffmpeg(script)
            self.fails(4, "go.glb", *SMALL, "--frames", "0..1", "-o", "a.mp4", "--quiet", env=env,
                       saying="a.mp4: ffmpeg failed: no such encoder")
        for script, end in (("kill -9 $$", "by signal 9"), ("cat >/dev/null; kill -9 $$", "by signal 9"),
                            ("cat >/dev/null; exit 3", "with code 3")):
            env = self.fake_ffmpeg(script)
            self.fails(4, "go.glb", *SMALL, "--frames", "0..1", "-o", "a.mp4", "--quiet", env=env,
                       saying="ended " + end)


class Interruption(MovingTest):
    def interrupt(self, *outputs):
        process = subprocess.Popen(
            [PROGRAM, "go.glb", *SMALL, "--frames", "0..99999", *outputs, "--quiet"],
            cwd=self.folder, stderr=subprocess.PIPE, text=True)
        for _ in range(6000):
            if (self.folder / "f.00002.png").exists():
                break
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, talk = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, talk)
        self.assertIn("interrupted", talk)

    def test_finished_frames_stay_whole_and_can_be_resumed(self):
        self.interrupt("-o", "f.%05d.png")
        frames = [n for n in self.files() if n.startswith("f.")]
        self.assertEqual([n for n in self.files() if n.startswith(".")], [])
        self.assertGreaterEqual(len(frames), 3)
        for name in frames:
            self.assertTrue(self.picture(name).endswith(b"IEND\xaeB`\x82"), name)
        result = self.succeeds("go.glb", *SMALL, "--frames", f"0..{len(frames)}", "-o", "f.%05d.png",
                               "--resume")
        self.assertIn(f"{len(frames)} frames were there already", result.stderr)

    @unittest.skipUnless(FFMPEG, "ffmpeg is not installed")
    def test_no_half_written_film_is_left(self):
        self.interrupt("-o", "f.%05d.png", "-o", "a.mp4")
        self.assertEqual([n for n in self.files() if n.startswith(".") or n == "a.mp4"], [])


if __name__ == "__main__":
    main()
