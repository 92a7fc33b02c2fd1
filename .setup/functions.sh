# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by edp/run, tests/run, tests/coverage, tests/mutants, tests/bench/run and .ci/run: what they install and how they build.
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages_to_run=(cmake ninja-build g++ freefem++ libfreefem++-dev libsuitesparse-dev libopenblas-dev libeigen3-dev gmsh)
packages_to_share=("${packages_to_run[@]}" libmumps-dev libopenmpi-dev openmpi-bin)
packages_to_draw=(python3 python3-matplotlib python3-numpy python3-pil)
packages_to_test=("${packages_to_share[@]}" libgtest-dev librapidcheck-dev clang-format)
packages_to_sanitize=("${packages_to_test[@]}" clang libclang-rt-dev libomp-dev)
packages_to_cover=("${packages_to_test[@]}" gcovr)
packages_to_check=("${packages_to_test[@]}" clang-tidy)
packages_to_measure=("${packages_to_run[@]}" libbenchmark-dev)

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

# install PACKAGE...: those that are missing.
install() {
  local package missing=() sudo=()
  command -v dpkg-query >/dev/null || { say "this is no Debian, so nothing is installed; needed: $*"; return; }
  for package; do is_installed "$package" || missing+=("$package"); done
  [ ${#missing[@]} = 0 ] && return
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || fail "please install as root: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  say "installing ${missing[*]}"
  quietly "${sudo[@]}" apt-get update || say "apt-get update failed; going on with the lists at hand"
  quietly "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" ||
    fail "apt-get install failed"
}

# configure PRESET [CMake options]
configure() {
  say "configuring ($1)"
  (cd "$top" && quietly cmake --preset "$@") || fail "the configuration failed"
}

# build PRESET TARGET, with a compiler for each core: two more, which is what Ninja starts, crowd the caches (a tenth of the time)
build() {
  say "building ($1)"
  quietly cmake --build "$top/build/$1" --target "$2" --parallel "$(nproc)" -- --quiet || fail "the build failed"
}

# A new seed for the random cases of the tests, one for all programs of a run; said, so that the run can be replayed.
draw_seed() {
  [[ ${RC_PARAMS-} = *seed=* ]] || export RC_PARAMS="seed=$RANDOM$RANDOM ${RC_PARAMS-}"
  say "random cases: RC_PARAMS=\"$RC_PARAMS\""
}
