#!/usr/bin/env python3
"""Derives M and f by SymPy's Kane's method and writes them as C and as Python, once for each result:
sympy_sources.py MODEL DIRECTORY. Whoever starts it limits its time.

M u̇ = f is solved by elimination in C and by NumPy in Python; so are the derivatives, by those of f − M u̇ at given u̇.
"""

import inspect
import sys
from pathlib import Path

from model import read_model
from sympy import Matrix, Rational, Symbol, cse, lambdify, symbols
from sympy.codegen.rewriting import create_expand_pow_optimization
from sympy.physics.mechanics import (KanesMethod, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia, msubs)
from sympy.printing.c import ccode

SOLVER = Path(__file__).resolve().parent / "solve.h"


def exact(value):
    return Rational(repr(value))


def vector(frame, numbers):
    return sum((exact(n) * e for n, e in zip(numbers, (frame.x, frame.y, frame.z))), 0 * frame.x)


def tree(model):
    """Of links that turn, with velocities and accelerations along each link's own axes."""
    n = len(model.links)
    q, u, torque = dynamicsymbols(f"q:{n}"), dynamicsymbols(f"u:{n}"), symbols(f"r:{n}")
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    O.set_acc(N, 0)
    frames, joints, bodies, loads = [], [], [], []
    for i, link in enumerate(model.links):
        below, at = (frames[link.parent], joints[link.parent]) if link.parent >= 0 else (N, O)
        home = ReferenceFrame(f"H{i}")
        home.orient_explicit(below, Matrix(3, 3, lambda j, k: exact(link.home[j][k])))
        axis = (home.x, home.y, home.z)[link.axis]
        frame = home.orientnew(f"F{i}", "Axis", [q[i], axis])
        own = (frame.x, frame.y, frame.z)[link.axis]
        frame.set_ang_vel(N, below.ang_vel_in(N).express(frame) + u[i] * own)
        joint = at.locatenew(f"J{i}", vector(below, link.joint))
        centre = joint.locatenew(f"C{i}", vector(frame, link.centre))
        for point, start, carried, axes in ((joint, at, below, frame), (centre, joint, frame, frame)):
            point.v2pt_theory(start, N, carried)
            point.set_vel(N, point.vel(N).express(axes))
            point.a2pt_theory(start, N, carried)
        (xx, xy, zx), (_, yy, yz), (_, _, zz) = ([exact(e) for e in row] for row in link.inertia)
        bodies.append(RigidBody(f"B{i}", centre, frame, exact(link.mass),
                                (inertia(frame, xx, yy, zz, xy, yz, zx), centre)))
        loads.append((centre, exact(link.mass) * vector(N, model.gravity)))
        if model.inputs:
            loads.append((frame, torque[i] * own))
            if link.parent >= 0:
                loads.append((below, -torque[i] * own))
        frames.append(frame)
        joints.append(joint)
    kane = KanesMethod(N, q_ind=q, u_ind=u, kd_eqs=[c.diff() - s for c, s in zip(q, u)])
    kane.kanes_equations(bodies, loads)
    return kane.mass_matrix, kane.forcing, q, u, torque[:model.inputs]


def bicycle(model):
    """Of all speeds, with the rates of the constraints below the equations of the independent ones."""
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "linearization"))
    from models_in_sympy import bicycle as derived

    kane = derived()
    values = {Symbol(name): value for name, value in model.values.items()}
    return msubs(kane.mass_matrix, values), msubs(kane.forcing, values), list(kane.q), list(kane.u), []


def body(entries, arguments, into):
    """Lines of C."""
    squares = create_expand_pow_optimization(8)
    shared, reduced = cse(entries, symbols=(Symbol(f"t{i}") for i in range(1_000_000)))
    lines = [f"const double {name} = {ccode(squares(e))};" for name, e in shared]
    lines += [f"{into}[{i}] = {ccode(squares(e))};" for i, e in enumerate(reduced)]
    return "".join(f"  {line}\n" for line in lines)


class Writer:
    def __init__(self, folder, x):
        self.folder = folder
        self.names = {symbol: Symbol(f"x{i}") for i, symbol in enumerate(x)}
        self.arguments = list(self.names.values())
        self.open = "".join(f"  const double x{i} = x[{i}]; (void)x{i};\n" for i in range(len(x)))

    def named(self, matrix):
        return [msubs(e, self.names) for e in matrix]

    def write(self, result, text, functions):
        """`functions` are those of Python, by name: entries and arguments."""
        (self.folder / f"{result}.c").write_text(
            f'#include "{SOLVER}"\n\n#include <math.h>\n\nvoid {result}(const double* x, double* result) {{\n'
            f"{self.open}{text}}}\n")
        source = ["from math import cos, sin, sqrt, tan\n"]
        for name, (entries, arguments) in functions.items():
            text = inspect.getsource(lambdify([arguments], entries, modules="math", cse=True))
            source.append(text.replace("_lambdifygenerated", name))
        (self.folder / f"{result}.py").write_text("\n".join(source))


def write(model, folder):
    M, f, q, u, r = tree(model) if model.is_tree else bicycle(model)
    n = len(u)
    writer = Writer(folder, [*q, *u, *r])
    entries = writer.named([*M, *f])
    both = body(entries, writer.arguments, "result")
    writer.write("mass_matrix_and_forcing", both, {"both": (entries, writer.arguments)})
    solve_rates = (f"  double both[{n * n + n}];\n" + both.replace("result[", "both[") +
                   f"  solve(both, both + {n * n}, {n}, 1);\n")
    writer.write("udot", solve_rates + f"  for (int i = 0; i < {n}; ++i) result[i] = both[{n * n} + i];\n",
                 {"both": (entries, writer.arguments)})
    if not model.is_tree:
        return
    rates = [Symbol(f"a{i}") for i in range(n)]
    change = writer.named((f - M * Matrix(rates)).jacobian([*q, *u, *r]).T)  # column by column
    columns = len(writer.arguments)
    text = solve_rates + "".join(f"  const double a{i} = both[{n * n + i}];\n" for i in range(n))
    text = (f"  double kept[{n * n}];\n" + text + "  {\n" + body(change, writer.arguments, "result") + "  }\n")
    # The elimination leaves nothing of M, so it is kept before.
    text = text.replace("  solve(both,", f"  for (int i = 0; i < {n * n}; ++i) kept[i] = both[i];\n  solve(both,")
    writer.write("udot_derivatives", text + f"  solve(kept, result, {n}, {columns});\n",
                 {"both": (entries, writer.arguments), "change": (change, [*writer.arguments, *rates])})


if __name__ == "__main__":
    write(read_model(Path(sys.argv[1])), Path(sys.argv[2]))
