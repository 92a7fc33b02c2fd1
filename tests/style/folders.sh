#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A folder of code has at most 20 units: its list is read at a glance.
set -euo pipefail
crowded=$(find cpp/ffcontact plugin -name '*.?pp' | sed 's/\.[ch]pp$//' | sort -u | xargs -n 1 dirname | uniq -c | awk '$1 > 20')
[ -z "$crowded" ] || { echo "more than 20 units in a folder:"; echo "$crowded"; exit 1; }
