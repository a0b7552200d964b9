# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of OpenFOAM's function objects in a run of umfsiFoam.

The case is the developed flow between a rigid wall, y = 1, and an elastic
plate, y < 0, which is at rest:

    U = (y (1 - y), 0, 0),  p = 1 - x,  0 < x < 1,  depth 0.1,
    rho = 2, mu = 0.5, in steps of 10 s

Zones of the fluid by height: lower 0.25 core 0.75 upper. A row has the type,
its library, what is written into its dictionary, and what is expected:

    ("field", name, component, zone, value, tolerance)
        average of a field of cells over a zone
    ("patch", name, component, patch, value, tolerance)
        average of a field of faces over a patch, "sum" its sum
    ("file", name, index, value, tolerance)
        a number of the last line of the only file of that name
    ("files", pattern)
        files that must be there, in its folder or, with a slash, in the case
    ("log", text)
        it works and says this in the log
    ("message", text)
        it says this in the log and does nothing else
    ("silent",)
        it works, there is nothing to compare
    ("root", text)
        like log, but OpenFOAM refuses it to administrators
    ("says", text)
        it does not work here: the warning has this text, the run goes on
    and, for all: what the user guide says

Values are means over the centres of the cells of the exact solution."""

NX, H = 8, 1/16


def u(y):
    """Velocity"""
    return y*(1 - y)


def mean(f, low=0.25, high=0.75):
    """Mean of a function of y over the centres of cells"""
    n = round((high - low)/H)
    return sum(f(low + (i + 0.5)*H) for i in range(n))/n


FIELD = "fieldFunctionObjects"
FORCES = "forces"
UTILITY = "utilityFunctionObjects"
SAMPLING = "sampling"
SOLVER = "solverFunctionObjects"

# The velocity of the cells has an error of second order beside the walls
U_TOL, EXACT = 0.01, 1e-8

meanU = mean(u)
meanX = sum((i + 0.5)/NX for i in range(NX))/NX

TABLE = [
    # Loads

    ("forces", FORCES, "patches (top); CofR (0 0 0);",
     ("file", "force.dat", 1, 0.05, EXACT), "on patches of fluids and solids; `rho rho` (default), or `rhoInf` of the fluid"),
    ("forces", FORCES, "patches (top); CofR (0 0 0);",
     ("file", "force.dat", 5, 0.05, EXACT), ""),
    ("forces", FORCES, "patches (top); CofR (0 0 0); rho rhoInf; rhoInf 2;",
     ("file", "force.dat", 7, 0.05, EXACT), ""),
    ("forces", FORCES, "patches (base); CofR (0 0 0);",
     ("file", "force.dat", 1, 0.05, EXACT), ""),
    ("forces", FORCES, "patches (base); CofR (0 0 0);",
     ("file", "force.dat", 2, -0.05, EXACT), ""),
    ("forces", FORCES, "patches (plate); CofR (0 0 0);",
     ("log", "surfaceFieldValue of traction on a faceZone"), "interfaces: `surfaceFieldValue` of `traction`"),
    ("forces", FORCES, "patches (top); CofR (0 0 0); rho rhoInf; rhoInf 1;",
     ("log", "not the density at its patches"), ""),
    ("forceCoeffs", FORCES,
     "patches (top); CofR (0 0 0); rhoInf 2; magUInf 1; lRef 1; Aref 0.1;"
     " liftDir (0 1 0); dragDir (1 0 0); pitchAxis (0 0 1);",
     ("file", "coefficient.dat", 1, 0.5, EXACT), "as `forces`; `rhoInf` the fluid's"),
    ("wallShearStress", FIELD, "patches (top);",
     ("file", "wallShearStress.dat", 1, -0.25, EXACT),
     "over the density [m2/s2], patches of type `wall`; in Pa: `traction`"),
    ("yPlus", FIELD, "", ("file", "yPlus.dat", -1, 0, EXACT),
     "patches of type `wall`; 0 on solids"),
    ("yPlus", FIELD, "", ("patch", "yPlus", "", "top", 0.0625, 0.02), ""),
    ("surfaceFieldValue", FIELD,
     "regionType faceZone; name interface; operation areaIntegrate;"
     " fields (traction); writeFields no;",
     ("file", "surfaceFieldValue.dat", 1, -0.05, EXACT),
     "of `traction`: loads of patches and interfaces"),
    ("surfaceFieldValue", FIELD,
     "regionType faceZone; name interface; operation areaIntegrate;"
     " fields (traction); writeFields no;",
     ("file", "surfaceFieldValue.dat", 2, 0.05, EXACT), ""),
    ("surfaceFieldValue", FIELD,
     "regionType patch; name outlet; operation sum; fields (phi);"
     " writeFields no;",
     ("file", "surfaceFieldValue.dat", 1, 0.1/6, U_TOL), ""),
    ("fluxSummary", FIELD, "mode faceZone; faceZones (interface);",
     ("file", "interface.dat", -1, 0, EXACT), ""),
    ("energy", "unifiedMomentum", "",
     ("file", "energy.dat", 1, 0.1*mean(lambda y: u(y)**2, 0, 1), U_TOL),
     "section 10"),
    ("enclosedFluids", "unifiedMomentum", "",
     ("files", "enclosedFluids.dat"), "section 10"),

    # Fields of fields. In core, as gradients mix materials at an interface

    ("add", FIELD, "fields (p p); result twoP;",
     ("field", "twoP", "", "core", 1, EXACT), ""),
    ("subtract", FIELD, "fields (twoP p); result oneP;",
     ("field", "oneP", "", "core", 0.5, EXACT), ""),
    ("components", FIELD, "field U;",
     ("field", "Ux", "", "core", meanU, U_TOL), ""),
    ("mag", FIELD, "field U; result magU;",
     ("field", "magU", "", "core", meanU, U_TOL), ""),
    ("magSqr", FIELD, "field U; result magSqrU;",
     ("field", "magSqrU", "", "core", mean(lambda y: u(y)**2), 2*U_TOL), ""),
    ("grad", FIELD, "field p; result gradP;",
     ("field", "gradP", 0, "core", -1, EXACT), ""),
    ("div", FIELD, "field U; result divU;",
     ("field", "divU", "", "core", 0, EXACT), ""),
    ("ddt", FIELD, "field p; result ddtP;",
     ("field", "ddtP", "", "core", 0, EXACT), ""),
    ("ddt2", FIELD, "fields (p);",
     ("log", "ddt2 field magSqr(ddt(p)) average"), ""),
    ("flux", FIELD, "field U; result fluxU;",
     ("patch", "fluxU", "", "outlet", mean(u, 0, 1)*0.1*H, U_TOL), ""),
    ("surfaceInterpolate", FIELD, "fields ((U Uint));",
     ("patch", "Uint", 0, "outlet", mean(u, 0, 1), U_TOL), ""),
    ("vorticity", FIELD, "field U; result omega;",
     ("field", "omega", 2, "upper", mean(lambda y: 2*y - 1, 0.75, 1), 0.03),
     "not beside interfaces"),
    ("enstrophy", FIELD, "field U; result ens;",
     ("field", "ens", "", "core", mean(lambda y: 0.5*(1 - 2*y)**2), EXACT),
     "not beside interfaces"),
    ("Q", FIELD, "field U; result QU;",
     ("field", "QU", "", "core", 0, EXACT), "not beside interfaces"),
    ("Lambda2", FIELD, "field U; result L2U;",
     ("field", "L2U", "", "core", 0, EXACT), "not beside interfaces"),
    ("lambVector", FIELD, "field U; result lamb;",
     ("field", "lamb", 1, "core", mean(lambda y: u(y)*(2*y - 1)), EXACT),
     "not beside interfaces"),
    ("flowType", FIELD, "field U; result kind;",
     ("field", "kind", "", "core", 0, 1e-6), "not beside interfaces"),
    ("CourantNo", FIELD, "field phi; result Cou;",
     ("field", "Cou", "", "core", meanU*10*NX, U_TOL), "of fluids"),
    ("PecletNo", FIELD, "field phi; result Pec;",
     ("patch", "Pec", "", "outlet", mean(u, 0, 1)/NX/2/0.25, U_TOL), "of fluids"),
    ("blendingFactor", FIELD, "field U; result blend;",
     ("log", "is not a blended scheme"), "of schemes that blend"),
    ("momentum", FIELD, "regionType cellZone; name core; writeMomentum yes;",
     ("file", "momentum.dat", 1, 2*meanU*0.05, U_TOL), "fluids and solids"),
    ("pressure", FIELD, "mode total; rho rho; pRef 0; result pTotal;",
     ("field", "pTotal", "", "core", 0.5 + mean(lambda y: u(y)**2), U_TOL),
     "p is in Pa"),
    ("reference", FIELD,
     "field p; position (0.9375 0.53125 0.05); offset 0; result pRelative;",
     ("field", "pRelative", "", "core", 0.4375, EXACT), ""),
    ("fieldMinMax", FIELD, "fields (p); location no;",
     ("file", "fieldMinMax.dat", -1, 1, EXACT), ""),
    ("fieldAverage", FIELD,
     "fields (p { mean on; prime2Mean off; base time; });",
     ("field", "pMean", "", "core", 0.5, 1e-3), ""),
    ("fieldCoordinateSystemTransform", FIELD,
     "fields (U); coordinateSystem { type cartesian; origin (0 0 0);"
     " rotation { type axes; e1 (0 1 0); e2 (-1 0 0); } }",
     ("field", "U:Transformed", 1, "core", -meanU, U_TOL), ""),
    ("fieldExtents", FIELD, "fields (p); threshold 0.5;",
     ("files", "fieldExtents.dat"), ""),
    ("columnAverage", FIELD, "patches (top); fields (p);",
     ("field", "columnAverage:columnAverage(p)", "", "core", 0.4, EXACT),
     "over all materials of the column"),
    ("continuityError", FIELD, "phi phi;",
     ("file", "continuityError.dat", 1, 0, EXACT), ""),
    ("derivedFields", FIELD, "derived (rhoU pTotal); rhoRef 2;",
     ("field", "rhoU", 0, "core", 2*meanU, U_TOL), ""),
    ("nearWallFields", FIELD, "fields ((U UNear)); patches (top);"
     " distance 0.1;",
     ("patch", "UNear", 0, "top", u(0.9), 0.05), ""),
    ("processorField", FIELD, "", ("field", "processorID", "", "core", None, 0),
     ""),
    ("readFields", FIELD, "fields (s);", ("silent",), ""),
    ("surfaceDistance", FIELD, "geometry { wall { type searchablePlane;"
     " planeType pointAndNormal; pointAndNormalDict { point (0 1 0);"
     " normal (0 1 0); } } } calculateCells yes;",
     ("field", "surfaceDistance", "", "core", 0.5, EXACT), ""),
    ("streamLine", FIELD, "U U; fields (p U); direction forward; lifeTime 100;"
     " nSubCycle 5; setFormat vtk; cloud particleTracks;"
     " seedSampleSet { type uniform; axis y;"
     " start (0.0625 0.1 0.05); end (0.0625 0.9 0.05); nPoints 5; }",
     ("files", "/postProcessing/sets/*/*/track0*.vtk"), "of fluids"),
    ("wallBoundedStreamLine", FIELD, "U UNear; fields (p UNear);"
     " direction forward; lifeTime 100; setFormat vtk; cloud wallTracks;"
     " seedSampleSet { type patchSeed; axis x; patches (top); maxPoints 5; }",
     ("files", "/postProcessing/sets/*/*/track0*.vtk"),
     "of a velocity of nearWallFields"),
    ("regionSizeDistribution", FIELD, "field p; patches (inlet);"
     " threshold 0.5; fields (p); nBins 4; maxDiameter 1; setFormat raw;",
     ("log", "regionSizeDistribution"), ""),
    ("histogram", FIELD, "field p; max 1; min 0; nBins 4; setFormat raw;",
     ("files", "*"), ""),
    ("randomise", FIELD, "field p; magPerturbation 1e-6; result pRandom;",
     ("field", "pRandom", "", "core", 0.5, 1e-5), ""),
    ("limitFields", FIELD, "fields (twoP); limit both; min 0; max 1;",
     ("log", "limitFields"), "of other fields than U, p, D"),
    ("setFlow", FIELD, "mode function; scale 1; origin (0 0 0);"
     " refDir (1 0 0); axis (0 0 1);", ("says", "Valid choices: initial fields"),
     "it changes U; `fixedValue`, `exactSolution` on patches"),
    ("writeCellCentres", FIELD, "", ("files", "/100/C"), ""),
    ("writeCellVolumes", FIELD, "", ("files", "/100/V"), ""),
    ("streamFunction", FIELD, "", ("files", "/100/streamFunction*"), ""),
    ("zeroGradient", FIELD, "fields (p);",
     ("field", "zeroGradient(p)", "", "core", 0.5, EXACT), ""),
    ("turbulenceFields", FIELD, "fields (devReff nuEff);",
     ("field", "turbulenceProperties:devReff", 1, "upper",
      -0.25*mean(lambda y: 1 - 2*y, 0.75, 1), EXACT),
     "devReff, nuEff; all others are zero"),
    ("volFieldValue", FIELD,
     "regionType cellZone; name plate; operation volAverage;"
     " fields (sigma); writeFields no;",
     ("file", "volFieldValue.dat", 2, 0.5, EXACT), ""),
    ("volFieldValue", FIELD,
     "regionType cellZone; name plate; operation volAverage;"
     " fields (sigma); writeFields no;",
     ("file", "volFieldValue.dat", 4, -0.5, EXACT), ""),
    ("fieldValueDelta", FIELD, "operation subtract;"
     " region1 { type surfaceFieldValue; libs (fieldFunctionObjects);"
     " regionType patch; name inlet; operation areaAverage; fields (p);"
     " writeFields no; } region2 { $region1; name outlet; }",
     ("file", "fieldValueDelta.dat", -1, 1, EXACT), ""),
    ("valueAverage", FIELD, "functionObject volFieldValue; fields"
     " (volAverage(plate,sigma));", ("log", "valueAverage"), ""),

    # Samples

    ("probes", SAMPLING, "fields (p); probeLocations ((0.0625 0.53125 0.05));",
     ("file", "p", 1, 0.9375, EXACT), ""),
    ("patchProbes", SAMPLING, "patches (top); fields (p);"
     " probeLocations ((0.0625 1 0.05));",
     ("file", "p", 1, 0.9375, EXACT), ""),
    ("sets", SAMPLING, "setFormat raw; interpolationScheme cell; fields (U);"
     " sets (line { type midPoint; axis y; start (0.0625 -0.25 0.05);"
     " end (0.0625 1 0.05); });", ("files", "*/line*"), ""),
    ("surfaces", SAMPLING, "surfaceFormat raw; interpolationScheme cell;"
     " fields (p); surfaces (outlet { type patch; patches (outlet); });",
     ("files", "*/*outlet*"), ""),

    # Utilities

    ("ensightWrite", UTILITY, "fields (U p);", ("files", "*"), ""),
    ("vtkWrite", UTILITY, "fields (U p);", ("files", "/postProcessing/vtkWrite/*"), ""),
    ("removeRegisteredObject", UTILITY, "objects (oneP);",
     ("log", "removeRegisteredObject"), "of other fields than the solver's"),
    ("parProfiling", UTILITY, "", ("log", "parProfiling"), ""),
    ("solverInfo", UTILITY, "fields (U p);",
     ("files", "solverInfo.dat"), "empty; residuals are in the log"),
    ("timeInfo", UTILITY, "", ("files", "timeInfo.dat"), ""),
    ("runTimeControl", UTILITY, "conditions { all { type maxDuration;"
     " duration 1e6; } }", ("log", "runTimeControl"), ""),
    ("systemCall", UTILITY, 'writeCalls ("echo called it");',
     ("root", "called it"), "not as root"),
    ("timeActivatedFileUpdate", UTILITY, 'fileToUpdate "system/unused";'
     ' timeVsFile ((0 "system/topoSetDict"));',
     ("files", "/system/unused"), ""),
    ("writeDictionary", UTILITY, "dictNames (fvSchemes);",
     ("log", "writeDictionary"), ""),
    ("writeObjects", UTILITY, "objects (rho nu); writeOption anyWrite;",
     ("files", "/100/nu"), ""),
    ("coded", UTILITY, 'name codedOne; codeWrite #{ Info<< "coded: "'
     ' << time().value() << endl; #};', ("root", "coded: 100"), "not as root"),
    ("abort", UTILITY, "action writeNow;", ("log", "abort activated"), ""),
    ("setTimeStep", UTILITY, "deltaT 5;", ("says", "adjustTimeStep"),
     "with adjustTimeStep"),
    ("areaWrite", UTILITY, "fields (U); surfaceFormat raw;", ("silent",),
     "nothing without a finite-area mesh"),

    # Equations

    ("scalarTransport", SOLVER, "field s; D 0.01; nCorr 0;",
     ("field", "s", "", "core", 1, 1e-3), "spreads through solids, too"),
    ("energyTransport", SOLVER, "field T; phi phi; rho rho; Cp 1; kappa 1;",
     ("says", "0/T"), "needs a field T"),

    # Not here

    ("limitFields", FIELD, "fields (U); limit both; min 0; max 1;",
     ("says", "limitFields of fields other than"), ""),
    ("hydrostaticPressure", "initialisationFunctionObjects", "",
     ("says", "Valid choices: initial fields"), "`constant/g`"),
    ("wallHeatFlux", FIELD, "", ("says", "compressible turbulence model"),
     "there is no energy"),
    ("heatTransferCoeff", FIELD, "field T; patches (top); result htc;"
     " htcModel fixedReferenceTemperature; TRef 300;", ("says", "T"),
     "there is no energy"),
    ("thermoCoupleProbes", UTILITY, "rho 1; Cp 1; d 1e-3; epsilon 0.5;"
     " radiationField G; fields (T); interpolationScheme cell; solver rodas23;"
     " probeLocations ((0.5 0.5 0.05));", ("says", "fluidThermo"),
     "there is no energy"),
    ("MachNo", FIELD, "field U; result Ma;",
     ("message", "cannot find required object thermophysicalProperties"),
     "incompressible"),
    ("proudmanAcousticPower", FIELD, "rhoInf 2; aRef 340;",
     ("message", "proudman"), "laminar"),
    ("DESModelRegions", FIELD, "", ("message", "DES"), "laminar"),
    ("XiReactionRate", FIELD, "", ("says", "volScalarField b"),
     "there is no combustion"),
    ("psiReactionThermoMoleFractions", FIELD, "",
     ("says", "psiReactionThermo"), "there is no combustion"),
    ("Curle", FIELD, "field p; patches (top); c0 1500; result curle;",
     ("field", "curle", "", "core", 0, EXACT), ""),
    ("AMIWeights", FIELD, "writeFields no;", ("message", "AMIWeights"),
     "cyclicAMI is refused"),
    ("mapFields", FIELD, "mapRegion other; mapMethod cellVolumeWeight;"
     " consistent yes; fields (p);", ("says", "other"), "needs a region"),
    ("stabilityBlendingFactor", FIELD, "field U; result stable;"
     " switchNonOrtho yes; switchGradCc no; switchResiduals no;"
     " switchFaceWeight no; switchSkewness no; switchCo no;",
     ("says", "nonOrthoAngle"), "needs its fields"),
    ("cloudInfo", "lagrangianFunctionObjects", "clouds (none);",
     ("says", "kinematicCloud none"), "there are no particles"),
]
