#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# reports.sh FREEFEM: the lines that functions print are those that the script makes of their outputs (*: seconds), no others, and
# at verbosity 0 there are none.
set -euo pipefail
script=reports.edp
cat >$script <<'EOF'
include "ffcontact.idp"
include "getARGV.idp"
load "msh3"
load "shell"
int level = getARGV("-level", 2);
func int expect(string line) {
  if (level > 0) cout << "expect: " << line << endl;
  return 0;
}

// Plane bodies
real E = 13e3, nu = 0.2, lambda = E*nu/((1 + nu)*(1 - 2*nu)), G = E/(2*(1 + nu));
mesh Th = square(16, 8, [80*x, 40*y]);
fespace Vh(Th, [P1, P1]);
varf elasticity([u, v], [r, s]) = int2d(Th)(lambda*(dx(u) + dy(v))*(dx(r) + dy(s))
    + 2*G*(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s)))) + int1d(Th, 4)(10*r) + on(3, u=0, v=0) + on(2, u=0);
matrix A = elasticity(Vh, Vh);
real[int] b = elasticity(0, Vh);
Vh [u, v];
contact C(Th, label=1, friction=0.5);
real violation, e, elastic, part, springs, balance, cone, penetration, kappa, bound, unique, wanted, predicted;
int open, stick, slip, status, steps;
real[int] history(0), last(0);
steps = contactsolve(C, A, b, u[], solver="fixedpoint", violation=violation, opennodes=open, sticknodes=stick, slipnodes=slip,
                     history=history, verbosity=level);
expect("contactsolve: " + Vh.ndof + " dofs, " + C.node.n + " contact nodes, " + steps + " iterations, " + open + " open, " + stick
  + " stick, " + slip + " slip, converged, * s");
expect("contactsolve: " + history.n + " steps of the fixed point, last change of the normal multipliers " + history[history.n - 1]);
expect("contactsolve: violation " + violation + ", residual *");

fespace Ph(Th, P0);
fespace Sh(Th, P1);
Ph epsE;
Sh h;
real eps = contacterror(C, lambda=lambda, G=G, traction=[10*(label==4), 0], eps=epsE[], e=e, elasticpart=elastic, contactpart=part,
                        springpart=springs, balance=balance, cone=cone, penetration=penetration, coulomb=kappa, bound=bound,
                        verbosity=level);
expect("contacterror: " + Th.nt + " triangles, eps " + 100*eps + " %, e " + e + ", 0 edges corrected, * s");
expect("contacterror: mu kappa " + 0.5*kappa + ", bound " + bound + ", sticking nodes free to slip");
expect("contacterror: elastic part " + elastic + ", contact part of e^2 " + part + ", that of springs " + springs
  + ", equilibrium defect " + balance + ", cone defect " + cone + ", penetration " + penetration);

int corrected;
bool admissible;
eps = contacterror(C, lambda=lambda, G=G, traction=[10*(label==4), 0], tractions="published", e=e, corrected=corrected,
                   admissible=admissible, verbosity=min(level, 1));
expect("contacterror: " + Th.nt + " triangles, eps " + 100*eps + " %, e " + e + ", " + corrected + " edges corrected, * s");
expect("contacterror: not admissible: *");

real critical = criticalfriction(C, unique=unique, stick="held", verbosity=level);
expect("criticalfriction: mu 0.5, unique below " + unique + " (sticking nodes held), not unique at " + critical
  + (unique < critical ? ", unknown between" : ""));
real triangles = optimalsize(C, epsE[], target=0.1, size=h[], predicted=predicted, verbosity=level);
expect("optimalsize: sizes " + h[].min + " to " + h[].max + ", about " + int(floor(triangles + 0.5)) + " triangles for eps "
  + 100*predicted + " %");

contact T(Th, label=1, slipbound=2);
contactsolve(T, A, b, u[]);
real least, most, value;
int solves, estimates;
real wide = contactbounds(T, lambda=lambda, G=G, traction=[10*(label==4), 0], goaltraction=[(label==4)/40., 0], steps=1, turns=3, sweeps=1,
                          lower=least, upper=most, value=value, solves=solves, estimates=estimates, verbosity=level);
assert(solves == 18 && estimates == 8);   // three turns and a further one of each bound
expect("contactbounds: " + least + " to " + most + ", " + 100*wide + " % wide, u_h has " + value + ", " + solves
  + " contact problems, " + estimates + " estimates, * s");

varf loose([u, v], [r, s]) = int2d(Th)(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s))) + int1d(Th, 3)(s);
matrix Aloose = loose(Vh, Vh);
real[int] bloose = loose(0, Vh), uloose(Vh.ndof);
contact L(Th, label=1, friction=0.5);
contactsolve(L, Aloose, bloose, uloose, status=status, verbosity=min(level, 1));
expect("contactsolve: no equilibrium: the loads push the body in a translation along (0, 1), *");
assert(status == 5);

real[int] pn = C.pn, pt = 2*C.pt;
int unmended = conecorrection(C, pn, pt, corrected=corrected, cone=cone, verbosity=level);
expect("conecorrection: 16 edges, " + corrected + " corrected, " + unmended + " unmended, cone defect " + cone);
int outside = contactproject(C, pn, pt, verbosity=level);
expect("contactproject: 17 nodes, " + outside + " were outside");

// Friction at which the solution is not the only one: the triangle of tests/contact/uniqueness/critical_friction_test.cpp
real q = sqrt(lambda*(lambda + 2*G))/G, height = lambda*10/(q*(lambda + G)), only = sqrt((1 - nu)/nu);
border bottom(t=0, 1) { x = 10*t; y = 0; label = 1; }
border right(t=0, 1) { x = 10 + t*(q*height - 10); y = t*height; label = 2; }
border left(t=1, 0) { x = t*q*height; y = t*height; label = 3; }
mesh Tt = buildmesh(bottom(6) + right(6) + left(6));
fespace Vt(Tt, [P1, P1]);
Vt [ut, vt];
real nx = height, ny = 10 - q*height, length = sqrt(nx^2 + ny^2);
for (real share = 0.985; share < 1.02; share += 0.01) {
  real mu = share*only, p = 5, stretch = 2e-3;
  real e12 = mu*p/G, e22 = -(p + lambda*stretch)/(lambda + 2*G), s11 = (lambda + 2*G)*stretch + lambda*e22, s12 = mu*p;
  varf slipping([u, v], [r, s]) = int2d(Tt)(lambda*(dx(u) + dy(v))*(dx(r) + dy(s))
      + 2*G*(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s))))
      + int1d(Tt, 2)((s11*nx + s12*ny)/length*r + (s12*nx - p*ny)/length*s) + on(3, u=stretch*x + e12*y, v=e22*y);
  matrix At = slipping(Vt, Vt);
  real[int] bt = slipping(0, Vt);
  contact F(Tt, label=1, friction=mu);
  int[int] sliding(F.node.n);
  sliding = 2;
  contactsolve(F, At, bt, ut[], initial=sliding, slipnodes=slip, verbosity=min(level, 1));
  expect("contactsolve: " + Vt.ndof + " dofs, 7 contact nodes, 1 iterations, 0 open, 0 stick, 7 slip, converged, * s");
  if (share > 0.99)
    expect("contactsolve: friction " + mu + (share > 1.01 ? " is beyond " : " is within 1 % of ") + only
      + ", where the solution with these open, sticking and slipping nodes is not the only one");
}

// Two solids whose meshes do not match
mesh3 T1 = cube(4, 3, 2, [x, y, 1 + z]), T2 = cube(3, 4, 2);
fespace V1(T1, [P1, P1, P1]);
fespace V2(T2, [P1, P1, P1]);
varf upper([u, v, w], [r, s, q]) = int3d(T1)(dx(u)*dx(r) + dy(v)*dy(s) + dz(w)*dz(q) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s))
    + 0.5*(dz(v) + dy(w))*(dz(s) + dy(q)) + 0.5*(dx(w) + dz(u))*(dx(q) + dz(r))) + on(6, u=0.03, v=0, w=-0.1*(1 + x));
varf lower([u, v, w], [r, s, q]) = int3d(T2)(dx(u)*dx(r) + dy(v)*dy(s) + dz(w)*dz(q) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s))
    + 0.5*(dz(v) + dy(w))*(dz(s) + dy(q)) + 0.5*(dx(w) + dz(u))*(dx(q) + dz(r))) + on(5, u=0, v=0, w=0);
matrix A1 = upper(V1, V1), A2 = lower(V2, V2);
real[int] b1 = upper(0, V1), b2 = lower(0, V2);
V1 [u1, v1, w1];
V2 [u2, v2, w2];
contact S(T1, T2, label1=5, label2=6, friction=0.1);
steps = contactsolve(S, A1, b1, u1[], A2, b2, u2[], violation=violation, opennodes=open, sticknodes=stick, slipnodes=slip,
                     verbosity=level);
expect("contactsolve: " + (V1.ndof + V2.ndof) + " dofs, 20 contact nodes on side " + S.side[0] + ", " + steps + " iterations, " + open
  + " open, " + stick + " stick, " + slip + " slip, converged, * s");
expect("contactsolve: violation " + violation + ", residual *");
real beyond;
eps = contacterror(S, lambda1=0, G1=0.5, lambda2=0, G2=0.5, e=e, elasticpart=elastic, contactpart=part, balance=balance, cone=cone,
                   penetration=penetration, tractionoscillation=beyond, coulomb=kappa, bound=bound, history=history, stick="held",
                   verbosity=level);
expect("contacterror: " + (T1.nt + T2.nt) + " tetrahedra, eps " + 100*eps + " %, e " + e + ", " + (history.n - 1) + " steps, * s");
expect("contacterror: bounds hold with e + " + beyond + " in place of e, as meshes do not match or directions turn");
expect("contacterror: mu kappa " + 0.1*kappa + ", delta *, bound " + bound + ", sticking nodes held");
expect("contacterror: elastic part " + elastic + ", contact part of e^2 " + part + ", that of springs 0, equilibrium defect " + balance
  + ", cone defect " + cone + ", penetration " + penetration);

S = contact(T1, T2, label1=5, label2=6, friction=0.1);
steps = contactsolve(S, A1, b1, u1[], A2, b2, u2[], solver="multigrid", violation=violation, verbosity=level);
expect("contactsolve: " + (V1.ndof + V2.ndof) + " dofs, 20 contact nodes on side " + S.side[0] + ", " + steps + " iterations of * products, "
  + open + " open, " + stick + " stick, " + slip + " slip, converged, * s");
expect("contactsolve: violation " + violation + ", residual *");

{
  ofstream geo("reports.geo");
  geo << "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 1, 1};" << endl;
}
verbosity = level;
mesh Tg = gmshmesh("reports.geo");
verbosity = 0;
expect("gmshmesh: reports.geo, " + Tg.nt + " triangles, " + Tg.nv + " vertices");

// Quadrangles, hexahedra beside prisms, and one that is twisted
{
  ofstream geo("bricks.geo"), file("twisted.msh");
  geo << "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 12, 10}; Transfinite Curve {1, 3} = 13; Transfinite Curve {2, 4} = 11;"
      << "Transfinite Surface {1}; Recombine Surface {1}; Rectangle(2) = {0, 0, 9, 1, 1}; Transfinite Surface {2}; Transfinite Curve {5:8} = 2;"
      << "s() = {}; If (SOLID) s() = Extrude {0, 0, 1} { Surface{1, 2}; Layers{1}; Recombine; }; Else Recursive Delete { Surface{2}; } EndIf" << endl;
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n9 0 0 3\n1 -1 -1 0\n2 1 -1 0\n3 1 1 0\n4 -1 1 0\n5 -0.8 -1.2 2\n6 1.2 -0.8 2\n7 0.8 1.2 2\n"
       << "8 -1.2 0.8 2\n$EndNodes\n$Elements\n2\n1 5 2 1 1 1 2 3 4 5 6 7 8\n2 4 2 1 1 5 6 7 9\n$EndElements" << endl;
}
exec("sed s/SOLID/0/ bricks.geo > quadrangles.geo && sed s/SOLID/1/ bricks.geo > hexahedra.geo");
verbosity = level;
mesh gq = gmshmesh("quadrangles.geo");
mesh3 gh = gmshmesh3("hexahedra.geo");
mesh3 gt = gmshmesh3("twisted.msh");
verbosity = 0;
expect("gmshmesh: quadrangles.geo, 240 triangles, 143 vertices");
expect("gmshmesh: 120 quadrangles were split into 240 triangles");
expect("gmshmesh3: hexahedra.geo, 726 tetrahedra, 294 vertices");
expect("gmshmesh3: 120 hexahedra and 2 prisms were split into 726 tetrahedra");
expect("gmshmesh3: twisted.msh, 13 tetrahedra, 10 vertices");
expect("gmshmesh3: 1 hexahedron was split into 12 tetrahedra, with a new vertex in the middle of 1");
EOF

fails() { echo "$*"; exit 1; }
prints_what_it_expects() {
  local printed said expected
  printed=$("$@")
  echo "$printed"
  mapfile -t said < <(grep -E '^[a-z0-9]+: ' <<<"$printed" | grep -v '^expect: ')
  mapfile -t expected < <(sed -n 's/^expect: //p' <<<"$printed")
  for k in "${!said[@]}"; do
    [[ ${said[k]} = ${expected[k]-} ]] || fails "printed: ${said[k]}; expected: ${expected[k]-nothing}"
  done
  [ ${#said[@]} = ${#expected[@]} ] || fails "not printed: ${expected[${#said[@]}]}"
}
prints_what_it_expects "$1" $script
printed=$("$1" $script -level 0)
[ -z "$printed" ] || fails "printed at verbosity 0: $printed"

# What statements say at verbosity 1 of the curves of plane bodies, and what is warned of at any verbosity: cells that lock,
# matrices of other meshes.
script=doubts.edp
cat >$script <<'EOF'
include "ffcontact.idp"
load "msh3"
func int expect(string line) {
  cout << "expect: " << line << endl;
  return 0;
}
string curve = " edges that turn by at most * degrees are a smooth curve, up to * mm beside them", kept = "; corner=0 keeps the polygon";
string smooth = ": a smooth surface, up to * mm beside its faces, with its ";

// A pin in a bore
real R = 10, r = 9.95;
border pin(t=0, 2*pi) { x=r*cos(t); y=r*sin(t); label=11; }
border bore(t=0, 2*pi) { x=R*cos(t); y=R*sin(t); label=12; }
border box1(t=-20, 20) { x=t; y=-20; label=2; }
border box2(t=-20, 20) { x=20; y=t; label=2; }
border box3(t=20, -20) { x=t; y=20; label=2; }
border box4(t=20, -20) { x=-20; y=t; label=2; }
mesh T1 = buildmesh(pin(40)), T2 = buildmesh(box1(4) + box2(4) + box3(4) + box4(4) + bore(-46));
verbosity = 1;
expect("contact: label 11 of mesh 1: 40" + curve + ", with its normals and its gap" + kept);
expect("contact: label 12 of mesh 2: 46" + curve + ", with its gap" + kept);
contact C1(T1, T2, label1=11, label2=12, friction=0);
expect("contact: label 12 of mesh 1: 46" + curve + ", with its normals" + kept);
contact C2(T2, T1, label1=12, label2=11, friction=0, gap=R - r);
expect("contact: label 11 of mesh 1: 40" + curve + ", with its gap" + kept);
expect("contact: label 12 of mesh 2: 46" + curve + ", with its gap" + kept);
contact C3(T1, T2, label1=11, label2=12, friction=0, normal=[x/r, y/r]);
contact C3a(T1, T2, label1=11, label2=12, friction=0, corner=0);
// Coarse ones: 12 edges are a curve, 8 a polygon but with corner=50
verbosity = 0;
mesh T5 = buildmesh(pin(12)), T6 = buildmesh(pin(8));
verbosity = 1;
expect("contact: label 11: 12" + curve + ", with its normals" + kept);
contact C5(T5, label=11, friction=0);
expect("contact: label 11: 8 edges with corners of 45 degrees are a polygon; corner=50 takes them for a curve");
contact C6(T6, label=11, friction=0);
expect("contact: label 11: 8" + curve + ", with its normals" + kept);
contact C7(T6, label=11, friction=0, corner=50);

// A half cylinder on a plane: all of it labelled, and a part
for (int degrees = 30; degrees <= 90; degrees += 20) {
  border low(t=-pi/2 - degrees*pi/180, -pi/2 + degrees*pi/180) { x=R*cos(t); y=R*sin(t); label=1; }
  border up(t=-pi/2 + degrees*pi/180, 3*pi/2 - degrees*pi/180) { x=R*cos(t); y=R*sin(t); label=4; }
  verbosity = 0;
  mesh Th = buildmesh(low(degrees) + up(60));
  verbosity = 1;
  string taken = ", with one contact direction";
  if (degrees > 60) taken = ", with its normals";
  expect("contact: label 1: " + degrees + curve + taken + kept);
  contact C(Th, label=1, friction=0.3, gap=y + R);
}

// What is a polygon and not said: a square nut, a punch with chamfers, a die with two edges
verbosity = 0;
border nut(t=0, 2*pi) { x=cos(t); y=sin(t); label=1; }
mesh Tn = buildmesh(nut(4)), Ts = square(12, 4, [x*12, y*4 + (1 - y)*max(0., abs(12*x - 6) - 4)]),
     Td = square(9, 3, [x*9, y*4 + (1 - y)*0.3*(min(3., max(0., 9*x - 3)) + 2*max(0., 9*x - 6))]);
verbosity = 1;
contact Cn(Tn, label=1, friction=0.1, gap=y + 1), Cs(Ts, label=1, friction=0.1, gap=y), Cd(Td, label=1, friction=0.1, gap=y);

verbosity = 0;
// A part of a solid pin in its bore, and on a plane
mesh3 P = cube(8, 2, 2, [(r - 2*z)*sin(x - 0.5), 4*y, -(r - 2*z)*cos(x - 0.5)]),
      B = cube(9, 3, 2, [(R + 2*(1 - z))*sin(1.2*x - 0.6), 4*y, -(R + 2*(1 - z))*cos(1.2*x - 0.6)]),
      F = cube(9, 3, 2, [12*x - 6, 4*y, z - 11]);
verbosity = 1;
expect("contact: label 5 of mesh 1" + smooth + "normals and its gap");
expect("contact: label 6 of mesh 2" + smooth + "gap");
contact S1(P, B, label1=5, label2=6, friction=0.1);
expect("contact: label 5 of mesh 1" + smooth + "gap");
expect("contact: label 6 of mesh 2" + smooth + "gap");
contact S2(P, B, label1=5, label2=6, friction=0.1, normal=[x/r, 0, z/r]);
contact S2b(P, B, label1=5, label2=6, friction=0.1, normal=[x/r, 0, z/r], gap=R - r);
expect("contact: label 5 of mesh 1" + smooth + "normals");
contact S3(P, B, label1=5, label2=6, friction=0.1, gap=R - r);
expect("contact: label 5 of mesh 1" + smooth + "normals and its gap");
contact S4(P, F, label1=5, label2=6, friction=0.1);
verbosity = 0;

// Loads that are not linear on an edge of a free side are spoken of even at verbosity 0, if much is missing
mesh Tb = square(4, 4);
fespace Vb(Tb, [P1, P1]);
func real pull(real bent) { return 1 + bent*sin(4*pi*y)^2; }
func int judged(real bent) {
  varf body([u, v], [r, s]) = int2d(Tb)(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s)))
      + int1d(Tb, 4)(pull(bent)*r) + on(3, u=0, v=-0.01);
  matrix A = body(Vb, Vb);
  real[int] b = body(0, Vb);
  Vb [u, v];
  contact C(Tb, label=1, friction=0);
  contactsolve(C, A, b, u[]);
  contacterror(C, lambda=0, G=0.5, traction=[(label > 2)*pull(bent), 0]);
  return 0;
}
judged(1e-3);
expect("bent: nothing is said");
cout << "bent: nothing is said" << endl;
expect("contacterror: traction= is not linear on the edge at (0, *% of its largest value: e is no bound of what this does");
judged(1);

// Cells that lock: once in a run, of triangles and of tetrahedra; not where quadrangles are cut by both diagonals, and not at nu 0.48
real G = 1;
func int solved(mesh & T, real nu) {
  real lambda = 2*G*nu/(1 - 2*nu);
  fespace Vh(T, [P1, P1]);
  Vh [u, v];
  varf body([u, v], [r, s]) = int2d(T)(lambda*(dx(u) + dy(v))*(dx(r) + dy(s))
      + 2*G*(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s)))) + on(3, u=0, v=-0.01);
  matrix A = body(Vh, Vh);
  real[int] b = body(0, Vh);
  contact C(T, label=1, friction=0);
  return contactsolve(C, A, b, u[]);
}
mesh Tcrossed = square(6, 6, flags=1), Tl = square(6, 6);
solved(Tcrossed, 0.4999);
solved(Tl, 0.48);
expect("crossed: nothing is said");
cout << "crossed: nothing is said" << endl;
expect("contactsolve: the material is nearly incompressible (nu 0.4999), and linear triangles lock: *flags=1), which do not lock, or lower nu to 0.48");
solved(Tl, 0.4999);
solved(Tl, 0.4999);
mesh3 Tt = cube(3, 3, 3);
for (int k = 0; k < 3; ++k) {
  real nu = k == 0 ? 0.48 : 0.495, lambda = 2*G*nu/(1 - 2*nu);
  fespace Vt(Tt, [P1, P1, P1]);
  Vt [u, v, w];
  varf body([u, v, w], [r, s, q]) = int3d(Tt)(lambda*(dx(u) + dy(v) + dz(w))*(dx(r) + dy(s) + dz(q))
      + 2*G*(dx(u)*dx(r) + dy(v)*dy(s) + dz(w)*dz(q)) + G*((dy(u) + dx(v))*(dy(r) + dx(s))
      + (dz(v) + dy(w))*(dz(s) + dy(q)) + (dx(w) + dz(u))*(dx(q) + dz(r)))) + on(6, u=0, v=0, w=-0.01);
  matrix A = body(Vt, Vt);
  real[int] b = body(0, Vt);
  contact C(Tt, label=5, friction=0);
  if (k == 1) expect("contactsolve: the material is nearly incompressible (nu 0.495), and linear tetrahedra lock: *, or lower nu to 0.48");
  contactsolve(C, A, b, u[]);
}

// A matrix of a mesh that has moved since the contact was stated: once, and not where it has moved a little.
fespace Vl(Tl, [P1, P1]);
varf soft([u, v], [r, s]) = int2d(Tl)(dx(u)*dx(r) + dy(v)*dy(s) + 0.5*(dy(u) + dx(v))*(dy(r) + dx(s))) + on(3, u=0, v=-0.01);
contact Cl(Tl, label=1, friction=0);
for (int k = 0; k < 3; ++k) {
  Tl = movemesh(Tl, [x, y*(k == 0 ? 1.001 : 1.5)]);
  Vl [u, v];
  matrix A = soft(Vl, Vl);
  real[int] b = soft(0, Vl);
  if (k == 1) expect("contactsolve: A resists a rotation of the mesh that the contact was stated on: * C = contact(Th, ...)");
  contactsolve(Cl, A, b, u[]);
}
EOF
prints_what_it_expects "$1" $script
