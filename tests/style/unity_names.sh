#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The files of a module may be compiled as one (UNITY_BUILD): constants and types that are private to a file
# carry names that nothing in another file of the module has; functions may be overloaded.
set -euo pipefail

failed=0
for module in cpp/ffcontact/*/; do
  # c NAME: a constant or a type; f NAME: a function
  private=$(awk 'FNR == 1 { hidden = 0 }
               /^namespace \{/ { hidden = 1 }
               /^}  \/\/ namespace$/ { hidden = 0 }
               !hidden { next }
               /^(constexpr|const) [^(]*( =|\{)/ { while (match($0, /[A-Za-z_0-9]+(\[[^]]*\])?( =|\{)/)) {
                                                   print "c", substr($0, RSTART, RLENGTH); $0 = substr($0, RSTART + RLENGTH) }
                                                 next }
               /^(class|struct|enum class) [A-Za-z]/ { print "c", $($1 == "enum" ? 3 : 2) }
               /^[A-Za-z].* [*&]?[a-z_0-9]+\(/ { match($0, /[a-z_0-9]+\(/); print "f", substr($0, RSTART, RLENGTH - 1) }' \
                  $(find "$module" -name '*.cpp') /dev/null | sed 's/\[.*//; s/[={].*//; s/ *$//')
  names=$({ grep '^c' <<<"$private" || true; { grep '^f' <<<"$private" || true; } | sort -u; } | cut -d' ' -f2 | sort | uniq -d)
  [ -z "$names" ] || { echo "$module: private names of more than one file: $(echo $names)"; failed=1; }
done
exit $failed
