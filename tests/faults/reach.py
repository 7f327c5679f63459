"""Which tests reach which places of a planted build, and what each takes: found by one run of all tests
without a fault, kept beside the build, and found anew after each build."""
import dataclasses
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

SKIPPED = 4  # tests/support/skip.hpp: what cannot run notices nothing
LONGEST = 900  # seconds; what takes longer hangs, which a test run notices, too
# What needs more than the planted copy has, or compares times.
LEFT_OUT = {'launcher_test.py', 'docs_pictures_test.py', 'povray_test.py', 'bench_test.py'}
# What computes long; `--quick` leaves it out.
SLOW_CASES = (
    'truth', 'area light', 'all around', 'water film', 'torture:', 'textured casters', 'hard cases',
    'failing', 'parity:', 'random', 'gl: memory', 'Draco data', 'determinism', 'lanes: random', 'Sphere',
    'Half ring')
SLOW_FILES = {
    'animation_test.py', 'compare_metrics_test.py', 'faults_test.py', 'frame_costs_test.py', 'gl_test.py',
    'inspect_page_test.py', 'inspect_test.py', 'lights_test.py', 'memory_test.py', 'on_demand_test.py',
    'paper_test.py', 'probe_test.py', 'study_test.py', 'water_test.py', 'written_page_test.py'}
# Tests that compare with kept files, which they write with `--update`.
KEPT = ('golden_test.py', 'outputs_test.py')
# Tests that hold all that is put out against what is kept. They notice most, so that they are tried early.
OF_ALL_OUTPUT = {*KEPT, 'page_shown_test.py', 'command_line_doc_test.py'}


CATCH2_PARTS = 4


@dataclasses.dataclass
class Test:
    file: str  # of Python tests; '' for Catch2's
    name: str
    seconds: float
    places: set


def run(command, environment, folder, timeout):
    """Exit status and output; the whole group of processes ends with it. None where it does not end."""
    environment = {**os.environ, 'PYTHONDONTWRITEBYTECODE': '1', **environment}
    with tempfile.TemporaryFile('w+', errors='replace') as output:
        child = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                 stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            status = child.wait(timeout)
        except subprocess.TimeoutExpired:
            status = None
        finally:
            try:
                os.killpg(child.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            child.wait()
        output.seek(0)
        return status, output.read()


def files_of_tests(source, quick):
    files = sorted((source / 'tests').glob('program/*_test.py')) + sorted(
        (source / 'tests').glob('inspect/*_test.py'))
    return [file for file in files if file.name not in LEFT_OUT and not (quick and file.name in SLOW_FILES)]


def interpreter(file):
    """Of the page's tests the system's, which has Debian's selenium, as in tests/inspect/room.cmake."""
    system = '/usr/bin/python3'
    return system if 'tests/inspect' in str(file) and os.path.exists(system) else sys.executable


def case_names(build, quick):
    """Catch2's tests by name, which version 2 and 3 list in ways of their own."""
    for listing in (['--list-test-names-only'], ['--list-tests', '--verbosity', 'quiet']):
        status, output = run([str(build / 'caustics_tests'), *listing], {}, '/', 100)
        names = [line.strip() for line in output.splitlines() if line.strip()]
        if len(names) > 100:
            return [name for name in names if not (quick and name.startswith(SLOW_CASES))]
    sys.exit(f'reach.py: caustics_tests does not list its tests: {output[-300:]}')


def lines_of(log):
    for line in log.read_text(errors='replace').splitlines():
        name, seconds, passed, places = line.split('\t')
        yield name, float(seconds), passed == '1', {int(place) for place in places.split()}


def keep_answers(source, program, pool):
    """What these files keep is written anew by the planted program: a choice between a text and its fault has
    brackets of its own, so that sums and products round in another order."""
    answers = [(name, pool.submit(run, [sys.executable, str(source / 'tests/program' / name), '--update'],
                                  program, str(source), 4000)) for name in KEPT]
    for name, answer in answers:
        status, output = answer.result()
        if status != 0:
            print(f'{name} --update ended with {status}: {output[-500:]}', flush=True)


def find(build, source, quick, pool):
    """All tests that pass here."""
    with tempfile.TemporaryDirectory() as scratch:
        scratch, answers, tests = pathlib.Path(scratch), [], []
        program = {'CAUSTICS_PROGRAM': str(build / 'caustics')}
        keep_answers(source, program, pool)
        # In parts: Catch2 runs one test after the other.
        names = case_names(build, quick)
        for part in range(CATCH2_PARTS):
            log = scratch / f'catch2_{part}'
            command = [str(build / 'caustics_tests'), *map(pattern, names[part::CATCH2_PARTS])]
            logged = {**program, 'CAUSTICS_REACH_LOG': str(log)}
            answers.append(('', log, pool.submit(run, command, logged, scratch, 4000)))
        for file in files_of_tests(source, quick):
            log = scratch / file.name
            runner = str(pathlib.Path(__file__).with_name('reach_of.py'))
            command = [interpreter(file), runner, str(file), str(log)]
            name = str(file.relative_to(source))
            answers.append((name, log, pool.submit(run, command, program, scratch, 4000)))
        for file, log, answer in answers:
            status, output = answer.result()
            if not log.is_file():
                print(f'no test of {file or "Catch2"} runs: {output[-500:]}', flush=True)
                continue
            for name, seconds, passed, places in lines_of(log):
                if passed:
                    tests.append(Test(file, name, seconds, places))
                elif 'kipped' not in output:
                    print(f'left out, since it fails without a fault: {file} {name}', flush=True)
        return tests


def known_or_found(build, source, quick, pool):
    kept = build / ('reach_quick.json' if quick else 'reach.json')
    made = max((build / name).stat().st_mtime for name in ('caustics', 'caustics_tests'))
    if kept.is_file() and kept.stat().st_mtime > made:
        return [Test(*row[:3], set(row[3])) for row in json.loads(kept.read_text())]
    tests = find(build, source, quick, pool)
    kept.write_text(json.dumps([[t.file, t.name, t.seconds, sorted(t.places)] for t in tests]))
    return tests


def groups(tests):
    """Groups of tests that share a process, the cheapest first: of Catch2's in shares that grow, of a file's
    quick methods; a slow method is alone."""
    shares, sum_of_share, limit = [[]], 0.0, 0.5
    for test in sorted((t for t in tests if not t.file), key=lambda t: t.seconds):
        if shares[-1] and sum_of_share + test.seconds > limit:
            shares.append([])
            sum_of_share, limit = 0.0, limit * 3
        shares[-1].append(test)
        sum_of_share += test.seconds
    files = {}
    for test in tests:
        if test.file:
            files.setdefault((test.file, test.name if test.seconds > 2 else ''), []).append(test)

    def cost(group):
        seconds = sum(t.seconds for t in group) + (0.3 if group[0].file else 0)
        return seconds / (4 if pathlib.Path(group[0].file).name in OF_ALL_OUTPUT else 1)
    return sorted([share for share in shares if share] + list(files.values()), key=cost)


def words(text):
    """Of a path or a test's name, without what many have."""
    common = {'test', 'tests', 'program', 'pipeline', 'passes', 'page', 'inspect', 'scene', 'light', 'shared',
              'glsl'}
    return set(re.findall(r'[a-z0-9]{4,}', text.lower())) - common


def by_subject(tests, path):
    """Groups of the tests whose file or subject has a word of the fault's path, then of the others."""
    subject = words(path)
    about = [t for t in tests if subject & words(pathlib.Path(t.file).stem or t.name.split(':')[0])]
    return groups(about) + groups([t for t in tests if t not in about])


class Runner:
    """Runs groups of tests with a fault."""

    def __init__(self, build, source):
        self.build, self.source = build, source

    def command(self, group):
        if group[0].file:
            names = [test.name for test in group]
            file = self.source / group[0].file
            return [interpreter(file), str(file), '--failfast', *names]
        return [str(self.build / 'caustics_tests'), '--abort', *(pattern(test.name) for test in group)]

    def failing(self, group, fault):
        """The name of the test that fails, or None."""
        limit = 60 + 10 * sum(test.seconds for test in group)
        environment = {'CAUSTICS_FAULT': fault, 'CAUSTICS_PROGRAM': str(self.build / 'caustics')}
        with tempfile.TemporaryDirectory() as folder:
            status, output = run(self.command(group), environment, folder, min(limit, LONGEST))
        if status is None:
            return 'does not end'
        if 'No tests ran' in output:
            sys.exit(f'reach.py: none of these is a test: {[test.name for test in group]}')
        if status in (0, SKIPPED):
            return None
        if not group[0].file:
            return next(iter(re.findall(r'^-{70,}\n(.*)\n-{70,}', output, re.M)), group[0].name)
        found = re.findall(r'^(?:FAIL|ERROR): (\w+) \((?:__main__\.)?(\w+)', output, re.M)
        return '.'.join(reversed(found[0])).replace('.setUpClass', '') if found else group[0].name

    def notices(self, group, fault):
        """The test that fails with the fault and not without: a busy machine makes some fail by
        themselves."""
        name = self.failing(group, fault)
        if name is None or not (group[0].file or name == 'does not end'):
            return name
        again = [test for test in group if test.name == name or test.name.startswith(name + '.')] or group
        return name if self.failing(again, '') is None else None


def escaped(name):
    """A name in which Catch2 takes no comma or bracket for one of its own."""
    return re.sub(r'([\\,"\[\]])', r'\\\1', name)


def pattern(name):
    """The test of this name alone, among several arguments of Catch2."""
    return escaped(name) + ','
