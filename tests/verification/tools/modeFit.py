# SPDX-License-Identifier: GPL-3.0-or-later
"""Complex frequency w of a sampled series Re(a exp(i w t))."""

import cmath
import math


def readProbes(fileName):
    """Times and, for each probe, its values (scalars or tuples)."""
    times, series = [], []
    with open(fileName, encoding="ascii") as lines:
        for line in lines:
            words = line.replace("(", " ( ").replace(")", " ) ").split()
            if not words or words[0].startswith("#"):
                continue
            times.append(float(words[0]))
            series.append(grouped(words[1:]))
    return times, [list(values) for values in zip(*series)]


def grouped(words):
    """Numbers and bracketed vectors of one line."""
    values, vector = [], None
    for word in words:
        if word == "(":
            vector = []
        elif word == ")":
            values.append(tuple(vector))
            vector = None
        elif vector is None:
            values.append(float(word))
        else:
            vector.append(float(word))
    return values


def solve(matrix, rhs):
    """Small dense system, Gauss elimination with pivots."""
    n = len(rhs)
    rows = [list(row) + [b] for row, b in zip(matrix, rhs)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        if rows[pivot][i] == 0:
            raise ArithmeticError("singular fit: the series is no damped wave")
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(i + 1, n):
            factor = rows[k][i]/rows[i][i]
            rows[k] = [a - factor*b for a, b in zip(rows[k], rows[i])]
    x = [0.0]*n
    for i in reversed(range(n)):
        x[i] = (
            rows[i][n] - sum(rows[i][k]*x[k] for k in range(i + 1, n))
        )/rows[i][i]
    return x


def leastSquares(columns, values):
    matrix = [[math.fsum(a*b for a, b in zip(c, d)) for d in columns]
              for c in columns]
    return solve(matrix, [math.fsum(a*b for a, b in zip(c, values))
                          for c in columns])


def amplitude(w, times, values):
    """a of Re(a exp(i w (t - times[0]))) at a known frequency."""
    waves = [cmath.exp(1j*w*(t - times[0])) for t in times]
    real, imag = leastSquares(
        [[e.real for e in waves], [-e.imag for e in waves]], values)
    return complex(real, imag)


def linearPrediction(times, values, stride):
    """w from x[n+k] = a x[n] - b x[n-k], exact for one sampled mode."""
    n = range(stride, len(values) - stride)
    a, b = leastSquares(
        [[values[i] for i in n], [-values[i - stride] for i in n]],
        [values[i + stride] for i in n])
    if b <= 0:
        raise ArithmeticError("the series is no damped wave")
    factor = (a + cmath.sqrt(a*a - 4*b))/2
    if factor.imag == 0:
        raise ArithmeticError("the series does not oscillate")
    spacing = (times[-1] - times[0])/(len(times) - 1)*stride
    w = cmath.log(factor)/(1j*spacing)
    return complex(abs(w.real), w.imag)


def fit(times, values, stepsPerPeriod, tolerance=1e-12, maxIterations=50):
    """w, amplitude at times[0] and relative misfit of the best single mode.

    Gauss-Newton on the four parameters.  Linear prediction over an eighth of
    a period gives the start; alone it would amplify the solver's tolerance.
    """
    if not all(math.isfinite(x) for x in values):
        raise ArithmeticError("the series is not finite")
    w = linearPrediction(times, values, max(1, stepsPerPeriod//8))
    a = amplitude(w, times, values)
    t0 = times[0]
    for _ in range(maxIterations):
        model = [a*cmath.exp(1j*w*(t - t0)) for t in times]
        slopes = [1j*(t - t0)*m for t, m in zip(times, model)]
        waves = [m/a for m in model]
        change = leastSquares(
            [
                [s.real for s in slopes], [-s.imag for s in slopes],
                [e.real for e in waves], [-e.imag for e in waves],
            ],
            [x - m.real for x, m in zip(values, model)])
        w += complex(change[0], change[1])
        a += complex(change[2], change[3])
        if math.hypot(change[0], change[1]) <= tolerance*abs(w):
            break
    else:
        raise ArithmeticError("the fit has not converged")
    misfit = math.sqrt(math.fsum(
        (x - (a*cmath.exp(1j*w*(t - t0))).real)**2
        for t, x in zip(times, values))/math.fsum(x*x for x in values))
    return w, a, misfit
