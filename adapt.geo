Point(1) = {0, 0, 0, 5}; Point(2) = {40, 0, 0, 5}; Point(3) = {40, 40, 0, 5};
Point(4) = {0, 40, 0, 5}; Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1}; Physical Surface(1) = {1};
Physical Curve(1) = {1}; Physical Curve(2) = {2}; Physical Curve(3) = {3}; Physical Curve(4) = {4};
