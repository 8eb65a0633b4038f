"""kanexpr, compiled and interpreted."""

from peer import CXX, HERE, KANEXPR, RESULTS, ROOT, Offer, limits_of, symbol

SYSTEMS = {"pendulum6": "pendulum6::System", "puma": "puma::System", "iiwa": "iiwa::System",
           "quadruped": "quadruped::System", "bicycle": "bicycle::BoundSystem"}


def headers():
    return sorted([*(ROOT / "include").rglob("*.hpp"), *(ROOT / "examples/models").glob("*.hpp"),
                   *(HERE / "kanexpr").glob("*.hpp")])


def write_models(shop, compiler, folder, flags=None):
    """Writes the numbers of all models, and states, and returns the folder."""
    import subprocess
    flags = flags or ["-O1", "-std=c++20"]
    program = shop.build(compiler, HERE / "kanexpr/write_models.cpp", [*flags, *limits_of(compiler), *KANEXPR],
                         headers(), link=[])
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([program.path, folder], check=True)
    return folder


class Compiled:
    def __init__(self, compiler, flags=None):
        self.compiler, self.name = compiler, f"kanexpr, {compiler}"
        self.flags = CXX if flags is None else flags

    def offers(self, model, shop, _):
        found = {}
        for result in RESULTS:
            built = shop.build(self.compiler, HERE / f"kanexpr/{result}.cpp",
                               [*self.flags, *limits_of(self.compiler), *KANEXPR, "-include",
                                f"models/{model.name}.hpp", f"-DSYSTEM={SYSTEMS[model.name]}"], headers())
            found[result] = Offer(symbol(built.path, result), model.operations[result], built)
        return found


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
