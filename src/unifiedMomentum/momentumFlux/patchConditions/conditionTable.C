/*---------------------------------------------------------------------------*\
  umfsiFoam: fluid-structure interaction with one momentum equation
-------------------------------------------------------------------------------
License
    This file is part of umfsiFoam.

    umfsiFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by
    the Free Software Foundation, either version 3 of the License, or
    (at your option) any later version.

    umfsiFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE.  See the GNU General Public License
    for more details.

    You should have received a copy of the GNU General Public License
    along with umfsiFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "patchConditions.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    // Reasons that several share
    static const char* const alpha =
        "it needs a volume fraction, which a single fluid does not have";
    static const char* const baffle =
        "it jumps or acts between the two sides of a baffle, which this solver"
        " does not have: a thin wall is a solid of its own";
    static const char* const gas =
        "it is of compressible flow";
    static const char* const internalCells =
        "it sets values of cells beside the patch";
    static const char* const rotatingFrame =
        "it is of a rotating frame of reference";
    static const char* const turbulence =
        "it is of turbulence models, which this solver does not have";
    static const char* const otherField =
        "it is a condition of another quantity";
    static const char* const nothing =
        "it gives no condition";
    static const char* const pRgh =
        "it is a condition of p_rgh; p contains the hydrostatic part here";
    static const char* const patchType =
        "its type of patch is refused";
}


// Sorted as the sections of the user guide's table; the test
// tests/regression/patchConditions wants each of OpenFOAM's types in here
const Foam::patchConditions::condition Foam::patchConditions::ofU[] =
{
    { "fixedValue", GIVEN, nullptr },
    { "noSlip", GIVEN, nullptr },
    { "uniformFixedValue", GIVEN, nullptr },
    { "codedFixedValue", GIVEN, nullptr },
    { "exprFixedValue", GIVEN, nullptr },
    { "fixedProfile", GIVEN, nullptr },
    { "scaledFixedValue", GIVEN, nullptr },
    { "surfaceNormalFixedValue", GIVEN, nullptr },
    { "uniformNormalFixedValue", GIVEN, nullptr },
    { "timeVaryingMappedFixedValue", GIVEN, nullptr },
    { "cylindricalInletVelocity", GIVEN, nullptr },
    { "swirlInletVelocity", GIVEN, nullptr },
    { "swirlFlowRateInletVelocity", GIVEN, nullptr },
    { "flowRateInletVelocity", FOLLOWS, nullptr },
    { "flowRateOutletVelocity", FOLLOWS, nullptr },
    { "matchedFlowRateOutletVelocity", FOLLOWS, nullptr },
    { "fixedMean", FOLLOWS, nullptr },
    { "mapped", FOLLOWS, nullptr },
    { "mappedField", GIVEN, nullptr },
    { "outletMappedUniformInlet", FOLLOWS, nullptr },
    { "turbulentInlet", GIVEN, nullptr },
    { "movingWallVelocity", GIVEN, nullptr },
    { "rotatingWallVelocity", GIVEN, nullptr },
    { "translatingWallVelocity", GIVEN, nullptr },

    { "zeroGradient", COEFFICIENTS, nullptr },
    { "fixedGradient", COEFFICIENTS, nullptr },
    { "uniformFixedGradient", COEFFICIENTS, nullptr },
    { "mixed", COEFFICIENTS, nullptr },
    { "codedMixed", COEFFICIENTS, nullptr },
    { "exprMixed", COEFFICIENTS, nullptr },
    { "inletOutlet", COEFFICIENTS, nullptr },
    { "uniformInletOutlet", COEFFICIENTS, nullptr },
    { "outletInlet", COEFFICIENTS, nullptr },
    { "fixedMeanOutletInlet", COEFFICIENTS, nullptr },
    { "freestream", COEFFICIENTS, nullptr },
    { "freestreamVelocity", COEFFICIENTS, nullptr },
    { "advective", COEFFICIENTS, nullptr },
    { "fluxCorrectedVelocity", COEFFICIENTS, nullptr },

    { "directionMixed", DIRECTION_MIXED, nullptr },
    { "fixedNormalInletOutletVelocity", DIRECTION_MIXED, nullptr },
    { "pressureInletOutletVelocity", DIRECTION_MIXED, nullptr },
    { "rotatingPressureInletOutletVelocity", DIRECTION_MIXED, nullptr },
    { "pressureInletVelocity", FLUX_NORMAL, nullptr },
    { "pressureNormalInletOutletVelocity", FLUX_NORMAL_IN, nullptr },
    { "pressureDirectedInletVelocity", FLUX_DIRECTED, nullptr },
    { "pressureDirectedInletOutletVelocity", FLUX_DIRECTED_IN, nullptr },
    { "pressureInletOutletParSlipVelocity", FREE, nullptr },

    { "slip", WALL, nullptr },
    { "symmetry", WALL, nullptr },
    { "symmetryPlane", WALL, nullptr },
    { "partialSlip", PARTIAL_SLIP, nullptr },
    { "fixedNormalSlip", NORMAL_SLIP, nullptr },

    { "empty", CONSTRAINT, nullptr },
    { "cyclic", CONSTRAINT, nullptr },
    { "processor", CONSTRAINT, nullptr },
    { "processorCyclic", CONSTRAINT, nullptr },

    { "calculated", REFUSED, nothing },
    { "extrapolatedCalculated", REFUSED, nothing },
    { "sliced", REFUSED, nothing },
    { "cyclicAMI", REFUSED, patchType },
    { "cyclicACMI", REFUSED, patchType },
    { "cyclicSlip", REFUSED, patchType },
    { "nonuniformTransformCyclic", REFUSED, patchType },
    { "wedge", REFUSED, patchType },
    { "fixedInternalValue", REFUSED, internalCells },
    { "mappedFixedInternalValue", REFUSED, internalCells },
    { "mappedFixedPushedInternalValue", REFUSED, internalCells },
    {
        "pressureInletUniformVelocity", REFUSED,
        "the mean of the flux would be an integral of itself; take"
        " pressureInletVelocity"
    },
    {
        "pressurePIDControlInletVelocity", REFUSED,
        "it takes p for kinematic; give the pressures themselves"
    },
    {
        "fixedShearStress", REFUSED,
        "it would be an integral of itself; take fixedGradient, the shear"
        " stress over the viscosity"
    },
    {
        "mappedFlowRate", REFUSED,
        "it couples two regions, here all is one mesh; within it take mapped"
    },
    {
        "mappedVelocityFlux", REFUSED,
        "it sets the flux beside the velocity; take mapped"
    },
    { "interstitialInletVelocity", REFUSED, alpha },
    { "outletPhaseMeanVelocity", REFUSED, alpha },
    { "variableHeightFlowRateInletVelocity", REFUSED, alpha },
    { "activeBaffleVelocity", REFUSED, baffle },
    { "activePressureForceBaffleVelocity", REFUSED, baffle },
    { "fixedJump", REFUSED, baffle },
    { "fixedJumpAMI", REFUSED, baffle },
    { "uniformJump", REFUSED, baffle },
    { "uniformJumpAMI", REFUSED, baffle },
    { "swirlFanVelocity", REFUSED, baffle },
    { "SRFFreestreamVelocity", REFUSED, rotatingFrame },
    { "SRFVelocity", REFUSED, rotatingFrame },
    { "SRFWallVelocity", REFUSED, rotatingFrame },
    { "supersonicFreestream", REFUSED, gas },
    { "waveTransmissive", REFUSED, gas },
    { "kqRWallFunction", REFUSED, turbulence },
    { "turbulentDFSEMInlet", REFUSED, turbulence },
    { "turbulentDigitalFilterInlet", REFUSED, turbulence },

    { nullptr, REFUSED, nullptr }
};


const Foam::patchConditions::condition Foam::patchConditions::ofP[] =
{
    { "fixedValue", GIVEN, nullptr },
    { "uniformFixedValue", GIVEN, nullptr },
    { "codedFixedValue", GIVEN, nullptr },
    { "exprFixedValue", GIVEN, nullptr },
    { "fixedProfile", GIVEN, nullptr },
    { "scaledFixedValue", GIVEN, nullptr },
    { "timeVaryingMappedFixedValue", GIVEN, nullptr },
    { "uniformDensityHydrostaticPressure", GIVEN, nullptr },
    { "fixedMean", FOLLOWS, nullptr },
    { "mapped", FOLLOWS, nullptr },
    { "mappedField", GIVEN, nullptr },

    { "totalPressure", TOTAL_PRESSURE, nullptr },
    { "uniformTotalPressure", TOTAL_PRESSURE, nullptr },

    { "zeroGradient", COEFFICIENTS, nullptr },
    { "fixedGradient", COEFFICIENTS, nullptr },
    { "uniformFixedGradient", COEFFICIENTS, nullptr },
    { "mixed", COEFFICIENTS, nullptr },
    { "codedMixed", COEFFICIENTS, nullptr },
    { "exprMixed", COEFFICIENTS, nullptr },
    { "inletOutlet", COEFFICIENTS, nullptr },
    { "uniformInletOutlet", COEFFICIENTS, nullptr },
    { "outletInlet", COEFFICIENTS, nullptr },
    { "fixedMeanOutletInlet", COEFFICIENTS, nullptr },
    { "freestream", COEFFICIENTS, nullptr },
    { "freestreamPressure", COEFFICIENTS, nullptr },

    { "fixedFluxPressure", EXTRAPOLATED, nullptr },
    { "fixedFluxExtrapolatedPressure", EXTRAPOLATED, nullptr },

    { "slip", WALL, nullptr },
    { "symmetry", WALL, nullptr },
    { "symmetryPlane", WALL, nullptr },

    { "empty", CONSTRAINT, nullptr },
    { "cyclic", CONSTRAINT, nullptr },
    { "processor", CONSTRAINT, nullptr },
    { "processorCyclic", CONSTRAINT, nullptr },

    { "calculated", REFUSED, nothing },
    { "extrapolatedCalculated", REFUSED, nothing },
    { "sliced", REFUSED, nothing },
    { "directionMixed", REFUSED, "it is a condition of vectors" },
    { "partialSlip", REFUSED, "it is a condition of vectors" },
    { "cyclicAMI", REFUSED, patchType },
    { "cyclicACMI", REFUSED, patchType },
    { "cyclicSlip", REFUSED, patchType },
    { "nonuniformTransformCyclic", REFUSED, patchType },
    { "wedge", REFUSED, patchType },
    { "fixedInternalValue", REFUSED, internalCells },
    { "mappedFixedInternalValue", REFUSED, internalCells },
    { "mappedFixedPushedInternalValue", REFUSED, internalCells },
    {
        "fanPressure", REFUSED,
        "the pressure of its curve would lag behind the flow rate"
    },
    {
        "advective", REFUSED,
        "the pressure of an incompressible fluid does not travel with it"
    },
    { "rotatingTotalPressure", REFUSED, rotatingFrame },
    { "prghPressure", REFUSED, pRgh },
    { "prghTotalPressure", REFUSED, pRgh },
    { "prghTotalHydrostaticPressure", REFUSED, pRgh },
    { "phaseHydrostaticPressure", REFUSED, alpha },
    { "waveSurfacePressure", REFUSED, "the mesh does not move" },
    { "fixedPressureCompressibleDensity", REFUSED, gas },
    { "plenumPressure", REFUSED, gas },
    { "syringePressure", REFUSED, gas },
    { "outletMachNumberPressure", REFUSED, gas },
    { "waveTransmissive", REFUSED, gas },
    { "fan", REFUSED, baffle },
    { "fixedJump", REFUSED, baffle },
    { "fixedJumpAMI", REFUSED, baffle },
    { "uniformJump", REFUSED, baffle },
    { "uniformJumpAMI", REFUSED, baffle },
    { "energyJump", REFUSED, baffle },
    { "energyJumpAMI", REFUSED, baffle },
    { "porousBafflePressure", REFUSED, baffle },
    { "variableHeightFlowRate", REFUSED, otherField },
    { "turbulentInlet", REFUSED, otherField },
    { "outletMappedUniformInlet", REFUSED, otherField },
    { "interfaceCompression", REFUSED, otherField },
    { "inletOutletTotalTemperature", REFUSED, otherField },
    { "outletMappedUniformInletHeatAddition", REFUSED, otherField },
    { "totalTemperature", REFUSED, otherField },
    { "totalFlowRateAdvectiveDiffusive", REFUSED, otherField },
    { "turbulentIntensityKineticEnergyInlet", REFUSED, otherField },
    { "turbulentMixingLengthDissipationRateInlet", REFUSED, otherField },
    { "turbulentMixingLengthFrequencyInlet", REFUSED, otherField },
    { "MarshakRadiation", REFUSED, otherField },
    { "MarshakRadiationFixedTemperature", REFUSED, otherField },
    { "fixedIncidentRadiation", REFUSED, otherField },
    { "greyDiffusiveRadiation", REFUSED, otherField },
    { "greyDiffusiveRadiationViewFactor", REFUSED, otherField },
    { "wideBandDiffusiveRadiation", REFUSED, otherField },
    { "convectiveHeatTransfer", REFUSED, otherField },
    { "externalWallHeatFluxTemperature", REFUSED, otherField },
    { "lumpedMassWallTemperature", REFUSED, otherField },
    { "wallHeatTransfer", REFUSED, otherField },
    { "fixedEnergy", REFUSED, otherField },
    { "gradientEnergy", REFUSED, otherField },
    { "mixedEnergy", REFUSED, otherField },
    { "fixedUnburntEnthalpy", REFUSED, otherField },
    { "gradientUnburntEnthalpy", REFUSED, otherField },
    { "mixedUnburntEnthalpy", REFUSED, otherField },

    { nullptr, REFUSED, nullptr }
};


// ************************************************************************* //
