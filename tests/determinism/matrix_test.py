#!/usr/bin/env python3
"""matrix.py against programs that only pretend: it must find what differs, fails or is missing, and name
it."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

MATRIX = pathlib.Path(__file__).with_name('matrix.py')
PRETENDER = '''import os, sys
lanes, threads = os.environ['CAUSTICS_LANES'], sys.argv[sys.argv.index('-t') + 1] if '-t' in sys.argv else ''
if lanes not in ('scalar', 'avx2'):
    sys.exit("caustics: CAUSTICS_LANES is 'none'; this build and processor have: scalar avx2")
lines = ['slab.glb landing[sun] position 11', 'slab.glb landing[sun] flux 22', 'slab.glb compose light 33']
{change}
print('\\n'.join(lines))
'''


class Matrix(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def program(self, name, change=''):
        file = self.folder / name
        file.write_text(PRETENDER.format(change=change))
        return f'{name}={sys.executable} -I -S {file}'

    def run_matrix(self, *programs):
        return subprocess.run([sys.executable, MATRIX, '--threads', '1,7', '--scenes', 'slab.glb', *programs],
                              text=True,
                              capture_output=True, timeout=60)

    def test_programs_that_agree(self):
        result = self.run_matrix(self.program('one'), self.program('two'))
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn('6 of 6 configurations agree on 3 attachments of 1 scenes', result.stdout)

    def test_one_attachment_on_one_lane_width_with_one_number_of_threads(self):
        other = self.program('two', "if lanes == 'avx2' and threads == '7': lines[1] = lines[1][:-1] + '3'")
        result = self.run_matrix(self.program('one'), other)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout, r'\ntwo +avx2 +7 +3 +1 +[0-9.]+  slab.glb landing\[sun\] flux\n')
        self.assertIn('5 of 6 configurations agree', result.stdout)

    def test_missing_attachments_failures_and_silence(self):
        for change, said in (('lines.pop()', 'other attachments'),
                             ('if threads: sys.exit()', 'printed nothing'),
                             ("lines[2] = lines[2].replace('compose', 'glass')", 'glass light'),
                             ('if threads: sys.exit("no such scene")', 'no such scene')):
            result = self.run_matrix(self.program('one'), self.program('two', change))
            self.assertEqual(result.returncode, 1, change)
            self.assertIn(said, result.stdout)

    def test_no_program(self):
        self.assertEqual(self.run_matrix(str(self.folder / 'none')).returncode, 2)
        self.assertEqual(self.run_matrix(f'x={self.folder}/none').returncode, 1)


if __name__ == '__main__':
    unittest.main()
