#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-format has nothing to change. Its versions differ in details: the one that .clang-format names decides.
set -euo pipefail
command -v clang-format >/dev/null || { echo "skipped: clang-format is not installed"; exit 77; }
wanted=$(sed -nE 's/.*clang-format ([0-9]+).*/\1/p' .clang-format | head -n 1)
[[ $(clang-format --version) =~ version\ ([0-9]+) ]]
[ "${BASH_REMATCH[1]}" = "$wanted" ] || { echo "skipped: this is clang-format ${BASH_REMATCH[1]}, not $wanted"; exit 77; }
report=$(find cpp plugin tests -name '*.?pp' -print0 | xargs -0 clang-format --dry-run 2>&1) || { echo "$report"; exit 1; }
changed=$(sed -nE 's/^([^:]+):[0-9]+:[0-9]+: warning: .*/\1/p' <<<"$report" | sort -u)
[ -z "$changed" ] || { echo "run clang-format -i" $changed; exit 1; }
