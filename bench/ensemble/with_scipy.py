#!/usr/bin/env python3
"""Simulates double pendulums with kanexpr on two threads and with SciPy in two processes: the same starts, tolerances and
time span, right-hand sides derived and lambdified by SymPy. Prints how many runs a second each makes.

with_scipy.py PROGRAM [RUNS [RUNS_OF_SCIPY]]: PROGRAM is built from beside_scipy.cpp. The two take turns.
"""

import multiprocessing
import os
import statistics
import subprocess
import sys
import time

SPAN, RTOL, ATOL = 10, 1e-6, 1e-8
METHODS = ["DOP853", "LSODA"]
INTEGRATORS = ["Adams", "Dormand & Prince"]
TURNS = 3
CHECKED, CHECKED_SPAN, APART = 20, 1, 1e-4  # runs whose states after a second are compared, and how far they may differ


def derive():
    """Rates of y = (q1, q2, u1, u2), from Lagrange's equations with the absolute rates of turning as speeds."""
    from sympy import Function, Matrix, Rational, cos, lambdify, sin, symbols

    t, a, b, v, w = symbols("t a b v w")
    gravity, l = 9.81, 1
    first, second = Function("first")(t), Function("second")(t)  # absolute angles
    inertia = Rational(1, 12)

    def square(x, y):
        return x.diff(t)**2 + y.diff(t)**2

    x1, y1 = cos(first) / 2, sin(first) / 2
    x2, y2 = l * cos(first) + cos(second) / 2, l * sin(first) + sin(second) / 2
    kinetic = (square(x1, y1) + square(x2, y2) + inertia * (first.diff(t)**2 + second.diff(t)**2)) / 2
    potential = gravity * (y1 + y2)
    angles, numbers = [first, second], [a, b]
    rates = [angle.diff(t) for angle in angles]
    left = [(kinetic - potential).diff(rate).diff(t) - (kinetic - potential).diff(angle) for angle, rate in zip(angles, rates)]
    accelerations = Matrix([angle.diff(t, 2) for angle in angles])
    mass = Matrix([[each.expand().coeff(other) for other in accelerations] for each in left])
    rest = Matrix([each.expand().subs([(other, 0) for other in accelerations]) for each in left])
    names = list(zip(rates, [v, w])) + list(zip(angles, numbers))
    mass, rest = mass.subs(names), rest.subs(names)
    return lambdify([a, b, v, w], list(mass.LUsolve(-rest)), modules="numpy", cse=True)


def rates_by(accelerations):
    """f(t, y) of y = (q1, q2, u1, u2)."""
    import numpy

    def rates(t, y):
        q1, q2, u1, u2 = y
        return numpy.array((u1, u2 - u1, *accelerations(q1, q1 + q2, u1, u2)))

    return rates


def begin():
    global RATES
    RATES = rates_by(derive())


def simulate(work):
    from scipy.integrate import solve_ivp

    start, span, method = work
    found = solve_ivp(RATES, (0, span), (*start, 0, 0), method=method, rtol=RTOL, atol=ATOL)
    assert found.success, found.message
    return found.y[:2, -1]


def with_kanexpr(program, runs):
    """Runs a second on two threads by each integrator, and of the first runs the start and the angles after a second."""
    told = subprocess.run([program, str(runs)], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    rates, *rows = [[float(word) for word in line.split()] for line in told]
    return rates, rows


def main():
    program = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    runs_of_scipy = int(sys.argv[3]) if len(sys.argv) > 3 else 40
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[name] = "1"
    print(f"load of the machine before\t{os.getloadavg()[0]:.1f}")
    ours, theirs = {name: [] for name in INTEGRATORS}, {method: [] for method in METHODS}
    with multiprocessing.Pool(2, begin) as pool:
        _, rows = with_kanexpr(program, runs)
        starts = [(q1, q2) for q1, q2, *_ in rows]
        found = pool.map(simulate, [(start, CHECKED_SPAN, "DOP853") for start in starts[:CHECKED]])
        apart = max(abs(a - b) for row, end in zip(rows, found) for a, b in zip(row[2:], end))
        for _ in range(TURNS):
            for rates, rate in zip(ours.values(), with_kanexpr(program, runs)[0]):
                rates.append(rate)
            for method in METHODS:
                work = [(starts[i % len(starts)], SPAN, method) for i in range(runs_of_scipy)]
                start = time.perf_counter()
                pool.map(simulate, work, chunksize=1)
                theirs[method].append(runs_of_scipy / (time.perf_counter() - start))
    print(f"{CHECKED} pendulums after {CHECKED_SPAN} s\t{apart:.1g} rad apart at most")
    def told(rates):
        return f"{statistics.median(rates):.1f} runs/s\t({min(rates):.1f} to {max(rates):.1f})"

    for name, rates in ours.items():
        print(f"kanexpr, {name}, two threads\t{told(rates)}")
    for method, rates in theirs.items():
        slower = [statistics.median(a / b for a, b in zip(each, rates)) for each in ours.values()]
        print(f"SciPy {method}, two processes\t{told(rates)}\t" + " and ".join(f"{ratio:.0f}" for ratio in slower) + " times slower")
    return 0 if apart < APART else 1


if __name__ == "__main__":
    sys.exit(main())
