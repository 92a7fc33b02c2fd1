#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The files of a module may be compiled as one (UNITY_BUILD): constants and types that are private to a file
# carry names that no other file of the module has.
set -euo pipefail

failed=0
for module in cpp/ffcontact/*/; do
  names=$(awk 'FNR == 1 { hidden = 0 }
               /^namespace \{/ { hidden = 1 }
               /^}  \/\/ namespace$/ { hidden = 0 }
               !hidden { next }
               /^(constexpr|const) / { while (match($0, /[A-Za-z_0-9]+(\[[^]]*\])?( =|\{)/)) {
                                         print substr($0, RSTART, RLENGTH); $0 = substr($0, RSTART + RLENGTH) } }
               /^(class|struct|enum class) [A-Za-z]/ { print $($1 == "enum" ? 3 : 2) }' "$module"*.cpp |
          sed 's/\[.*//; s/[ ={].*//' | sort | uniq -d)
  [ -z "$names" ] || { echo "$module: private names of more than one file: $(echo $names)"; failed=1; }
done
exit $failed
