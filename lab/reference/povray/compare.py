#!/usr/bin/env python3
"""Compares `caustics render` with POV-Ray's photon mapping: error against traced light, and time
(docs/accuracy.md).

    lab/reference/povray/compare.py [--scene NAME|FILE.glb ...] [--sizes N,...] [--photons N:MIN:MAX[:R],...]
                                     [-o DIR]

Every scene is exported to POV-Ray, rendered by both with several settings in turns, and held against
`caustics reference` in boxes of pixels. Prints tables; writes DIR/povray.json and DIR/SCENE_difference.png,
and leaves all scenes, pictures and logs in DIR/SCENE. Needs POV-Ray 3.7 (package povray), oiiotool and a
built caustics. Exit codes: 0 done; 1 a program failed; 2 wrong usage; 3 a program is missing, or a scene
cannot be exported."""
import argparse
import json
import math
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
import bench as benches  # noqa: E402
import glb  # noqa: E402
import report  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENES = 'glass_sphere', 'metal_ring', 'water_sine'
SIZES = '64,128,256,512'
# Few photons bear no wide estimate, of many a narrow one keeps the noise; a small radius keeps edges sharp
# and makes dim places noisy. Which serves best depends on the scene.
PHOTONS = '10000:20:100,100000:20:100,300000:20:100,300000:20:100:0.01,1000000:50:300,1000000:50:300:0.01'


def positive(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def numbers(text):
    return sorted(positive(word) for word in text.split(','))


def sizes(text):
    return [benches.Setting('caustics', (n,)) for n in numbers(text)]


def photons(text):
    settings = []
    for word in text.split(','):
        count, least, most, *radius = word.split(':')
        if len(radius) > 1 or any(not 0 < float(r) < math.inf for r in radius):
            raise ValueError
        settings.append(benches.Setting('POV-Ray', (positive(count), positive(least), positive(most),
                                                    *map(float, radius))))
    return settings


def arguments_of(words):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    option = parser.add_argument
    option('--scene', action='append',
           help=f'a sample scene or a file; may stand several times ({", ".join(SCENES)})')
    option('--camera', default='floor', metavar='NAME', help='an orthographic camera of the scene (floor)')
    option('--sizes', type=sizes, default=SIZES, metavar='N,...', help=f'grid and map of render ({SIZES})')
    option('--photons', type=photons, default=PHOTONS, metavar='N:MIN:MAX[:R],...',
           help=f"POV-Ray's photons, how many an estimate gathers, within which radius at first, metres "
                f"({PHOTONS})")
    option('-r', '--resolution', type=positive, default=512, metavar='N', help='pixels a side (512)')
    option('--boxes', type=numbers, default='4,8', metavar='N,...', help='sides of the boxes, pixels (4,8)')
    option('--physics', choices=('single', 'full'), default='single',
           help='light in and out of glass once, as render has it, or every way that it takes (single)')
    option('--exact', metavar='NAME',
           help='this mesh is a sphere: POV-Ray and the truth have the sphere itself')
    option('--truth-rays', type=positive, default=2048, metavar='N',
           help='N x N rays a batch of traced light (2048)')
    option('--truth-batches', type=positive, default=4, metavar='N',
           help='batches, an even number from 4 on (4)')
    option('--repeat', type=positive, default=2, metavar='N',
           help='times each setting runs; the least counts (2)')
    option('-t', '--threads', type=positive, default=2, metavar='N', help='threads of each program (2)')
    option('--program', default=ROOT / 'build/release/caustics', metavar='FILE',
           help='caustics (build/release/caustics)')
    option('--povray', default='povray', metavar='FILE', help='POV-Ray (povray)')
    option('-o', '--output', type=pathlib.Path, default=pathlib.Path('povray_comparison'), metavar='DIR',
           help='made where it is missing (povray_comparison)')
    arguments = parser.parse_args(words)
    if any(arguments.resolution % side for side in arguments.boxes):
        parser.error('--resolution: must be a multiple of every box')
    if arguments.truth_batches < 4 or arguments.truth_batches % 2:
        parser.error('--truth-batches: must be an even number from 4 on')
    return arguments


def need_programs(arguments):
    for program, way_on in ((arguments.povray, 'install the package povray'),
                            ('oiiotool', 'install the package openimageio-tools'),
                            (arguments.program, 'build caustics, or name it with --program')):
        if not shutil.which(program):
            raise benches.Failure(3, f'{program}: is not here; {way_on}')


def main(words):
    arguments = arguments_of(words)
    need_programs(arguments)
    files = [ROOT / 'scenes' / f'{s}.glb' if s.isidentifier() else pathlib.Path(s)
             for s in arguments.scene or SCENES]
    settings = arguments.sizes + arguments.photons
    results = []
    for bench in [benches.Bench(arguments, file) for file in files]:
        result = benches.measured(bench, settings, lambda line: print(line, file=sys.stderr, flush=True))
        result['equal_error'] = report.equal_error(result['rows'], arguments.boxes[0])
        results.append(result)
        report.print_tables(result, arguments.boxes)
        sys.stdout.flush()
        report.write_difference(bench, settings, arguments.output / f'{bench.name}_difference.png')
    kept = {key: getattr(arguments, key)
            for key in ('camera', 'resolution', 'boxes', 'physics', 'exact', 'truth_rays',
                                                     'truth_batches', 'repeat', 'threads')}
    (arguments.output / 'povray.json').write_text(json.dumps({'format': 1, 'settings': kept,
                                                              'scenes': results},
                                                             indent=1) + '\n')


if __name__ == '__main__':
    try:
        main(sys.argv[1:])
    except KeyboardInterrupt:
        sys.exit(130)
    except (benches.Failure, glb.Unsupported, OSError, subprocess.CalledProcessError) as failure:
        print(f'compare.py: {failure}', file=sys.stderr)
        failed = isinstance(failure, subprocess.CalledProcessError)
        sys.exit(getattr(failure, 'code', 1 if failed else 3))
