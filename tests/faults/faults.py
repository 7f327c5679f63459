"""The list of faults: one TOML file a room, one table a fault."""
import pathlib
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEYS = {'wrong', 'file', 'text', 'fault', 'noticed_by'}


class Fault:
    def __init__(self, room, name, entry):
        self.room, self.name, self.entry = room, name, entry
        self.wrong, self.file = entry.get('wrong', ''), entry.get('file', '')
        self.text, self.fault = entry.get('text', ''), entry.get('fault', '')
        self.noticed_by = entry.get('noticed_by', [])
        self.unnoticed = entry.get('unnoticed')

    def number(self):
        """FNV-1a without the sign bit, as in fault.cpp: names may come and go, and no other number changes."""
        number = 2166136261
        for byte in self.name.encode():
            number = (number ^ byte) * 16777619 % 2**32
        return number & 0x7fffffff

    def choice(self):
        """The text with both ways, one taken at run time; where the fault itself says FAULT, it is the whole."""
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
        begin = source.index(fault.text)
        for other, first, last in spans.setdefault(fault.file, []):
            if begin < last and first < begin + len(fault.text):
                complain(f'overlaps {other}')
        spans[fault.file].append((fault.name, begin, begin + len(fault.text)))
    return wrong
