"""kanexpr, compiled and interpreted."""

import ctypes

from peer import CXX, HERE, KANEXPR, RESULTS, ROOT, Offer, limits_of, symbol

SYSTEMS = {"pendulum6": "pendulum6::System", "puma": "puma::System", "iiwa": "iiwa::System",
           "quadruped": "quadruped::System", "bicycle": "bicycle::BoundSystem"}


def headers():
    return sorted([*(ROOT / "include").rglob("*.hpp"), *(ROOT / "examples/models").glob("*.hpp"),
                   *(HERE / "kanexpr").glob("*.hpp"), ROOT / "bench/evaluation/two_threads.hpp"])


def write_models(shop, compiler, folder, flags=None):
    """Writes the numbers of all models, and states, and returns the folder."""
    import subprocess
    flags = flags or ["-O1", "-std=c++20"]
    program = shop.build(compiler, HERE / "kanexpr/write_models.cpp", [*flags, *limits_of(compiler), *KANEXPR],
                         headers(), link=[])
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([program.path, folder], check=True)
    return folder


def command(compiler, flags, model, *definitions):
    return [*flags, *limits_of(compiler), *KANEXPR, "-include", f"models/{model.name}.hpp",
            f"-DSYSTEM={SYSTEMS[model.name]}", *definitions]


def places_of(path, name):
    """Where a function leaves the parts of its result, if it says so."""
    told = symbol(path, f"{name}_places", optional=True)
    if told is None:
        return None
    numbers = (ctypes.c_int * 8)(*[-1] * 8)
    told(numbers)
    return [(first, count) for first, count in zip(numbers[::2], numbers[1::2]) if first >= 0]


class Compiled:
    """Of one state, or of some side by side, by `batch`."""

    def __init__(self, compiler, flags=None, lanes=1, results=RESULTS):
        self.compiler, self.lanes, self.results = compiler, lanes, results
        self.name = f"kanexpr, {compiler}" + (f", {lanes} lanes" if lanes > 1 else "")
        self.flags = CXX if flags is None else flags

    def offers(self, model, shop, _):
        found = {}
        for result in self.results:
            built = shop.build(self.compiler, HERE / f"kanexpr/{result}.cpp",
                               command(self.compiler, self.flags, model, f"-DLANES={self.lanes}"), headers())
            found[result] = Offer(symbol(built.path, result), model.operations[result], built, lanes=self.lanes,
                                  places=places_of(built.path, result))
        return found


class Many:
    """The derivatives of many systems, on two threads."""

    def __init__(self, compiler, count, flags=None):
        self.compiler, self.count, self.name = compiler, count, f"kanexpr, {compiler}, {count} on two threads"
        self.flags = CXX if flags is None else flags

    def offers(self, model, shop, _):
        result = "udot_derivatives"
        built = shop.build(self.compiler, HERE / f"kanexpr/{result}_of_many.cpp",
                           command(self.compiler, self.flags, model, f"-DMANY={self.count}"), headers())
        return {result: Offer(symbol(built.path, result), model.operations[result], built, lanes=self.count,
                              found=symbol(built.path, f"{result}_found"))}


class Interpreted:
    name = "kanexpr, interpreted"

    def __init__(self, compiler="g++", flags=None):
        self.compiler = compiler
        self.flags = CXX if flags is None else flags

    def offers(self, model, shop, models):
        built = shop.build(self.compiler, HERE / "kanexpr/interpreted.cpp",
                           [*self.flags, *limits_of(self.compiler), *KANEXPR], headers())
        path = models / f"{model.name}.model"
        return {result: Offer(symbol(built.path, result, load=path), model.operations[result]) for result in RESULTS}
