// The section of elastic.toml: five lifts of 1 m between slopes of 1:2, x = 0 in the middle of the crest.
//   gmsh -2 -format msh41 mesh.geo -o mesh.msh   (Gmsh 4.8; -setnumber size 0.25 for a finer one)
DefineConstant[ size = 0.5 ]; // of the quadrilaterals [m]
height = 5; crest = 4; slope = 2; lifts = 5;

For i In {0:lifts}
  level = height * i / lifts;
  half = crest / 2 + slope * (height - level);
  Point(2 * i + 1) = {-half, level, 0};
  Point(2 * i + 2) = {half, level, 0};
  Line(3 * i + 1) = {2 * i + 1, 2 * i + 2}; // from the left to the right slope
EndFor
For i In {0:lifts - 1}
  Line(3 * i + 2) = {2 * i + 2, 2 * i + 4}; // up the right slope
  Line(3 * i + 3) = {2 * i + 1, 2 * i + 3}; // up the left slope
  Curve Loop(i + 1) = {3 * i + 1, 3 * i + 2, -(3 * i + 4), -(3 * i + 3)};
  Plane Surface(i + 1) = {i + 1};
  Physical Surface(Sprintf("lift-%g", i + 1)) = {i + 1};
EndFor
Physical Curve("base") = {1};

Mesh.RecombineAll = 1;          // quadrilaterals only: triangles are refused
Mesh.SubdivisionAlgorithm = 1;  // which divides what is twice as large
Mesh.MeshSizeMin = 2 * size;
Mesh.MeshSizeMax = 2 * size;
