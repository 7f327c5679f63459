#!/usr/bin/env python3
"""What every command says of several scenes, word for word: outputs/*.txt hold commands, each a line that
begins with `$ `, and under it what it printed and, after `$ show FILE`, what it wrote. With --update the
answers are written anew. Times and what is the machine's own are masked; numbers may be off by what
outputs/*.txt says in a line `# within X`, relatively, or else by 1e-6."""

import hashlib
import itertools
import json
import pathlib
import re
import shlex
import sys

import shown
import small_scenes
from program import ProgramTest, main

KEPT = pathlib.Path(__file__).with_name("outputs")
SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
PROGRESS = re.compile(r"  (\d[\d.]* s|\d+ min \d+ s)$|^(pass|batch|row|finishing) ")
TIME = r"\d[\d.,]*(?:e[-+]\d+)? (?:ns|us|ms|s|min|h)\b(?: \d+ (?:s|min)\b)?"
# What a run takes, and what is this machine's or this build's; a table's columns are as wide as its times.
LONGEST = 220  # lines of an answer that is kept as it is
HELP = re.compile(r" --help(-markdown)?$| completion \w+$")
MASKS = [(" *" + TIME, " TIME"), (r"software, \d+ lanes \(\w+\)", "software"),
         (r"caustics \d[\d.]* \([^)]*\)", "PROGRAM"),
         (r"[\d.]+ [KMG]iB of the [\d.]+ [MG]iB that this machine can spare", "MEMORY"),
         # study
         (r"time (?:x [\d.]+|[-+]\d+ %) \([\d.]+ to TIME\)", "time CHANGED"),
         (r"took (?:x [\d.]+|[-+]\d+ %) \([\d.]+ to TIME\)", "took CHANGED"),
         (r"^(  .* +[\d.]+ +[\d.]+) +[\d.]+ +[\d.]+$", r"\1 TIMES"),
         # bench
         (r" +[\d.]+ ±\d+%(?: +[\d.]+)?", " TIME"), (r" +[\d.]+%$", " SHARE"),
         (r"(memory|arithmetic): .*", r"\1: MASKED"), (r"peak [\d.]+ \wiB", "peak MASKED")]
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w])")


def masked(line):
    for pattern, word in MASKS:
        line = re.sub(pattern, word, line)
    return line.rstrip()


def steady(lines):
    """Without the rows that a study chooses by their times."""
    chosen = False
    for line in lines:
        chosen = line.startswith("nothing beats these") or chosen and line.startswith("  ")
        if not (chosen and line.startswith("  ")):
            yield line


def shortened(lines, longest):
    """Of a long answer, a hash for every few lines."""
    if len(lines) <= longest:
        return lines
    pieces = [lines[i:i + 25] for i in range(0, len(lines), 25)]
    hashes = [hashlib.sha256("/".join(piece).encode()).hexdigest()[:8] for piece in pieces]
    heads = [f"from {piece[0].strip()[:60]!r}" for piece in pieces]
    return [f"{len(piece)} lines {hashed} {head}" for piece, hashed, head in zip(pieces, hashes, heads)]


def commands(text):
    return [line for line in text.splitlines() if line.startswith(("$ ", "#"))]


def differ(line, kept, within):
    """Whether two lines say different things; their numbers may differ by a little."""
    if line == kept:
        return False
    if NUMBER.sub("#", line) != NUMBER.sub("#", kept):
        return True
    pairs = zip(map(float, NUMBER.findall(line)), map(float, NUMBER.findall(kept)))
    return any(abs(a - b) > within * max(abs(a), abs(b)) + 1e-3 * within for a, b in pairs)


class Outputs(ProgramTest):
    maxDiff = None

    def setUp(self):
        super().setUp()
        for name, data in small_scenes.files().items():
            (self.folder / name).write_bytes(data)
        (self.folder / "scenes").symlink_to(SCENES)

    def answer(self, command):
        """The lines that stand under a command."""
        words = shlex.split(command[2:])
        if words[0] == "show":
            return [masked(line) for name in words[1:] for line in shown.lines_of(self.folder / name)]
        if words[0] == "files":
            return [" ".join(sorted(set(self.files()) - set(small_scenes.files()) - {"scenes"}))]
        result = self.run_program(*words[1:])
        lines = [f"exit {result.returncode}"] if result.returncode else []
        if "--json" in words and result.stdout.startswith("{"):
            lines += shown.json_lines(result.stdout)
        else:
            lines += steady(result.stdout.splitlines())
        if "bench" in words:  # its columns are as wide as its times
            lines = [re.sub(" +", " ", line) for line in lines]
        lines += ["! " + line for line in result.stderr.splitlines() if not PROGRESS.search(line)]
        return shortened([masked(line) for line in lines],
                         0 if HELP.search(command) else LONGEST)

    def session(self, text):
        lines = []
        for command in commands(text):
            if command.startswith("#"):
                lines.append(command)
            else:
                lines += ([""] if lines else []) + [command, *self.answer(command)]
        return lines

    def check(self, path):
        text = path.read_text()
        if "need Embree" in text.split("\n$")[0]:
            self.need_ray_queries()
        found = re.search(r"# within (\S+)", text)
        within = float(found[1]) if found else 1e-6
        wrong, command = [], ""
        for line, kept in itertools.zip_longest(self.session(text), text.splitlines(), fillvalue=""):
            command = kept if kept.startswith("$ ") else command
            if differ(line, kept, within):
                wrong += [f"under {command}", f"  kept: {kept}", f"  now:  {line}"]
        if wrong:
            self.fail(f"outputs_test.py --update writes {path.name} anew; of {len(wrong) // 3} lines that "
                      "differ:\n" + "\n".join(wrong[:24]))


for each in sorted(KEPT.glob("*.txt")):
    setattr(Outputs, "test_" + each.stem, lambda self, path=each: self.check(path))


def update(names):
    for path in sorted(KEPT.glob("*.txt")):
        if not names or path.stem in names:
            test = Outputs()
            test.setUp()
            path.write_text("\n".join(test.session(path.read_text())) + "\n")
            test.doCleanups()


if __name__ == "__main__":
    if "--update" in sys.argv:
        update(sys.argv[2:])
    else:
        main()
