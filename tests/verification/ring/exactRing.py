#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact frequency of a ring under an inviscid fluid, two waves around it.

Usage: exactRing.py <density of the fluid>

Plane strain, a < r < b, free inside; incompressible potential flow b < r < R,
rigid wall at R. With u_r, sigma_rr ~ cos(n theta) and u_theta,
sigma_rtheta ~ sin(n theta) the equations of motion are four ordinary
differential equations in r, solved by Runge-Kutta steps from r = a. The
fluid's pressure on the ring follows from its potential. Prints rad/s.
"""

import functools
import math
import sys

INSIDE, OUTSIDE, WALL = 0.95, 1.05, 1.5
RHO, YOUNG, POISSON = 1000, 1e6, 0.3
WAVES = 2

# From an independent solution of the same problem
LISTED = {0: 2.555042, 14: 2.435615, 140: 1.804513, 1400: 0.768654}
LISTED_TOLERANCE = 1e-6     # rad/s: the digits given

SHEAR = YOUNG/(2*(1 + POISSON))
LAMBDA = YOUNG*POISSON/((1 + POISSON)*(1 - 2*POISSON))
STEPS = 400                 # of Runge-Kutta; 1e-10 of the frequency


def slopes(r, state, w2):
    """d/dr of u_r, u_theta, sigma_rr, sigma_rtheta."""
    u, v, radial, shear = state
    hoop = (u + WAVES*v)/r
    du = (radial - LAMBDA*hoop)/(LAMBDA + 2*SHEAR)
    around = LAMBDA*du + (LAMBDA + 2*SHEAR)*hoop
    return (
        du,
        shear/SHEAR + (v + WAVES*u)/r,
        -(radial - around + WAVES*shear)/r - RHO*w2*u,
        -(2*shear - WAVES*around)/r - RHO*w2*v,
    )


def outside(state, w2):
    """State at the outside of the ring that has this state inside."""
    h = (OUTSIDE - INSIDE)/STEPS
    for i in range(STEPS):
        r = INSIDE + i*h
        k = [slopes(r, state, w2)]
        for part in (0.5, 0.5, 1):
            k.append(slopes(
                r + part*h,
                [y + part*h*s for y, s in zip(state, k[-1])], w2))
        state = [
            y + h/6*(a + 2*b + 2*c + d)
            for y, a, b, c, d in zip(state, *k)]
    return state


def addedMass(rhoFluid):
    """p/(w^2 u_r) at the outside of the ring, from the potential
    r^n + R^2n/r^n.
    """
    ratio = (WALL/OUTSIDE)**(2*WAVES)
    return rhoFluid*OUTSIDE/WAVES*(1 + ratio)/(1 - ratio)


def residual(w, rhoFluid):
    """Zero at a natural frequency."""
    w2 = w*w
    columns = []
    for start in (1, 0, 0, 0), (0, 1, 0, 0):
        u, _, radial, shear = outside(start, w2)
        columns.append((radial + addedMass(rhoFluid)*w2*u, shear))
    (a, b), (c, d) = columns
    return a*d - b*c


@functools.lru_cache
def frequency(rhoFluid):
    """Lowest natural frequency [rad/s]."""
    step = 0.05
    low = step
    sign = residual(low, rhoFluid)
    while residual(low + step, rhoFluid)*sign > 0:
        low += step
    high = low + step
    while high - low > 1e-13*high:
        middle = (low + high)/2
        if middle in (low, high):
            break
        if residual(middle, rhoFluid)*sign > 0:
            low = middle
        else:
            high = middle
    return low


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(f"{frequency(float(sys.argv[1])):.12g}")
