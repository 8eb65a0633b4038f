"""What SymPy generates: C, and functions of Python (lambdify). Derivation and shared subexpressions may take a minute of
the processor."""

import os
import resource
import signal
import subprocess
import sys

import operations
from build import contents, fingerprint
from peer import HERE, MARCH, ROOT, Offer, Without, symbol

SECONDS = 60
NO_END = f"too large: not derived within {SECONDS} s"
LARGER = "larger than the iiwa, which is already too large"


def sources(model, shop, models):
    """The folder of what SymPy wrote; what is missing there took too long."""
    used = [HERE / "sympy_sources.py", HERE / "solve.h", HERE / "requirements.txt", models / f"{model.name}.model",
            ROOT / "bench/linearization/models_in_sympy.py"]
    folder = shop.folder / f"sympy-{model.name}-{fingerprint(contents(used))}"
    if not folder.exists():
        unfinished = folder.with_suffix(".unfinished")
        unfinished.mkdir(exist_ok=True)
        ended = subprocess.run([*shop.nice, sys.executable, HERE / "sympy_sources.py", models / f"{model.name}.model",
                                unfinished], env={**os.environ, "SYMPY_CACHE_SIZE": "None"},
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5)))
        if ended.returncode not in (0, -signal.SIGXCPU):
            ended.check_returncode()
        unfinished.rename(folder)
    return folder


def form(model, result):
    """M and f of the bicycle are those of all speeds."""
    return "kanexpr" if model.is_tree or result != "mass_matrix_and_forcing" else "whole"


class Generated:
    name = "SymPy, C"

    def offers(self, model, shop, models):
        if model.floats:
            return Without(LARGER)
        found = {}
        for path in sorted(sources(model, shop, models).glob("*.c")):
            built = shop.build("gcc", path, MARCH, [HERE / "solve.h"])
            result = path.stem
            found[result] = Offer(symbol(built.path, result),
                                  operations.in_code(path.read_text()) if result == "mass_matrix_and_forcing" else None,
                                  built, form=form(model, result))
        return found or Without(NO_END)


class Lambdified:
    name = "SymPy, Python"

    def offers(self, model, shop, models):
        if model.floats:
            return Without(LARGER)
        found = {}
        for path in sorted(sources(model, shop, models).glob("*.py")):
            written = {}
            exec(compile(path.read_text(), path, "exec"), written)
            found[path.stem] = Offer(called(path.stem, model, written), is_python=True,
                                     form=form(model, path.stem))
        return found or Without(NO_END)


def called(result, model, written):
    """A function of a state; what is left to solve NumPy solves."""
    import numpy
    both, change = written["both"], written.get("change")
    n = model.speeds if model.is_tree else 6
    if result == "mass_matrix_and_forcing":
        return both

    def udot(x):
        values = numpy.array(both(x))
        M = values[:n * n].reshape(n, n)
        return M, numpy.linalg.solve(M, values[n * n:])

    if result == "udot":
        return lambda x: udot(x)[1]

    def derivatives(x):
        M, rates = udot(x)
        return numpy.linalg.solve(M, numpy.array(change([*x, *rates])).reshape(-1, n).T).ravel(order="F")

    return derivatives
