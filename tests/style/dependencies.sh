#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FreeFEM's headers are included in plugin/ only; CHOLMOD's and KLU's in exactly one .cpp file of the core each
# (the benchmarks compare with CHOLMOD).
set -euo pipefail
includes() { grep -rlE "^ *# *include *[<\"]($1)" "${@:2}" --include='*.?pp' --exclude-dir=bench || true; }

failed=0
freefem=$(includes 'ff\+\+\.hpp|AFunction|RNM|fem\.hpp|FESpace' cpp tests)
[ -z "$freefem" ] || { echo "FreeFEM's headers outside plugin/:" $freefem; failed=1; }

in_one_file() {
  local files
  files=$(includes "(suitesparse/)?$2" cpp plugin tests)
  [[ $(wc -w <<<"$files") = 1 && $files = cpp/*.cpp ]] || { echo "not one .cpp file with $1:" $files; failed=1; }
}
in_one_file CHOLMOD '(cholmod|SuiteSparse|amd|camd|colamd|metis|umfpack)[A-Za-z_]*\.h|Eigen/\w*Support'
in_one_file KLU '(klu|btf)\.h'
exit $failed
