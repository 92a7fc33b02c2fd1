#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install.sh BUILD SCRATCH COMPILER FLAGS: installs the build into SCRATCH, runs scripts with the installed command, and builds
# and runs the example that uses the installed library.
set -euo pipefail
build=$1 scratch=$2 compiler=$3 flags=${4//;/ }
rm -rf "$scratch"
mkdir -p "$scratch"
prefix=$scratch/prefix

cmake --install "$build" --prefix "$prefix" >"$scratch/install.log"

# ffcontact-freefem ...: the installed command, from a folder of its own; a plugin with sanitizers needs what the build preloads.
installed() (
  eval "$(grep -s '^export LD_PRELOAD' "$build/freefem" || true)"
  cd "$scratch"
  "$prefix/bin/ffcontact-freefem" "$@" </dev/null 2>&1
)

if [ -f "$build/freefem" ]; then
  printf '%s\n' 'load "iovtk"' 'include "getARGV.idp"' 'include "ffcontact.idp"' \
    'cout << "loaded with " << getARGV("-word", "no word") << endl;' >"$scratch/load.edp"
  [ "$(installed load.edp -nw -ne -v 0 -word hello)" = "loaded with hello" ]
  [ "$(installed "$prefix/share/ffcontact/examples/block_pressed.edp" -nw -ne -v 0 | grep -c '^result ')" -gt 1 ]

  # Without the module for solids plane bodies have all, and solids a sentence.
  mv "$prefix"/lib*/ffcontact/ffcontact_solids.so "$scratch"
  printf '%s\n' 'load "msh3"' 'include "ffcontact.idp"' 'mesh3 Th = cube(1, 1, 1);' 'contact C(Th, label=1, friction=0);' >"$scratch/solid.edp"
  [ "$(installed "$prefix/share/ffcontact/examples/block_pressed.edp" -nw -ne -v 0 | grep -c '^result ')" -gt 1 ]
  ! answer=$(installed solid.edp -nw -ne -v 0)
  [[ $answer = *"contact: a mesh3, and comm=, need the module ffcontact_solids beside ffcontact.so"* ]]
  mv "$scratch/ffcontact_solids.so" "$prefix"/lib*/ffcontact
  installed solid.edp -nw -ne -v 0

  printf '%s\n' '#!/bin/sh' 'echo 9.9' >"$scratch/other"
  chmod +x "$scratch/other"
  ! answer=$(FREEFEM_PROGRAM=$scratch/other installed load.edp)
  [[ $answer = *"the plugin was built for FreeFEM "*", and $scratch/other is 9.9: build it with "* ]]
  ! answer=$(FREEFEM_PROGRAM=$scratch/none installed load.edp)
  [[ $answer = *"there is no $scratch/none"* ]]
  installed --help | grep -q '^usage: ffcontact-freefem '
  for file in README.md plugin/README.md LICENSE; do [ -f "$prefix/share/doc/ffcontact/$file" ]; done
  bash "$(dirname "$0")/../documentation/links.sh" "$prefix/share/doc/ffcontact"
fi

cmake -G Ninja -S "$prefix/share/ffcontact/examples/cpp" -B "$scratch/block" -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_BUILD_TYPE=Release >"$scratch/configure.log"
cmake --build "$scratch/block"
"$scratch/block/block" | grep '^normal force -200 N/mm, eps 1\.17'
