#!/usr/bin/env python3
"""Whether the pages say what the program finds: each figure stands in what the command beside it prints,
rounded as the page has it.

    doc_figures.py PROGRAM paper DIR       docs/paper.md against DIR/paper.json of `caustics paper -o DIR`
    doc_figures.py PROGRAM pages [PASS]    what this pass's page, or each one, says of its experiment
    doc_figures.py PROGRAM guide [PAGE]    what this page of the guide, or each one, says of its commands, and
                                           the sections of other pages that have commands of ./caustics

An experiment is an indented command under "**Experiment.**"; of one that renders the percentages are looked
for that stand in the text after it. They may also be those of the scene without the command's options, of the
command with an `--option` that the text names, or "without" one. The guide's figures are looked for in all
that the page's commands print and write as text. Ends with 1 and a line for each figure that is not
printed."""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "paper.md"
FIGURE_6 = "5, 31, 32"
NUMBER = re.compile(r"(?<![\w.-])\d+(?:[ ,]\d{3})*(?:\.\d+)?(?:e-?\d+)?(?![\w.]*\.(?:md|glb))")
# What times and frame rates a machine has is nobody else's business.
OF_A_MACHINE = re.compile(r"^ ?(?:ms|s|fps|min|times)\b")


def numbers(text, of_any_machine=True):
    """[(number, as it stands)] without code and addresses, and unless told otherwise without what depends on
    the machine."""
    text = re.sub(r"`[^`]*`|\]\([^)]*\)|#\S+", " ", text)
    found = []
    for match in NUMBER.finditer(text):
        if not of_any_machine or not OF_A_MACHINE.match(text[match.end():]):
            found.append((float(re.sub("[ ,]", "", match[0])), match[0]))
    return found


def rounds_to(value, figure, text):
    """Is this the value, by as many digits as the figure has? Of three and more digits the last may be off by
    one: traced light differs between processors."""
    digits, _, power = re.sub("[ ,]", "", text).partition("e")
    unit = 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))
    exact = len(digits.replace(".", "").lstrip("0")) < 3
    return abs(value - figure) <= (0.501 if exact else 1.001) * unit


def parts_of_page(page):
    """{row: what the page says of it}."""
    said = {}
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and len(cells) == 3 and re.fullmatch(r"\d+(, \d+)*", cells[0]):
            said[cells[0]] = cells[2]
    about = page.partition("## Figure 6")[2].strip().split("\n\n")[0]
    said[FIGURE_6] = said.get(FIGURE_6, "") + " " + " ".join(about.split())
    return said


def printed_of(row, rows):
    """All that the command prints of a row of the page, which may be several of its own."""
    wanted = set(row.split(", "))
    return " ".join(f"{r['thing']} {r['expected']} {r['found']}" for r in rows
                    if wanted & set(r["row"].split(", ")))


def unprinted(page, rows):
    """A line for each figure of the page that stands in no row of its own; only rows that were made count."""
    lines = []
    for row, said in parts_of_page(page).items():
        printed = printed_of(row, rows)
        values = [value for value, _ in numbers(printed.replace("%", " %"), of_any_machine=False)]
        for figure, text in numbers(said) if printed else []:
            if not any(rounds_to(value, figure, text) for value in values):
                lines.append(f"docs/paper.md, row {row}: {text} is not in: {printed}")
    return lines


def experiment_of(page):
    """(command, text) of a page of a pass; None where its experiment prints no figures."""
    after = page.partition("**Experiment.**")[2]
    found = re.search(r"^    \./caustics (.*)\n\n((?:(?!    ).+\n?)+)", after, re.M)
    if not found or not found[1].startswith("render"):
        return None
    return shlex.split(found[1]), " ".join(found[2].split())


def without(command, option):
    at = command.index(option[0])
    end = at + 1
    while end < len(command) and not command[end].startswith("-"):
        end += 1
    return command[:at] + command[end:]


def commands_of(command, text):
    """What the text's figures may come from."""
    runs = [command, command[:2]]
    for word, quoted in re.findall(r"(\w*) ?`(-[^`]*|\d+,\d+)`", text):
        option = shlex.split(quoted)
        if word == "without" and option[0] in command:
            runs.append(without(command, option))
        elif quoted[0] == "-":
            other = option[0] in command and option[0] != "-D"
            runs.append((without(command, option) if other else command) + option)
    return runs


class Printed:
    """What commands print, each run once."""

    def __init__(self, program):
        self.program = program
        self.known = {}

    def of(self, command):
        key = tuple(command)
        if key not in self.known:
            with tempfile.TemporaryDirectory() as folder:
                output = ["-o", folder + "/picture.png"]
                run = subprocess.run(
                    [self.program, *command, *output], cwd=ROOT, text=True, capture_output=True
                )
            if run.returncode not in (0, 1):
                raise SystemExit(f"caustics {shlex.join(command)}: {run.stderr}")
            self.known[key] = run.stdout + run.stderr
        return self.known[key]


def unprinted_by_experiment(page, printed):
    experiment = experiment_of(page.read_text())
    if not experiment:
        return []
    command, text = experiment
    said = [figure for match in re.finditer(r"([\d.]+)(?: (?:to|and) ([\d.]+))? %", text)
            for figure in match.groups() if figure]
    runs = commands_of(command, text)
    for run in runs:
        if said:
            values = [value for value, _ in numbers(printed.of(run).replace("%", " %"), False)]
            said = [figure for figure in said
                    if not any(rounds_to(value, float(figure), figure) for value in values)]
    return [f"{page.relative_to(ROOT)}: {figure} % is printed by none of "
            + "; ".join("caustics " + shlex.join(run) for run in runs) for figure in said]


def printed_on(page, program):
    """What the page's indented commands print, and what tables they write, in one folder after the other."""
    said = []
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "scenes").symlink_to(ROOT / "scenes")
        for line in re.findall(r"^    \./caustics (.*)", page, re.M):
            run = subprocess.run([program, *shlex.split(line)], cwd=folder, text=True, capture_output=True)
            if run.returncode not in (0, 1):
                raise SystemExit(f"caustics {line}: {run.stderr}")
            said += [run.stdout, run.stderr]
        said += [path.read_text() for path in pathlib.Path(folder).glob("*/*.csv")]
    return "\n".join(said)


def sections(page):
    """The parts of a page that stand for themselves: of the guide the whole."""
    text = page.read_text()
    return [text] if page.parent.name == "guide" else re.split(r"^(?=## )", text, flags=re.M)


def unprinted_of_section(name, text, program):
    """Of a text the percentages, and what has a decimal point; "cm" and "mm" may be printed as metres, and a
    share of 1 as a percentage."""
    prose = "\n".join(line for line in text.splitlines() if not line.startswith(("    ", "#", "Next:")))
    prose = re.sub(r"`[^`]*`|\]\([^)]*\)", " ", " ".join(prose.split()))
    said = re.findall(r"(\d+\.\d+|\d+(?= %))( cm| mm)?", prose)
    if not said or "\n    ./caustics " not in text:
        return []
    printed = re.sub("(?<!e)-|,", " ", printed_on(text, program).replace("%", " %"))
    values = {value for value, _ in numbers(printed)}

    def found(figure, scales):
        return any(rounds_to(value * scale, float(figure), figure) for value in values for scale in scales)

    scale = {"": (1, 100), " cm": (100,), " mm": (1000,)}
    return [f"{name}: {figure}{unit} is printed by none of its commands"
            for figure, unit in said if not found(figure, scale[unit])]


def main(program, what, name="*"):
    if what == "paper":
        made = json.loads((pathlib.Path(name) / "paper.json").read_text())["rows"]
        wrong = unprinted(PAGE.read_text(), made)
    elif what == "guide":
        pages = [page for page in sorted((ROOT / "docs").rglob(f"{name}.md")) if page != PAGE]
        wrong = [line for page in pages for section in sections(page)
                 for line in unprinted_of_section(page.relative_to(ROOT), section, program)]
    else:
        printed = Printed(program)
        pages = sorted((ROOT / "passes").glob(f"{name}/*.md"))
        wrong = [line for page in pages for line in unprinted_by_experiment(page, printed)]
    print("\n".join(wrong) or "the pages' figures are those that the program prints")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
