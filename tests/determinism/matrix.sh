#!/usr/bin/env bash
# Builds `caustics digest` with g++ and clang++ at -O0, -O2 and -O3, and compares all that they draw on every
# lane width with 1, 2 and 7 threads.
#   matrix.sh [--builds "g++-O0 clang++-O2"] [ARGUMENT ...]
# --builds: only these. The other arguments go to matrix.py: --all takes the sizes of `caustics digest`, and
# programs that
# exist already join the comparison. CAUSTICS_LANES_BUILT=native: of each build the scalar lanes and the
# processor's widest alone.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

wanted="g++-O3 g++-O2 g++-O0 clang++-O3 clang++-O2 clang++-O0"
if [[ ${1:-} == --builds && $# -ge 2 ]]; then
  wanted=$2
  shift 2
fi
if [[ $wanted == *clang* ]]; then ensure_packages tests clang; else ensure_packages tests; fi
programs=()
for name in $wanted; do
  if ! [[ $name =~ ^(g|clang)\+\+-O[0-3s]$ ]]; then 
    give_up 2 "no such build: '$name'; they are named as g++-O2 is"
  fi
  digest_build "$name" -DCMAKE_CXX_COMPILER="${name%-*}" -DCMAKE_CXX_FLAGS="-${name#*-}" \
    -DCAUSTICS_LANES="${CAUSTICS_LANES_BUILT:-all}"
  programs+=("$builds/$name/caustics_digest")
done
exec "$matrix" "$@" "${programs[@]}"
