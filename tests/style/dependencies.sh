#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FreeFEM's headers are included in plugin/ only; CHOLMOD's in exactly one .cpp file of the core
# (the benchmarks compare with it).
set -euo pipefail
includes() { grep -rlE "^ *# *include *[<\"]($1)" "${@:2}" --include='*.?pp' --exclude-dir=bench || true; }

failed=0
freefem=$(includes 'ff\+\+\.hpp|AFunction|RNM|fem\.hpp|FESpace' cpp tests)
[ -z "$freefem" ] || { echo "FreeFEM's headers outside plugin/:" $freefem; failed=1; }

cholmod=$(includes '(suitesparse/)?(cholmod|SuiteSparse|amd|camd|colamd|metis|umfpack)[A-Za-z_]*\.h|Eigen/\w*Support' cpp plugin tests)
[[ $(wc -w <<<"$cholmod") = 1 && $cholmod = cpp/*.cpp ]] || { echo "not one .cpp file with CHOLMOD:" $cholmod; failed=1; }
exit $failed
