# SPDX-License-Identifier: GPL-3.0-or-later
"""Two incompressible fluids enclosed by two elastic rings, exact.

Rigid core | fluid, A < r | ring, r < B | fluid, B < r < C | ring, r < D |
pressure P. Plane strain, Lame's solution in the rings. The inner fluid keeps
its volume: u(A) = 0; the outer one too: B u(B) = C u(C). These two linear
equations give the pressures of the fluids.
"""

import math

CORE, A, B, C, D = 0.5, 1.0, 1.25, 1.5, 1.75
DEPTH = 1.0
ANGLE = math.pi/2       # a quarter is computed


class Ring:
    """Lame's solution between two radii, for pressures inside and outside."""

    def __init__(self, inner, outer, E, nu):
        self.inner, self.outer, self.E, self.nu = inner, outer, E, nu

    def constants(self, inside, outside):
        """Stress m - k/r^2 across the radius, m + k/r^2 around."""
        a2, b2 = self.inner**2, self.outer**2
        return ((inside*a2 - outside*b2)/(b2 - a2),
                (inside - outside)*a2*b2/(b2 - a2))

    def displacement(self, r, inside, outside):
        """Radial."""
        m, k = self.constants(inside, outside)
        return (1 + self.nu)/self.E*((1 - 2*self.nu)*m*r + k/r)

    def stress(self, r, inside, outside):
        """sigma_rr, sigma_tt, sigma_zz."""
        m, k = self.constants(inside, outside)
        return m - k/r**2, m + k/r**2, 2*self.nu*m


class Rings:
    """Rings and fluids under the outer pressure P."""

    def __init__(self, E, P):
        self.P = P
        self.inner = Ring(A, B, E, 0.3)
        self.outer = Ring(C, D, 2*E, 0.4)

        # Volumes are linear in the pressures
        (v11, v21), (v12, v22) = self.volumes(1, 0, 0), self.volumes(0, 1, 0)
        v1, v2 = self.volumes(0, 0, P)
        det = v11*v22 - v12*v21
        self.p = ((v12*v2 - v22*v1)/det, (v21*v1 - v11*v2)/det)
        self.compliance = v11, v22

    def volumes(self, p1, p2, P):
        """Volumes that the walls of both fluids make way for."""
        factor = ANGLE*DEPTH
        return (
            factor*A*self.inner.displacement(A, p1, p2),
            factor*(C*self.outer.displacement(C, p2, P)
                    - B*self.inner.displacement(B, p1, p2)))

    def ring(self, r):
        """The ring at r and the pressures inside and outside of it."""
        if r < (B + C)/2:
            return self.inner, self.p[0], self.p[1]
        return self.outer, self.p[1], self.P

    def displacement(self, r):
        ring, inside, outside = self.ring(r)
        return ring.displacement(r, inside, outside)

    def stress(self, r):
        ring, inside, outside = self.ring(r)
        return ring.stress(r, inside, outside)
