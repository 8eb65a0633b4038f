#!/usr/bin/env python3
"""Simulates the bicycle with kanexpr and with SciPy, whose right-hand side SymPy derives and lambdifies: the same model,
start, tolerances and time span. Prints how long both take and how far apart they end.

with_scipy.py PROGRAM: PROGRAM is built from in_lines.cpp. Without SciPy and SymPy it says so and is done.

SciPy takes the explicit methods that suit the motion, each with the functions that lambdify takes by itself,
NumPy's, and with those of Python's math, which are faster for single numbers. Common subexpressions are shared;
derivation and lambdification come off the clock.
"""

import importlib.util
import os
import subprocess
import sys
import time

RTOL, ATOL = 1e-8, 1e-10
METHODS = ["RK45", "DOP853", "LSODA"]
FUNCTIONS = ["numpy", "math"]
TURNS = 3  # of which the fastest counts, as with kanexpr
APART = 1000  # tolerances of one step, of which there are hundreds, that the ends may be apart


def with_kanexpr(program):
    """Milliseconds, evaluations, and by names the parameters and the states at both ends."""
    found = {"parameter": {}, "start": {}, "end": {}}
    told = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in told.splitlines():
        what, *words = line.split("\t")
        if len(words) == 2:
            found[what][words[0]] = float(words[1])
        else:
            found[what] = float(words[0])
    return found


def derive(names):
    """The bicycle by Kane's method in SymPy, with the states in the order that is named."""
    os.environ["SYMPY_CACHE_SIZE"] = "None"
    sys.dont_write_bytecode = True
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "linearization"))
    from models_in_sympy import bicycle

    kane = bicycle()
    assert [s.func.__name__ for s in (*kane.q, *kane.u)] == names
    return kane


def right_hand_side(kane, parameters, functions):
    """f(t, y): M u' = f solved in numbers, after q'."""
    import numpy
    from sympy import Symbol, lambdify

    qdot = [kane.kindiffdict()[q.diff()] for q in kane.q]
    evaluate = lambdify([[*kane.q, *kane.u], [Symbol(name) for name in parameters]],
                        [*kane.mass_matrix, *kane.forcing, *qdot], modules=functions, cse=True)
    p, n = list(parameters.values()), len(kane.u)

    def rates(t, y):
        values = numpy.array(evaluate(y.tolist(), p))
        M, f, qdot = values[:n * n].reshape(n, n), values[n * n:n * n + n], values[n * n + n:]
        return numpy.concatenate((qdot, numpy.linalg.solve(M, f)))

    return rates


def apart(ours, theirs):
    """The largest of the differences, in tolerances of one step."""
    return max(abs(a - b) / (ATOL + RTOL * abs(b)) for a, b in zip(ours, theirs))


def compare(ours, rates, method, functions):
    """Prints one line of the table; the ratio, and whether the ends are the same."""
    from scipy.integrate import solve_ivp

    seconds = []
    for _ in range(TURNS):
        start = time.perf_counter()
        found = solve_ivp(rates, (0, ours["time"]), list(ours["start"].values()), method=method, rtol=RTOL, atol=ATOL)
        seconds.append(time.perf_counter() - start)
    milliseconds = 1000 * min(seconds)
    ratio = milliseconds / ours["milliseconds"]
    difference = apart(ours["end"].values(), found.y[:, -1])
    print(f"SciPy {method}, {functions}\t{found.nfev}\t{milliseconds:.0f}\t{ratio:.0f}\t{difference:.1f}", flush=True)
    return ratio, found.success and difference <= APART


def main():
    for package in ("sympy", "scipy"):
        if importlib.util.find_spec(package) is None:
            print(f"Python has no {package} here: nothing to compare with")
            return 0
    ours = with_kanexpr(sys.argv[1])
    kane = derive(list(ours["start"]))
    print("bicycle for 10 s\tevaluations\tms\tratio\tapart, in tolerances")
    print(f"kanexpr\t{ours['evaluations']:.0f}\t{ours['milliseconds']:.2f}", flush=True)
    agree = True
    for functions in FUNCTIONS:
        rates = right_hand_side(kane, ours["parameter"], functions)
        ratios, same = zip(*(compare(ours, rates, method, functions) for method in METHODS))
        print(f"at least {min(ratios):.0f} times faster than with functions of {functions}")
        agree = agree and all(same)
    if not agree:
        print(f"the ends are more than {APART} tolerances apart", file=sys.stderr)
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())
