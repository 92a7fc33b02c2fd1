#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# blocks.sh FREEFEM PAGE [PROCESSES]: the page's blocks of FreeFEM, or those for several processes, one script from the first to the
# last, run to their end and say no nan.
set -euo pipefail
language=freefem run=("$1")
if [ -n "${3-}" ]; then language=freefem-mpi run=(bash "$(dirname "$0")/../../.setup/processes.sh" "$3" "$1"); fi
script=$(basename "$(dirname "$2")")_$(basename "$2" .md)_$language.edp
awk -v first='```'"$language" '$0 == first { inside = 1; next } /^```$/ { inside = 0; print "" } inside' "$2" >"$script"
[ -s "$script" ] || { echo "no block in $2"; exit 1; }
"${run[@]}" "$script" | tee "$script.out"
[ -s "$script.out" ] && ! grep -qiw nan "$script.out"
