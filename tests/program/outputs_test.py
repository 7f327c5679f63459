#!/usr/bin/env python3
"""What every command says of several scenes, word for word: outputs/*.txt hold commands, each a line that
begins with `$ `, and under it what it printed and, after `$ show FILE`, what it wrote. With --update the
answers are written anew. Times and what is the machine's own are masked; numbers may be off by what
outputs/*.txt says in a line `# within X`, relatively, or else by 1e-6. Of answers of more than 220 lines, or
what a line `# longest N` says, hashes are kept.

`< FILE` and `> FILE` are as in a shell. `$ change A.glb B.glb PATH=VALUE ...` makes a scene of another: PATH
is of keys and places of its JSON, with dots between, VALUE is JSON, and none removes what stands there.
Scenes are those of small_scenes.py, of golden_scenes.py and, in the folder scenes, the samples."""

import hashlib
import itertools
import json
import pathlib
import re
import shlex
import subprocess
import sys

import glb
import golden_scenes
import shown
import small_scenes
from program import PROGRAM, ProgramTest, main

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
         (r"OpenGL, llvmpipe \(.*?\), [^,;]*", "OPENGL")]
MASKS_OF = {  # what these commands say
    "study": [(r"time (?:x [\d.]+|[-+]\d+ %) \([\d.]+ to TIME\)", "time CHANGED"),
              (r"took (?:x [\d.]+|[-+]\d+ %) \([\d.]+ to TIME\)", "took CHANGED"),
              (r"^(  .* +[\d.]+ +[\d.]+) +[\d.]+ +[\d.]+$", r"\1 TIMES")],
    "bench": [(r" +[\d.]+ ±\d+%(?: +[\d.]+)?", " TIME"), (r" +[\d.]+%$", " SHARE"),
              (r"TIME TIME [\d.]+", "TIME TIME RATIO"), (r"(memory|arithmetic): .*", r"\1: MASKED"),
              (r"peak [\d.]+ \wiB", "peak MASKED")]}
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w])")


def masked(line, command=""):
    for pattern, word in MASKS + MASKS_OF.get(command, []):
        line = re.sub(pattern, word, line)
    return line.rstrip()


def steady(lines):
    """Without the rows that a study chooses by their times."""
    chosen = False
    for line in lines:
        chosen = line.startswith("nothing beats these") or chosen and line.startswith("  ")
        if not (chosen and line.startswith("  ")):
            yield line


def shortened(lines, longest, piece=25):
    """Of a long answer, a hash for every few lines."""
    if len(lines) <= longest:
        return lines
    pieces = [lines[i:i + piece] for i in range(0, len(lines), piece)]
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


def changed(data, changes):
    """A scene with other values at these paths of its JSON."""
    document, blob = glb.unpack(data)
    for change in changes:
        path, _, text = change.partition("=")
        *before, last = [int(key) if key.isdigit() else key for key in path.split(".")]
        at = document
        for key in before:
            at = at[key] if isinstance(at, list) else at.setdefault(key, {})
        if not text:
            del at[last]
        elif isinstance(at, list) and last == len(at):
            at.append(json.loads(text))
        else:
            at[last] = json.loads(text)
    return glb.pack(document, blob)


class Outputs(ProgramTest):
    maxDiff = None
    longest, piece = LONGEST, 25  # lines of answers that are kept as they are, and of what else has a hash

    def setUp(self):
        super().setUp()
        for name, data in small_scenes.files().items():
            (self.folder / name).write_bytes(data)
        (self.folder / "scenes").symlink_to(SCENES)
        self.given = set(self.files())

    def make_scenes(self, words):
        """Those of golden_scenes.py that are named."""
        for word in words:
            make = getattr(golden_scenes, word.removesuffix(".glb"), None)
            if word.endswith(".glb") and make and word not in self.given:
                make().write(self.folder / word)
                self.given.add(word)

    def run_words(self, words):
        """A run whose standard input and output may be files."""
        redirected = {}
        for mark, stream, mode in (("<", "stdin", "rb"), (">", "stdout", "wb")):
            if mark in words:
                at = words.index(mark)
                redirected[stream] = open(self.folder / words[at + 1], mode)
                words = words[:at] + words[at + 2:]
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, **redirected}
        result = subprocess.run([PROGRAM, *words], cwd=self.folder, text=True, stderr=subprocess.PIPE,
                                timeout=300, **options)
        for file in redirected.values():
            file.close()
        return result.returncode, result.stdout or "", result.stderr

    def answer(self, command):
        """The lines that stand under a command."""
        words = shlex.split(command[2:])
        self.make_scenes(words)
        if words[0] == "show":
            lines = [masked(line, "study" if name.endswith(".html") else "") for name in words[1:]
                     for line in shown.lines_of(self.folder / name)]
            return shortened(lines, self.longest, self.piece) if self.longest < LONGEST else lines
        if words[0] == "files":
            return [" ".join(sorted(set(self.files()) - self.given))]
        if words[0] == "change":
            self.given.add(words[2])
            (self.folder / words[2]).write_bytes(changed((self.folder / words[1]).read_bytes(), words[3:]))
            return []
        code, stdout, stderr = self.run_words(words[1:])
        lines = [f"exit {code}"] if code else []
        if "--json" in words and stdout.startswith("{"):
            lines += shown.json_lines(stdout)
        else:
            lines += steady(stdout.splitlines())
        if "bench" in words:  # its columns are as wide as its times
            lines = [re.sub(" +", " ", line) for line in lines]
        lines += ["! " + line for line in stderr.splitlines() if not PROGRESS.search(line)]
        return shortened([masked(line, " ".join(words[1:2])) for line in lines],
                         0 if HELP.search(command) else self.longest, self.piece)

    def need_llvmpipe(self):
        """Skips the test where OpenGL is another driver's, or rounds otherwise."""
        said = self.run_program("doctor").stdout
        if not re.search(r"gl driver class +llvmpipe, fused$", said, re.MULTILINE):
            self.skip_without_gl("the answers are those of llvmpipe with fused multiply-add")

    def session(self, text):
        lines, found = [], re.search(r"^# longest (\d+)", text, re.MULTILINE)
        self.longest, self.piece = (int(found[1]), 80) if found else (LONGEST, 25)
        for command in commands(text):
            if command.startswith("#"):
                lines.append(command)
            else:
                lines += ([""] if lines else []) + [command, *self.answer(command)]
        return lines

    def check(self, path):
        text = path.read_text()
        head = text.split("\n$")[0]
        if "need Embree" in head:
            self.need_ray_queries()
        if "need llvmpipe" in head:
            self.need_llvmpipe()
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
