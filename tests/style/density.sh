#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Functions are short and airy: a median of at most 7 lines and 71 tokens, none over 50 lines; lines of code have 40 characters
# in the mean. A function is its head and its body, without comments; what is written within it belongs to it.
set -euo pipefail
find cpp/ffcontact plugin -name '*.?pp' -print0 | sort -z | xargs -0 perl -0777 -ne '
  BEGIN {
    our ($most_lines, $median_lines, $median_tokens, $mean_width) = (50, 7, 71, 40);
    our $token = qr/[A-Za-z_]\w*|\d[\w.]*|"(?:\\.|[^"\\])*"|::|->|<<|>>|<=|>=|==|!=|&&|\|\||[-+*\/%]=|\+\+|--|\S/;
    our $qualifiers = qr/(?:const|noexcept|override|final|\s)*(?:->\s*[\w:<>,\s]+)?(?::[^;{}]*)?/;
  }
  s{/\*.*?\*/}{}gs;
  s{//[^\n]*}{}g;
  for (grep { /\S/ } split /\n/) { s/\s+$//; $characters += length; ++$code_lines }
  s/^\s*#[^\n]*//gm;
  my (@open, $function);  # where braces open, and how many are open in the function at hand
  my $head = 0;
  while (/"(?:\\.|[^"\\])*"|\x27(?:\\.|[^\x27\\])\x27|[{};]/g) {
    my ($mark, $place) = ($&, $-[0]);
    if ($mark eq "{") {
      my $before = substr($_, $head, $place - $head);
      push @open, $head;
      $function //= @open if $before =~ /\)\s*$qualifiers$/;
    } elsif ($mark eq "}" && @open) {
      my $start = pop @open;
      if (defined $function && @open == $function - 1) {
        undef $function;
        my $text = substr($_, $start, $place + 1 - $start);
        push @tokens, scalar(() = $text =~ /$token/g);
        push @lines, scalar(grep { /\S/ } split /\n/, $text);
        print "$ARGV: a function of $lines[-1] lines\n" if $lines[-1] > $most_lines;
      }
    }
    $head = $place + 1 if $mark =~ /[{};]/;
  }
  END {
    sub median { my @sorted = sort { $a <=> $b } @_; ($sorted[$#sorted / 2] + $sorted[@sorted / 2]) / 2 }
    my ($lines, $tokens, $width) = (median(@lines), median(@tokens), $characters / $code_lines);
    my ($longest) = sort { $b <=> $a } @lines;
    printf "%d functions: median %g lines and %g tokens, longest %d lines; %.1f characters a line\n",
      scalar @lines, $lines, $tokens, $longest, $width;
    exit 1 if $longest > $most_lines || $lines > $median_lines || $tokens > $median_tokens || $width > $mean_width;
  }'
