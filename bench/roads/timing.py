"""What CasADi waits for on the iiwa, beside the C that it generates of Pinocchio's algorithm: timing.py FOLDER."""

import os
import subprocess
import sys
import time
from pathlib import Path

import casadi as ca
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "peers"))
import with_pinocchio  # noqa: E402
from build import Shop  # noqa: E402

FLAGS = ["-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=fast", "-shared", "-fPIC"]  # those of the guide
COUNT = 2000


def traced(model):
    """Pinocchio's algorithm of a model as a function of CasADi. What traces it is compiled once, in minutes."""
    libraries = Path(ca.__file__).resolve().parent
    tracer = Shop(Path.cwd()).build("g++", HERE / "pinocchio.cpp",
                             ["-O0", "-std=c++20", "-DNDEBUG", *with_pinocchio.flags(), "-isystem", f"{libraries}/include"],
                             with_pinocchio.uses(), link=[f"-L{libraries}", f"-Wl,-rpath,{libraries}", "-lcasadi"])
    subprocess.run([tracer.path, model, "."], check=True)
    return ca.Function.load("pinocchio.casadi")


def generated(name, given, wanted):
    """A function as CasADi generates it, compiled as the guide compiles what is exported."""
    function = ca.Function(name, given, wanted)
    function.generate(f"{name}.c")
    subprocess.run([os.environ.get("CC", "cc"), *FLAGS, f"{name}.c", "-o", f"{name}.so", "-lm"], check=True)
    return ca.external(name, f"./{name}.so"), function.n_instructions()


class Callback:
    """A function with memory of its own, as a solver calls it."""

    def __init__(self, function, given):
        self.buffer, self.call = function.buffer()
        self.given = [np.ascontiguousarray(each, dtype=float) for each in given]
        self.results = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        for i, each in enumerate(self.given):
            self.buffer.set_arg(i, memoryview(each))
        for i, each in enumerate(self.results):
            self.buffer.set_res(i, memoryview(each))

    def microseconds(self):
        begin = time.perf_counter()
        for _ in range(COUNT):
            self.call()
        return (time.perf_counter() - begin) / COUNT * 1e6


os.chdir(sys.argv[1])
own = ca.external("iiwa", "./iiwa.so")
pinocchio = traced("iiwa.model")
x, r, weights = ca.SX.sym("x", 14), ca.SX.sym("r", 7), ca.SX.sym("w", 14)
rate, z = pinocchio(x, r, []), ca.vertcat(x, r)
peers = {"rates": generated("peer_rates", [x, r], [rate]),
         "first derivatives": generated("peer_jacobian", [x, r], [ca.jacobian(rate, x), ca.jacobian(rate, r)]),
         "gradient of a weighted sum": generated("peer_gradient", [x, r, weights], [ca.gradient(ca.dot(weights, rate), z)]),
         "second derivatives": generated("peer_hessian", [x, r, weights], [ca.hessian(ca.dot(weights, rate), z)[0]])}

random = np.random.default_rng(3)
at, w = [random.uniform(-1, 1, 14), random.uniform(-1, 1, 7)], random.uniform(-1, 1, 14)
none = np.zeros(14), np.zeros(7), np.zeros(0)
ours = {"rates": (own, [*at, none[2]]),
        "first derivatives": (own.jacobian(), [*at, none[2], none[0]]),
        "gradient of a weighted sum": (own.reverse(1), [*at, none[2], none[0], w]),
        "second derivatives": (ca.external("jac_adj1_iiwa", "./iiwa.so"), [*at, none[2], none[0], w, *none])}
for what, (peer, instructions) in peers.items():
    function, given = ours[what]
    found, expected = function.call(given), peer.call([*at, w][: peer.n_in()])
    if what == "second derivatives":
        found = [ca.blockcat([[found[0], found[1]], [found[5], found[6]]])]
    elif what.startswith("gradient"):
        found = [ca.vertcat(*found[:2])]
    for one, other in zip(found, expected):
        assert np.abs(np.array(one - other)).max() < 1e-11 * np.abs(np.array(other)).max()
    a, b = Callback(function, given), Callback(peer, [*at, w][: peer.n_in()])
    rounds = [(a.microseconds(), b.microseconds()) for _ in range(30)]
    own_time, peer_time = (min(column) for column in zip(*rounds))
    ratios = sorted(one / other for one, other in rounds)
    print(f"iiwa, {what}: {own_time:.2f} µs, Pinocchio through CasADi {peer_time:.2f} µs ({instructions} instructions); "
          f"ratio {ratios[15]:.2f} ({ratios[3]:.2f} to {ratios[26]:.2f})")
