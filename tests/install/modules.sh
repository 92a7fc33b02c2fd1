#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# modules.sh BUILD: ffcontact.so is complete without what only solids need, ffcontact_solids.so with it, and no file is built for
# plane bodies that ffcontact.so does not need (cpp/CMakeLists.txt says which are of which library).
set -euo pipefail
build=$1 failed=0

for module in ffcontact ffcontact_solids; do
  missing=$(nm -uC "$build/plugin/$module.so" | grep ' ffcontact::' || true)
  [ -z "$missing" ] || { echo "$module.so lacks what it needs:"; echo "$missing"; failed=1; }
done

# Of modules compiled as one file (UNITY_BUILD) all is needed where one function is.
members=$(ar t "$build/cpp/libffcontact_plane.a" | grep -v '^unity_' | sort)
taken=$(sed -n 's/.*libffcontact_plane\.a(\([^)]*\)).*/\1/p' "$build/plugin/ffcontact.map" | sort -u)
idle=$(comm -23 <(echo "$members") <(echo "$taken"))
[ -z "$idle" ] || { echo "ffcontact.so does not need these files of ffcontact_plane:" $idle; failed=1; }
exit $failed
