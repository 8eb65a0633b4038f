#!/usr/bin/env python3
"""check.py PAGES FOLDER [PAGE...]: runs the blocks of docs/coming-from in other programs and compares them with kanexpr.

PAGES holds the blocks of the pages (tests/docs/snippets), FOLDER a program for each page that evaluates kanexpr's
system at states (evaluate.cpp). The text that the block prints must be that of the page, the accelerations at random
states must agree to TOLERANCE, relative to the largest of them, and the program must have the words of the page's table.
"""

import contextlib
import io
import random
import subprocess
import sys
from pathlib import Path
from typing import Callable, NamedTuple

import words

DOCS = Path(__file__).resolve().parents[2] / "docs/coming-from"
TOLERANCE = 1e-12
STATES = 20


class Page(NamedTuple):
    coordinates: int
    speeds: int
    inputs: int
    accelerations: Callable  # of what the block of the page defines: a function of coordinates, speeds and inputs
    block: str = "theirs"  # of Python
    files: dict = {}  # other blocks, and the files that the program reads
    adjust: Callable = list  # makes coordinates of random numbers between -1.2 and 1.2


def with_speeds(defined):
    return lambda q, u, r: defined["accelerations"](q, u)


def with_inputs(defined):
    return lambda q, u, r: defined["accelerations"](q, u, r)


def by_pydy(defined):
    import numpy
    system = defined["system"]
    return lambda q, u, r: system.evaluate_ode_function(numpy.array([*q, *u]), 0.0, r, system.constants)[2:]


def by_pinocchio(defined):
    import numpy
    return lambda q, u, r: defined["accelerations"](numpy.array(q), numpy.array(u), numpy.array(r))


def by_casadi(defined):
    """Their derivatives by the state follow, row by row."""
    import numpy

    def evaluate(q, u, r):
        rate, by_state = (numpy.array(result) for result in defined["F"]([*q, *u], r))
        return [*rate[2:, 0], *by_state[2:].flatten()]
    return evaluate


def by_mujoco(defined):
    """The scalar part of the quaternion, kanexpr's last, is the first."""
    return lambda q, u, r: defined["accelerations"]([q[3], *q[0:3], q[4]], u, r)


def double_pendulum(defined):
    """In place of MotionGenesis: the same pendulum in SymPy, by Lagrange's method."""
    from numpy.linalg import solve
    from sympy import cos, lambdify
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols
    a, b = dynamicsymbols("a b")
    u, v = dynamicsymbols("a b", 1)
    torque = dynamicsymbols("T")
    la, lb, ma, mb, g = 0.5, 0.4, 2, 1, 9.81
    kinetic = (ma / 3 + mb) * la**2 * u**2 / 2 + mb / 3 * lb**2 * v**2 / 2 + mb * la * lb / 2 * u * v * cos(a - b)
    potential = -g * ((ma / 2 + mb) * la * cos(a) + mb * lb / 2 * cos(b))
    method = LagrangesMethod(kinetic - potential, [a, b])
    method.form_lagranges_equations()
    equations = lambdify([a, b, u, v], [method.mass_matrix, method.forcing])

    def evaluate(q, rates, r):
        mass_matrix, forcing = equations(*q, *rates)
        return solve(mass_matrix, forcing + [[-r[0]], [r[0]]]).flatten()
    return evaluate


def with_length(q):
    """A length of 0.1 to 1.3 m, and an angle."""
    return [q[0] / 2 + 0.7, q[1]]


def with_quaternion(q):
    norm = sum(value * value for value in q[0:4]) ** 0.5
    return [*(value / norm for value in q[0:4]), q[4]]


PAGES = {
    "autolev": Page(3, 3, 0, with_speeds, block="run", files={"theirs.text": "gyroscope.al"}),
    "casadi": Page(2, 2, 1, by_casadi, adjust=with_length),
    "drake": Page(2, 2, 1, with_inputs),
    "motiongenesis": Page(2, 2, 1, double_pendulum, block=""),
    "mujoco": Page(5, 4, 1, by_mujoco, files={"top.xml": "top.xml"}, adjust=with_quaternion),
    "pinocchio": Page(3, 3, 3, by_pinocchio, files={"reacher.xml": "reacher.urdf"}),
    "pydy": Page(2, 2, 1, by_pydy),
    "sympy": Page(3, 3, 0, with_speeds),
}


def run(page, blocks):
    """Runs the block of a page; returns what it defines and what it prints."""
    for block, file in page.files.items():
        Path(file).write_text((blocks / block).read_text())
    defined, printed = {"__name__": "__main__"}, io.StringIO()
    if page.block:
        with contextlib.redirect_stdout(printed):
            exec(compile((blocks / f"{page.block}.python").read_text(), f"{blocks.name}.md", "exec"), defined)
    return defined, printed.getvalue()


def random_states(page, source):
    for _ in range(STATES):
        numbers = [source.uniform(-1.2, 1.2) for _ in range(page.coordinates + page.speeds + page.inputs)]
        end = page.coordinates + page.speeds
        yield page.adjust(numbers[:page.coordinates]), numbers[page.coordinates:end], numbers[end:]


def by_kanexpr(program, states):
    text = "".join(" ".join(f"{value:.17g}" for part in state for value in part) + "\n" for state in states)
    lines = subprocess.run([program], input=text, stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    return [[float(word) for word in line.split()] for line in lines]


def difference(found, expected):
    """The largest difference relative to the largest entry; infinite if the entries are not the same in number."""
    found, expected = [float(value) for value in found], list(expected)
    if len(found) != len(expected) or not expected:
        return float("inf")
    apart = max(abs(a - b) for a, b in zip(found, expected)) / max(abs(value) for value in expected)
    return apart if apart == apart else float("inf")


def check(name, blocks, program):
    """Returns the largest difference and, if something is wrong, a sentence."""
    page = PAGES[name]
    defined, printed = run(page, blocks)
    expected = (blocks / "printed.text").read_text()
    if page.block and printed != expected:
        return float("inf"), f"the program prints\n{printed}instead of\n{expected}"
    states = list(random_states(page, random.Random(name)))
    ours = by_kanexpr(program, states)
    theirs = page.accelerations(defined)
    apart = max(difference(theirs(*state), result) for state, result in zip(states, ours, strict=True))
    return apart, "" if apart <= TOLERANCE else f"the accelerations differ by {apart:.1e}"


def main(pages, folder, *names):
    wrong = 0
    for name in names or PAGES:
        apart, sentence = check(name, Path(pages) / name, Path(folder).resolve() / name)
        if missing := words.unknown(name, (DOCS / f"{name}.md").read_text()):
            sentence = f"the program has no {', '.join(missing)}"
        print(f"{name:14} {sentence or f'{STATES} states, largest relative difference {apart:.1e}'}", flush=True)
        wrong |= bool(sentence)
    if set(names or PAGES) == set(PAGES):
        missing = words.unknown_forces((DOCS / "forces.md").read_text())
        print(f"{'forces':14} {'no program has ' + ', '.join(missing) if missing else 'all words exist'}")
        wrong |= bool(missing)
    return wrong


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
