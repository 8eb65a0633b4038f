"""What FMPy and CasADi make of FMUs: with_fmpy.py FOLDER SESSION, with each motion as simulated by kanexpr, the models for
CasADi and the guide's session."""

import os
import sys

import casadi as ca
import fmpy
import numpy as np
from fmpy.validation import validate_fmu

sys.argv[2] = os.path.abspath(sys.argv[2])
os.chdir(sys.argv[1])


def states_of(name):
    return [each.variable.name[4:-1] for each in fmpy.read_model_description(f"{name}.fmu").derivatives]


def parameters_of(name):
    return [each.name for each in fmpy.read_model_description(f"{name}.fmu").modelVariables if each.causality == "parameter"]


def difference(found, expected):
    return np.abs(found - expected).max() / max(1, np.abs(expected).max())


def check_motion(name):
    reference = np.loadtxt(f"{name}.txt")
    times = {round(t, 12): row for t, *row in reference}
    worst = {}
    for kind in ("ModelExchange", "CoSimulation"):
        motion = fmpy.simulate_fmu(f"{name}.fmu", fmi_type=kind, stop_time=reference[-1, 0], relative_tolerance=1e-12,
                                   output_interval=reference[-1, 0] / 20)
        found = {round(row["time"], 12): [row[s] for s in states_of(name)] for row in motion}
        assert set(times) <= set(found), set(times) - set(found)
        worst[kind] = max(difference(np.array(found[t]), np.array(times[t])) for t in times)
        assert worst[kind] < 1e-8, (name, worst)
    return worst


def check_derivatives(name):
    """What CasADi asks the FMU for, beside what it finds in the library of write_casadi, and beside differences."""
    model = ca.DaeBuilder(name, f"{name}.fmu")
    f = model.create("f", ["x", "u"] if model.nu() else ["x"], ["ode"])
    library = ca.external(name, f"./{name}.so")
    x = np.array(model.start(model.x())).ravel()
    at = [x + 0.01 * np.arange(1, len(x) + 1)] + ([0.1 * np.ones(model.nu())] if model.nu() else [])
    in_library = [at[0], at[1] if model.nu() else [], np.array([model.start(p) for p in parameters_of(name)])]
    blocks = f.jacobian().call([*at, f(*at)])
    expected = library.jacobian().call([*in_library, library(*in_library)])
    rates = lambda given: np.array(f(*given)).ravel()
    worst, by_differences, h = 0, 0, 1e-4
    for k, block in enumerate(blocks):
        worst = max(worst, difference(np.array(block), np.array(expected[k])))
        for j in range(len(at[k])):
            ends = []
            for step in (h, -h, 2 * h, -2 * h):
                moved = [np.copy(each) for each in at]
                moved[k][j] += step
                ends.append(rates(moved))
            slope = (8 * (ends[0] - ends[1]) - (ends[2] - ends[3])) / (12 * h)
            by_differences = max(by_differences, difference(np.array(block)[:, j], slope))
    assert worst < 1e-12 and by_differences < 1e-8, (name, worst, by_differences)
    return worst, by_differences


for name in ("pendulum", "ball", "bicycle", "iiwa"):
    problems = validate_fmu(f"{name}.fmu")
    assert not problems, problems
    worst = check_motion(name)
    slopes = check_derivatives(name)
    print(f"{name}: validated; model exchange within {worst['ModelExchange']:.1e}, co-simulation "
          f"{worst['CoSimulation']:.1e}, derivatives {slopes[0]:.1e}, of differences {slopes[1]:.1e}")

with open(sys.argv[2]) as session:
    of_session = {}
    exec(session.read(), of_session)
assert of_session["slopes"].size1_in(0) == 2
