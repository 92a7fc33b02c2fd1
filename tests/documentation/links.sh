#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# links.sh TOP: every relative link of a page names a file that is there, and a heading of it if it has an anchor; a page has at most
# 1500 words, the README 1000.
set -euo pipefail
cd "$1"
failed=0
wrong() { echo "$*"; failed=1; }

# anchors PAGE: of its headings, as GitHub makes them
anchors() { awk '/^```/ { code = !code } /^#+ / && !code' "$1" | sed -E 's/^#+ //' | tr '[:upper:]' '[:lower:]' | sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'; }

# links PAGE: their targets, also those whose text goes over a line's end; blocks and code have none
links() { awk '/^```/ { code = !code; next } !code' "$1" | tr '\n' ' ' | sed -E 's/`[^`]*`//g' | grep -oP '\]\(\K[^)]+' || true; }

mapfile -t pages < <(find . \( -name .git -o -path ./build -o -name results \) -prune -o -name '*.md' -print | sort)
for page in "${pages[@]}"; do
  while read -r link; do
    [[ -n $link && $link != *://* && $link != mailto:* ]] || continue
    file=${link%%#*} target=$page
    [ -z "$file" ] || target=$(dirname "$page")/$file
    [ -e "$target" ] || { wrong "$page: there is no $file"; continue; }
    [[ $link != *'#'* ]] || anchors "$target" | grep -qxF "${link#*#}" || wrong "$page: there is no heading $link"
  done < <(links "$page")
  most=1500
  [ "$page" != ./README.md ] || most=1000
  words=$(wc -w <"$page")
  [ "$words" -le $most ] || wrong "$page has $words words, more than $most"
done
exit $failed
