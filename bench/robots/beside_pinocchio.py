#!/usr/bin/env python3
"""beside_pinocchio.py FOLDER [ROBOT...]: times M and u' of robots of example-robot-data, compiled by kanexpr, beside
Pinocchio's crba and aba, in one run. Prints nanoseconds of kanexpr, the time of Pinocchio relative to it (median and
quartiles), bytes of code, and what the compiler took. FOLDER has kanexpr-robot, results and tree."""
import ctypes
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PEERS = HERE.parent / "peers"
sys.path += [str(PEERS)]

import timing  # noqa: E402
import with_pinocchio  # noqa: E402
from build import Shop  # noqa: E402
from compare_with_pinocchio import all_files  # noqa: E402
from compiled import ROBOTS  # noqa: E402
from peer import CXX, KANEXPR, limits_of, symbol  # noqa: E402
from with_kanexpr import headers  # noqa: E402

RESULTS = ["mass_matrix", "udot"]
STATES = 64
ROOM = 64 * 64


def states_of(folder, urdf, base):
    """States with inputs, as both take them."""
    told = subprocess.run([folder / "results", urdf, base, str(STATES)], capture_output=True, text=True, check=True)
    lines = [line.split(" ") for line in told.stdout.splitlines()]
    parts = {what: [[float(n) for n in words] for word, *words in lines if word == what]
             for what in ("state", "inputs")}
    return [x + r for x, r in zip(parts["state"], parts["inputs"])]


def evaluated(call, x):
    argument, result = timing.aligned(x), timing.aligned([0.0] * ROOM)
    call(argument, result)
    return result[:]


def apart(calls, states):
    """The largest difference relative to the largest entry."""
    worst = 0.0
    for x in states:
        ours, theirs = (evaluated(call, x) for call in calls)
        worst = max(worst, max(abs(a - b) for a, b in zip(ours, theirs)) / max(map(abs, ours)))
    return worst


def compared(folder, shop, timer, name, urdf, base):
    header, model = folder / f"{name}.hpp", folder / f"{name}.model"
    write = [folder / "kanexpr-robot", urdf, "--name", name, "-o", header, "--base", base, "--no-damping", "-q"]
    subprocess.run(write, check=True)
    told = subprocess.run([folder / "tree", urdf, base], capture_output=True, text=True)
    if told.returncode != 0:
        print(f"{name}: {told.stderr.strip()}", file=sys.stderr)
        return
    model.write_text(told.stdout)
    states = states_of(folder, urdf, base)
    flags = [*CXX, *limits_of("g++"), *KANEXPR, "-include", header, f"-DSYSTEM={name}::System"]
    theirs = shop.build("g++", PEERS / "pinocchio/algorithms.cpp", [*CXX, *with_pinocchio.flags()],
                        with_pinocchio.uses())
    for result in RESULTS:
        ours = shop.build("g++", PEERS / f"kanexpr/{result}.cpp", flags, [*headers(), header])
        calls = [symbol(ours.path, result), symbol(theirs.path, result, load=model)]
        # floating bases have other coordinates; compare_with_pinocchio.py compares these
        if base == "fixed" and apart(calls, states) > 1e-10:
            raise RuntimeError(f"{result} of {name} differs")
        loops = [timing.NativeLoop(timer, call, states, ROOM) for call in calls]
        ratio = timing.compare(*loops)
        yield [f"{ratio.reference:.0f}", f"{ratio.median:.1f} ({ratio.lower:.1f}–{ratio.upper:.1f})", ours.code,
               f"{ours.seconds:.1f}", f"{ours.megabytes:.0f}"]


def main():
    folder, wanted = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    shop = Shop(folder / "built")
    timer = ctypes.CDLL(shop.build("g++", PEERS / "timing.cpp", CXX).path)
    files = all_files()
    print("robot\tresult\tns\tPinocchio\tbytes\tseconds\tMB")
    for name, file, base in ROBOTS:
        if wanted and name not in wanted:
            continue
        urdf = next(f for f in files if str(f).endswith("/" + file))
        for result, row in zip(RESULTS, compared(folder, shop, timer, name, urdf, base)):
            print(name, result, *row, sep="\t", flush=True)


if __name__ == "__main__":
    main()
