"""One scene on the bench: its files, both programs' commands and times, and the truth they are held
against."""
import functools
import math
import os
import pathlib
import re
import shutil
import subprocess
import time

import export
import glb
import pictures


class Failure(Exception):
    """What ends the comparison: an exit code and one line."""

    def __init__(self, code, line):
        super().__init__(line)
        self.code = code


def timed(command, log):
    """Runs a command; its wall and processor (user and system) seconds. What it says goes to the log."""
    with open(log, 'w') as out:
        before = time.monotonic()
        process = subprocess.Popen([str(part) for part in command], stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=out)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - before
    code = process.returncode = os.waitstatus_to_exitcode(status)
    if code:
        said = [line for line in log.read_text(errors='replace').splitlines() if line.strip()]
        last = said[-1] if said else 'said nothing'
        raise Failure(1, f'{pathlib.Path(command[0]).name} ended with {code}: {last}')
    return {'wall': wall, 'cpu': usage.ru_utime + usage.ru_stime}


class Bench:
    def __init__(self, arguments, file):
        self.arguments, self.file, self.name = arguments, file, file.stem
        self.folder = arguments.output / self.name
        self.scene = glb.read(file)
        if arguments.camera not in self.scene.cameras:
            raise Failure(3, f"{file}: has no orthographic camera '{arguments.camera}'")
        self.view = self.scene.cameras[arguments.camera]
        self.exact = arguments.exact
        if self.exact and not any(mesh.name == self.exact for mesh in self.scene.meshes):
            raise Failure(3, f"{file}: has no mesh '{self.exact}'")

    def path(self, name):
        return self.folder / name

    def read(self, name, layer=None):
        return pictures.read(self.path(name + '.exr'), self.folder, layer)

    def povray(self, name, photons):
        """Renders with POV-Ray; `photons` as export.scene_text has it."""
        self.path(name + '.pov').write_text(export.scene_text(
            self.scene, self.view, photons, self.arguments.physics == 'full', self.exact))
        side, log = self.arguments.resolution, self.path(name + '.log')
        spent = timed([self.arguments.povray, f'+I{self.path(name + ".pov")}',
                       f'+O{self.path(name + ".exr")}', '+FE',
                       f'+W{side}', f'+H{side}', f'+WT{self.arguments.threads}', '-D', '-A', '-P'], log)
        phases = re.findall(r'(Parse|Photon|Trace) Time:.*\(([\d.]+) seconds\)',
                            log.read_text(errors='replace'))
        return {**spent, 'phases': {phase.lower(): float(seconds) for phase, seconds in phases}}

    def caustics(self, command, name, *more):
        side = self.arguments.resolution
        return timed([self.arguments.program, command, self.file, '--camera', self.arguments.camera, '-r',
                      f'{side}x{side}', '-t', self.arguments.threads, '-o', self.path(name + '.exr'),
                      '--quiet', *more],
                     self.path(name + '.log'))

    def render(self, name, size):
        return self.caustics('render', name, '--aov', 'caustic,direct', '--grid', size, '--map', size)

    @functools.cached_property
    def direct(self):
        """POV-Ray's direct light alone."""
        self.povray('direct', None)
        return self.read('direct')

    @functools.cached_property
    def truth(self):
        return Truth(self)

    def caustic(self, setting):
        """A picture's irradiance from the caustic alone, lux."""
        if setting.program == 'caustics':
            return self.read(setting.name, 'caustic')
        return self.read(setting.name).minus(self.direct)


class Setting:
    """One way to render: grid and map of caustics; or POV-Ray's photons, how many an estimate gathers, and,
    where it is not left to POV-Ray, the radius in metres that it begins with."""

    def __init__(self, program, numbers):
        self.program, self.numbers = program, numbers
        self.name = ('render_' if program == 'caustics' else 'photons_') + '_'.join(map(str, numbers))

    def words(self):
        if self.program == 'caustics':
            return 'grid, map %d' % self.numbers
        count, least, most, *radius = self.numbers
        return f'{count} photons, gather {least} to {most}' + ''.join(f' within {r} m' for r in radius)

    def run(self, bench):
        if self.program == 'caustics':
            return bench.render(self.name, *self.numbers)
        count, least, most, *radius = self.numbers
        photons = f'count {count} gather {least}, {most}' + ''.join(f' radius {r}' for r in radius)
        return bench.povray(self.name, photons)


class Truth:
    """Traced light in boxes of pixels. Its noise is measured: the first half of its batches against all of
    them lies as far apart as all of them and the truth, for the difference of the halves, divided by two, is
    what both are. What an earlier run left in the folder is used again."""

    def __init__(self, bench):
        arguments = bench.arguments
        half, whole = (self.traced(bench, share * arguments.truth_batches // 2) for share in (1, 2))
        self.flux = whole.total()
        if self.flux <= 0:
            raise Failure(3, f'{bench.file}: no caustic in the picture')
        self.boxes = {side: whole.boxes(side) for side in arguments.boxes}
        self.noise = {side: pictures.relative_l1(half.boxes(side), self.boxes[side])
                      for side in arguments.boxes}

    @staticmethod
    def traced(bench, batches):
        """The caustic after so many batches: begun, or gone on with from the state in the folder."""
        arguments = bench.arguments
        camera = re.sub(r'\W', '_', arguments.camera)
        words = ['truth', camera, arguments.physics, bench.exact, str(arguments.resolution),
                 str(arguments.truth_rays)]
        state = bench.path('_'.join(filter(None, words)) + '.state')
        name = f'{state.stem}_{batches}'
        more = ['--physics', arguments.physics, '--rays', arguments.truth_rays, '--batches', batches]
        if bench.exact:
            more += ['--exact', f'{bench.exact}=sphere']
        if not bench.path(name + '.exr').exists():
            if state.exists():
                shutil.copy(state, bench.path(name + '.exr.state'))
                more.append('--resume')
            bench.caustics('reference', name, *more)
            bench.path(name + '.exr.state').replace(state)
        return bench.read(name, 'caustic')

    def errors(self, picture):
        """Relative L1 as rendered, and with the light scaled to the truth's: nothing is scaled silently."""
        flux = picture.total() / self.flux
        result = {'flux': flux, 'raw': {}, 'scaled': {}}
        for side, truth in self.boxes.items():
            boxed = picture.boxes(side)
            result['raw'][side] = pictures.relative_l1(boxed, truth)
            scaled = pictures.relative_l1(boxed.scaled(1 / flux), truth) if flux > 0 else math.inf
            result['scaled'][side] = scaled
        return result


def in_turns(settings):
    """One of each program after the other, so that what else the machine does meets both."""
    ours = [s for s in settings if s.program == 'caustics']
    theirs = [s for s in settings if s.program != 'caustics']
    for i in range(max(len(ours), len(theirs))):
        yield from ours[i:i + 1]
        yield from theirs[i:i + 1]


def least(times):
    """Of several times of one setting the least: what disturbs only ever adds."""
    shortest = min(times, key=lambda t: t['wall'])
    return {**shortest, 'cpu': min(t['cpu'] for t in times)}


def direct_light(bench, finest):
    """The calibration: light that reaches the floor and meets no caster, which both must show alike. The
    ratio of what both show where both light the floor; None where the view has no such place."""
    ours, theirs = bench.read(finest.name, 'direct'), bench.direct
    lit = [(b, a) for p, q in zip(ours.planes, theirs.planes) for a, b in zip(p, q) if a > 0 and b > 0]
    if len(lit) < 100:
        return None
    return {'ratio': math.fsum(b for b, _ in lit) / math.fsum(a for _, a in lit),
            'lit_share': len(lit) / (3 * ours.size ** 2), 'relative_l1': pictures.relative_l1(theirs, ours)}


def measured(bench, settings, note):
    """All settings of a scene, in turns, several times: least times and errors."""
    bench.folder.mkdir(parents=True, exist_ok=True)
    times = {}
    for _ in range(bench.arguments.repeat):
        for setting in in_turns(settings):
            note(f'{bench.name}: {setting.program}, {setting.words()}')
            times.setdefault(setting.name, []).append(setting.run(bench))
    note(f'{bench.name}: comparing with traced light')
    rows = [{'program': s.program, 'setting': s.words(), **least(times[s.name]),
             **bench.truth.errors(bench.caustic(s))}
            for s in settings]
    finest = [s for s in settings if s.program == 'caustics'][-1]
    return {'scene': bench.name, 'exact': bench.exact, 'physics': bench.arguments.physics,
            'truth_noise': bench.truth.noise, 'direct': direct_light(bench, finest), 'rows': rows}
