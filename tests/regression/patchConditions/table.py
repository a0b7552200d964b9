# SPDX-License-Identifier: GPL-3.0-or-later
"""All conditions of U and p that OpenFOAM has: (field, type, entries, case).

Instead of a case: REFUSED, or a text that says why it is not tried. A type may
stand in several rows. Another check wants each type of OpenFOAM's own list,
and of the solver's table, in here.
"""

from cases import (
    Column, Couette, Oblique, Plug, Ramp, Rest, Start, Swing, header
)

REFUSED = "refused"


class Row:
    """One condition in one case."""

    def __init__(self, field, kind, entries, case, files=None):
        self.field, self.kind, self.case = field, kind, case
        self.text = "type %s; %s" % (kind, entries)
        self.files = files or {}


# Entries for V of Ramp, for 1 m/s of Plug, for 0 of a patch value
DOWN = "uniform (0 -1e-5 0)"
UP = "uniform (0 1e-5 0)"
ALONG = "uniform (1 0 0)"
V0 = "value uniform (0 0 0);"
P0 = "value uniform 0;"
PUSH = "value uniform 1e-3;"
OPEN_P = "type fixedValue; value uniform 0;"
TOTAL = "type totalPressure; p0 uniform 500; value uniform 500;"

# The same value at two points, as timeVaryingMappedFixedValue wants it
def boundary_data(name, value):
    folder = "constant/boundaryData/tried/"
    points = "4\n(\n(0 1 0)\n(0.3 1 0)\n(0 1 0.1)\n(0.3 1 0.1)\n)\n"
    return {
        folder + "points": points,
        folder + "0/" + name: "4\n(\n" + 4*(value + "\n") + ")\n",
        folder + "100/" + name: "4\n(\n" + 4*(value + "\n") + ")\n",
    }


def mapped_case(case):
    """The patch takes its values from the cells 0.45 m downstream."""
    case.patches["tried"] = (
        "type mappedPatch; sampleMode nearestCell; samplePatch none;"
        " offsetMode uniform; offset (0.45 0 0);",
        case.patches["tried"],
    )
    return case


ROWS = [
    # U: given
    Row("U", "fixedValue", "value %s;" % DOWN, Ramp()),
    Row("U", "fixedValue", "value %s;" % ALONG, Plug()),
    Row("U", "noSlip", "", Couette()),
    Row("U", "uniformFixedValue", "uniformValue constant (0 -1e-5 0); " + V0,
        Ramp()),
    Row("U", "codedFixedValue", "", "OpenFOAM compiles it, not as root"),
    Row("U", "exprFixedValue", 'valueExpr "vector(0, -1e-5, 0)"; ' + V0,
        Ramp()),
    Row("U", "fixedProfile", "profile constant (0 -1e-5 0); direction (1 0 0);"
        " origin 0;", Ramp()),
    Row("U", "scaledFixedValue", "scale constant 0.5; refValue { type"
        " fixedValue; value uniform (0 -2e-5 0); }", Ramp()),
    Row("U", "surfaceNormalFixedValue", "refValue uniform -1e-5;", Ramp()),
    Row("U", "uniformNormalFixedValue", "uniformValue constant -1e-5; " + V0,
        Ramp()),
    Row("U", "timeVaryingMappedFixedValue", "offset (0 0 0); setAverage off;"
        " mapMethod nearest; " + V0, Ramp(),
        boundary_data("U", "(0 -1e-5 0)")),
    Row("U", "cylindricalInletVelocity", "axis (0 -1 0); origin (9 0 0);"
        " axialVelocity constant 1e-5; radialVelocity constant 0;"
        " rpm constant 0; " + V0, Ramp()),
    Row("U", "swirlInletVelocity", "axis (0 -1 0); origin (9 0 0);"
        " axialVelocity constant 1e-5; radialVelocity constant 0;"
        " tangentialVelocity constant 0; " + V0, Ramp()),
    Row("U", "swirlFlowRateInletVelocity", "flowRate constant 3e-7;"
        " rpm constant 0; " + V0, Ramp()),
    Row("U", "flowRateInletVelocity", "volumetricFlowRate 3e-7; " + V0,
        Ramp()),
    Row("U", "flowRateInletVelocity", "massFlowRate 3e-4; " + V0, Ramp()),
    Row("U", "flowRateInletVelocity", "massFlowRate 3e-4; rhoInlet 1000;"
        " extrapolateProfile yes; " + V0, Ramp()),
    Row("U", "flowRateOutletVelocity", "volumetricFlowRate 3e-7; " + V0,
        Ramp("outlet")),
    Row("U", "flowRateOutletVelocity", "massFlowRate 3e-4; " + V0,
        Ramp("outlet")),
    Row("U", "matchedFlowRateOutletVelocity", "inletPatch other; volumetric"
        " yes; " + V0, Plug("outlet", p="type zeroGradient;")),
    Row("U", "fixedMean", "meanValue constant (0 -1e-5 0); " + V0, Ramp()),
    Row("U", "fixedMean", "meanValue constant (1 0 0); " + V0, Plug()),
    Row("U", "mapped", "interpolationScheme cell; setAverage no;"
        " average (0 0 0); value %s;" % ALONG,
        mapped_case(Plug())),
    Row("U", "mappedField", "interpolationScheme cell; setAverage no;"
        " average (0 0 0); sampleMode nearestCell; samplePatch none;"
        " offsetMode uniform; offset (0.45 0 0); value %s;" % ALONG,
        Plug()),
    Row("U", "outletMappedUniformInlet", "outletPatch other; value %s;"
        % ALONG, Plug()),
    Row("U", "turbulentInlet", "fluctuationScale (0 0 0); referenceField"
        " uniform (0 -1e-5 0); value %s;" % DOWN, Ramp()),
    Row("U", "movingWallVelocity", V0, Couette()),
    Row("U", "rotatingWallVelocity", "origin (0 -9 0); axis (0 0 1);"
        " omega 0.1; " + V0, Couette(0, -1, "type noSlip;")),
    Row("U", "translatingWallVelocity", "U (1 0 0); " + V0,
        Couette(0, 1, "type noSlip;")),

    # U: coefficients
    Row("U", "zeroGradient", "", Plug("outlet")),
    Row("U", "zeroGradient", "", Swing()),
    Row("U", "zeroGradient", "", Start(p=TOTAL)),
    Row("U", "fixedGradient", "gradient uniform (0 0 0);", Swing()),
    Row("U", "fixedGradient", "gradient uniform (-1 0 0);",
        Couette(1, 0, p=OPEN_P)),
    Row("U", "uniformFixedGradient", "uniformGradient constant (-1 0 0);",
        Couette(1, 0, p=OPEN_P)),
    Row("U", "mixed", "refValue uniform (0 -1e-5 0); refGradient uniform"
        " (0 0 0); valueFraction uniform 1; " + V0, Ramp()),
    Row("U", "mixed", "refValue uniform (0 0 0); refGradient uniform (0 0 0);"
        " valueFraction uniform 0; " + V0, Swing()),
    Row("U", "codedMixed", "", "OpenFOAM compiles it, not as root"),
    Row("U", "exprMixed", 'valueExpr "vector(0, -1e-5, 0)"; fractionExpr "1";'
        ' gradientExpr ""; ' + V0, Ramp()),
    Row("U", "inletOutlet", "inletValue %s; " % DOWN + V0, Ramp()),
    Row("U", "inletOutlet", "inletValue uniform (9 9 0); " + V0,
        Plug("outlet")),
    Row("U", "uniformInletOutlet", "uniformInletValue constant (0 -1e-5 0); "
        + V0, Ramp()),
    Row("U", "uniformInletOutlet", "uniformInletValue constant (9 9 0); "
        + V0, Plug("outlet")),
    Row("U", "outletInlet", "outletValue %s; " % UP + V0, Ramp("outlet")),
    Row("U", "fixedMeanOutletInlet", "outletValue uniform (0 0 0); meanValue"
        " constant (0 1e-5 0); " + V0, Ramp("outlet")),
    Row("U", "freestream", "freestreamValue %s;" % DOWN, Ramp()),
    Row("U", "freestream", "freestreamValue uniform (1 0.5 0);",
        Oblique("outlet")),
    Row("U", "freestreamVelocity", "freestreamValue %s;" % DOWN, Ramp()),
    Row("U", "advective", "value %s;" % ALONG, Plug("outlet")),
    Row("U", "fluxCorrectedVelocity", V0, Swing()),
    Row("U", "fluxCorrectedVelocity", V0, Oblique("outlet")),

    # U: by directions, from the flux
    Row("U", "directionMixed", "refValue uniform (0 0 0); refGradient uniform"
        " (0 0 0); valueFraction uniform (1 0 0 0 0 1); " + V0, Swing()),
    Row("U", "directionMixed", "refValue uniform (1 0 0); refGradient uniform"
        " (0 0 0); valueFraction uniform (0.5 0.25 0 0.125 0 0); " + V0,
        "see the unit test"),
    Row("U", "fixedNormalInletOutletVelocity", "fixTangentialInflow yes;"
        " normalVelocity { type fixedValue; value %s; } " % DOWN + V0,
        Ramp()),
    Row("U", "fixedNormalInletOutletVelocity", "fixTangentialInflow no;"
        " normalVelocity { type fixedValue; value uniform (9 0.5 0); } " + V0,
        Oblique("top")),
    Row("U", "pressureInletOutletVelocity", V0, Swing()),
    Row("U", "pressureInletOutletVelocity", V0, Start(p=TOTAL)),
    Row("U", "pressureInletOutletVelocity", "tangentialVelocity uniform"
        " (7 0.5 0); " + V0, Oblique(p=OPEN_P)),
    Row("U", "rotatingPressureInletOutletVelocity", "omega constant"
        " (0 1e-20 0); " + V0, Swing()),
    Row("U", "pressureInletVelocity", V0, Swing()),
    Row("U", "pressureInletVelocity", V0, Start()),
    Row("U", "pressureInletVelocity", V0, Start(p=TOTAL)),
    Row("U", "pressureNormalInletOutletVelocity", V0, Swing()),
    Row("U", "pressureNormalInletOutletVelocity", V0, Start(p=TOTAL)),
    Row("U", "pressureNormalInletOutletVelocity", V0, Oblique("outlet")),
    Row("U", "pressureDirectedInletVelocity", "inletDirection uniform"
        " (0 -1 0); " + V0, Swing()),
    Row("U", "pressureDirectedInletVelocity", "inletDirection uniform"
        " (1 0.5 0); " + V0, Oblique(p=OPEN_P)),
    Row("U", "pressureDirectedInletOutletVelocity", "inletDirection uniform"
        " (0 -1 0); " + V0, Swing()),
    Row("U", "pressureDirectedInletOutletVelocity", "inletDirection uniform"
        " (1 0.5 0); " + V0, Oblique(p=OPEN_P)),
    Row("U", "pressureInletOutletParSlipVelocity", V0, Swing()),
    Row("U", "pressureInletOutletParSlipVelocity", V0, Oblique(p=OPEN_P)),

    # U: walls. partialSlip: u_b = .75 u_P half a cell off
    Row("U", "slip", "", Couette(1, 1)),
    Row("U", "symmetry", "", "needs a patch of its type: verification/wave"),
    Row("U", "symmetryPlane", "",
        "needs a patch of its type: verification/wave"),
    Row("U", "partialSlip", "valueFraction uniform 0.25; " + V0,
        Couette(1, 0.15789473684210525)),
    Row("U", "fixedNormalSlip", "fixedValue uniform (7 0.5 0); " + V0,
        Oblique("top")),

    # U: constraints, in all other tests
    Row("U", "empty", "", "in all cases"),
    Row("U", "cyclic", "", "in the cases couette"),
    Row("U", "processor", "", "tests/parallel"),
    Row("U", "processorCyclic", "", "tests/parallel"),

    # p: given
    Row("p", "fixedValue", PUSH, Swing()),
    Row("p", "fixedValue", "value uniform 500;", Start()),
    Row("p", "uniformFixedValue", "uniformValue constant 1e-3; " + P0, Swing()),
    Row("p", "codedFixedValue", "", "OpenFOAM compiles it, not as root"),
    Row("p", "exprFixedValue", 'valueExpr "1e-3"; ' + P0, Swing()),
    Row("p", "fixedProfile", "profile constant 1e-3; direction (1 0 0);"
        " origin 0;", Swing()),
    Row("p", "scaledFixedValue", "scale constant 0.5; refValue { type"
        " fixedValue; value uniform 2e-3; }", Swing()),
    Row("p", "timeVaryingMappedFixedValue", "offset 0; setAverage off;"
        " mapMethod nearest; " + P0, Swing(), boundary_data("p", "1e-3")),
    Row("p", "uniformDensityHydrostaticPressure", "rho 1000; pRefValue 0;"
        " pRefPoint (0 1 0); " + P0, Rest()),
    Row("p", "fixedMean", "meanValue constant 1e-3; " + P0, Swing()),
    Row("p", "mapped", "interpolationScheme cell; setAverage yes;"
        " average 500; " + P0, mapped_case(Start())),
    Row("p", "mappedField", "interpolationScheme cell; setAverage yes;"
        " average 500; sampleMode nearestCell; samplePatch none;"
        " offsetMode uniform; offset (0.45 0 0); " + P0, Start()),
    Row("p", "totalPressure", "p0 uniform 1e-3; " + PUSH, Swing()),
    Row("p", "totalPressure", "p0 uniform 500; " + P0, Start()),
    Row("p", "uniformTotalPressure", "p0 constant 1e-3; " + PUSH, Swing()),
    Row("p", "uniformTotalPressure", "p0 constant 500; " + P0, Start()),

    # p: coefficients
    Row("p", "zeroGradient", "", Ramp(U="type fixedValue; value %s;" % DOWN)),
    Row("p", "fixedGradient", "gradient uniform 0;",
        Ramp(U="type fixedValue; value %s;" % DOWN)),
    Row("p", "fixedGradient", "gradient uniform 0;", Plug(U="type fixedValue;"
        " value %s;" % ALONG)),
    Row("p", "uniformFixedGradient", "uniformGradient constant 0;",
        Ramp(U="type fixedValue; value %s;" % DOWN)),
    Row("p", "mixed", "refValue uniform 1e-3; refGradient uniform 0;"
        " valueFraction uniform 1; " + P0, Swing()),
    Row("p", "mixed", "refValue uniform 9; refGradient uniform 0;"
        " valueFraction uniform 0; " + P0,
        Ramp(U="type fixedValue; value %s;" % DOWN)),
    Row("p", "codedMixed", "", "OpenFOAM compiles it, not as root"),
    Row("p", "exprMixed", 'valueExpr "1e-3"; fractionExpr "1"; gradientExpr "";'
        + P0, Swing()),
    Row("p", "inletOutlet", "inletValue uniform 500; " + P0, Start(start=0.1)),
    Row("p", "uniformInletOutlet", "uniformInletValue constant 500; " + P0,
        Start(start=0.1)),
    Row("p", "outletInlet", "outletValue uniform 0; " + P0, Plug("outlet")),
    Row("p", "fixedMeanOutletInlet", "outletValue uniform 0; meanValue"
        " constant 0; " + P0, Plug("outlet")),
    Row("p", "freestream", "freestreamValue uniform 500;", Start(start=0.1)),
    Row("p", "freestreamPressure", "freestreamValue uniform 0;",
        Plug("outlet", U="type zeroGradient; value %s;" % ALONG)),
    Row("p", "fixedFluxPressure", "gradient uniform 0; " + P0,
        Ramp(U="type fixedValue; value %s;" % DOWN)),
    Row("p", "fixedFluxPressure", "gradient uniform 0; " + P0, Rest("wall")),
    Row("p", "fixedFluxExtrapolatedPressure", "gradient uniform 0; " + P0,
        Rest("wall")),

    # p: walls, constraints
    Row("p", "slip", "", "as zeroGradient: tests/unit/momentumFlux"),
    Row("p", "symmetry", "", "needs a patch of its type: verification/wave"),
    Row("p", "symmetryPlane", "",
        "needs a patch of its type: verification/wave"),
    Row("p", "empty", "", "in all cases"),
    Row("p", "cyclic", "", "in the cases couette"),
    Row("p", "processor", "", "tests/parallel"),
    Row("p", "processorCyclic", "", "tests/parallel"),
]
