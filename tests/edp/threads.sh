#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# threads.sh FREEFEM: 17 digits of what a plane body, a solid and two solids answer are the same for any number of threads.
set -euo pipefail
script=threads.edp
cat >$script <<'EOF'
load "msh3"
include "ffcontact.idp"
cout.precision(17);
real lambda = 3600, G = 5400;

macro strains(u, v, r, s) (lambda*(dx(u) + dy(v))*(dx(r) + dy(s))
    + 2*G*(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s)))) // EOM
mesh Th = square(256, 64, [160*x, 40*y]);
fespace Vh(Th, [P1, P1]);
varf body([u, v], [r, s]) = int2d(Th)(strains(u, v, r, s)) + int1d(Th, 2)(-10*r) + on(3, u=0, v=0);
matrix A = body(Vh, Vh);
real[int] b = body(0, Vh), eps(Th.nt);
Vh [u, v];
contact C(Th, label=1, friction=0.5);
contactsolve(C, A, b, u[]);
real kappa, unique, error = contacterror(C, lambda=lambda, G=G, traction=[-10*(label == 2), 0], eps=eps, coulomb=kappa);
real critical = criticalfriction(C, unique=unique);
cout << u[].l1 << " " << C.fn.sum << " " << C.ft.sum << " " << error << " " << eps.sum << " " << kappa << " " << unique << " "
     << critical << endl;

macro elasticity(u, v, w, r, s, q) (lambda*(dx(u) + dy(v) + dz(w))*(dx(r) + dy(s) + dz(q))
    + 2*G*(dx(u)*dx(r) + dy(v)*dy(s) + dz(w)*dz(q)) + G*((dy(u) + dx(v))*(dy(r) + dx(s))
    + (dz(v) + dy(w))*(dz(s) + dy(q)) + (dx(w) + dz(u))*(dx(q) + dz(r)))) // EOM
mesh3 T1 = cube(24, 12, 12, [80*x, 40*y, 40*z]), T2 = cube(10, 6, 3, [80*x, 40*y, 20*z - 20]);
fespace V1(T1, [P1, P1, P1]);
fespace V2(T2, [P1, P1, P1]);
varf upper([u, v, w], [r, s, q]) = int3d(T1)(elasticity(u, v, w, r, s, q)) + int2d(T1, 2)(-8*r) + int2d(T1, 3)(-5*s)
    + on(6, u=0, v=0, w=-0.01);
varf lower([u, v, w], [r, s, q]) = int3d(T2)(elasticity(u, v, w, r, s, q)) + on(5, u=0, v=0, w=0);
matrix A1 = upper(V1, V1), A2 = lower(V2, V2);
real[int] b1 = upper(0, V1), b2 = lower(0, V2);
V1 [u1, v1, w1];
V2 [u2, v2, w2];
real[int] one(T1.nt), two(T2.nt);
{
  contact S(T1, label=5, friction=0.5);
  contactsolve(S, A1, b1, u1[]);
  error = contacterror(S, lambda=lambda, G=G, traction=[-8*(label == 2), -5*(label == 3), 0], eps=one);
  cout << u1[].l1 << " " << S.fn.sum << " " << error << " " << one.sum << endl;
}
contact S(T1, T2, label1=5, label2=6, friction=0.5);
contactsolve(S, A1, b1, u1[], A2, b2, u2[]);
error = contacterror(S, lambda1=lambda, G1=G, traction1=[-8*(label == 2), -5*(label == 3), 0], eps1=one, lambda2=lambda, G2=G,
                     eps2=two);
cout << u1[].l1 << " " << u2[].l1 << " " << S.fn.sum << " " << error << " " << one.sum << " " << two.sum << endl;
EOF
digits() { OMP_NUM_THREADS=$2 OPENBLAS_NUM_THREADS=$2 "$1" $script; }
one=$(digits "$1" 1)
echo "$one"
for threads in 2 3; do
  other=$(digits "$1" $threads)
  [ "$other" = "$one" ] || { echo "with $threads threads:"; echo "$other"; exit 1; }
done
