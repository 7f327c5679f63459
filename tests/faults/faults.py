#!/usr/bin/env python3
"""The list of faults: one TOML file a room, one table a fault. Run by itself it checks the list against the
sources: every fault still has its place, and tests that could notice it."""
import fnmatch
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEYS = {'wrong', 'file', 'text', 'fault', 'noticed_by'}
FEWEST = 150
MOST_UNNOTICEABLE = 0.05  # of them


class Fault:
    def __init__(self, room, name, entry):
        self.room, self.name, self.entry = room, name, entry
        self.wrong, self.file = entry.get('wrong', ''), entry.get('file', '')
        self.text, self.fault = entry.get('text', ''), entry.get('fault', '')
        self.noticed_by = entry.get('noticed_by', [])
        self.unnoticed = entry.get('unnoticed')

    def number(self):
        """FNV-1a without the sign bit, as in fault.cpp: no number depends on what else is on the list."""
        number = 2166136261
        for byte in self.name.encode():
            number = (number ^ byte) * 16777619 % 2**32
        return number & 0x7fffffff

    def place(self, source):
        return source.index(self.text)

    def choice(self):
        """The text with both ways, one taken at run time; a fault that says FAULT is the whole text."""
        if 'FAULT' in self.fault:
            return self.fault.replace('FAULT', f'FAULT({self.number()})')
        if self.text.rstrip().endswith((';', '}')):
            return f'if (FAULT({self.number()})) {{ {self.fault} }} else {{ {self.text} }}'
        return f'(FAULT({self.number()}) ? ({self.fault}) : ({self.text}))'


def all_faults():
    faults = []
    for path in sorted(pathlib.Path(__file__).parent.glob('*.toml')):
        with path.open('rb') as file:
            faults += [Fault(path.stem, name, entry) for name, entry in tomllib.load(file).items()]
    return faults


def is_whole(text):
    """Can this be put into brackets? Its own are closed; it is neither a loop's head nor a declaration."""
    depth, is_statement = 0, text.rstrip().endswith((';', '}'))
    for character in re.sub(r"'[^']'|\"[^\"]*\"", '', text):
        depth += (character in '([{') - (character in ')]}')
        if depth < 0 or (depth == 0 and character == ',' and not is_statement):
            return False
    # An operator at the end lacks what it works on.
    is_part = re.search(r'[-+*/%=<>!&|?:]\s*$|^(for|if|while)\b', text)
    return depth == 0 and (is_statement or not is_part) and not re.match(r'[\w:<>]+ \w+ = ', text)


def complaints(faults):
    """What is wrong with the list, held against the sources of today."""
    wrong, names, numbers, spans = [], set(), set(), {}
    for fault in faults:
        def complain(why):
            wrong.append(f'{fault.room}.toml, {fault.name}: {why}')
        keys = set(fault.entry)
        if keys not in (KEYS, KEYS - {'noticed_by'} | {'unnoticed'}):
            complain(f'has the keys {", ".join(sorted(keys))}')
            continue
        if fault.name in names or fault.number() in numbers:
            complain('its name or number is taken')
        names.add(fault.name)
        numbers.add(fault.number())
        path = ROOT / fault.file
        source = path.read_text() if path.is_file() else ''
        if source.count(fault.text) != 1:
            complain(f'its text occurs {source.count(fault.text)} times in {fault.file}; choose it anew')
            continue
        if 'FAULT' not in fault.fault and not (is_whole(fault.text) and is_whole(fault.fault)):
            complain('neither an expression nor a statement')
        begin = source.index(fault.text)
        is_statement = fault.choice().startswith('if')
        is_operand = re.search(r'(\breturn|[=,?({])\s*$', source[:begin])
        if re.search(r'_of\([-\d.ef]+, [-\d.ef]+\)', fault.fault):
            complain('a function of two numbers is ambiguous where lanes are wide')
        if not is_statement and not fault.fault.strip():
            complain('nothing cannot take the place of an expression')
        if is_statement and is_operand and not source[:begin].rstrip().endswith('{'):
            complain('a statement cannot stand here')
        if not is_statement and not is_operand and re.match(r'[^(]* \? ', fault.text):
            complain('in parentheses its ? binds otherwise than without')
        for other, first, last in spans.setdefault(fault.file, []):
            if begin < last and first < begin + len(fault.text):
                complain(f'overlaps {other}')
        spans[fault.file].append((fault.name, begin, begin + len(fault.text)))
    return wrong


def test_names():
    """Catch2's of today."""
    names = []
    for path in ROOT.rglob('*_test.cpp'):
        if 'build' not in path.relative_to(ROOT).parts:
            names += re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', path.read_text())
    return names


def unknown_tests(faults):
    names, wrong = test_names(), []
    for fault in faults:
        for test in fault.noticed_by:
            file, *parts = test.split()
            if '_test.py' not in test:
                known = any(fnmatch.fnmatchcase(name, re.sub(r'([\[?])', r'[\1]', test)) for name in names)
            else:
                path = ROOT / 'tests/program' / file
                text = path.read_text() if path.is_file() else ''
                known = text and all(f'class {part.split(".")[0]}(' in text for part in parts)
            if not known:
                wrong.append(f'{fault.room}.toml, {fault.name}: there is no test {test}')
    return wrong


def main():
    from plant import planted
    faults = all_faults()
    wrong = complaints(faults) + unknown_tests(faults)
    if not wrong:
        planted(faults)  # exits where a file does not take them
    unnoticeable = sum(1 for fault in faults if fault.unnoticed)
    if len(faults) < FEWEST or unnoticeable > MOST_UNNOTICEABLE * len(faults):
        wrong.append(f'{len(faults)} faults, of which no test can notice {unnoticeable}')
    print('\n'.join(wrong) or f'{len(faults)} faults have their place; no test can notice {unnoticeable}')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
