#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install.sh BUILD SCRATCH COMPILER FLAGS: installs the build into SCRATCH, loads the installed plugin in FreeFEM, and builds
# and runs a project that uses the installed library.
set -euo pipefail
build=$1 scratch=$2 compiler=$3 flags=${4//;/ }
consumer=$(dirname "${BASH_SOURCE[0]}")/consumer
rm -rf "$scratch"
mkdir -p "$scratch"
prefix=$scratch/prefix

cmake --install "$build" --prefix "$prefix" >"$scratch/install.log"

if [ -f "$build/freefem" ]; then
  idp=$prefix/share/ffcontact/idp
  [ -f "$idp/ffcontact.idp" ]
  printf '%s\n' "load \"$prefix/lib/ffcontact/ffcontact\"" 'include "ffcontact.idp"' 'cout << "loaded" << endl;' >"$scratch/load.edp"
  FF_LOADPATH=$prefix/lib/ffcontact FF_INCLUDEPATH=$idp "$build/freefem" "$scratch/load.edp"
fi

cmake -G Ninja -S "$consumer" -B "$scratch/consumer" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_BUILD_TYPE=Release >"$scratch/configure.log"
cmake --build "$scratch/consumer"
"$scratch/consumer/consumer"
