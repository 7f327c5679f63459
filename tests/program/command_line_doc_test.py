#!/usr/bin/env python3
"""The tables in docs/command_line.md are those of `caustics COMMAND --help-markdown`. Each stands between a
line `<!-- caustics COMMAND: HEADING; ... -->`, which names the tables (or `purpose`), and `<!-- end -->`.
With --update they are written anew."""

import pathlib
import re
import subprocess
import sys
import unittest

from program import PROGRAM, main

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/command_line.md"
HELP = PAGE.parent / "help.txt"  # what ./caustics --help prints before the program is built
BLOCK = re.compile(r"<!-- caustics ?(\w*): ([^\n]*) -->\n(.*?)<!-- end -->\n", re.DOTALL)


def help_of(command):
    """What the help says, by heading; its first paragraph is `purpose`."""
    arguments = [command] if command else []
    result = subprocess.run([PROGRAM, *arguments, "--help-markdown"], check=True, text=True,
                            capture_output=True)
    purpose, *tables = result.stdout.rstrip("\n").split("\n\n")
    return {"purpose": purpose} | {re.match(r"\| (.*?) \|", table)[1]: table for table in tables}


def block(match):
    command, headings, _ = match.groups()
    said = help_of(command)
    wanted = "\n\n".join(said[heading] for heading in headings.split("; "))
    return f"<!-- caustics{' ' * bool(command)}{command}: {headings} -->\n{wanted}\n\n<!-- end -->\n"


def help_text():
    return subprocess.run([PROGRAM, "--help"], check=True, text=True, capture_output=True).stdout


def update():
    PAGE.write_text(BLOCK.sub(block, PAGE.read_text()))
    HELP.write_text(help_text())


def names(table):
    return re.findall(r"^\| (`.*?) \| ", table, re.MULTILINE)


class CommandLineDoc(unittest.TestCase):
    def test_tables_are_what_the_program_says(self):
        page = PAGE.read_text()
        if BLOCK.sub(block, page) != page:
            self.fail("docs/command_line.md is not what the program says; to write its tables anew: "
                      "CAUSTICS_PROGRAM=build/release/caustics "
                      "python3 tests/program/command_line_doc_test.py --update")

    def test_the_help_of_a_program_that_is_not_built_yet_is_the_programs(self):
        self.assertEqual(HELP.read_text(), help_text())

    def test_every_command_option_and_setting_is_on_the_page(self):
        page = PAGE.read_text()
        commands = [name.strip("`") for name in names(help_of("")["Commands"])]
        self.assertIn("render", commands)
        said = [(command, name) for command in commands for heading, table in help_of(command).items()
                if heading != "purpose" for name in names(table)]
        self.assertGreater(len(said), 200)
        self.assertEqual([each for each in said if f"| {each[1]} |" not in page], [])


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        update()
    else:
        main()
