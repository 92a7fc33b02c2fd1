#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The modules are a total order: a file includes only from its own module and from those before it.
set -euo pipefail
order=(base linear mesh elastic interface contact equilibrium estimate bounds sizing parallel)

failed=0
for module in cpp/ffcontact/*/; do
  [[ " ${order[*]} " == *" $(basename "$module") "* ]] || { echo "$module is not in the order: ${order[*]}"; failed=1; }
done
for i in "${!order[@]}"; do
  later=$(IFS='|'; echo "${order[*]:i+1}")
  [ -z "$later" ] && continue
  grep -rnE "^ *# *include *[<\"]ffcontact/($later)/" "cpp/ffcontact/${order[i]}" && failed=1
done
grep -rnE '^ *# *include *[<"](\.\./|ffcontact/ffcontact\.hpp)' cpp/ffcontact && failed=1
exit $failed
