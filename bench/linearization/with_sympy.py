#!/usr/bin/env python3
"""Derives and linearizes the same systems with kanexpr and with SymPy, about points that give everything a number,
checks that A and B are the same, and prints how long both take.

with_sympy.py PROGRAM [SECONDS]: PROGRAM is built from in_lines.cpp; a system that takes SymPy more than SECONDS (300) is
given up. Without SymPy it says so and is done.

SymPy is set up to be as fast as its public interface lets it: its cache has no limit, and the linear solver
that is handed to its linearization puts the numbers in before it solves.
"""

import importlib.util
import json
import math
import os
import subprocess
import sys
import time

SYSTEMS = ["bicycle", "cart", "arm"]
TOLERANCE = 1e-9  # of A and B, beside their largest entries


def with_kanexpr(program, system):
    """Milliseconds, the operating point by names, A and B."""
    found = {"point": {}, "A": [], "B": []}
    told = subprocess.run([program, system], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in told.splitlines():
        what, *words = line.split("\t")
        if what == "point":
            found["point"][words[0]] = float(words[1])
        elif what in ("A", "B"):
            found[what].append([float(w) for w in words])
        else:
            found["milliseconds"] = float(words[0])
    return found


def with_sympy(system, point, limit):
    """Seconds, A and B, from a process of its own; None: it took more time than it has."""
    try:
        child = subprocess.run([sys.executable, __file__, "--derive", system], input=json.dumps(point),
                               stdout=subprocess.PIPE, check=True, text=True, timeout=limit,
                               env={**os.environ, "SYMPY_CACHE_SIZE": "None", "PYTHONDONTWRITEBYTECODE": "1"})
    except subprocess.TimeoutExpired:
        return None
    return json.loads(child.stdout)


def solve(A, b):
    """A x = b in numbers, with pivots: SymPy's own elimination takes the first that is not zero."""
    import mpmath
    from sympy import Matrix

    factors = mpmath.matrix(A.tolist())
    columns = [list(mpmath.lu_solve(factors, mpmath.matrix(b[:, j].tolist()))) for j in range(b.cols)]
    return Matrix(b.rows, b.cols, lambda i, j: columns[int(j)][int(i)])


def derive(system, named):
    """What `with_sympy` returns. The rates at the point, which SymPy must be told, come off the clock."""
    from models_in_sympy import MODELS
    from sympy import Symbol
    from sympy.physics.mechanics import dynamicsymbols, msubs

    start = time.perf_counter()
    kane = MODELS[system]()
    seconds = time.perf_counter() - start

    point = {symbol(name): value for name, value in named.items() for symbol in (Symbol, dynamicsymbols)}
    rates = solve(msubs(kane.mass_matrix, point), msubs(kane.forcing, point))
    point.update(zip(kane.u.diff(dynamicsymbols._t), rates))

    start = time.perf_counter()
    A, B, _ = kane.linearize(A_and_B=True, op_point=point,
                             linear_solver=lambda A, b: solve(msubs(A, point), msubs(b, point)))
    seconds += time.perf_counter() - start
    numbers = {name: [[float(e) for e in row] for row in m.tolist()] for name, m in (("A", A), ("B", B))}
    return {"seconds": seconds, **numbers}


def difference(ours, theirs):
    """The largest of the entries' differences, beside the largest entry."""
    if [len(row) for row in ours] != [len(row) for row in theirs]:
        return math.inf
    pairs = [pair for rows in zip(ours, theirs) for pair in zip(*rows)]
    if not all(math.isfinite(a) and math.isfinite(b) for a, b in pairs):
        return math.inf
    return max(abs(a - b) for a, b in pairs) / max(abs(b) for _, b in pairs)


def compare(program, system, limit):
    """Prints one line of the table; false: the results are not the same."""
    ours = with_kanexpr(program, system)
    theirs = with_sympy(system, ours["point"], limit)
    milliseconds = ours["milliseconds"]
    if theirs is None:
        print(f"{system}\t{milliseconds:.2f}\t>{limit:.0f}\t>{1000 * limit / milliseconds:.0f}", flush=True)
        return True
    seconds = theirs["seconds"]
    apart = max(difference(ours[m], theirs[m]) for m in ("A", "B") if ours[m][0])
    ratio = 1000 * seconds / milliseconds
    print(f"{system}\t{milliseconds:.2f}\t{seconds:.1f}\t{ratio:.0f}\t{apart:.0e}", flush=True)
    return apart <= TOLERANCE


def main():
    if importlib.util.find_spec("sympy") is None:
        print("Python has no SymPy here: nothing to compare with")
        return 0
    program, limit = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 300
    print("derivation and linearization beside SymPy's, which takes minutes", flush=True)
    print("system\tkanexpr ms\tSymPy s\tratio\tdifference", flush=True)
    agree = [compare(program, system, limit) for system in SYSTEMS]
    if not all(agree):
        print(f"A or B differ by more than {TOLERANCE:g}", file=sys.stderr)
    return 0 if all(agree) else 1


if __name__ == "__main__":
    if sys.argv[1:2] == ["--derive"]:
        json.dump(derive(sys.argv[2], json.load(sys.stdin)), sys.stdout)
    else:
        sys.exit(main())
