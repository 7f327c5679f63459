# What matrix.sh, aarch64.sh, wasm.sh and price.sh share; sourced by bash, with set -euo pipefail. $builds is
# where they build.
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd -P)
# shellcheck source=../../cmake/setup.sh
source "$root/cmake/setup.sh"
builds=$root/build/determinism
matrix=$root/tests/determinism/matrix.py

# digest_build NAME [CMAKE ARGUMENT ...]: builds $target, and nothing that it does not need, in $builds/NAME.
target=caustics_digest
digest_build() {
  local name=$1 folder=$builds/$1 started=$SECONDS
  shift
  configure "$folder" -DCMAKE_BUILD_TYPE=None -DCAUSTICS_BUILD_APP=OFF -DCAUSTICS_BUILD_TESTS=OFF \
    -DCAUSTICS_BUILD_DIGEST=ON -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON \
    -DCMAKE_DISABLE_FIND_PACKAGE_embree=ON "$@" ||
    give_up 1 "$name: configuring failed" "$folder/configure.log"
  build "$folder" "$target" || give_up 1 "$name: building failed" "$folder/build.log"
  say "$name: built in $((SECONDS - started)) s"
}

# For other machines: the libraries that are headers alone, apart from this machine's own headers, and CMake
# packages that name them. $portable holds the arguments that lead CMake there and keep it from this machine's
# libraries.
portable_packages() {
  local folder=$builds/portable package target
  rm -rf "$folder"
  mkdir -p "$folder/include"
  ln -s /usr/include/{glm,nlohmann,CLI} "$folder/include/"
  for package in glm:glm nlohmann_json:nlohmann_json CLI11:CLI11; do
    target=${package%:*}::${package#*:} package=${package%:*}
    mkdir -p "$folder/lib/cmake/$package"
    echo 'set(PACKAGE_VERSION_COMPATIBLE TRUE)' > "$folder/lib/cmake/$package/${package}ConfigVersion.cmake"
    cat > "$folder/lib/cmake/$package/${package}Config.cmake" << CMAKE
add_library($target INTERFACE IMPORTED)
set_target_properties($target PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "$folder/include")
CMAKE
  done
  portable=(-DCAUSTICS_PLAIN_PNG=ON -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
  for package in glm nlohmann_json CLI11; do portable+=("-D${package}_DIR=$folder/lib/cmake/$package"); done
}
