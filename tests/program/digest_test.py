"""caustics digest: names that hold blanks, and the comparison with a kept list."""

import glb
from program import ProgramTest, main

TINY = ["-r", "16x12", "--grid", "8", "--map", "8", "-D", "shadow=16"]


class Names(ProgramTest):
    def test_blanks_and_percent_signs_survive(self):
        document, blob = glb.unpack(glb.scene())
        for node in document["nodes"]:
            node["name"] = "high 100%"
        for name in ("two balls.glb", "two_balls.glb"):
            (self.folder / name).write_bytes(glb.pack(document, blob))
        lines = self.succeeds("digest", "two balls.glb", "two_balls.glb", *TINY).stdout.splitlines()
        words = [line.split(" ") for line in lines]
        self.assertEqual({len(each) for each in words}, {4})
        self.assertEqual({each[0] for each in words}, {"two%20balls.glb", "two_balls.glb"})
        self.assertTrue(any("[high%20100%25]" in each[1] for each in words))
        (self.folder / "kept.txt").write_text("\n".join(lines) + "\n")
        self.succeeds("digest", "two balls.glb", "two_balls.glb", *TINY, "--check", "kept.txt")


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        self.kept = self.succeeds("digest", "ball.glb", *TINY).stdout.splitlines()

    def check(self, lines, code, *scenes):
        (self.folder / "kept.txt").write_text("".join(line + "\n" for line in lines))
        result = self.run_program("digest", *(scenes or ["ball.glb"]), *TINY, "--check", "kept.txt")
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stdout.splitlines()

    def test_equal_lists_say_nothing(self):
        self.assertEqual(self.check(self.kept, 0), [])
        self.assertEqual(self.check(reversed(self.kept), 0), [])
        self.assertEqual(self.check(self.kept * 2, 0, "ball.glb", "ball.glb"), [])

    def test_a_line_for_each_difference(self):
        name, now = self.kept[0].rsplit(" ", 1)
        before = "0" * 64
        self.assertEqual(self.check([f"{name} {before}", *self.kept[1:]], 1),
                         [f"changed {name} {before} {now}"])
        self.assertEqual(self.check(self.kept[1:], 1), [f"new {self.kept[0]}"])
        other = f"other.glb compose beauty {before}"
        self.assertEqual(self.check([*self.kept, other], 1), [f"missing {other}"])
        self.assertEqual(self.check(self.kept * 2, 1), sorted(f"missing {line}" for line in self.kept))

    def test_what_is_no_list_is_refused(self):
        line = self.kept[0]
        for text in ("", "\n", "hello\n", line[:-1], line + "0", line.replace(" ", "  ", 1), line.upper()):
            (self.folder / "kept.txt").write_text(text)
            self.fails(3, "digest", "ball.glb", "--check", "kept.txt", saying="kept.txt: ")
        self.fails(3, "digest", "ball.glb", "--check", "lost.txt",
                   saying="lost.txt: no list that can be read")
        self.fails(3, "digest", "ball.glb", "--check", ".", saying="no list that can be read")


if __name__ == "__main__":
    main()
