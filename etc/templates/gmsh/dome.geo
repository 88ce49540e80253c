// Water with a round front beside an elastic dome. After changes:
//
//     gmsh -2 -format msh41 dome.geo          (version 4.1 as text; -format msh22 does as well)
//
// Bodies that touch share their points and curves. Lengths in metres (`scale` in system/meshDict for others).
Mesh.MshFileVersion = 4.1;
Mesh.Algorithm = 6;             // frontal: nearly equilateral triangles

hWater = 0.012;
hDome = 0.005;

// water: (0 0) (0.2 0) and a quarter of an ellipse's worth of arcs up to (0 0.3)
Point(1) = {0, 0, 0, hWater};
Point(2) = {0.2, 0, 0, hWater};
Point(3) = {0.2, 0.15, 0, hWater};
Point(4) = {0.05, 0.3, 0, hWater};
Point(5) = {0, 0.3, 0, hWater};
Point(6) = {0.05, 0.15, 0, hWater};
Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 6, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};

// dome: half a ring around (0.45 0), radii 0.08 and 0.06
Point(10) = {0.45, 0, 0, hDome};
Point(11) = {0.37, 0, 0, hDome};
Point(12) = {0.39, 0, 0, hDome};
Point(13) = {0.51, 0, 0, hDome};
Point(14) = {0.53, 0, 0, hDome};
Point(15) = {0.45, 0.08, 0, hDome};
Point(16) = {0.45, 0.06, 0, hDome};
Line(11) = {11, 12};
Circle(12) = {12, 10, 16};
Circle(13) = {16, 10, 13};
Line(14) = {13, 14};
Circle(15) = {14, 10, 15};
Circle(16) = {15, 10, 11};
Curve Loop(2) = {11, 12, 13, 14, 15, 16};
Plane Surface(2) = {2};

// the groups that system/meshDict speaks of
Physical Surface("water") = {1};
Physical Surface("dome") = {2};
Physical Curve("domeBase") = {11, 14};
