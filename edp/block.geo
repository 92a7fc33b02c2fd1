// SPDX-License-Identifier: GPL-3.0-or-later
// Left half of the block of example 1. The numbers of the physical curves are the labels in FreeFEM.
size = DefineNumber[2.8, Name "size of the first mesh"];
Point(1) = {0, 0, 0, size};
Point(2) = {80, 0, 0, size};
Point(3) = {80, 40, 0, size};
Point(4) = {0, 40, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Curve("contact", 1) = {1};
Physical Curve("symmetry", 2) = {2};
Physical Curve("clamped", 3) = {3};
Physical Curve("loaded", 4) = {4};
Physical Surface("block", 1) = {1};
