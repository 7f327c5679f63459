#!/usr/bin/env bash
# The same bits from WebAssembly: builds `caustics digest` by Emscripten, with SIMD instructions, runs it in
# Node.js, scalar and in lanes of 4, one thread, and compares all attachments of the sample scenes with those
# of a program that exists:
#   wasm.sh build/release/caustics [ARGUMENT ...]
# The other arguments go to matrix.py.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"
(($# >= 1)) || give_up 2 "wasm.sh needs the program to compare with, as build/release/caustics"

ensure_packages tests emscripten nodejs
portable_packages
# Emscripten 3.1.6 takes Node.js 18 and later, which have fetch(), for browsers: hence
# --no-experimental-fetch.
linking="--pre-js $root/tests/determinism/node_environment.js -fexceptions -sALLOW_MEMORY_GROWTH=1"
linking+=" -sNODERAWFS=1 -sTOTAL_STACK=8MB -sEXIT_RUNTIME=1"
digest_build wasm "${portable[@]}" \
  -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake \
  -DCMAKE_CXX_FLAGS="-O1 -fexceptions -msimd128 -include $root/tests/determinism/libcxx_gaps.hpp" \
  -DCMAKE_EXE_LINKER_FLAGS="$linking"
emcc --version | head -n 1
node --version
exec "$matrix" --threads 1 --lanes scalar,plain4 "$@" \
  "wasm=node --no-experimental-fetch $builds/wasm/caustics_digest.js"
