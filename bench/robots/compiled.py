#!/usr/bin/env python3
"""compiled.py FOLDER COMPILER...: compiles robots of example-robot-data and prints, for each, the operations
(multiplications and additions) of M and f together and of u', those of Pinocchio traced by CppADCodeGen, how far the
compiled results are from those at run time, and what the compiler took. FOLDER has kanexpr-robot, results and tree;
COMPILER has the flags for a file that uses kanexpr."""
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "peers")]

import operations  # noqa: E402
from build import Shop  # noqa: E402
from compare_with_pinocchio import all_files  # noqa: E402
from with_pinocchio import Traced  # noqa: E402

ROBOTS = [
    ("ur5", "ur5_robot.urdf", "fixed"),
    ("xarm7", "xarm7.urdf", "fixed"),
    ("panda", "panda.urdf", "fixed"),
    ("talos_arm", "talos_left_arm.urdf", "fixed"),
    ("solo", "solo.urdf", "floating"),
    ("solo12", "solo12.urdf", "floating"),
    ("anymal", "anymal_b_simple_description/robots/anymal.urdf", "floating"),
    ("go1", "go1.urdf", "floating"),
    ("icub", "icub_reduced.urdf", "floating"),
    ("talos", "talos_reduced.urdf", "floating"),
]


def traced(folder, name, urdf, base):
    """Operations of M and f, and of u', each traced in its shortest way; of a robot that the peers do not know: none."""
    told = subprocess.run([folder / "tree", urdf, base], capture_output=True, text=True)
    if told.returncode != 0:
        return "", ""
    model = folder / f"{name}.model"
    model.write_text(told.stdout)
    ways = Traced.traces(Shop(folder / "built"), model)
    return tuple(
        min(operations.in_code(way.read_text()) for way in ways.glob(f"{result}.*.c"))
        for result in ("mass_matrix_and_forcing", "udot")
    )


def resources_of(command):
    """What a command, which must succeed, and its children take."""
    _, status, took = os.wait4(subprocess.Popen(command).pid, 0)
    if status != 0:
        raise subprocess.CalledProcessError(os.waitstatus_to_exitcode(status), command)
    return took


def compiled(folder, compiler, name, urdf, base):
    header, program = folder / f"{name}.hpp", folder / f"compiled_{name}"
    write = [folder / "kanexpr-robot", urdf, "--name", name, "-o", header, "--base", base, "--no-damping", "-q"]
    subprocess.run(write, check=True)
    flags = [f'-DROBOT_HEADER="{header}"', f"-DROBOT={name}", HERE / "compiled.cpp", "-o", program]
    took = resources_of([*compiler, *flags])
    told = subprocess.run([folder / "results", urdf, base, "5", "1e-4"], capture_output=True, text=True, check=True)
    ran = subprocess.run([program], input=told.stdout, capture_output=True, text=True, check=True)
    return [*ran.stdout.split(), f"{took.ru_utime:.1f}", took.ru_maxrss // 1024]


def main():
    folder, compiler = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    files = all_files()
    print("robot\tbase\tM and f\tu'\tapart\tseconds\tMB\tM and f, traced\tu', traced")
    for name, file, base in ROBOTS:
        urdf = next(f for f in files if str(f).endswith("/" + file))
        row = [name, base, *compiled(folder, compiler, name, urdf, base), *traced(folder, name, urdf, base)]
        print(*row, sep="\t", flush=True)


if __name__ == "__main__":
    main()
