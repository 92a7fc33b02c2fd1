#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# names.sh TOP: every function of the plugin, the functions of ffcontact.idp that make meshes, and every result of a contact, has its name in the reference,
# and every named parameter in a page whose headings have the file's function (those of contact_statement.cpp: the contact's).
# "Conventions" and "Several bodies" belong to all functions. Every page with blocks of FreeFEM is in a test.
set -euo pipefail
cd "$1"
pages=(plugin/reference/*.md) failed=0

# words FILE BEFORE AFTER: what stands between both, across line breaks
words() { tr '\n' ' ' <"$1" | grep -oP "$2\\s*\"?\\K\\w+(?=\"?\\s*$3)" || true; }
missing() { echo "the reference does not name $*"; failed=1; }

# text_of FUNCTION: of the pages whose headings have the function, and of those that belong to all
text_of() {
  cat plugin/reference/{conventions,several_bodies}.md $(grep -lE "^#.*\b$1( [A-Z])?\(" "${pages[@]}" || true)
}

mapfile -t sources < <(find plugin -name '*.cpp' | sort)
for function in $(for file in "${sources[@]}"; do words "$file" 'Global\.Add\(' ', "\('; done) $(words edp/ffcontact_meshes.idp 'func mesh3? ' '\(') contactadapt; do
  grep -q "\b$function(" "${pages[@]}" || missing "the function $function"
done
nodal=$(grep -oP '^ *("\w+",? *)+' "$(find plugin -name nodal_results.hpp)" | tr -d '",')
for result in $nodal $(words "$(find plugin -name contact_members.cpp)" 'add_member\(' ','); do
  grep -q "\`C\.$result\`" "${pages[@]}" || missing "C.$result"
done
for file in "${sources[@]}"; do
  parameters=$(words "$file" '\{' ', &typeid')
  [ -n "$parameters" ] || continue
  functions=$(words "$file" 'Global\.Add\(' ', "\(')
  text=$(for function in ${functions:-contact}; do text_of "$function"; done)
  for parameter in $parameters; do
    grep -q "\b$parameter=" <<<"$text" || missing "$parameter= of $(basename "$file")"
  done
done
for parameter in $nodal; do
  grep -q "\b$parameter=" <<<"$(text_of contactsolve)" || missing "$parameter= of contactsolve"
done
for page in $(grep -rl '^```freefem' --include='*.md' --exclude-dir=build --exclude-dir=results .); do
  grep -qw "$(basename "$page" .md)" tests/CMakeLists.txt || { echo "the blocks of $page are in no test"; failed=1; }
done
exit $failed
