# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by edp/run, edp/package, the scripts of tests and .ci/run: what they install and how they build.
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages_to_run=(cmake ninja-build g++ freefem++ libfreefem++-dev libsuitesparse-dev libopenblas-dev libeigen3-dev gmsh)
packages_to_share=("${packages_to_run[@]}" libmumps-dev libopenmpi-dev openmpi-bin)
packages_to_draw=(python3 python3-matplotlib python3-numpy python3-pil)
packages_to_test=("${packages_to_share[@]}" libgtest-dev librapidcheck-dev clang-format)
packages_to_sanitize=("${packages_to_test[@]}" clang libclang-rt-dev libomp-dev)
packages_to_cover=("${packages_to_test[@]}" gcovr)
packages_to_check=("${packages_to_test[@]}" clang-tidy)
packages_to_measure=("${packages_to_run[@]}" libbenchmark-dev)
packages_to_pack=("${packages_to_share[@]}" dpkg-dev file lintian)
packages_to_start_fresh=(mmdebstrap git)

export OMP_WAIT_POLICY="${OMP_WAIT_POLICY-passive}"  # threads that wait leave the processor to others

say() { echo "ffcontact: $*" >&2; }
fail() { say "$@"; exit 1; }

# The answer of a long command is of interest only when it fails.
quietly() {
  local log code=0
  log=$(mktemp)
  "$@" </dev/null >"$log" 2>&1 || code=$?
  [ $code = 0 ] || cat "$log" >&2
  rm -f "$log"
  return $code
}

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# May this user use sudo, without a password or with one that a terminal can ask for?
has_sudo() { command -v sudo >/dev/null && { sudo -n true 2>/dev/null || { [ -t 0 ] && sudo -v; }; }; }

# install PACKAGE...: those that are missing.
install() {
  local package missing=() sudo=()
  command -v dpkg-query >/dev/null || { say "this is no Debian, so nothing is installed; needed: $*"; return; }
  for package; do is_installed "$package" || missing+=("$package"); done
  [ ${#missing[@]} = 0 ] && return
  if [ "$(id -u)" != 0 ]; then
    has_sudo || fail "please install as root: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  say "installing ${missing[*]}"
  quietly "${sudo[@]}" apt-get update || say "apt-get update failed; going on with the lists at hand"
  quietly "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" ||
    fail "apt-get install failed"
}

is_writable() { mkdir -p "$top/build" 2>/dev/null && [ -w "$top/build" ]; }

# locked COMMAND...: one build of a checkout at a time. A second one waits, and finds what the first has built.
locked() {
  if [ -n "${build_lock-}" ]; then "$@"; return; fi
  is_writable || fail "$top cannot be written to, and what is built goes there: copy it to a folder of yours (cp -r $top ~) and run it there"
  exec 9>>"$top/build/lock"
  flock --nonblock 9 || { say "waiting for another build of this checkout"; flock 9; }
  build_lock=held
  "$@"
  build_lock=
  exec 9>&-
}

# configure PRESET [CMake options]
configure() { locked configure_alone "$@"; }
configure_alone() {
  discard_foreign_build "$1"
  say "configuring ($1)"
  (cd "$top" && quietly cmake --preset "$@") || fail "the configuration failed"
}

# A build holds the path of its checkout: in a copied or moved one it would build and run the original.
discard_foreign_build() {
  local build=$top/build/$1 home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null) || return 0
  [ "$home" -ef "$top" ] || { say "$build was made for $home: building anew"; rm -rf "$build"; }
}

# build PRESET TARGET, with a compiler for each core: two more, which is what Ninja starts, crowd the caches (a tenth of the time).
build() { locked build_alone "$@"; }
build_alone() {
  local log=$top/build/$1.log code=0
  (set -o pipefail
    cmake --build "$top/build/$1" --target "$2" --parallel "$(nproc)" </dev/null 2>&1 9>&- | tee "$log" | show_progress "$1") || code=$?
  [ $code = 0 ] || { grep -m 1 -A 30 '^FAILED' "$log" >&2 || tail -n 30 "$log" >&2; fail "the build failed: $log has all that was said"; }
}

# Ninja's steps, "[12/345] Building ...": on a terminal one line that counts, elsewhere a line for each tenth. (Debian's awk would
# keep them to itself until it has 4 kB.)
show_progress() {
  local line text tenth shown='' end='\n' begin=''
  if [ -t 2 ]; then end='' begin='\r'; fi
  while IFS= read -r line; do
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && [ "${BASH_REMATCH[1]}" != 0 ] || continue  # 0: it looks for new files
    text="ffcontact: building ($1), step ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
    tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
    if [ -n "$begin" ] || [ "$tenth" != "$shown" ]; then printf "$begin%s$end" "$text" >&2; fi
    shown=$tenth
  done
  [ -z "$begin" ] || [ -z "$shown" ] || echo >&2
}

# A new seed for the random cases of the tests, one for all programs of a run; said, so that the run can be replayed.
draw_seed() {
  [[ ${RC_PARAMS-} = *seed=* ]] || export RC_PARAMS="seed=$RANDOM$RANDOM ${RC_PARAMS-}"
  say "random cases: RC_PARAMS=\"$RC_PARAMS\""
}
