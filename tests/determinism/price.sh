#!/usr/bin/env bash
# What equal bits cost: milliseconds of all passes in g++ -O3 as it is, with contraction allowed for a
# processor with FMA, and with -ffast-math. Times are taken in turns, one thread, AVX2 lanes; the fastest of
# three frames, then the median of the turns.
#   price.sh [TURNS]     at least 2; 7 unless given, and a quarter of an hour then
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

turns=${1:-7}
[[ $turns =~ ^[1-9][0-9]*$ ]] && ((turns >= 2)) ||
  give_up 2 "TURNS is '$turns', must be a number of at least 2"
ensure_packages tests
target=caustics_pass_times
digest_build g++-O3 -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-O3
inexact() {  # NAME FLAGS
  INEXACT_FLAGS=$2 digest_build "$1" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-O3 \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$root/tests/determinism/without_promise.sh"
}
inexact contracted "-ffp-contract=fast -march=haswell"
inexact fast-math "-ffast-math -march=haswell -U__FAST_MATH__"
exec python3 - "$root" "$builds" "$turns" << 'PYTHON'
import os
import statistics
import subprocess
import sys

root, builds, turns = sys.argv[1], sys.argv[2], int(sys.argv[3])
names = ['g++-O3', 'contracted', 'fast-math']
os.environ['CAUSTICS_LANES'] = 'avx2'
print('scene            ms      contracted  fast-math   '
      '(times of the build as it is; quartiles of the turns)')
for scene in ['glass_sphere', 'water_sine', 'two_lights', 'spectrum']:
    times = {name: [] for name in names}
    for _ in range(turns):
        for name in names:
            command = [f'{builds}/{name}/caustics_pass_times', f'{root}/scenes/{scene}.glb', '3', '-t', '1']
            lines = subprocess.run(command, check=True, text=True, capture_output=True,
                                   stdin=subprocess.DEVNULL).stdout
            times[name].append(min(map(float, lines.split())))
    row = f'{scene:14} {statistics.median(times[names[0]]):6.0f}'
    for name in names[1:]:
        ratios = [a / b for a, b in zip(times[name], times[names[0]])]
        low, middle, high = statistics.quantiles(ratios, n=4)
        row += f'   {middle:.2f} ({low:.2f}..{high:.2f})'
    print(row, flush=True)
PYTHON
