#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# refused.sh FREEFEM SCRIPT: the script must stop with exit code 8, or 1 where it does not compile, and print what its line
# `// expect: REGEX` says; a line `// environment: NAME=VALUE` is for its environment.
set -u
expected=$(sed -n '/^\/\/ expect: /{s///p;q}' "$2")
[ -n "$expected" ] || { echo "$2 has no line '// expect: REGEX'"; exit 1; }
mapfile -t environment < <(sed -n 's/^\/\/ environment: //p' "$2")

printed=$(env "${environment[@]}" "$1" "$2" 2>&1)
code=$?
echo "$printed"
wanted=8
[[ $expected != 'Compile error'* ]] || wanted=1
[ $code = $wanted ] || { echo "exit code $code instead of $wanted"; exit 1; }
grep -Eq -- "$expected" <<<"$printed" || { echo "not printed: $expected"; exit 1; }
