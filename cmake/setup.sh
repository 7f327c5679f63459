# What ./caustics and ./test share: packages, configuring, building. Sourced by bash; needs $root, the
# repository's folder. Talk goes to stderr, one line a phase; the compilers' talk goes to a log file.

say() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; }

# Whatever was fetched or built stays.
trap 'say "interrupted; the same command goes on from here"; exit 130' INT

# Prints why, the end of a log file, and leaves with an exit code.
give_up() {
  local code=$1 why=$2 log=${3:-}
  say "$why"
  if [[ -n $log && -s $log ]]; then
    tail -n 25 "$log" >&2
    say "the whole log: $log"
  fi
  exit "$code"
}

# missing_packages program|tests [PACKAGE ...]: what is not installed of packages.txt (the program's part, or
# all of it) and of the packages named; one a line. Systems without dpkg bring them in their own way, and
# CMake says what it misses.
missing_packages() {
  command -v dpkg-query > /dev/null || return 0
  local wanted installed package stop=
  if [[ $1 == program ]]; then stop='/^# For the tests/,$d'; fi
  wanted="$(sed -e "$stop" -e 's/#.*//' "$root/packages.txt") ${*:2}"
  # shellcheck disable=SC2086
  installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' $wanted 2> /dev/null || true)"
  for package in $wanted; do
    if [[ $installed != *" installed:$package "* ]]; then echo "$package"; fi
  done
}

# ensure_packages program|tests [PACKAGE ...]: installs what is missing. Without the right to, or without
# network, prints the line that does it and leaves with 5.
ensure_packages() {
  local missing=() package as_root=() log
  for package in $(missing_packages "$@"); do missing+=("$package"); done
  if ((${#missing[@]} == 0)); then return; fi
  local line="apt-get update && apt-get install --no-install-recommends -y ${missing[*]}"
  if ((EUID != 0)); then
    if ! command -v sudo > /dev/null || ! { [[ -t 0 && -t 2 ]] || sudo -n true 2> /dev/null; }; then
      give_up 5 "packages are missing; as root: $line"
    fi
    as_root=(sudo)
  fi
  say "packages to install: ${missing[*]}"
  mkdir -p "$root/build"
  log=$root/build/packages.log
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -o DPkg::Lock::Timeout=300
    -o Acquire::Retries=1 -o Acquire::http::Timeout=20 -o Acquire::https::Timeout=20)
  "${apt[@]}" update --error-on=any > "$log" 2>&1 < /dev/null ||
    give_up 5 "no list of packages: is there a network? With one, run this again, or as root: $line" "$log"
  say "$("${apt[@]}" install --print-uris --no-install-recommends "${missing[@]}" 2>> "$log" |
    sed -nE 's/.* ([0-9]+) newly installed.*/\1 packages with all that they need/p
      s/^Need to get ([^/]*).* of archives.*/, \1 to fetch/p
      s/^After this operation, (.*) of add.*/, \1 on disk/p' |
    tr -d '\n')"
  "${apt[@]}" install --no-install-recommends -y "${missing[@]}" 2>> "$log" < /dev/null |
    watch_lines "$log" '^(Get|Unpacking|Setting up)[: ]' ||
    give_up 5 "could not install packages; as root: $line" "$log"
}

# Compilers at a time: one a core, and no more than the memory holds at about 1 GiB each.
build_jobs() {
  local cores memory
  cores=$(nproc 2> /dev/null || echo 2)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo 2> /dev/null || true)
  memory=${memory:-$cores}
  ((memory < 1)) && memory=1
  echo $((memory < cores ? memory : cores))
}

# configure FOLDER [CMAKE ARGUMENT ...]
configure() {
  local folder=$1 log=$1/configure.log
  shift
  mkdir -p "$folder"
  # A cache from another place (a moved or mounted checkout) is of no use.
  if [[ -f $folder/CMakeCache.txt ]] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  fi
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCAUSTICS_UNITY_BUILD=ON "$@" \
    > "$log" 2>&1 < /dev/null || return 1
}

# Adds lines to a log file; on a terminal one line shows the latest that matches.
watch_lines() {
  local line width=78
  while IFS= read -r line; do
    printf '%s\n' "$line"
    if [[ -t 2 && $line =~ $2 ]]; then printf '\r  %-*.*s' "$width" "$width" "$line" >&2; fi
  done >> "$1"
  if [[ -t 2 ]]; then printf '\r  %*s\r' "$width" '' >&2; fi
}

# build FOLDER TARGET ...; false when it fails, FOLDER/build.log says why.
build() {
  local folder=$1
  shift
  : > "$folder/build.log"
  cmake --build "$folder" --parallel "$(build_jobs)" --target "$@" 2>&1 < /dev/null |
    watch_lines "$folder/build.log" '^\[[0-9]+/[0-9]+\]'
}

# The program is fresh when nothing that it is made of is newer than the stamp, folders included: they
# change when a file comes or goes.
program_is_fresh() {
  local stamp=$release/.built part parts=()
  [[ -x $release/caustics && -f $stamp ]] || return 1
  for part in pipeline passes raster gl_backend lab app cmake CMakeLists.txt; do
    if [[ -e $root/$part ]]; then parts+=("$root/$part"); fi
  done
  [[ -z $(find "${parts[@]}" -newer "$stamp" ! -name '*_test.cpp' ! -name '*.md' -print -quit) ]]
}

# Runs a command that makes build/release, and remembers when it began if it succeeds.
stamped() {
  touch "$release/.built.new"
  "$@" || return 1
  mv "$release/.built.new" "$release/.built"
}

# One at a time in a build folder: the lock is held until this shell ends or calls unlock.
lock() {
  mkdir -p "$1" 2> /dev/null && { exec 9> "$1/.lock"; } 2> /dev/null ||
    give_up 4 "cannot write to $1; make a copy of the repository that you own"
  flock -n 9 && return
  say "another build is running in $1; waiting for it"
  flock 9
}
unlock() { exec 9>&-; }

release=$root/build/release
