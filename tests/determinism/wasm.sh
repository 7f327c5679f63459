#!/usr/bin/env bash
# The same bits from WebAssembly: builds `caustics digest` for this machine and, by Emscripten, for
# WebAssembly with and without its SIMD instructions, runs the latter in Node.js, and compares all attachments
# of the sample scenes. One thread. Arguments go to matrix.py.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

ensure_packages tests emscripten nodejs
portable_packages
digest_build g++-O2 -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-O2
# Emscripten 3.1.6 takes Node.js 18 and later, which have fetch(), for browsers: hence
# --no-experimental-fetch.
programs=("$builds/g++-O2/caustics_digest")
linking="--pre-js $root/tests/determinism/node_environment.js -fexceptions -sALLOW_MEMORY_GROWTH=1"
linking+=" -sNODERAWFS=1 -sTOTAL_STACK=8MB -sEXIT_RUNTIME=1"
for simd in "" -msimd128; do
  name=wasm${simd:+-simd}
  digest_build "$name" "${portable[@]}" \
    -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake \
    -DCMAKE_CXX_FLAGS="-O1 -fexceptions $simd -include $root/tests/determinism/libcxx_gaps.hpp" \
    -DCMAKE_EXE_LINKER_FLAGS="$linking"
  programs+=("$name=node --no-experimental-fetch $builds/$name/caustics_digest.js")
done
emcc --version | head -n 1
node --version
exec "$matrix" --threads 1 "$@" "${programs[@]}"
