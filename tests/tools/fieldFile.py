# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of OpenFOAM's field files, ascii or binary, also compressed.

Standard library only.
"""

import array
import gzip
import re
from pathlib import Path

SIZES = {b'scalar': 1, b'vector': 3, b'symmTensor': 6, b'tensor': 9}


def content(file):
    '''Bytes of a file, or of its compressed form, or None'''
    file = Path(file)
    if file.is_file():
        return file.read_bytes()
    packed = file.with_name(file.name + '.gz')
    return gzip.decompress(packed.read_bytes()) if packed.is_file() else None


def values(file):
    '''Numbers of the internal field'''
    data = content(file)
    if data is None:
        raise FileNotFoundError(file)

    uniform = re.search(rb'internalField\s+uniform\s+([^;]*);', data)
    if uniform:
        return [float(x) for x in re.sub(rb'[()]', b' ', uniform[1]).split()]

    head = re.search(rb'internalField\s+nonuniform\s+List<(\w+)>\s*(\d+)\s*\(',
                     data)
    if not head:
        return []
    n = int(head[2])
    n *= SIZES[head[1]]
    if re.search(rb'format\s+binary', data[:1000]):
        return list(array.array('d', data[head.end():head.end() + 8*n]))
    end = data.index(b';', head.end())
    text = re.sub(rb'[()]', b' ', data[head.end():end])
    return [float(x) for x in text.split()]
