# SPDX-License-Identifier: GPL-3.0-or-later
"""Raw files (.xy) of the function object sets, for plot and for the tests.

The name of a file is that of the line, then those of its fields. Up to v2112
a file holds fields of one type, from v2206 on all fields: scalars, vectors,
symmetric tensors, in this order. The columns are the coordinate, then the
components of the fields.
"""

import os

SIZES = {"p": 1, "U": 3, "D": 3, "sigma": 6}


class Unreadable(Exception):
    """A file or a field is not there, or not as it should be."""


def fields(name):
    """Fields of a file, from its name: the last words of it that are known.

    The name of a line may have underscores, too.
    """
    words = os.path.splitext(name)[0].split("_")[1:]
    known = []
    while words and words[-1] in SIZES:
        known.insert(0, words.pop())
    return known


def columns(name):
    """{field: (first column, number of columns)} and number of columns."""
    places = {}
    first = 1
    before = 0
    for field in fields(name):
        size = SIZES[field]
        if size < before or field in places:
            raise Unreadable("unexpected order of fields in " + name)
        places[field] = first, size
        first += size
        before = size
    return places, first


def rows(path):
    """Numbers of a file, row by row."""
    if not os.path.exists(path):
        raise Unreadable("no " + path)
    with open(path, encoding="ascii") as file:
        numbers = [
            [float(word) for word in line.split()]
            for line in file if line.strip() and line.lstrip()[0] != "#"
        ]
    if not numbers:
        raise Unreadable("no points in " + path)

    _, expected = columns(os.path.basename(path))
    for row in numbers:
        if len(row) != expected:
            raise Unreadable("unexpected columns in {}: {}, not {}".format(
                path, len(row), expected
            ))
    return numbers


def read(folder, line, field):
    """Coordinates and components of a field on a line, row by row."""
    names = os.listdir(folder) if os.path.isdir(folder) else []
    for name in sorted(names):
        if (
            name.endswith(".xy") and field in fields(name)
            and name == "_".join([line] + fields(name)) + ".xy"
        ):
            first, size = columns(name)[0][field]
            numbers = rows(os.path.join(folder, name))
            return (
                [row[0] for row in numbers],
                [row[first:first + size] for row in numbers]
            )
    raise Unreadable("no {} on line {} in {}".format(field, line, folder))
