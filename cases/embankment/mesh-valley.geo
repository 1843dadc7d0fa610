// The dam of valley.toml: its section across a valley with a floor of 2 m and flanks of 1:1, five lifts of 1 m.
//   gmsh -3 -format msh41 mesh-valley.geo -o mesh-valley.msh   (Gmsh 4.8; -setnumber size 0.5 for a finer one)
DefineConstant[ size = 1 ]; // of the hexahedra, about, and the largest height of their rows [m]
height = 5; crest = 4; slope = 2; bottom = 2; flank = 1; lifts = 5;
along = Ceil(14 / size);   // cells along x, in the mean of base and crest
across = Ceil(7 / size);   // along y, likewise
rows = Ceil(1 / size);     // of a lift

For i In {0:lifts}
  level = height * i / lifts;
  x = crest / 2 + slope * (height - level);
  y = bottom / 2 + flank * level;
  p = 4 * i;
  Point(p + 1) = {-x, -y, level}; Point(p + 2) = {x, -y, level};
  Point(p + 3) = {x, y, level};   Point(p + 4) = {-x, y, level};
  c = 8 * i;
  For k In {1:4}
    Line(c + k) = {p + k, p + (k % 4) + 1};
  EndFor
  Transfinite Curve {c + 1, c + 3} = along + 1;
  Transfinite Curve {c + 2, c + 4} = across + 1;
  Curve Loop(6 * i + 1) = {c + 1, c + 2, c + 3, c + 4};
  Plane Surface(6 * i + 1) = {6 * i + 1};
EndFor
For i In {0:lifts - 1}
  For k In {1:4}
    Line(8 * i + 4 + k) = {4 * i + k, 4 * i + 4 + k}; // upwards
    Transfinite Curve {8 * i + 4 + k} = rows + 1;
  EndFor
  For k In {1:4}
    s = 6 * i + 1 + k;
    Curve Loop(s) = {8 * i + k, 8 * i + 5 + (k % 4), -(8 * i + 8 + k), -(8 * i + 4 + k)};
    Plane Surface(s) = {s};
  EndFor
  Surface Loop(i + 1) = {6 * i + 1, 6 * i + 7, 6 * i + 2, 6 * i + 3, 6 * i + 4, 6 * i + 5};
  Volume(i + 1) = {i + 1};
  Physical Volume(Sprintf("lift-%g", i + 1)) = {i + 1};
  flanks[] += {6 * i + 2, 6 * i + 4};
EndFor
Physical Surface("floor") = {1};
Physical Surface("flanks") = {flanks[]};
Transfinite Surface {:};
Recombine Surface {:};
Transfinite Volume {:};
