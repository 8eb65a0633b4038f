"""Calls the libraries written for CasADi as CasADi calls them, but without it: casadi_test.py FOLDER."""

import ctypes
import math
import random
import sys

REAL = ctypes.POINTER(ctypes.c_double)
INTEGER = ctypes.c_longlong


class Function:
    def __init__(self, library, name):
        self.library, self.name = library, name
        self.call = getattr(library, name)
        self.call.argtypes = [ctypes.POINTER(REAL), ctypes.POINTER(REAL), ctypes.c_void_p, REAL, ctypes.c_int]

        def described(what, result, *types):
            function = getattr(library, f"{name}_{what}")
            function.restype, function.argtypes = result, types
            return function

        self.names, self.shapes = [], []
        for way in ("in", "out"):
            count = described(f"n_{way}", INTEGER)()
            names = described(f"name_{way}", ctypes.c_char_p, INTEGER)
            shapes = described(f"sparsity_{way}", ctypes.POINTER(INTEGER), INTEGER)
            assert names(count) is None and not shapes(count) and names(-1) is None
            self.names.append([names(i).decode() for i in range(count)])
            self.shapes.append([self.shape(shapes(i)) for i in range(count)])
            assert len(set(self.names[-1])) == count
        sizes = [INTEGER() for _ in range(4)]
        work = described("work", ctypes.c_int, *[ctypes.POINTER(INTEGER)] * 4)
        assert work(*map(ctypes.byref, sizes)) == 0 and work(None, None, None, None) == 0
        assert [s.value for s in sizes[:2]] == [len(s) for s in self.shapes] and sizes[2].value == 0
        self.work = sizes[3].value

    @staticmethod
    def shape(numbers):
        """Rows, columns, and the positions of the entries."""
        rows, columns = numbers[0], numbers[1]
        if numbers[2] == 1:
            return rows, columns, [(i, j) for j in range(columns) for i in range(rows)]
        begins = numbers[2 : 3 + columns]
        assert begins[0] == 0 and list(begins) == sorted(begins)
        places = [(numbers[3 + columns + k], j) for j in range(columns) for k in range(begins[j], begins[j + 1])]
        assert all(0 <= i < rows for i, _ in places) and len(set(places)) == len(places)
        assert places == sorted(places, key=lambda place: place[::-1])
        return rows, columns, places

    def raw(self, given, wanted=None):
        """The status, and the entries of the results; None is a null pointer."""
        beyond = 1e99  # behind each array, to stay there
        arrays = [None if g is None else (ctypes.c_double * (len(g) + 1))(*g, beyond) for g in given]
        results = [(ctypes.c_double * (len(places) + 1))(*[math.nan] * len(places), beyond)
                   if wanted is None or k in wanted else None for k, (_, _, places) in enumerate(self.shapes[1])]
        work = (ctypes.c_double * (self.work + 1))(*[0.0] * self.work, beyond)
        status = self.call((REAL * len(arrays))(*[ctypes.cast(a, REAL) for a in arrays]),
                           (REAL * len(results))(*[ctypes.cast(a, REAL) for a in results]), None, work, 0)
        assert all(a is None or a[len(a) - 1] == beyond for a in [*arrays, *results, work])
        return status, [None if r is None else list(r)[:-1] for r in results]

    def dense(self, given):
        status, results = self.raw(given)
        assert status == 0
        all_of_them = []
        for (rows, columns, places), entries in zip(self.shapes[1], results):
            matrix = [[0.0] * columns for _ in range(rows)]
            for (i, j), value in zip(places, entries):
                matrix[i][j] = value
            all_of_them.append(matrix)
        return all_of_them


def flat(matrix):
    return [row[0] for row in matrix]


def slope(f, at, k, j):
    """The derivatives of f with respect to entry j of argument k, by Richardson extrapolation of central differences."""
    def difference(h):
        ends = []
        for step in (h, -h):
            moved = [list(a) for a in at]
            moved[k][j] += step
            ends.append(f(moved))
        return [(a - b) / (2 * h) for a, b in zip(*ends)]

    return [(64 * a - 20 * b + c) / 45 for a, b, c in zip(*map(difference, (4e-4, 8e-4, 16e-4)))]


def near(found, expected, tolerance=1e-8):
    scale = max([1.0, *map(abs, expected)])
    assert len(found) == len(expected)
    assert all(abs(a - b) <= tolerance * scale for a, b in zip(found, expected)), (found, expected)


def functions(library, name):
    """A function, and its derivatives in the order of `check`."""
    return [Function(library, before + name) for before in ("", "jac_", "fwd1_", "jac_fwd1_", "adj1_", "jac_adj1_")]


def check(library, name, arguments, result, tolerance=1e-8):
    """Compares the derivatives of a function with differences of those of lower order."""
    f, jacobian, forward, of_forward, adjoint, of_adjoint = functions(library, name)
    assert f.names[0] == arguments and f.names[1] == [result]
    n = len(arguments)
    at = [[random.uniform(0.5, 1.5) * (0.1 if called == "h" else 1) for _ in range(rows)]
          for called, (rows, _, _) in zip(f.names[0], f.shapes[0])]
    size = f.shapes[1][0][0]
    rate, weights = [0.0] * size, [random.uniform(-1, 1) for _ in range(size)]
    direction = [[random.uniform(-1, 1) for _ in a] for a in at]
    first = jacobian.dense([*at, rate])
    for k in range(n):
        for j in range(len(at[k])):
            near([row[j] for row in first[k]], slope(lambda a: flat(f.dense(a)[0]), at, k, j), tolerance)
    along = flat(forward.dense([*at, rate, *direction])[0])
    near(along, [sum(first[k][i][j] * v for k in range(n) for j, v in enumerate(direction[k])) for i in range(size)],
         1e-13)
    adjoints = [flat(a) for a in adjoint.dense([*at, rate, weights])]
    for k in range(n):
        near(adjoints[k], [sum(first[k][i][j] * weights[i] for i in range(size)) for j in range(len(at[k]))], 1e-13)

    second = of_adjoint.dense([*at, rate, weights, *adjoints])
    for o in range(n):
        for k in range(n):
            block = second[o * (n + 2) + k]
            assert block == [list(row) for row in zip(*second[k * (n + 2) + o])] or not block or not block[0], "symmetric"
            for j in range(len(at[k])):
                near([row[j] for row in block],
                     slope(lambda a, o=o: flat(adjoint.dense([*a, rate, weights])[o]), at, k, j), tolerance)
        assert second[o * (n + 2) + n] == [[0.0] * size for _ in at[o]], "adjoints do not depend on the rates"
        assert second[o * (n + 2) + n + 1] == [list(row) for row in zip(*first[o])], "transposed"
    changes = of_forward.dense([*at, rate, *direction, along])
    for k in range(n):
        for j in range(len(at[k])):
            near([row[j] for row in changes[k]],
                 slope(lambda a: flat(forward.dense([*a, rate, *direction])[0]), at, k, j), tolerance)
        assert changes[n + 1 + k] == first[k]

    # Null arguments are zero, and null results are not requested.
    states = {0: [0.0] * len(at[0])}
    assert str(f.raw([None, *at[1:]])) == str(f.raw([states[0], *at[1:]]))
    for each, given in ((jacobian, [*at, None]), (adjoint, [*at, None, weights]),
                        (of_forward, [*at, None, *direction, None]),
                        (of_adjoint, [*at, None, weights, *[None] * n]), (forward, [*at, None, *direction])):
        everything = each.raw(given)[1]
        assert each.raw(given, wanted=())[0] == 0
        for k in range(len(everything)):
            status, alone = each.raw(given, wanted=(k,))
            assert status == 0
            near(alone[k], everything[k], 1e-13)
    return f


def check_implicit(f, residual):
    """It is linear in the rates, and zero at the rates of the motion."""
    at = [[random.uniform(0.5, 1.5) for _ in range(rows)] for rows, _, _ in residual.shapes[0]]
    rate = flat(f.dense([at[0], *at[2:]])[0])
    found = flat(residual.dense(at)[0])
    by_rates = Function(residual.library, f"jac_{residual.name}").dense([*at, None])[1]
    near(found, [sum(a * (v - w) for a, v, w in zip(row, at[1], rate)) for row in by_rates], 1e-12)


def runge_kutta(rates, x, h, t):
    k = rates(x, t)
    total = list(k)
    for reach, weight in ((0.5, 2), (0.5, 2), (1, 1)):
        k = rates([a + reach * h * b for a, b in zip(x, k)], t + reach * h)
        total = [a + weight * b for a, b in zip(total, k)]
    return [a + h / 6 * b for a, b in zip(x, total)]


def ralston(rates, x, h, t):
    k = rates(x, t)
    total = [2 / 9 * a for a in k]
    for reach, weight in ((1 / 2, 1 / 3), (3 / 4, 4 / 9)):
        k = rates([a + reach * h * b for a, b in zip(x, k)], t + reach * h)
        total = [a + weight * b for a, b in zip(total, k)]
    return [a + h * b for a, b in zip(x, total)]


def semi_implicit_euler(rates, x, h, t):
    """Half of the entries of the state are speeds here."""
    n = len(x) // 2
    x = [*x[:n], *(a + h * b for a, b in zip(x[n:], rates(x, t)[n:]))]
    return [*(a + h * b for a, b in zip(x[:n], rates(x, t))), *x[n:]]


def check_step(f, step, method):
    x, r, p, [h], *t = ([random.uniform(0.5, 1.5) for _ in range(rows)] for rows, _, _ in step.shapes[0])
    h /= 10
    expected = method(lambda y, now: flat(f.dense([y, r, p, *([[now]] if t else [])])[0]), x, h, t[0][0] if t else 0)
    near(flat(step.dense([x, r, p, [h], *t])[0]), expected, 1e-14)


def check_failures(library, name):
    """Of a pendulum whose mass matrix is a number, all results of which depend on the angle: no sine is known beyond
    131072 rad."""
    for f in (each for end in ("", "_implicit", "_step") for each in functions(library, name + end)):
        for angle, is_known in ((131071, True), (131073, False), (-131073, False), (math.inf, False), (math.nan, False)):
            given = [[0.5] * rows for rows, _, _ in f.shapes[0]]
            given[0][0] = angle
            status, results = f.raw(given)
            assert status == (0 if is_known else 1), (f.name, angle)
            assert is_known == all(math.isfinite(entry) for each in results for entry in each)
            assert f.raw(given, wanted=())[0] == 0, "where nothing is wanted, nothing fails"


def check_all(name, *more, method=runge_kutta, tolerance=1e-8):
    library = ctypes.CDLL(f"{sys.argv[1]}/{name}.so")
    f = check(library, name, ["x", "r", "p", *more], "rate", tolerance)
    check_implicit(f, check(library, f"{name}_implicit", ["x", "xdot", "r", "p", *more], "residual", tolerance))
    if method is None:
        return f
    check_step(f, check(library, f"{name}_step", ["x", "r", "p", "h", *more], "next", tolerance), method)
    return f


random.seed(4)
check_all("cart")
check_all("disc", method=semi_implicit_euler)
check_all("a")
check_all("motor_arm")
check_all("loaded_arm", tolerance=1e-6)  # differences across its stops and its friction are less accurate
check_all("cornering_car")
check_all("elbow", method=None)
driven = check_all("driven", "t")
pendulum = check_all("bound_pendulum", method=ralston)
status, [rate] = pendulum.raw([[0.3, 0.0], [0.0], [0.5, 0.1]])
assert status == 0
near(rate, [0.0, -9.81 / 0.5 * math.sin(0.3)], 1e-14)
assert pendulum.raw([[0.3, 0.0], [0.0], None])[0] != 0, "without a length there are no rates"
check_failures(driven.library, "driven")
check_all("wheel", method=None)
