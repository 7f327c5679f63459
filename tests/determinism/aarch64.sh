#!/usr/bin/env bash
# The same bits on aarch64: builds `caustics digest` for this machine and for aarch64 (g++'s cross compiler,
# linked statically), runs the latter under QEMU's user mode, and compares all attachments of the sample
# scenes. One thread: the cross build has no oneTBB. Arguments go to matrix.py.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

ensure_packages tests g++-aarch64-linux-gnu qemu-user-static
portable_packages
digest_build g++-O2 -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-O2
digest_build aarch64 "${portable[@]}" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
  -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_CXX_FLAGS=-O1 -DCMAKE_EXE_LINKER_FLAGS=-static
aarch64-linux-gnu-g++ --version | head -n 1
qemu-aarch64-static --version | head -n 1
exec "$matrix" --threads 1 "$@" "$builds/g++-O2/caustics_digest" \
  "aarch64=qemu-aarch64-static $builds/aarch64/caustics_digest"
