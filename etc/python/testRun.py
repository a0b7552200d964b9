# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pictures of a tutorial's 'Allrun -test' say. Standard library only.

The tutorials' plots use it.
"""

import filecmp
import os


def note(case):
    """Text for a title if Allrun -test has set the values of
    system/parameters.test, else none."""
    local, test = (
        os.path.join(case, "system", "parameters." + kind)
        for kind in ("local", "test")
    )
    files = os.path.exists(local) and os.path.exists(test)
    if files and filecmp.cmp(local, test, shallow=False):
        return ", coarse (-test)"
    return ""
