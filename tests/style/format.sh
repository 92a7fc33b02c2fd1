#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-format has nothing to change.
set -euo pipefail
command -v clang-format >/dev/null || { echo "skipped: clang-format is not installed"; exit 77; }
failed=0
while read -r file; do
  clang-format "$file" | cmp -s - "$file" || { echo "to be formatted: clang-format -i $file"; failed=1; }
done < <(find cpp plugin tests -name '*.?pp' | sort)
exit $failed
