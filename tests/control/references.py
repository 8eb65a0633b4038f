"""Writes references.hpp, the reference values of the tests of control/.

    python3 references.py > references.hpp

Needs NumPy, SciPy and mpmath. Discrete forms are computed with 60 digits. Solutions of Riccati equations are those of
SciPy, refined by Newton's method (Kleinman's, with one linear system for all entries) with 60 digits; comments give the
errors of SciPy's own results. The filter is a textbook implementation with dense matrices and derivatives by complex steps.
"""

import json
from pathlib import Path

import mpmath
import numpy as np
import scipy
from scipy.linalg import expm, solve_continuous_are, solve_discrete_are
from scipy.signal import cont2discrete
from scipy.stats import chi2

mpmath.mp.dps = 60


def exact(m):
    return mpmath.matrix(np.asarray(m, float).tolist())


def braces(m):
    return "{" + ", ".join("{" + ", ".join(repr(float(x)) for x in row) + "}" for row in np.atleast_2d(m)) + "}"


def rounded(m):
    return np.array([[float(m[i, j]) for j in range(m.cols)] for i in range(m.rows)])


def relative(found, expected):
    return np.abs(found - expected).max() / np.abs(expected).max()


# Discrete forms

def discrete(name, a, b, c, h):
    a, b, c = np.atleast_2d(np.asarray(a, float)), np.atleast_2d(np.asarray(b, float)), np.asarray(c, float).reshape(-1, 1)
    n, m = b.shape
    whole = mpmath.zeros(n + m + 1)
    for i in range(n):
        for j in range(n):
            whole[i, j] = mpmath.mpf(a[i, j]) * mpmath.mpf(h)
        for j in range(m):
            whole[i, n + j] = mpmath.mpf(b[i, j]) * mpmath.mpf(h)
        whole[i, n + m] = mpmath.mpf(c[i, 0]) * mpmath.mpf(h)
    e = rounded(mpmath.expm(whole, method="taylor"))
    ad, bd, cd = e[:n, :n], e[:n, n:n + m], e[:n, n + m:]
    found = cont2discrete((a, b, np.eye(n), np.zeros((n, m))), h)
    print(f"// The errors of SciPy are {relative(found[0], ad):.1e} and {relative(found[1], bd):.1e}.")
    print(f"inline constexpr discrete<{n}, {m}> {name}{{{braces(a)}, {braces(b)}, {braces(c)}, {h!r}, "
          f"{braces(ad)}, {braces(bd)}, {braces(cd)}}};")


# Riccati equations

def linear_solution(columns, right):
    """Solves f(X) = right for a linear f that is given by its values at the unit matrices."""
    n = right.rows
    system = mpmath.matrix(n * n, n * n)
    for k, column in enumerate(columns):
        for i in range(n):
            for j in range(n):
                system[i * n + j, k] = column[i, j]
    flat = mpmath.lu_solve(system, mpmath.matrix([right[i, j] for i in range(n) for j in range(n)]))
    return mpmath.matrix(n, n, ) + mpmath.matrix([[flat[i * n + j] for j in range(n)] for i in range(n)])


def unit(n, k):
    e = mpmath.zeros(n)
    e[k // n, k % n] = 1
    return e


def refined(a, b, q, r, x, continuous):
    a, b, q, r, x = map(exact, (a, b, q, r, x))
    n = a.rows
    g = b * mpmath.inverse(r) * b.T
    for _ in range(40):
        if continuous:
            closed = a - g * x
            left = q + a.T * x + x * a - x * g * x
            columns = [-(closed.T * unit(n, k) + unit(n, k) * closed) for k in range(n * n)]
        else:
            closed = mpmath.inverse(mpmath.eye(n) + g * x) * a
            left = q - x + a.T * x * closed
            columns = [unit(n, k) - closed.T * unit(n, k) * closed for k in range(n * n)]
        change = linear_solution(columns, left)
        x = x + change
        x = (x + x.T) / 2
        if mpmath.mnorm(change, 1) < mpmath.mpf(10) ** -45 * mpmath.mnorm(x, 1):
            values = [closed[0, 0]] if n == 1 else mpmath.eig(closed, left=False, right=False)
            assert all((mpmath.re(v) < 0) if continuous else (abs(v) < 1) for v in values), "not stabilizing"
            return rounded(x)
    raise RuntimeError("Newton's method did not converge")


def riccati(name, a, b, q, r, continuous, start=None):
    a, b, q, r = (np.atleast_2d(np.asarray(m, float)) for m in (a, b, q, r))
    n, m = b.shape
    solver = solve_continuous_are if continuous else solve_discrete_are
    try:
        found = solver(a, b, q, r)
    except (np.linalg.LinAlgError, ValueError):
        found = None
    x = refined(a, b, q, r, found if start is None else start, continuous)
    print("// SciPy finds no solution." if found is None else f"// The error of SciPy is {relative(found, x):.1e}.")
    print(f"inline constexpr riccati<{n}, {m}> {name}{{{braces(a)}, {braces(b)}, {braces(q)}, {braces(r)}, "
          f"{braces(x)}}};")


def in_units(a, b, q, r, states, inputs):
    s, u = np.diag(states), np.diag(inputs)
    return np.linalg.inv(s) @ a @ s, np.linalg.inv(s) @ b @ u, s @ q @ s, u @ r @ u


# A cart with a pendulum, examples/models/n_pendulum_cart.hpp: [x, angle, v, rate], the angle from the track.

m0, m1, length, gravity = 1.5, 0.4, 0.8, 9.81


def rates(x, force):
    s, c = np.sin(x[1]), np.cos(x[1])
    mass = np.array([[m0 + m1, -m1 * length * s], [-m1 * length * s, m1 * length**2]])
    right = np.array([force + m1 * length * c * x[3]**2, -m1 * gravity * length * c])
    return np.concatenate([x[2:], np.linalg.solve(mass, right)])


def measured(x, force):
    return np.array([x[0], x[2] - length * np.sin(x[1]) * x[3], rates(x, force)[2]])


def slope(f, x):
    columns = []
    for i in range(len(x)):
        moved = x.astype(complex)
        moved[i] += 1e-30j
        columns.append(f(moved).imag / 1e-30)
    return np.array(columns).T


def step(x, force, h):
    k1 = rates(x, force)
    k2 = rates(x + h / 2 * k1, force)
    k3 = rates(x + h / 2 * k2, force)
    k4 = rates(x + h * k3, force)
    return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def filtered():
    h, random = 0.02, np.random.default_rng(4)
    q = np.diag([1e-6, 1e-6, 1e-4, 2e-4])
    r = np.diag([1e-4, 4e-4, 1e-2])
    r[0, 1] = r[1, 0] = 5e-5
    p = np.diag([1e-2, 2e-2, 4e-2, 3e-2])
    x = np.array([0.0, 1.5, 0.0, 0.0])
    truth = x + np.array([0.05, -0.1, 0.1, 0.1])
    forces, seen = [], []
    for k in range(40):
        force = float(np.round(3 * np.sin(0.3 * k), 3))
        truth = step(truth, force, h) + random.multivariate_normal(np.zeros(4), q)
        y = np.round(measured(truth, force) + random.multivariate_normal(np.zeros(3), r), 6)
        forces.append(force)
        seen.append(y)
        a = expm(h * slope(lambda s: rates(s, force), x))
        x = step(x, force, h)
        p = a @ p @ a.T + q
        c = slope(lambda s: measured(s, force), x)
        off = y - measured(x, force)
        s = c @ p @ c.T + r
        k = np.linalg.solve(s, c @ p).T
        x = x + k @ off
        p = p - k @ c @ p
    print(f"inline constexpr double forces[]{braces([forces])[1:-1]};")
    print(f"inline constexpr double seen[][3]{braces(seen)};")
    print(f"inline constexpr double filtered_state[]{braces([x])[1:-1]};")
    print(f"inline constexpr double filtered_covariance[4][4]{braces(p)};")
    print(f"inline constexpr double last_innovation[]{braces([off])[1:-1]};")
    print(f"inline constexpr double last_innovation_covariance[3][3]{braces(s)};")


def bicycle():
    """The benchmark of Meijaard, Papadopoulos, Ruina & Schwab with a torque between frame and fork."""
    with open(Path(__file__).parent / "../oracles/bicycle_canonical.json") as file:
        known = json.load(file)
    mass, damping, k0, k2 = (np.array(known[name]) for name in ("M", "C1", "K0", "K2"))
    inverse = np.linalg.inv(mass)
    for v in (2, 4, 6):
        a = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ (9.81 * k0 + v * v * k2), -v * inverse @ damping]])
        b = np.concatenate([np.zeros(2), inverse[:, 1]]).reshape(4, 1)
        q, r = np.diag([10.0, 1, 1, 0.1]), np.array([[0.01]])
        x = refined(a, b, q, r, solve_continuous_are(a, b, q, r), True)
        print(f"inline constexpr double gain_at_{v}[]{braces(b.T @ x / r)[1:-1]};")


def main():
    print(f"// Written by references.py, with NumPy {np.__version__}, SciPy {scipy.__version__} and mpmath "
          f"{mpmath.__version__}.")
    print("""#pragma once

namespace references {

/// A, B, c of ẋ = A x + B r + c and the step, then those of the discrete form.
template <int n, int m>
struct discrete {
  double a[n][n], b[n][m], c[n][1], h, ad[n][n], bd[n][m], cd[n][1];
};

/// A, B, Q, R and the stabilizing solution X.
template <int n, int m>
struct riccati {
  double a[n][n], b[n][m], q[n][n], r[m][m], x[n][n];
};

// clang-format off
""")
    random = np.random.default_rng(13)
    normal = random.standard_normal

    print("namespace discrete_forms {\n")
    discrete("of_random", normal((5, 5)), normal((5, 2)), normal(5), 0.3)
    discrete("of_a_long_step", normal((4, 4)), normal((4, 1)), normal(4), 6.0)
    discrete("of_a_double_integrator", [[0, 1], [0, 0]], [[0], [1]], [0, -9.81], 0.01)
    discrete("of_a_stiff_system", [[-1e4, 1e4, 0], [1, -2, 1], [0, 0, -1e-3]], [[0], [0], [1]], [1, 2, 3], 0.5)
    discrete("of_an_oscillation", [[0, 1], [-1e4, -0.1]], [[0], [1]], [0, 1], 1.0)
    units = np.diag([1e6, 1e-6, 1e3, 1])
    a, b = normal((4, 4)), normal((4, 2))
    discrete("in_units", units @ a @ np.linalg.inv(units), units @ b, units @ normal(4), 0.1)
    discrete("of_a_short_step", normal((3, 3)), normal((3, 1)), normal(3), 1e-9)
    print("\n} // namespace discrete_forms\n")

    for continuous in (True, False):
        kind = "continuous" if continuous else "discrete_time"
        print(f"namespace {kind} {{\n")
        shift = 0 if continuous else 1
        for n, m in ((1, 1), (2, 1), (3, 2), (4, 1), (6, 3), (8, 2)):
            a, b, q, r = normal((n, n)), normal((n, m)), normal((n, n)), normal((m, m))
            riccati(f"random_{n}", a, b, q @ q.T, r @ r.T + np.eye(m), continuous)
        a, b, q, r = normal((4, 4)), normal((4, 2)), np.eye(4), np.eye(2)
        for name, states, inputs in (("large_units", [1e6, 1e-6, 1, 1e3], [1e6, 1e-6]),
                                     ("small_units", [1e-6, 1e-6, 1e-6, 1e-6], [1e3, 1e3])):
            scaled = in_units(a, b, q, r, states, inputs)
            x = solve_continuous_are(a, b, q, r) if continuous else solve_discrete_are(a, b, q, r)
            riccati(name, *scaled, continuous, np.diag(states) @ x @ np.diag(states))
        # An input that barely affects a growing motion.
        grows = [[0.5, 0.3], [0.0, 0.25]] if continuous else [[1.5, 0.3], [0.0, 1.25]]
        riccati("nearly_unstabilizable", grows, [[1], [1e-4]], np.eye(2), [[1]], continuous)
        # Weights that omit a growing and a decaying motion.
        riccati("unweighted", np.diag([0.7, -0.4, 0.2]) if continuous else np.diag([1.7, 0.4, -1.2]),
                [[1], [2], [1]], np.zeros((3, 3)), [[2]], continuous,
                start=solve_continuous_are(np.diag([0.7, -0.4, 0.2]), [[1], [2], [1]], 1e-8 * np.eye(3), [[2]])
                if continuous else
                solve_discrete_are(np.diag([1.7, 0.4, -1.2]), [[1], [2], [1]], 1e-8 * np.eye(3), [[2]]))
        # Motions that barely decay, with small weights: the closed loop is close to the axis, or to the circle.
        turn = np.array([[0, 1], [-1, 0]]) if continuous else np.array([[np.cos(1), np.sin(1)], [-np.sin(1), np.cos(1)]])
        for digits in (3, 5):
            small = 10.0**-digits
            riccati(f"close_to_the_axis_{digits}", turn, [[0], [1]], small**2 * np.eye(2), [[1]], continuous)
        # Fast and slow motions together.
        fast = np.diag([-1e5, -1.0, 1e-3]) if continuous else np.diag([1e-5, 0.5, 1.001])
        riccati("stiff", fast + np.array([[0, 1, 0], [0, 0, 1], [0, 0, 0]]), [[0], [0], [1]], np.eye(3), [[1]], continuous)
        # A chain of integrators, without any numbers.
        chain = np.eye(5, k=1) + shift * np.eye(5)
        riccati("integrators", chain, np.eye(5)[:, 4:], np.eye(5), [[0.1]], continuous)
        print(f"\n}} // namespace {kind}\n")

    print("namespace cart {\n")
    filtered()
    print("\n} // namespace cart\n")

    print("namespace bicycle {\n")
    bicycle()
    print("\n} // namespace bicycle\n")

    print("// The bounds within which the sum of squares of this many normally distributed numbers lies in 99.9 % of all cases.")
    for count in (200, 400):
        print(f"inline constexpr double chi_squared_{count}[]{{{float(chi2.ppf(0.0005, count))!r}, "
              f"{float(chi2.ppf(0.9995, count))!r}}};")
    print("\n// clang-format on\n\n} // namespace references")


main()
