"""Tests the modules written by write_c: python_test.py FOLDER, which contains libfour_bar.so next to four_bar.py."""

import math
import sys

sys.path.insert(0, sys.argv[1])
sys.dont_write_bytecode = True

import bead
import four_bar
import iiwa
import pendulum
import sliders


def refused(kind, call):
    try:
        call()
    except kind as error:
        return str(error)
    raise AssertionError("nothing was refused")


p = dict.fromkeys(four_bar.parameters, 1.0)
x = {"q1": 0.3, "q2": 1.1, "q3": -0.7, "u1": 0.5, "u2": -0.2, "u3": 0.1}
by_name = four_bar.udot(x, p, {"T": 2.0})
assert by_name == four_bar.udot(list(x.values()), [1.0] * len(p), [2.0])
assert len(by_name) == 3 and all(math.isfinite(rate) for rate in by_name)
A, B = four_bar.explicit_form(x, p, {"T": 2.0})
assert len(A) == 2 and len(A[0]) == 2 and len(B) == 2

assert "u2 and u3" in refused(four_bar.Singular, lambda: four_bar.udot([0.0] * 6, p, [0.0]))
assert refused(KeyError, lambda: four_bar.udot(x | {"q9": 0}, p, [0.0])) == repr(
    "q9 is not one of the states q1, q2, q3, u1, u2, u3")
assert refused(KeyError, lambda: four_bar.udot({"q1": 0}, p, [0.0])) == repr(
    "the states lack a value for q2, q3, u1, u2, u3")
assert refused(ValueError, lambda: four_bar.udot([0.0], p, [0.0])) == "expected 6 states, got 1"

state, torques = [0.1 * i for i in range(14)], [1.0] * 7
rates = iiwa.udot(state, r=torques)
# Inverse dynamics at the rates caused by the torques requires no additional forces.
left = iiwa.inverse_dynamics(state, r=torques, a=rates)
assert max(map(abs, left)) < 1e-11 * max(map(abs, iiwa.inverse_dynamics(state, r=torques, a=[0.0] * 7)))

[s, v] = bead.runge_kutta_4({"s": 1, "v": 0}, 0.5, {"m": 1, "w": 0, "g": 0}, {"push": 2})
assert abs(s - 1.25) < 1e-15 and abs(v - 1) < 1e-15

rate = pendulum.udot({"q": 0.3, "u": 0}, {"m": 2, "l": 0.5, "c": 0.1}, {"T": 0})
assert abs(rate[0] - -9.81 / 0.5 * math.sin(0.3)) < 1e-12
assert pendulum.tip([0.0, 0.0], [1.0, 0.5, 0.0], [0.0]) == [0.5, 0.0, 0.0]

p = {"a": 1.0, "b": 2.0, "c": 3.0, "d": 4.0}
A, B = sliders.explicit_form([0.0] * 4, p, [0.0] * 2)
assert A[2][0] == 1 and A[3][3] == 4 and B[2][0] == 9 and B[3][1] == 16
for name in p:
    for wrong in math.nan, math.inf, 1e200:
        call = lambda: sliders.explicit_form([0.0] * 4, p | {name: wrong}, [0.0] * 2)
        assert "not finite" in refused(sliders.Singular, call)
