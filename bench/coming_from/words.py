"""Checks that the words of other programs in the tables of docs/coming-from exist in their Python packages.

The words of Chrono are not checked, because PyPI does not have it.
"""

import importlib
import inspect
import re

MODULES = {
    "casadi": ["casadi"],
    "drake": ["pydrake.all"],
    "mujoco": ["mujoco"],
    "pinocchio": ["pinocchio"],
    "pydy": ["sympy", "sympy.physics.mechanics", "numpy", "scipy.integrate", "pydy.system", "pydy.models", "pydy.viz",
             "pydy.viz.shapes", "pydy.codegen.c_code", "pydy.codegen.octave_code", "pydy.codegen.ode_function_generators"],
    "sympy": ["sympy", "sympy.physics.mechanics"],
}
# the columns of the tables of forces.md
FORCES = {
    1: ["sympy.physics.mechanics", "sympy.physics.biomechanics", "symbrim.bicycle", "symbrim.brim", "symbrim.rider"],
    2: ["pydrake.all"],
    3: ["mujoco"],
}
# names of values in a row, keywords, and what is built into some packages only
OTHERS = {"A_and_B", "CppADCodeGen", "buildModelFromSdf", "casadi", "lambda", "op_point", "position", "rate",
          "filter", "plane", "spatial_inertia", "tool"}


def names_in_code(cell):
    """Names of at least four letters in code, outside of strings."""
    for code in re.findall(r"`([^`]+)`", cell):
        yield from re.findall(r"[A-Za-z_]\w{3,}", re.sub(r'"[^"]*"', "", code))


def words_of(page):
    """What the left column calls `name`."""
    table = page.split("\n## Words\n")[1].split("\n## ")[0]
    for row in [line for line in table.splitlines() if line.startswith("| ")][1:]:
        yield from names_in_code(row[2:].split(" | ")[0])


def names_in(module):
    """The names of a module, of the members of its classes, and of the arguments that make them."""
    for name, value in inspect.getmembers(module):
        yield name
        if inspect.isclass(value):
            yield from dir(value)
            yield from re.findall(r"\w+", value.__init__.__doc__ or "")
            if inspect.isfunction(value.__init__):
                yield from inspect.signature(value.__init__).parameters
    if module.__name__ == "mujoco":  # the elements and attributes of its files
        yield from re.findall(r"\w+", module.mj_printSchema(True, False))
    yield from module.__name__.split(".")


def unknown(name, page):
    """The words of a page that its program does not have."""
    if name not in MODULES:
        return []
    known = known_in(MODULES[name])
    return sorted({word for word in words_of(page) if word not in known})


def known_in(modules):
    return {word for module in modules for word in names_in(importlib.import_module(module))} | OTHERS


def unknown_forces(page):
    """The words of the tables of forces that their programs do not have."""
    rows = [line.split(" |") for line in page.splitlines() if line.startswith("| ") and not line.startswith("| |")]
    return sorted({word for column, modules in FORCES.items() for known in [known_in(modules)]
                   for row in rows for word in names_in_code(row[column]) if word not in known})
