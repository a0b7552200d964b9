# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact free modes of a column: a solid layer -Hs < y < 0 under a fluid
layer 0 < y < H.  All fields vary as exp(i w t); amplitudes are complex, SI.

The listed roots come from an independent solution of the same transcendental
equations.
"""

import cmath
import math

INTERFACE_SPEED = 1e-6          # m/s; small: the exact problems are linear
PHASE = cmath.exp(0.25j*math.pi)    # neither U nor D vanishes at t = 0


def newton(function, start, tolerance=1e-14, maxIterations=50):
    """Complex root of an analytic function, derivative by differences."""
    w = complex(start)
    for _ in range(maxIterations):
        step = 1e-6*(abs(w) + 1e-6)
        slope = (function(w + step) - function(w - step))/(2*step)
        change = function(w)/slope
        w -= change
        if abs(change) <= tolerance*abs(w):
            return w
    raise ArithmeticError("Newton iteration has not converged")


class AddedMassPiston:
    """B1: p-wave slab, clamped below, under an incompressible inviscid
    column with p = 0 on top.

        theta tan(theta) = M = rhoS Hs/(rho H),  w = theta cp/Hs
    """

    name = "addedMassPiston"
    symbol = "M"
    values = (100, 1, 0.01)
    listed = {                  # theta, to 1e-9
        100: 1.555245129,
        10: 1.428870011,
        1: 0.860333589,
        0.1: 0.3110528482,
        0.01: 0.09983363855,
        0.001: 0.03161750711,
    }
    listedTolerance = 1e-9
    Hs, H, rho, waveSpeed, poissonRatio = 1.0, 1.0, 1.0, 1.0, 0.3
    direction = 1               # component of U that moves
    patches = {
        "U": {
            "sides": "type slip;",
            "bottom": "type fixedValue; value uniform (0 0 0);",
            "top": "type zeroGradient;",
        },
        "p": {
            "sides": "type zeroGradient;",
            "bottom": "type zeroGradient;",
            "top": "type fixedValue; value uniform 0;",
        },
    }
    dSides = "calculated"

    def __init__(self, M):
        self.rhoS = M*self.rho*self.H/self.Hs
        self.theta = newton(
            lambda x: x*cmath.sin(x) - M*cmath.cos(x),
            math.atan(math.sqrt(M)*1.2)
        ).real
        self.listedRoot = self.listed[M]
        self.root = self.theta
        self.frequency = complex(self.theta*self.waveSpeed/self.Hs)
        modulus = self.rhoS*self.waveSpeed**2      # lambda + 2 G
        nu = self.poissonRatio
        self.youngsModulus = modulus*(1 + nu)*(1 - 2*nu)/(1 - nu)
        self.scale = PHASE*INTERFACE_SPEED/(
            1j*self.frequency*math.sin(self.theta))

    def displacement(self, y):
        return self.scale*math.sin(self.theta*(y + self.Hs)/self.Hs)

    def velocity(self, y):
        return 1j*self.frequency*self.displacement(min(y, 0))

    def pressure(self, y):
        if y < 0:
            return 0j
        return 1j*self.frequency*self.velocity(0)*self.rho*(self.H - y)


class ShearSlab:
    """B2: shear slab, clamped below, under a viscous layer with a wall on
    top.

        G ks cot(ks Hs) + i w mu kf coth(kf H) = 0,
        ks = w/cs,  kf = sqrt(i rho w/mu),  p = 0
    """

    name = "shearSlab"
    symbol = "rhoS"
    values = (10, 1, 0.1)
    listed = {                  # w, to 1e-8
        100: 3.13804774 + 0.00354090j,
        10: 3.10613761 + 0.03504278j,
        1: 2.78404449 + 0.30843323j,
        0.1: 1.08002575 + 0.52677310j,
    }
    listedTolerance = 1e-8
    Hs, H, rho, mu, waveSpeed, poissonRatio = 0.5, 1.0, 1.0, 0.02, 1.0, 0.3
    direction = 0
    patches = {
        "U": {
            "sides": "type cyclic;",
            "bottom": "type fixedValue; value uniform (0 0 0);",
            "top": "type noSlip;",
        },
        "p": {
            "sides": "type cyclic;",
            "bottom": "type zeroGradient;",
            "top": "type zeroGradient;",
        },
    }
    dSides = "cyclic"

    def __init__(self, rhoS):
        self.rhoS = rhoS
        self.listedRoot = self.listed[rhoS]
        modulus = rhoS*self.waveSpeed**2           # G
        self.youngsModulus = 2*modulus*(1 + self.poissonRatio)

        def traction(w):
            ks, kf = self.waveNumbers(w)
            return (
                modulus*ks/cmath.tan(ks*self.Hs)
              + 1j*w*self.mu*kf/cmath.tanh(kf*self.H)
            )

        # A rough start, so that the listed digits are a test and no input
        start = complex(round(self.listedRoot.real, 1),
                        round(self.listedRoot.imag, 1))
        self.root = self.frequency = newton(traction, start)
        ks, _ = self.waveNumbers(self.frequency)
        self.scale = PHASE*INTERFACE_SPEED/(
            1j*self.frequency*cmath.sin(ks*self.Hs))

    def waveNumbers(self, w):
        return w/self.waveSpeed, cmath.sqrt(1j*self.rho*w/self.mu)

    def displacement(self, y):
        ks, _ = self.waveNumbers(self.frequency)
        return self.scale*cmath.sin(ks*(y + self.Hs))

    def velocity(self, y):
        if y <= 0:
            return 1j*self.frequency*self.displacement(y)
        _, kf = self.waveNumbers(self.frequency)
        return self.velocity(0)*(
            cmath.sinh(kf*(self.H - y))/cmath.sinh(kf*self.H))

    def pressure(self, _):
        return 0j


PROBLEMS = {problem.name: problem for problem in (AddedMassPiston, ShearSlab)}


def schemeFrequency(scheme, w, dt):
    """Frequency a time scheme gives to the exact mode exp(i w t)."""
    s = 1j*w*dt
    if scheme == "Euler":
        factor = 1/(1 - s)
    elif scheme == "backward":
        factor = (2 + cmath.sqrt(1 + 2*s))/(3 - 2*s)
    else:
        raise ValueError("unknown scheme " + scheme)
    return cmath.log(factor)/(1j*dt)
