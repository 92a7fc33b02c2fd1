#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# progress.sh FREEFEM: what takes long says so, and how long it took, at verbosity 1, and nothing is printed at verbosity 0.
set -euo pipefail
script=progress.edp
cat >$script <<'EOF'
include "ffcontact.idp"
include "getARGV.idp"
int n = getARGV("-n", 4);
mesh Th = square(4*n, n, [4*x, y]);
fespace Vh(Th, [P1, P1]);
varf elasticity([u, v], [r, s]) = int2d(Th)((dx(u) + dy(v))*(dx(r) + dy(s))
    + 2*(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s)))) + on(3, u=0, v=-0.01);
matrix A = elasticity(Vh, Vh);
real[int] b = elasticity(0, Vh);
Vh [u, v];
for (int level = 0; level < 2; ++level) {
  contact C(Th, label=1, friction=0.2);
  real start = wallclock();
  contactsolve(C, A, b, u[], verbosity=level);
  if (level > 0) cout << "took " << wallclock() - start << endl;
  contacterror(C, lambda=1, G=1, verbosity=level);
  if (level == 0) cout << "talk" << endl;
}
EOF
cat >solid_$script <<'EOF'
load "msh3"
include "ffcontact.idp"
mesh3 Th = cube(26, 26, 26);
fespace Vh(Th, [P1, P1, P1]);
varf elasticity([u, v, w], [r, s, q]) = int3d(Th)((dx(u) + dy(v) + dz(w))*(dx(r) + dy(s) + dz(q))
    + 2*(dx(u)*dx(r) + dy(v)*dy(s) + dz(w)*dz(q)) + (dy(u) + dx(v))*(dy(r) + dx(s)) + (dz(v) + dy(w))*(dz(s) + dy(q))
    + (dx(w) + dz(u))*(dx(q) + dz(r))) + on(6, u=0.01, v=0, w=-0.02);
matrix A = elasticity(Vh, Vh);
real[int] b = elasticity(0, Vh);
Vh [u, v, w];
for (int level = 0; level < 2; ++level) {
  contact C(Th, label=5, friction=0.2);
  contactsolve(C, A, b, u[], verbosity=level);
  if (level == 0) cout << "talk" << endl;
}
EOF
fails() { echo "$*"; exit 1; }
printed=$("$1" $script -n 200)
echo "$printed"
[[ $printed = talk* ]] || fails 'printed at verbosity 0'
grep -q '^contactsolve: factorisation, dofs 32' <<<"$printed" || fails 'contactsolve says nothing of its factorisation'
grep -q '^contacterror: admissible fields, dofs 32' <<<"$printed" || fails 'contacterror says nothing of its fields'
awk '/^contactsolve: .* nodes/ { said = $(NF - 1) }
     /^took/ { took = $2 }
     END { exit !(said > 0 && said <= took) }' <<<"$printed" || fails 'contactsolve says that it took longer than it did'
solid=$("$1" solid_$script)
echo "$solid"
[[ $solid = talk* ]] || fails 'prints of a solid at verbosity 0'
grep -q '^contactsolve: multigrid, dofs 59049, .* s so far' <<<"$solid" || fails 'contactsolve says nothing of the multigrid of a solid'
if "$1" $script | grep 'so far'; then fails 'what takes no time says what it does'; fi
