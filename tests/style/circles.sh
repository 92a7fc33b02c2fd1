#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# No circles: of two files, a header and its source counted as one, the first that includes the second, by whatever others, is not
# included by it. The same holds for two folders.
set -euo pipefail
pairs() {
  find cpp/ffcontact plugin -name '*.?pp' -print0 | xargs -0 perl -ne '
    next unless /^#include "(.*)\.hpp"/;
    my $to = $1;
    my $from = $ARGV =~ s/\.\wpp$//r;
    my ($folder) = $from =~ m{(.*)/};
    ($to) = grep { -f "$_.hpp" } "cpp/$to", "$folder/$to", "plugin/$to";
    print "$from $to\n" if defined $to && $to ne $from;'
}
[ "$(pairs | wc -l)" -gt 500 ] || { echo "no includes found"; exit 1; }
pairs | tsort > /dev/null
pairs | sed -E 's=/[^/ ]+( |$)=\1=g' | awk '$1 != $2' | sort -u | tsort > /dev/null
