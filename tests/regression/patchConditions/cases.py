# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases in which conditions of U and p are tried, with their exact values.

Each has one patch, "tried", for the condition. Lengths in m, p in Pa.

plug      channel above a plate, mu = 0; flow at 1 m/s between slip walls; the
          condition is at the inlet or at the outlet. U = (1 0 0), p = 0.
start     the same, driven by 500 Pa. With a total pressure
          U = tanh(t/2) m/s, else U = t/2 m/s.
oblique   box of fluid in uniform flow (1 0.5 0), the condition at its inlet,
          outlet or top. p = 0.
couette   box of fluid, mu = 1, between a wall at rest and the condition (or the
          other way round): linear profile.
rest      box of heavy fluid at rest, p = rho g (H - y).
ramp      fluid above an elastic slab, which the condition pushes down at V:
          D = V t (y + Hs)/Hs, p = K V t/Hs, exact at every time step.
swing     the same with a light slab: a pressure P from t = 0 on, at the patch
          of the condition. m d'' = P - k d, m the column's and a third of the
          slab's mass, k = K/Hs; in and out of the patch by turns. So small
          that rho U^2 is nothing.
"""

import math
import os
import re
import subprocess

RHO = 1000.0
PI = math.pi


class Failed(Exception):
    """A run or a file is not as it should be."""


def header(name, kind="dictionary"):
    return (
        "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
        % (kind, name)
    )


def vector(v):
    return "(%.17g %.17g %.17g)" % tuple(v)


# Blocks: list of (x0, x1, nx, y0, y1, ny, zone), patches: {name: [(block,
# side)]} with side in w e s n; a patch may be (type and entries, list)
def block_mesh(blocks, patches):
    points, text, faces = [], [], {}

    def point(x, y, z):
        key = (x, y, z)
        if key not in points:
            points.append(key)
        return points.index(key)

    empty = []
    for i, (x0, x1, nx, y0, y1, ny, zone) in enumerate(blocks):
        p = [
            point(x, y, z)
            for z in (0, 0.1)
            for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
        ]
        text.append(
            "hex (%s) %s (%d %d 1) simpleGrading (1 1 1)"
            % (" ".join(map(str, p)), zone, nx, ny)
        )
        faces[i, "w"] = (p[0], p[4], p[7], p[3])
        faces[i, "e"] = (p[1], p[2], p[6], p[5])
        faces[i, "s"] = (p[0], p[1], p[5], p[4])
        faces[i, "n"] = (p[3], p[7], p[6], p[2])
        empty += [(p[0], p[3], p[2], p[1]), (p[4], p[5], p[6], p[7])]

    out = header("blockMeshDict") + "scale 1;\nvertices\n(\n"
    out += "".join("    %s\n" % vector(p) for p in points)
    out += ");\nblocks\n(\n" + "".join("    %s\n" % t for t in text)
    out += ");\nedges ();\nboundary\n(\n"
    for name, sides in patches.items():
        kind = "type patch;"
        if isinstance(sides, tuple):
            kind, sides = sides
        out += "    %s { %s faces ( %s ); }\n" % (
            name, kind,
            " ".join("(%d %d %d %d)" % faces[s] for s in sides)
        )
    out += "    frontAndBack { type empty; faces ( %s ); }\n" % (
        " ".join("(%d %d %d %d)" % f for f in empty)
    )
    return out + ");\nmergePatchPairs ();\n"


def centres(blocks):
    """(x, y, zone) of the cells, in blockMesh's order."""
    cells = []
    for x0, x1, nx, y0, y1, ny, zone in blocks:
        for j in range(ny):
            for i in range(nx):
                cells.append((
                    x0 + (i + 0.5)*(x1 - x0)/nx,
                    y0 + (j + 0.5)*(y1 - y0)/ny,
                    zone,
                ))
    return cells


def write(case, path, text):
    path = os.path.join(case, path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


def field(name, kind, dimensions, internal, patches):
    return (
        header(name, kind)
        + "dimensions %s;\ninternalField %s;\nboundaryField\n{\n"
        % (dimensions, internal)
        + "".join("    %s { %s }\n" % item for item in patches.items())
        + "    frontAndBack { type empty; }\n}\n"
    )


def numbers(text):
    return [
        float(w)
        for w in re.findall(r"[-+]?(?:\d+\.?\d*(?:e[-+]?\d+)?|nan|inf)", text)
    ]


def values(entry, size, n):
    """Values of an entry, uniform or not, n of them of that size."""
    if entry.startswith("uniform"):
        return [numbers(entry[7:])]*n
    flat = numbers(entry[entry.index("("):])
    return [flat[i:i + size] for i in range(0, len(flat), size)]


def read(case, time, name, size, n):
    """Values of the cells, and {patch: text} of a written field."""
    path = os.path.join(case, time, name)
    if not os.path.isfile(path):
        raise Failed("no file %s/%s" % (time, name))
    with open(path, encoding="ascii") as file:
        text = file.read()
    inside = re.search(r"internalField\s+([^;]*);", text).group(1)
    patches = dict(
        re.findall(r"\n    (\w+)\n    \{\n(.*?)\n    \}", text, re.S)
    )
    return values(inside, size, n), patches


def patch_values(patches, patch, size):
    entries = re.findall(r"^ {8}value\s+([^;]*);", patches[patch], re.M)
    if not entries:
        return []
    return values(entries[-1], size, 1)


class Case:
    """A case: blocks, patches, fields, and what is exact."""

    blocks = []
    patches = {}
    materials = ""
    U = {}
    p = {}
    files = {}
    pimple = ""
    schemes = "div(phi,U) Gauss linear;"

    def __init__(self, side="inlet"):
        self.side = side

    def initial(self):
        """Texts of internalField of U and p."""
        return "uniform (0 0 0)", "uniform 0"

    def run(self, case, row, delta_t, end, interval, solve=True):
        """Write the case, with the conditions of the row, and run it."""
        write(case, "system/blockMeshDict",
              block_mesh(self.blocks, self.patches))
        write(
            case, "system/controlDict",
            header("controlDict")
            + "application umfsiFoam; startFrom startTime; startTime 0;\n"
            "stopAt endTime; endTime %.17g; deltaT %.17g;\n"
            "writeControl adjustable; writeInterval %.17g;\n"
            "writeFormat ascii; writePrecision 12; timePrecision 12;\n"
            % (end, delta_t, interval)
        )
        write(
            case, "system/fvSchemes",
            header("fvSchemes")
            + "ddtSchemes { default backward; } gradSchemes "
            "{ default Gauss linear; } divSchemes { default none; %s }\n"
            "laplacianSchemes {} interpolationSchemes { default linear; }\n"
            "snGradSchemes { default corrected; }\n" % self.schemes
        )
        write(
            case, "system/fvSolution",
            header("fvSolution")
            + "solvers\n{\n"
            "    p { solver PCG; preconditioner DIC; tolerance 1e-30;"
            " relTol 0.01; }\n"
            "    U { solver PBiCGStab; preconditioner DILU; tolerance 1e-30;"
            " relTol 0.01; }\n"
            "    D { solver PCG; preconditioner DIC; tolerance 1e-30;"
            " relTol 0.01; }\n}\n"
            "PIMPLE { onNonConvergence stop; residualControl {"
            " fluidMomentum 1e-6; solidMomentum 1e-6; interfaceTraction 1e-6;"
            " continuity 1e-5; } %s }\n" % self.pimple
        )
        write(case, "constant/materialProperties",
              header("materialProperties") + self.materials)
        for path, text in {**self.files, **row.files}.items():
            write(case, path, text)

        U, p = self.initial()
        U_patches, p_patches = dict(self.U), dict(self.p)
        U_patches["tried"], p_patches["tried"] = self.conditions(row)
        write(case, "0/U", field("U", "volVectorField", "[0 1 -1 0 0 0 0]",
                                 U, U_patches))
        write(case, "0/p", field("p", "volScalarField", "[1 -1 -2 0 0 0 0]",
                                 p, p_patches))

        for program in ("blockMesh", "umfsiFoam") if solve else ():
            with open(os.path.join(case, "log." + program), "w",
                      encoding="ascii") as log:
                status = subprocess.call(
                    [program], cwd=case, stdout=log, stdin=subprocess.DEVNULL,
                    stderr=subprocess.STDOUT, timeout=120
                )
            if status:
                raise Failed("%s: exit status %d" % (program, status))

    def conditions(self, row):
        """The row's condition and the usual one of the other field."""
        if row.field == "U":
            return row.text, self.p_with_U
        return self.U_with_p, row.text

    p_with_U = "type zeroGradient;"
    U_with_p = "type zeroGradient;"

    def cells(self):
        return centres(self.blocks)

    def fields(self, case, time):
        n = len(self.cells())
        U, U_patches = read(case, time, "U", 3, n)
        p, p_patches = read(case, time, "p", 1, n)
        return U, [v[0] for v in p], U_patches, p_patches

    def compare(self, case, time, U, p, tolerance):
        """Largest errors of fluid cells and of the patch against U(x, y) and
        p(x, y), as checks (name, error, limit)."""
        found, pressures, U_patches, p_patches = self.fields(case, time)
        fluid = [
            (found[i], pressures[i], x, y)
            for i, (x, y, zone) in enumerate(self.cells()) if zone == "fluid"
        ]
        checks = [(
            "U at %s s" % time,
            max(abs(v[k] - U(x, y)[k]) for v, _, x, y in fluid
                for k in (0, 1)),
            tolerance[0],
        )]
        if p:
            checks.append((
                "p at %s s" % time,
                max(abs(q - p(x, y)) for _, q, x, y in fluid), tolerance[1],
            ))
        for x, y, v in self.patch_points(
                patch_values(U_patches, "tried", 3)):
            checks.append((
                "U of the patch",
                max(abs(v[k] - U(x, y)[k]) for k in (0, 1)), tolerance[0],
            ))
        return checks

    def patch_points(self, vectors):
        """(x, y, value) of the patch's faces: one point where uniform."""
        return [(*self.patch_point, v) for v in vectors]

    patch_point = (0, 0)


class Plug(Case):
    blocks = [
        (0, 1, 10, -0.1, 0, 2, "plate"), (0, 1, 10, 0, 0.2, 4, "fluid")
    ]
    patches = {
        "clamp": [(0, "w"), (0, "e"), (0, "s")],
        "tried": [(1, "w")], "other": [(1, "e")], "top": [(1, "n")],
    }
    materials = (
        "fluid { type newtonianFluid; cellZones (fluid); rho 1000; mu 0; }\n"
        "plate { type linearElastic; cellZones (plate); rho 2000; E 1e9;"
        " nu 0.3; }\n"
    )
    U = {"clamp": "type slip;", "top": "type slip;"}
    p = {"clamp": "type zeroGradient;", "top": "type zeroGradient;"}

    def __init__(self, side="inlet", U=None, p=None):
        super().__init__(side)
        self.U_with_p = U or self.U_with_p
        self.U = dict(self.U)
        self.p = dict(self.p)
        self.patches = dict(self.patches)
        if side == "inlet":
            self.U["other"] = "type zeroGradient;"
            self.p["other"] = "type fixedValue; value uniform 0;"
        else:
            self.patches["tried"] = [(1, "e")]
            self.patches["other"] = [(1, "w")]
            self.patch_point = (1, 0)
            self.p_with_U = p or "type fixedValue; value uniform 0;"
            self.U["other"] = "type fixedValue; value uniform (1 0 0);"
            self.p["other"] = "type zeroGradient;"
            if p:
                # Somewhere p must be given: on a patch without flow
                self.p["top"] = "type fixedValue; value uniform 0;"

    start = 1

    def initial(self):
        return (
            "nonuniform List<vector> %d (%s)" % (
                len(self.cells()),
                " ".join(vector((self.start*(zone == "fluid"), 0, 0))
                         for _, _, zone in self.cells())
            ),
            "uniform 0",
        )

    def check(self, case, row):
        checks = []
        for delta_t in (0.1, 0.01):
            self.run(case, row, delta_t, 10*delta_t, 10*delta_t)
            checks += self.compare(
                case, "%g" % (10*delta_t), lambda x, y: (1, 0),
                lambda x, y: 0, (1e-5, 1e-2)
            )
        return checks


class Start(Plug):
    """Driven by 500 Pa at the inlet."""

    def __init__(self, p="type fixedValue; value uniform 500;", start=0):
        super().__init__()
        self.p_with_U = p
        self.start = start

    U_with_p = "type pressureInletVelocity; value uniform (0 0 0);"

    def check(self, case, row):
        conditions = self.conditions(row)
        total = "otalPressure" in conditions[1]
        checks = []
        for delta_t, limit in ((0.1, 5e-4), (0.02, 3e-5)):
            self.run(case, row, delta_t, 2, 2)
            u = math.tanh(1) if total else self.start + 1.0
            p = 500*(1 - u*u) if total else 500.0
            checks += self.compare(
                case, "2", lambda x, y: (u, 0), lambda x, y: p*(1 - x),
                (limit if total else 1e-5, 2000*limit if total else 1e-2)
            )
        return checks


class Oblique(Case):
    blocks = [(0, 1, 5, 0, 1, 5, "fluid")]
    materials = (
        "fluid { type newtonianFluid; cellZones (fluid); rho 1000; mu 1; }\n"
    )
    U = {
        "south": "type fixedValue; value uniform (1 0.5 0);",
        "east": "type zeroGradient;", "north": "type zeroGradient;",
        "west": "type fixedValue; value uniform (1 0.5 0);",
    }
    p = {
        "south": "type zeroGradient;", "west": "type zeroGradient;",
        "east": "type fixedValue; value uniform 0;",
        "north": "type fixedValue; value uniform 0;",
    }

    def __init__(self, side="inlet", p=None):
        super().__init__(side)
        sides = {"west": "w", "south": "s", "east": "e", "north": "n"}
        tried = {"inlet": "west", "outlet": "east", "top": "north"}[side]
        self.patches = {
            "tried" if name == tried else name: [(0, letter)]
            for name, letter in sides.items()
        }
        self.U = {k: v for k, v in self.U.items() if k != tried}
        self.p = {k: v for k, v in self.p.items() if k != tried}
        self.p_with_U = p or (
            "type fixedValue; value uniform 0;" if side == "outlet"
            else "type zeroGradient;"
        )
        self.patch_point = {
            "inlet": (0, 0.5), "outlet": (1, 0.5), "top": (0.5, 1)
        }[side]

    def initial(self):
        return "uniform (1 0.5 0)", "uniform 0"

    def check(self, case, row):
        checks = []
        for delta_t in (0.1, 0.01):
            self.run(case, row, delta_t, 20*delta_t, 20*delta_t)
            checks += self.compare(
                case, "%g" % (20*delta_t), lambda x, y: (1, 0.5),
                lambda x, y: 0, (1e-5, 1e-2)
            )
        return checks


class Couette(Case):
    """Height 1, 8 cells, the condition at the top; bottom and top are the
    exact velocities of the walls."""

    blocks = [(0, 1, 4, 0, 1, 8, "fluid")]
    patches = {
        "tried": [(0, "n")], "south": [(0, "s")],
        "west": ("type cyclic; neighbourPatch east;", [(0, "w")]),
        "east": ("type cyclic; neighbourPatch west;", [(0, "e")]),
    }
    materials = (
        "fluid { type newtonianFluid; cellZones (fluid); rho 1000; mu 1; }\n"
    )
    U = {
        "south": "type fixedValue; value uniform (1 0 0);",
        "west": "type cyclic;", "east": "type cyclic;",
    }
    p = {
        "south": "type zeroGradient;",
        "west": "type cyclic;", "east": "type cyclic;",
    }
    pimple = "pRefPoint (0.5 0.5 0.05); pRefValue 0;"
    patch_point = (0, 1)

    def __init__(self, bottom=1.0, top=0.0, south=None, p=None):
        super().__init__()
        self.p_with_U = p or self.p_with_U
        self.bottom, self.top = bottom, top
        self.U = dict(self.U)
        if south:
            self.U["south"] = south

    def check(self, case, row):
        bottom, top = self.bottom, self.top
        # Ten times the viscous time, rho H^2/mu
        self.run(case, row, 500, 10000, 10000)
        return self.compare(
            case, "10000", lambda x, y: (bottom + y*(top - bottom), 0),
            None, (1e-5, 0)
        )


class Rest(Case):
    """Heavy fluid, height 1, g = 10."""

    blocks = [(0, 1, 4, 0, 1, 4, "fluid")]
    patches = {"tried": [(0, "w")], "walls": [(0, "e"), (0, "s"), (0, "n")]}
    materials = Oblique.materials
    U = {"walls": "type noSlip;"}
    p = {"walls": "type fixedFluxPressure; gradient uniform 0;"
                  " value uniform 0;"}
    files = {
        "constant/g": header("g", "uniformDimensionedVectorField")
        + "dimensions [0 1 -2 0 0 0 0]; value (0 -10 0);\n"
    }

    def __init__(self, side="inlet"):
        super().__init__(side)
        if side == "wall":
            self.patches = {
                "tried": [(0, "e"), (0, "s"), (0, "n")], "walls": [(0, "w")]
            }
            self.U_with_p = "type noSlip;"
            self.U = {"walls": "type zeroGradient;"}
            self.p = {"walls": "type uniformDensityHydrostaticPressure;"
                      " rho 1000; pRefValue 0; pRefPoint (0 1 0);"
                      " value uniform 0;"}

    def check(self, case, row):
        self.run(case, row, 0.1, 2, 2)
        return self.compare(
            case, "2", lambda x, y: (0, 0), lambda x, y: 1e4*(1 - y),
            (1e-6, 1e-1)
        )


class Column(Case):
    """Fluid, height 1, over an elastic slab, thickness .5."""

    blocks = [
        (0, 0.3, 3, -0.5, 0, 4, "slab"), (0, 0.3, 3, 0, 1, 6, "fluid")
    ]
    patches = {
        "clamp": [(0, "s")], "sides": [(0, "w"), (0, "e"), (1, "w"), (1, "e")],
        "tried": [(1, "n")],
    }
    U = {"clamp": "type fixedValue; value uniform (0 0 0);",
         "sides": "type slip;"}
    p = {"clamp": "type zeroGradient;", "sides": "type zeroGradient;"}
    patch_point = (0, 1)
    E, nu, rho_s = 4e5, 0.3, 1000.0

    @property
    def K(self):
        return (self.E*(1 - self.nu)/(1 + self.nu)/(1 - 2*self.nu))

    @property
    def materials(self):
        return (
            "fluid { type newtonianFluid; cellZones (fluid); rho 1000;"
            " mu 0.1; }\nslab { type linearElastic; cellZones (slab);"
            " rho %.17g; E %.17g; nu %.17g; }\n"
            % (self.rho_s, self.E, self.nu)
        )


class Ramp(Column):
    V = 1e-5

    def __init__(self, side="inlet", U=None):
        super().__init__(side)
        self.U_with_p = U or self.U_with_p

    def initial(self):
        sign = -1 if self.side == "inlet" else 1
        return (
            "nonuniform List<vector> %d (%s)" % (
                len(self.cells()),
                " ".join(
                    vector((0, sign*self.V*min(1, (y + 0.5)/0.5), 0))
                    for _, y, _ in self.cells()
                )
            ),
            "uniform 0",
        )

    def check(self, case, row):
        sign = -1 if self.side == "inlet" else 1
        checks = []
        for delta_t in (1e-2, 1e-4):
            t = 50*delta_t
            p = -sign*self.K*self.V*t/0.5
            self.run(case, row, delta_t, t, t)
            checks += self.compare(
                case, "%g" % t, lambda x, y: (0, sign*self.V),
                lambda x, y: p, (2e-4*self.V, 2e-4*abs(p))
            )
        return checks


class Swing(Column):
    P = 1e-3
    rho_s = 1.0
    # k = 1000 N/m3: one radian per second
    E = 500*(1.3*0.4/0.7)

    p_with_U = "type fixedValue; value uniform 1e-3;"

    def check(self, case, row):
        m = RHO*1 + self.rho_s*0.5/3
        k = self.K/0.5
        omega = math.sqrt(k/m)
        period = 2*PI/omega
        checks = []
        for n, limit in ((40, 0.06), (160, 0.006)):
            self.run(case, row, period/n, period*(1 + 1e-9), period/4)
            times = sorted(
                (d for d in os.listdir(case) if re.match(r"[0-9.]+$", d)),
                key=float
            )
            for quarter in (1, 2, 3, 4):
                angle = quarter*PI/2
                exact_u = self.P/k*omega*math.sin(angle)
                exact_d = self.P/k*(1 - math.cos(angle))
                U, _, U_patches, _ = self.fields(case, times[quarter])
                u = max(
                    (-U[i][1] for i, c in enumerate(self.cells())
                     if c[2] == "fluid"),
                    key=lambda v: abs(v - exact_u)
                )
                checks.append((
                    "U at %d/4, %d steps" % (quarter, n),
                    abs(u - exact_u), limit*self.P/k
                ))
                D, _ = read(case, times[quarter], "D", 3, len(U))
                top = -D[3*3 + 1][1]/(0.4375/0.5)
                checks.append((
                    "D at %d/4, %d steps" % (quarter, n),
                    abs(top - exact_d), limit*self.P/k
                ))
        return checks
