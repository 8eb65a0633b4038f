"""How far the results of a peer are from those of kanexpr, in the same coordinates and speeds.

Results stand column by column: M, then f (of a bicycle M of the independent speeds, f, and the bias of the dependent rates);
u̇; the derivatives of u̇ by q, by u and by the inputs. A link that floats has seven coordinates, the position, e1, e2,
e3, e0, and six speeds along its own axes. The forms are

    kanexpr   these
    tangent   derivatives by the directions of the speeds in place of the coordinates
    ground    the velocity of the link that floats along the axes of the ground
    whole     of a bicycle M, row by row, and f of all speeds
"""

import math


def times(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def rotation(x):
    """Of the link that floats, from its axes to those of the ground."""
    e1, e2, e3, e0 = x[3:7]
    return [[1 - 2 * (e2 * e2 + e3 * e3), 2 * (e1 * e2 - e0 * e3), 2 * (e3 * e1 + e0 * e2)],
            [2 * (e1 * e2 + e0 * e3), 1 - 2 * (e3 * e3 + e1 * e1), 2 * (e2 * e3 - e0 * e1)],
            [2 * (e3 * e1 - e0 * e2), 2 * (e2 * e3 + e0 * e1), 1 - 2 * (e1 * e1 + e2 * e2)]]


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def rates_of_speeds(x):
    """q̇ = T u of the link that floats: T, seven rows."""
    e1, e2, e3, e0 = (e / 2 for e in x[3:7])
    turn = [[e0, -e3, e2], [e3, e0, -e1], [-e2, e1, e0], [-e1, -e2, -e3]]
    return [[*row, 0, 0, 0] for row in rotation(x)] + [[0, 0, 0, *row] for row in turn]


def by_tangent(model, x, result):
    """Derivatives by the directions of the speeds."""
    n, T = model.speeds, rates_of_speeds(x)
    by_coordinates = [result[j * n:(j + 1) * n] for j in range(7)]
    turned = [[sum(T[j][k] * by_coordinates[j][i] for j in range(7)) for i in range(n)] for k in range(6)]
    return [e for column in turned for e in column] + result[7 * n:]


def from_ground(x, result, n):
    """What a peer gives along the axes of the ground, as kanexpr gives it. v = Rᵀ v_ground and so
    v̇ = Rᵀ v̇_ground − ω × v."""
    R, spin = rotation(x), cross(x[22:25], x[19:22])

    def turn(vector):  # forces and motions alike
        return [*times(transposed(R), vector[:3]), *vector[3:]]

    if len(result) == n:
        udot = turn(result)
        return [a - b for a, b in zip(udot, spin)] + udot[3:]
    rows = [turn(result[i * n:(i + 1) * n]) for i in range(n)]
    M = transposed([turn(column) for column in transposed(rows)])
    f = turn(result[n * n:])
    return [e for row in M for e in row] + [a - b for a, b in zip(f, times(M, [*spin, *[0] * (n - 3)]))]


def solved(M, f):
    """M x = f, with pivots."""
    rows = [[*row, right] for row, right in zip(M, f)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            ratio = rows[i][k] / rows[k][k]
            rows[i] = [a - ratio * b for a, b in zip(rows[i], rows[k])]
    x = [0.0] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - sum(rows[k][j] * x[j] for j in range(k + 1, n))) / rows[k][k]
    return x


def rates(M_and_f, n):
    return solved([M_and_f[i * n:(i + 1) * n] for i in range(n)], M_and_f[n * n:n * n + n])


def apart(model, result, form, x, ours, theirs):
    """The largest difference beside the largest entry."""
    if form == "whole":  # of a bicycle's M and f of all speeds and of the independent ones the rates agree
        ours, theirs = rates(ours, 3), rates(theirs, 6)[:3]
    if model.floats and result == "udot_derivatives":
        ours = by_tangent(model, x, ours)
        if form != "tangent":
            theirs = by_tangent(model, x, theirs)
    if form == "ground":
        theirs = from_ground(x, theirs, model.speeds)
    if len(ours) != len(theirs) or not all(map(math.isfinite, [*ours, *theirs])):
        return math.inf
    return max(abs(a - b) for a, b in zip(ours, theirs)) / max(map(abs, ours))


def room(model, result):
    """Entries of a result in kanexpr's form; none is larger in another."""
    if not model.is_tree:
        return 64
    n, columns = model.speeds, model.coordinates + model.speeds + model.inputs
    return {"mass_matrix_and_forcing": n * n + n, "udot": n, "udot_derivatives": n * columns}[result]
