#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# blocks.sh FREEFEM [PROCESSES] PAGE...: the pages' blocks of FreeFEM, or those for several processes, one script from the first page
# to the last, run to their end and say no nan.
set -euo pipefail
language=freefem run=("$1")
shift
if [[ $1 =~ ^[0-9]+$ ]]; then
  language=freefem-mpi run=(bash "$(dirname "$0")/../../.setup/processes.sh" "$1" "${run[0]}")
  shift
fi
script=$(basename "$(dirname "$1")")_$(basename "$1" .md)_$language.edp
for page; do
  blocks=$(awk -v first='```'"$language" '$0 == first { inside = 1; next } /^```$/ { inside = 0; print "" } inside' "$page")
  [ -n "$blocks" ] || { echo "no block in $page" >&2; exit 1; }
  printf '// %s\n%s\n' "$(basename "$page")" "$blocks"
done >"$script"
"${run[@]}" "$script" | tee "$script.out"
[ -s "$script.out" ] && ! grep -qiw nan "$script.out"
