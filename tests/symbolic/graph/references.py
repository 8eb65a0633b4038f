"""Writes references.hpp, the reference values for functions that are defined in terms of other functions.

    python3 references.py > references.hpp

Needs NumPy, SciPy and mpmath. Smooth functions and their derivatives are computed with 60 digits, monotone cubics by
SciPy (PchipInterpolator).
"""

import mpmath
import numpy as np
import scipy
from scipy.interpolate import PchipInterpolator

mpmath.mp.dps = 60


def smooth_abs(x, width):
    return x * mpmath.tanh(x / width)


def softplus(x, width):
    return width * mpmath.log1p(mpmath.exp(x / width))


def smooth_step(x, start, stop):
    t = min(max((x - start) / (stop - start), mpmath.mpf(0)), mpmath.mpf(1))
    return 6 * t**5 - 15 * t**4 + 10 * t**3


def rows(of, points):
    for given in points:
        x, *others = [mpmath.mpf(v) for v in given]
        f = [of(x, *others)] + [mpmath.diff(lambda s: of(s, *others), x, n) for n in (1, 2)]
        yield "{" + ", ".join(repr(float(v)) for v in (*given, *([] if len(given) == 3 else [0]), *f)) + "}"


def table(name, about, of, points):
    print(f"\n/// {about}\ninline constexpr row {name}[] = {{")
    for row in rows(of, points):
        print(f"    {row},")
    print("};")


widths = [(x, w) for w in (0.25, 3.0, 1e-3) for x in (-40.0, -2.0, -0.3, 1e-9, 0.01, 0.7, 5.0, 900.0)]
steps = [(x, a, b) for a, b in ((0.0, 1.0), (2.5, -1.0)) for x in (-7.0, -0.9, 0.1, 0.5, 0.93, 2.4, 40.0)]

print(f"// Written by references.py, with NumPy {np.__version__}, SciPy {scipy.__version__} and mpmath {mpmath.__version__}.")
print("#pragma once\n\nnamespace references {\n")
print("/// x and the other arguments, the value of the function, and its first two derivatives with respect to x.")
print("struct row {\n  double x, first, second, value, slope, curvature;\n};")
table("smooth_abs", "x tanh(x/width)", smooth_abs, widths)
table("softplus", "width ln(1 + exp(x/width))", softplus, widths)
table("smooth_step", "6 t^5 - 15 t^4 + 10 t^3", smooth_step, steps)

# A tyre's side force, uneven with a plateau and a fall; a straight line; a zigzag; three points that bend at the end.
curves = {
    "force": ([-0.4, -0.1, 0, 0.05, 0.1, 0.2, 0.5], [-0.9, -1, 0, 0.6, 1, 1, 0.8]),
    "line": ([1, 3], [2, -2]),
    "zigzag": ([0, 1, 2.5, 3, 7], [1, -1, 4, 3.5, 3.5]),
    "bend": ([1000, 1000.5, 1001], [0, 1, 20]),
}
print("\n/// x, and the value of the curve with its first and second derivatives there.")
print("struct on_curve {\n  double x, value, slope, curvature;\n};")
for name, (x, y) in curves.items():
    curve = PchipInterpolator(x, y) if len(x) > 2 else np.poly1d(np.polyfit(x, y, 1))
    derivative = curve.derivative if len(x) > 2 else lambda n: curve.deriv(n)
    print(f"\ninline constexpr double {name}_points[] = {{{', '.join(repr(float(v)) for p in zip(x, y) for v in p)}}};")
    print(f"inline constexpr on_curve {name}[] = {{")
    for a, b in zip(x, x[1:]):
        for part in (0.125, 0.5, 0.8125):
            at = a + part * (b - a)
            print(f"    {{{', '.join(repr(float(v)) for v in (at, curve(at), derivative(1)(at), derivative(2)(at)))}}},")
    print("};")

# One period of a periodic curve, from a curve through three.
period, x, y = 2.5, np.array([0.5, 1.0, 1.25, 2.2, 3.0]), np.array([2.0, 2.5, -1.0, -1.5, 2.0])
around = PchipInterpolator(
    np.concatenate([x[:-1] - period, x[:-1], x + period]), np.concatenate([y[:-1], y[:-1], y])
)
print(f"\ninline constexpr double wave_points[] = {{{', '.join(repr(float(v)) for p in zip(x, y) for v in p)}}};")
print("inline constexpr on_curve wave[] = {")
for at in (0.55, 0.75, 0.99, 1.1, 1.2, 1.5, 2.0, 2.4, 2.95):
    print(f"    {{{', '.join(repr(float(v)) for v in (at, around(at), *(around.derivative(n)(at) for n in (1, 2))))}}},")
print("};")
print("\n} // namespace references")
