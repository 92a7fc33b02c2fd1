#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# refused.sh FREEFEM SCRIPT: on two processes the script must end with an error within ten seconds and print what its line
# `// expect: REGEX` says; with `// expect: killed` it must only end.
set -u
expected=$(sed -n '/^\/\/ expect: /{s///p;q}' "$2")
[ -n "$expected" ] || { echo "$2 has no line '// expect: REGEX'"; exit 1; }

printed=$(timeout 10 bash "$(dirname "$0")/../../../.setup/processes.sh" 2 "$1" "$2" 2>&1)
code=$?
echo "$printed"
case $code in
  0) echo "no error"; exit 1 ;;
  124) echo "it hangs"; exit 1 ;;
esac
[ "$expected" = killed ] || grep -Eq -- "$expected" <<<"$printed" || { echo "not printed: $expected"; exit 1; }
