#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# blocks.sh FREEFEM PAGE: the page's blocks of FreeFEM, one script from the first to the last, run to their end and say no nan.
set -euo pipefail
script=$(basename "$(dirname "$2")")_$(basename "$2" .md).edp
awk '/^```freefem$/ { inside = 1; next } /^```$/ { inside = 0; print "" } inside' "$2" >"$script"
[ -s "$script" ] || { echo "no block in $2"; exit 1; }
"$1" "$script" | tee "$script.out"
[ -s "$script.out" ] && ! grep -qiw nan "$script.out"
