#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# refused.sh FREEFEM SCRIPT: the script must stop with exit code 8 and print what its line `// expect: REGEX` says.
set -u
expected=$(sed -n '/^\/\/ expect: /{s///p;q}' "$2")
[ -n "$expected" ] || { echo "$2 has no line '// expect: REGEX'"; exit 1; }

printed=$("$1" "$2" 2>&1)
code=$?
echo "$printed"
[ $code = 8 ] || { echo "exit code $code instead of 8"; exit 1; }
grep -Eq -- "$expected" <<<"$printed" || { echo "not printed: $expected"; exit 1; }
