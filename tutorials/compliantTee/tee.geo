// T-junction in an elastic block, lengths in metres. Every surface has four
// sides: quadrangles, that bend as they should.
// Cells: -setnumber <name> <value> replaces a number of DefineConstant.

DefineConstant
[
    nLeg = {40, Name "cells along a leg of the channel"},
    nAcross = {16, Name "cells across the channels"},
    nLower = {8, Name "cells through the lower wall"},
    nBranch = {28, Name "cells along the branch"}
];

mm = 0.001;
x[] = {0, 48*mm, 56*mm, 104*mm};
y[] = {-12*mm, 0, 8*mm, 44*mm};

// Points, row by row: 4*row + column + 1
For j In {0 : 3}
    For i In {0 : 3}
        Point(4*j + i + 1) = {x[i], y[j], 0};
    EndFor
EndFor

// Lines along x: 100 + 10*row + column; along y: 200 + 10*row + column
For j In {0 : 3}
    For i In {0 : 2}
        Line(100 + 10*j + i) = {4*j + i + 1, 4*j + i + 2};
    EndFor
EndFor
For j In {0 : 2}
    For i In {0 : 3}
        Line(200 + 10*j + i) = {4*j + i + 1, 4*j + i + 5};
    EndFor
EndFor

// Finer towards the junction
For j In {0 : 3}
    Transfinite Curve {100 + 10*j} = nLeg + 1 Using Progression 0.97;
    Transfinite Curve {101 + 10*j} = nAcross + 1;
    Transfinite Curve {102 + 10*j} = nLeg + 1 Using Progression 1/0.97;
EndFor
For i In {0 : 3}
    Transfinite Curve {200 + i} = nLower + 1;
    Transfinite Curve {210 + i} = nAcross + 1;
    Transfinite Curve {220 + i} = nBranch + 1 Using Progression 1.06;
EndFor

// Surfaces, extruded by one cell, 10 mm. What Extrude returns: the other end,
// the volume, and the four sides: below, right, above, left
For j In {0 : 2}
    For i In {0 : 2}
        n = 3*j + i;
        Curve Loop(n + 1) =
        {
            100 + 10*j + i, 200 + 10*j + i + 1,
            -(100 + 10*j + 10 + i), -(200 + 10*j + i)
        };
        Plane Surface(n + 1) = {n + 1};
        Transfinite Surface {n + 1};
        Recombine Surface {n + 1};
        e[] = Extrude {0, 0, 10*mm}
            { Surface{n + 1}; Layers{1}; Recombine; };
        back[n] = e[0];
        body[n] = e[1];
        below[n] = e[2];
        right[n] = e[3];
        above[n] = e[4];
        left[n] = e[5];
    EndFor
EndFor

// Volumes become cell zones, surfaces patches
Physical Volume("fluid") = {body[3], body[4], body[5], body[7]};
Physical Volume("block") = {body[0], body[1], body[2], body[6], body[8]};

Physical Surface("inlet") = {left[3]};
Physical Surface("outlet") = {right[5]};
Physical Surface("branch") = {above[7]};
Physical Surface("clamped") = {left[0], left[6], right[2], right[8]};
Physical Surface("free") =
    {below[0], below[1], below[2], above[6], above[8]};
Physical Surface("frontAndBack") = {1 : 9, back[]};
