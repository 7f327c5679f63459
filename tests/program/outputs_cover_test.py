#!/usr/bin/env python3
"""What outputs/*.txt show leaves out no option: each of each command's help, each name that an option or a
setting of -D takes, each kind of file that it writes and each layer stands in a command there that succeeds
and of which something is shown, with another value than its default. Settings may stand in golden_test.py's
frames instead. What all commands share is asked for once."""

import collections
import fnmatch
import re
import shlex
import unittest

import golden_test
from command_line_doc_test import help_of
from outputs_test import KEPT
from program import main

ANOTHER = "something else"
SHARED = ("View", "Method", "Running", "Settings for -D")
# Commands that say little of what they wrote: a file of theirs must be shown.
WRITE = {"render", "reference", "inspect"}
REFUSED = re.compile(r"exit ([2-57]|70|130|143)$")
# What no kept answer can show, as a failure names it, and why.
EXCEPTIONS = {
    "render --output .mp4": "ffmpeg's versions write other bytes, and shown.py reads no films",
    "render --output .mkv": "likewise",
    "render --output .webm": "likewise",
    "render --output .gif": "likewise",
    "render --time-budget": "the sizes that it chooses follow measured times",
}


def rows(table):
    """(names, range, default, meaning) of a table of help; what it does not say is empty."""
    for line in table.split("\n")[2:]:
        names, *between, meaning = re.split(r"(?<!\\) \| ", line.strip("| ") + " ")
        said = re.match(r"(.*?) ?(?:\(([^()]*)\))?$", between[0].replace("\\|", "|") if between else "")
        yield re.findall(r"`([^`]*)`", names.replace("\\|", "|")), said[1], said[2] or "", meaning


def alternatives(taken):
    """Of a range, the names in it, ANOTHER where it takes more than names, and the endings of files, with `-`
    for standard output."""
    if taken.startswith("."):
        return re.findall(r"\.[a-z]\w*", taken) + re.findall(r"(?<= )-(?= |$)", taken)
    words = taken.split("|") if "|" in taken else []
    names = [word for word in words if re.fullmatch(r"[a-z0-9.]+", word)]
    return names + [ANOTHER] * (len(names) < len(words))


class Wanted:
    """All that must be shown: the row's name, and how it is found in a command's values."""

    def __init__(self):
        self.found_by = {}
        self.commands = [row[0][0] for row in rows(help_of("")["Commands"])]
        self.with_value = collections.defaultdict(set)  # by command
        for command in self.commands:
            for heading, table in help_of(command).items():
                if heading.startswith("Layers"):
                    self.layers(command, table)
                elif table.startswith("|"):
                    self.options("" if heading in SHARED else command, command, table)

    def layers(self, command, table):
        for names, *_ in rows(table):
            self.found_by[f"{command} --aov {names[0]}"] = (command, "--aov", names[0], [], "")

    def options(self, of, command, table):
        """`of` is empty where any command will do."""
        for names, taken, default, _ in rows(table):
            written = [name.split(" ")[0] for name in names]
            if " " in names[-1]:
                self.with_value[command].update(written)
            if not written[-1].startswith("-"):
                if table.startswith("| Settings"):
                    self.one(of, "-D " + written[0], taken, default)
                continue
            self.one(of, written[-1], taken, default)

    def one(self, of, name, taken, default):
        names = alternatives(taken)
        for choice in [each for each in names if each != default] or [""]:
            self.found_by[f"{of} {name} {choice}".strip()] = (of, name, choice, names, default)


def values(command, words, with_value):
    """(option, value) of a command's words; -D KEY=VALUE is the option `-D KEY`, as is each of --vary's."""
    short = {"-o": "--output", "-r": "--resolution", "-t": "--threads", "-q": "--quiet", "-v": "--verbose"}
    words = iter(words)
    for word in words:
        if not word.startswith("-") or word == "-":
            continue
        name, equals, value = word.partition("=")
        if name not in with_value:
            value = "given"
        elif not equals:
            value = next(words, "")
        name = short.get(name, name)
        if name in ("-D", "--vary"):
            key, _, text = value.partition("=")
            for each in text.split(","):
                yield "-D " + key, each
        for each in value.split(",") if name == "--aov" else [value]:
            yield name, each


def sessions():
    """(command, its words, what it answered, whether a file that it names is shown) of all that is kept."""
    for path in sorted(KEPT.glob("*.txt")):
        answers = re.split(r"^\$ ", path.read_text(), flags=re.MULTILINE)[1:]
        lines = [answer.strip("\n").split("\n") for answer in answers]
        shown = [name for first, *_ in lines if first.startswith("show ") for name in shlex.split(first)[1:]]
        for first, *answer in lines:
            program, *words = shlex.split(first)
            if program == "caustics" and words and not (answer and REFUSED.match(answer[0])):
                files = [re.sub("%[0-9]*d", "*", word) + "*" for word in words]
                yield words[0], words[1:], answer, any(fnmatch.filter(shown, each) for each in files)


class OutputsCover(unittest.TestCase):
    maxDiff = None

    def test_every_option_and_setting_is_shown_with_another_value(self):
        wanted = Wanted()
        self.assertGreater(len(wanted.found_by), 150)
        seen = collections.defaultdict(set)  # (command, option): values
        for command, words, answer, shown in sessions():
            if command in wanted.commands and (shown or answer and command not in WRITE):
                for name, value in values(command, words, wanted.with_value[command]):
                    seen[command, name].add(value)
                    seen["", name].add(value)
        for frames in golden_test.FRAMES.values():
            for options in frames:
                for name, value in values("render", options.split(), wanted.with_value["render"]):
                    seen["", name].add(value)
        missing = [row for row, (of, name, *value) in wanted.found_by.items()
                   if not self.holds(seen[of, name], *value)]
        self.assertEqual([row for row in missing if row not in EXCEPTIONS], [],
                         "stand in no command of outputs/*.txt that shows what they do")
        self.assertEqual([row for row in EXCEPTIONS if row not in missing], [], "are no exceptions any more")

    @staticmethod
    def holds(found, choice, names, default):
        """Whether one of the values that were found is what is wanted."""
        if choice == ANOTHER:
            return any(value not in names for value in found)
        if not choice:
            return any(value != default for value in found)
        return any(value == choice or value.endswith("=" + choice) or
                   choice.startswith(".") and value.endswith(choice) for value in found)


if __name__ == "__main__":
    main()
