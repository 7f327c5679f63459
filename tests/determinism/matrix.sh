#!/usr/bin/env bash
# Builds `caustics digest` with g++ and clang++ at -O0, -O2 and -O3, and compares all that they draw on every lane width
# with 1, 2 and 7 threads. Arguments go to matrix.py: --all takes the sizes of `caustics digest`.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

ensure_packages clang
programs=()
for compiler in g++ clang++; do
  for level in 3 2 0; do
    digest_build "$compiler-O$level" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-O$level"
    programs+=("$builds/$compiler-O$level/caustics_digest")
  done
done
exec "$matrix" "$@" "${programs[@]}"
