#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# No exception of the standard library reaches a user with a text like "map::at": containers are looked up by find or entry_of,
# numbers read by whole_number, an optional tested before it is used; what is thrown is a sentence (Refusal, Failure or what derives
# from them), std::bad_alloc, or std::logic_error for a mistake of the library, which sentence_of says to be one.
# `.at(` is for members of that name, in the files that define them; `.value()` for entries of sparse matrices and sums.
set -euo pipefail
find cpp/ffcontact plugin -name '*.?pp' -print0 | sort -z | xargs -0 perl -0777 -ne '
  s{//[^\n]*}{}g;
  my $has_at = /^(?!\s*return\b)[\w:<>,&* ]*[\w>&*]\s+(?:\w+(?:<\w+>)?::)?at\([^()]*\)\s*(?:const\s*)?[{;]/m;
  my %container = map { $_ => 1 } /\bstd::(?:map|vector|array|deque|set|string|unordered_map)\b[^;(){}=]*?[\s&](\w+)\s*[;,={()]/g;
  my %optional = map { $_ => 1 } /\bstd::optional<[^;(){}=]*>[\s&]+(\w+)/g;
  sub found { my ($text) = @_; my $line = 1 + (substr($_, 0, $-[0]) =~ tr/\n//); print "$ARGV:$line: $text\n"; $failed = 1 }
  while (/(\w+)(?:\.|->)at\(/g) { found("$1.at(") if !$has_at || $container{$1} }
  while (/(\w+)\.value\(\)/g) { found("$1.value()") if $optional{$1} }
  while (/\b(?:std::)?(sto[a-z]{1,3}|any_cast|bad_optional_access)\b\(?/g) { found($1) if $1 =~ /^(?:sto(?:i|l|ul|ll|ull|f|d|ld)|any_cast|bad_optional_access)$/ }
  while (/\bstd::get<\s*[A-Z][^>]*>\(/g) { found($&) }
  while (/\bthrow\s+(std::\w+|\w+)?/g) { my $what = $1 // ""; found("throw $what") if $what =~ /^std::(?!bad_alloc$|logic_error$)/ }
  END { exit($failed ? 1 : 0) }'
