#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# kernels.sh BUILD [KERNEL[:THREADS]...]: the tests of the modules and the scripts of tests/edp under OpenBLAS's kernels, with so many
# threads, or with 1 and with 2. Prints every figure that scripts check: its smallest and largest value, what is wanted, the limit of the difference, and
# how many times the largest difference goes into it. Fails where a test fails or a figure uses up more than half of its limit.
set -euo pipefail
build=$(realpath "$1")
shift
kernels=("$@")
[ $# -gt 0 ] || kernels=(Prescott Nehalem Sandybridge Haswell SkylakeX Zen)
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What a kernel asks of the processor.
needs() { case $1 in SkylakeX) echo avx512f ;; Haswell | Zen) echo avx2 ;; Sandybridge) echo avx ;; *) echo fpu ;; esac; }

# run_one KERNEL THREADS TEST: a program, or a script
run_one() {
  local name command=("$3" --gtest_brief=1) code=0
  name=$(basename "$3" .edp)
  [[ $3 != *.edp ]] || command=("$build/freefem" "$3")
  mkdir "$scratch/$1.$2.$name" && cd "$scratch/$1.$2.$name"
  OPENBLAS_CORETYPE=$1 OMP_NUM_THREADS=$2 OPENBLAS_NUM_THREADS=$2 "${command[@]}" >out 2>&1 || code=$?
  grep '^figure' out | sed "s/^figure/$name/" >figures || true
  [ $code = 0 ] || { echo "$name fails under $1 with $2 threads:"; tail -n 20 out; touch "$scratch/failed"; }
}
export -f run_one
export build scratch

for wanted in "${kernels[@]}"; do
  kernel=${wanted%:*}
  grep -qw "$(needs "$kernel")" /proc/cpuinfo || { echo "$kernel: this processor cannot run it"; continue; }
  [[ $wanted = *:* ]] && counts=("${wanted#*:}") || counts=(1 2)
  for threads in "${counts[@]}"; do
    for module in "$scripts"/../../cpp/ffcontact/*/; do
      printf '%s\0' "$kernel $threads $build/tests/test_$(basename "$module")"
    done
    for script in "$scripts"/*.edp; do printf '%s\0' "$kernel $threads $script"; done
  done
done | xargs -0 -P "$(nproc)" -I{} bash -c 'run_one {}'

cat "$scratch"/*/figures | awk -F '\t' '
  { key = $1 ": " $2
    if (!(key in least) || $3 < least[key]) least[key] = $3
    if (!(key in most) || $3 > most[key]) most[key] = $3
    if ($5 > off[key]) off[key] = $5
    wanted[key] = $4; limit[key] = $6 }
  END { for (key in least)
    printf "%s\t%s\t%s\t%s\t%s\t%.3g\n", key, least[key], most[key], wanted[key], limit[key],
           (off[key] > 0 ? limit[key]/off[key] : 1e99) }' | sort -t "$(printf '\t')" -k 6,6gr >"$scratch/table"
{ printf 'figure\tsmallest\tlargest\twanted\tlimit\tmargin\n'; cat "$scratch/table"; } | column -t -s "$(printf '\t')"
[ ! -e "$scratch/failed" ]
awk -F '\t' '$6 < 2 { print "less than twice: " $1; bad = 1 } END { exit bad }' "$scratch/table"
