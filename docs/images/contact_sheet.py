#!/usr/bin/env python3
"""Draws every glTF file of folders at the defaults, as one sheet: docs/images/foreign_scenes.jpg.

    docs/images/contact_sheet.py [--before PROGRAM] [--columns N] PROGRAM FOLDER ...

With --before, another program's picture stands to the left of each. Files go by name, folder after folder,
row by row, N pictures in each (4). What the program says of each goes to the standard output. Needs Debian's
ffmpeg."""
import argparse
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SIZE = (320, 180)


def draw(program, scene, picture):
    """What the program said; a black picture where it drew none."""
    command = [program, scene, '-r', '%dx%d' % SIZE, '-o', picture]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode:
        subprocess.run(['ffmpeg', '-v', 'error', '-y', '-f', 'lavfi', '-i', 'color=black:s=%dx%d' % SIZE,
                        '-frames:v', '1', picture], check=True)
    return '\n'.join(line for line in run.stderr.splitlines() if not line.startswith(('pass ', 'finding ')))


def tiled(pictures, columns, sheet):
    rows = -(-len(pictures) // columns)
    inputs = [word for picture in pictures for word in ('-i', picture)]
    frames = ''.join(f'[{i}]' for i in range(len(pictures)))
    tile = f'{frames}concat=n={len(pictures)}:v=1,tile={columns}x{rows}:padding=4:color=white'
    subprocess.run(['ffmpeg', '-v', 'error', '-y', *inputs, '-filter_complex', tile, '-frames:v', '1',
                    '-q:v', '3', sheet], check=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('program')
    parser.add_argument('folders', nargs='+', type=pathlib.Path)
    parser.add_argument('--before')
    parser.add_argument('--columns', type=int, default=4)
    arguments = parser.parse_args()
    programs = [program for program in (arguments.before, arguments.program) if program]
    scenes = [scene for folder in arguments.folders for scene in sorted(folder.glob('*.gl*'))]
    with tempfile.TemporaryDirectory() as folder:
        pictures = []
        for scene in scenes:
            for program in programs:
                pictures.append(pathlib.Path(folder) / f'{len(pictures)}.png')
                said = draw(program, scene, pictures[-1])
            print(f'{scene.name}\n{said}\n', flush=True)
        tiled(pictures, arguments.columns, HERE / 'foreign_scenes.jpg')


if __name__ == '__main__':
    main()
