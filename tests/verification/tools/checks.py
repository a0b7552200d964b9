# SPDX-License-Identifier: GPL-3.0-or-later
"""Counted checks and observed orders."""

import math


class Checks:
    def __init__(self):
        self.passed = self.failed = 0

    def check(self, condition, text):
        if condition:
            self.passed += 1
        else:
            self.failed += 1
        print("PASS" if condition else "FAIL", text, flush=True)
        return bool(condition)

    def close(self):
        """Closing line; the exit status fails also if nothing was checked."""
        print(f"{self.passed} passed, {self.failed} failed", flush=True)
        return 1 if self.failed or not self.passed else 0


def orders(steps, errors):
    """Observed order of each refinement."""
    return [
        math.log(e0/e1)/math.log(h0/h1) if e0 > 0 and e1 > 0 else math.nan
        for h0, h1, e0, e1 in zip(steps, steps[1:], errors, errors[1:])
    ]


def orderIs(expected, tolerance, steps, errors):
    """True if both the finest and the mean order are as expected."""
    if len(errors) < 3 or not all(math.isfinite(e) for e in errors):
        return False
    mean = orders([steps[0], steps[-1]], [errors[0], errors[-1]])
    finest = orders(steps, errors)[-1:]
    return all(abs(o - expected) <= tolerance for o in mean + finest)
