// A round pipe along z: a square in the middle of the section and four parts around
// it, of hexahedra that are nearly cubes. Physical names are patches of OpenFOAM.

R = 0.003;          // radius [m]
L = 0.018;          // length
h = 0.00025;        // size of the cells: 6 per diameter of a grain
s = 0.55*R;         // half diagonal of the square

nSide = Round(Sqrt(2)*s/h) + 1;         // points on a side of the square
nRing = Round((R - 0.75*s)/h) + 1;      // from it to the wall
nLong = Round(L/h);                     // cells along the pipe

Point(1) = {0, 0, 0};
For k In {0:3}
    c = Cos(Pi/4 + k*Pi/2);
    d = Sin(Pi/4 + k*Pi/2);
    Point(10 + k) = {s*c, s*d, 0};
    Point(20 + k) = {R*c, R*d, 0};
EndFor

For k In {0:3}
    n = (k + 1)%4;
    Line(10 + k) = {10 + k, 10 + n};
    Circle(20 + k) = {20 + k, 1, 20 + n};
    Line(30 + k) = {10 + k, 20 + k};
    Transfinite Curve{10 + k, 20 + k} = nSide;
    Transfinite Curve{30 + k} = nRing;
EndFor

Curve Loop(1) = {10, 11, 12, 13};
Plane Surface(1) = {1};
For k In {0:3}
    n = (k + 1)%4;
    Curve Loop(2 + k) = {30 + k, 20 + k, -(30 + n), -(10 + k)};
    Plane Surface(2 + k) = {2 + k};
EndFor
Transfinite Surface{1:5};
Recombine Surface{1:5};

walls[] = {};
outlet[] = {};
all[] = {};
For i In {1:5}
    // End of the pipe, volume, then the sides in the order of the loop
    part[] = Extrude {0, 0, L} { Surface{i}; Layers{nLong}; Recombine; };
    outlet[] += part[0];
    all[] += part[1];
    If (i > 1)
        walls[] += part[3];
    EndIf
EndFor

Physical Surface("inlet") = {1:5};
Physical Surface("outlet") = outlet[];
Physical Surface("walls") = walls[];
Physical Volume("pipe") = all[];
