#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file starts with its licence; in a script the line #! stands before it.
set -euo pipefail
failed=0
while read -r file; do
  { read -r line; [[ $line != '#!'* ]] || read -r line; } <"$file" || line=
  [[ $line =~ ^(//|#)\ SPDX-License-Identifier:\ GPL-3.0-or-later$ ]] || { echo "no SPDX line at the top: $file"; failed=1; }
done < <(find . \( -path ./build -o -path ./.git -o -name results \) -prune -o -type f \
  -regextype posix-extended -regex '.*(\.([chi]pp|edp|idp|geo|py|sh|cmake|in)|/CMakeLists.txt|/[a-z_]+|/\.clang-\w+)' -print | sort)
exit $failed
