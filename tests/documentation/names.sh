#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# names.sh TOP: every function of the plugin and of ffcontact.idp, and every result of a contact, has its name in the reference,
# and every named parameter in a section whose heading has the file's function (those of contact_statement.cpp: the contact's).
# The first lines of the page and "Several bodies" belong to all sections.
set -euo pipefail
cd "$1"
page=plugin/README.md failed=0

# words FILE BEFORE AFTER: what stands between both, across line breaks
words() { tr '\n' ' ' <"$1" | grep -oP "$2\\s*\"?\\K\\w+(?=\"?\\s*$3)" || true; }
missing() { echo "$page does not name $*"; failed=1; }

# section WORD: of the headings with that word, and what belongs to all
section() {
  awk -v word="$1" '/^#/ { wanted = /Several bodies/ || index($0, word "(") || index($0, word " ") || (/^###/ && wanted) }
    NR == 1 { wanted = 1 } wanted' "$page"
}

for function in $(for file in plugin/*.cpp; do words "$file" 'Global\.Add\(' ', "\('; done) $(words edp/ffcontact.idp 'func mesh ' '\('); do
  grep -q "\b$function(" "$page" || missing "the function $function"
done
for result in $(words plugin/contact_members.cpp 'add_member\(' ','); do
  grep -q "\`C\.$result\`" "$page" || missing "C.$result"
done
for file in plugin/*.cpp; do
  parameters=$(words "$file" '\{' ', &typeid')
  [ -n "$parameters" ] || continue
  functions=$(words "$file" 'Global\.Add\(' ', "\(')
  text=$(for function in ${functions:-contact}; do section "$function"; done)
  for parameter in $parameters; do
    grep -q "\b$parameter=" <<<"$text" || missing "$parameter= of $(basename "$file")"
  done
done
exit $failed
