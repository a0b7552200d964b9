# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that the function object 'surfaces' wrote, for pictures.

The tutorials' plots use it. A function object that writes what is read here:

    slices
    {
        type                surfaces;
        libs                (sampling);
        writeControl        writeTime;
        fields              (U p);
        interpolationScheme cell;
        surfaceFormat       vtk;
        formatOptions       { vtk { legacy true; format ascii; } }
        surfaces            ( ... );
    }

Standard library only, but for draw(), which takes axes of matplotlib.
"""

import math
import os


class Unreadable(Exception):
    """A file that is missing or has no polygons."""


class Slice:
    """Points, polygons (lists of points' numbers) and the polygons' values:
    fields["U"][polygon] is a list of components."""

    def __init__(self, path):
        try:
            with open(path, encoding="ascii", errors="replace") as file:
                text = file.read()
        except OSError as error:
            raise Unreadable("cannot read {}: {}".format(
                path, error.strerror)) from error

        words = iter(text.split("\n", 3)[-1].split())
        self.points, self.polygons, self.fields = [], [], {}
        for word in words:
            if word == "POINTS":
                n = int(next(words))
                next(words)
                self.points = [
                    [float(next(words)) for _ in range(3)] for _ in range(n)
                ]
            elif word == "POLYGONS":
                n = int(next(words))
                next(words)
                self.polygons = [
                    [int(next(words)) for _ in range(int(next(words)))]
                    for _ in range(n)
                ]
            elif word == "FIELD":
                next(words)
                for _ in range(int(next(words))):
                    name, width, n = next(words), *(
                        int(next(words)) for _ in range(2))
                    next(words)
                    self.fields[name] = [
                        [float(next(words)) for _ in range(width)]
                        for _ in range(n)
                    ]
        if not self.polygons:
            raise Unreadable("no polygons in " + path)

    def centre(self, polygon):
        """Mean of a polygon's points."""
        corners = [self.points[i] for i in self.polygons[polygon]]
        return [sum(c)/len(corners) for c in zip(*corners)]

    def warped(self, field, scale):
        """Points moved by scale times a field, means of their polygons."""
        sums = [[0, 0, 0] for _ in self.points]
        count = [0]*len(self.points)
        for polygon, value in zip(self.polygons, self.fields[field]):
            for i in polygon:
                count[i] += 1
                for d in range(3):
                    sums[i][d] += value[d]
        return [
            [x + scale*s/max(n, 1) for x, s in zip(point, total)]
            for point, total, n in zip(self.points, sums, count)
        ]


def magnitude(value):
    """Of a vector."""
    return math.sqrt(sum(v*v for v in value))


def von_mises(sigma):
    """Equivalent stress of xx xy xz yy yz zz."""
    xx, xy, xz, yy, yz, zz = sigma
    return math.sqrt(
        0.5*((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2)
        + 3*(xy*xy + yz*yz + xz*xz)
    )


def times(folder):
    """Names of the times in a folder of postProcessing, ascending."""
    def number(name):
        try:
            return float(name)
        except ValueError:
            return None

    if not os.path.isdir(folder):
        raise Unreadable("there is no folder " + folder)
    names = [n for n in os.listdir(folder) if number(n) is not None]
    if not names:
        raise Unreadable("there are no times in " + folder)
    return sorted(names, key=float)


def table(function, name):
    """Rows of numbers of postProcessing/<function>/<time>/<name>, brackets
    ignored; of several times the later values. Sorted by the first column."""
    rows = {}
    for time in times(function):
        path = os.path.join(function, time, name)
        if not os.path.exists(path):
            continue
        with open(path, encoding="ascii") as lines:
            for line in lines:
                if line.strip() and not line.startswith("#"):
                    row = [
                        float(w) for w in
                        line.replace("(", " ").replace(")", " ").split()
                    ]
                    rows[row[0]] = row
    if not rows:
        raise Unreadable("there is no {} in {}".format(name, function))
    return [rows[t] for t in sorted(rows)]


def draw(axes, cut, values, points=None, plane=(0, 1), unit=1, **options):
    """Polygons coloured by values, lengths divided by unit."""
    from matplotlib.collections import PolyCollection

    points = cut.points if points is None else points
    corners = [
        [[points[i][d]/unit for d in plane] for i in polygon]
        for polygon in cut.polygons
    ]
    options.setdefault("edgecolors", "face")
    options.setdefault("linewidths", 0.2)
    drawn = PolyCollection(corners, rasterized=True, **options)
    drawn.set_array(values)
    axes.add_collection(drawn)
    axes.autoscale_view()
    axes.set_aspect("equal")
    return drawn
