"""Pinocchio by its own C++, and traced by CppADCodeGen."""

import subprocess
import sysconfig
from pathlib import Path

import operations
from build import contents, fingerprint
from peer import CXX, HERE, MARCH, RESULTS, Offer, Without, symbol

DEFINED = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
           "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DBOOST_FUSION_INVOKE_MAX_ARITY=12"]
CONSTRAINED = "rolling is not among its constraints"


def prefix():
    return (Path(sysconfig.get_path("purelib")) / "cmeel.prefix").resolve()


def flags():
    return [*DEFINED, "-isystem", f"{prefix()}/include", "-isystem", "/usr/include/eigen3"]


def uses():
    return [HERE / "pinocchio/read_model.hpp", HERE / "requirements.txt"]


class Algorithms:
    name = "Pinocchio"

    def offers(self, model, shop, models):
        if not model.is_tree:
            return Without(CONSTRAINED)
        built = shop.build("g++", HERE / "pinocchio/algorithms.cpp", [*CXX, *flags()], uses())
        path = models / f"{model.name}.model"
        return {result: Offer(symbol(built.path, result, load=path), built=None, form="tangent")
                for result in RESULTS}


class Traced:
    def __init__(self, compiler):
        self.compiler, self.name = compiler, f"CppADCodeGen, {compiler}"

    def offers(self, model, shop, models):
        if not model.is_tree:
            return Without(CONSTRAINED)
        folder = self.traces(shop, models / f"{model.name}.model")
        found = {}
        for result in RESULTS:
            counted = sorted((operations.in_code(way.read_text()), way) for way in folder.glob(f"{result}.*.c"))
            built = shop.build(self.compiler, counted[0][1], MARCH)
            found[result] = Offer(symbol(built.path, result), counted[0][0], built, form="tangent")
        return found

    @staticmethod
    def tracer(shop):
        """Compiled once, in minutes and with 5 GB."""
        libraries = prefix() / "lib"
        return shop.build("g++", HERE / "pinocchio/trace.cpp", ["-O0", "-std=c++20", "-DNDEBUG", *flags()], uses(),
                          link=[f"-L{libraries}", f"-Wl,-rpath,{libraries}", "-lcppad_lib"])

    @classmethod
    def traces(cls, shop, path):
        """The folder of what was traced of a model."""
        tracer = cls.tracer(shop)
        folder = shop.folder / f"traced-{path.stem}-{fingerprint(tracer.path, contents([path]))}"
        if not folder.exists():
            unfinished = folder.with_suffix(".unfinished")
            unfinished.mkdir(exist_ok=True)
            subprocess.run([*shop.nice, tracer.path, path, unfinished], check=True)
            unfinished.rename(folder)
        return folder
