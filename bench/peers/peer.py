"""What all peers have in common."""

import ctypes
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RESULTS = ["mass_matrix_and_forcing", "udot", "udot_derivatives"]

MARCH = ["-O3", "-march=native"]
CXX = [*MARCH, "-std=c++20", "-DNDEBUG"]
KANEXPR = [f"-I{ROOT}/include", f"-I{ROOT}/examples", "-isystem", "/usr/include/eigen3"]
LIMITS = {
    "g++": ["-fconstexpr-ops-limit=1000000000", "-fconstexpr-loop-limit=10000000", "-fconstexpr-depth=2000"],
    "clang++": ["-fconstexpr-steps=1000000000", "-fconstexpr-depth=2000", "-fbracket-depth=1024"],
}


def limits_of(compiler):
    return LIMITS["clang++" if "clang" in compiler else "g++"]


@dataclass
class Offer:
    """What a peer has for one result of one model."""
    call: object  # of a library: from doubles to doubles; else a function of Python
    operations: int | None = None  # multiplications and additions
    built: object = None
    is_python: bool = False
    state_of: object = None  # from a state [q; u; r] to what the call takes
    form: str = "kanexpr"  # in which coordinates and speeds, see agreement.py
    lanes: int = 1  # states side by side in one call: first entry of all, second entry of all, …
    places: list | None = None  # where the result has its parts, as pairs of a first entry and a number of entries
    found: object = None  # what copies the result of the last call, if it stays in the library


@dataclass
class Without:
    """Why a peer has none."""
    reason: str


def symbol(path, name, load=None, optional=False):
    """A function of a library; `load` is the file of the model, which libraries that hold all models are told. None
    for one that is not there and need not be."""
    library = ctypes.CDLL(path)
    if optional and not hasattr(library, name):
        return None
    if load is not None:
        library.load.restype = None
        library.load(str(load).encode())
    function = getattr(library, name)
    function.restype = None
    return function
