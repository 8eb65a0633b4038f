"""Actuators, pathways and musculotendons of SymPy 1.14 at random states.

Writes sympy_actuators.json: tables of numbers, evaluated with 40 digits and rounded once. The columns of each
table are listed in README.md.

    python3 tests/oracles/sympy_actuators.py > tests/oracles/sympy_actuators.json
"""

import json
import random

import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics import biomechanics as bio

DIGITS = 40
source = random.Random(16)


def uniform(low, high):
    return round(source.uniform(low, high), 6)


def numbers(arguments, expressions):
    """A function from numbers to the rounded values of expressions."""
    f = sm.lambdify(arguments, [sm.sympify(e).doit() for e in expressions], "mpmath")
    mp = sm.core.numbers.mpmath

    def evaluate(values):
        with mp.workdps(DIGITS):
            return [float(e) for e in f(*[mp.mpf(repr(v)) for v in values])]

    return evaluate


def table(arguments, expressions, sample, rows=20):
    evaluate = numbers(arguments, expressions)
    result = []
    for _ in range(rows):
        values = sample()
        result.append(values + evaluate(values))
    return result


# ---- curves

x = sm.Symbol("x")
CURVES = [
    (bio.TendonForceLengthDeGroote2016, (0.9, 1.08)),
    (bio.TendonForceLengthInverseDeGroote2016, (-0.2, 1.5)),
    (bio.FiberForceLengthPassiveDeGroote2016, (0.4, 1.7)),
    (bio.FiberForceLengthPassiveInverseDeGroote2016, (0.0, 1.5)),
    (bio.FiberForceLengthActiveDeGroote2016, (0.3, 1.8)),
    (bio.FiberForceVelocityDeGroote2016, (-1.2, 1.2)),
    (bio.FiberForceVelocityInverseDeGroote2016, (0.0, 1.6)),
]


def curves():
    each = [table([x], [curve.with_defaults(x)], lambda r=interval: [uniform(*r)]) for curve, interval in CURVES]
    return [sum(row, []) for row in zip(*each)]


# ---- activation and musculotendons, along the line between two points at the distance q

def activation():
    a = bio.FirstOrderActivationDeGroote2016("m", activation_time_constant=sm.Symbol("Ta"),
                                            deactivation_time_constant=sm.Symbol("Td"), smoothing_rate=10)
    symbols = sm.symbols("e a Ta Td")
    rate = a.rhs()[0].subs({a.e: symbols[0], a.a: symbols[1]})
    return table(symbols, [rate],
                 lambda: [uniform(0, 1), uniform(0, 1), uniform(0.01, 0.03), uniform(0.03, 0.1)])


def musculotendon(formulation, sample):
    """Columns: F_max, l_opt, l_slack, v_max in m/s, pennation, damping, l, dl/dt, activation, state; the force
    and the rate of the state. SymPy's force shortens the pathway if it is negative."""
    q, u = me.dynamicsymbols("q u")
    N = me.ReferenceFrame("N")
    origin, insertion = me.Point("O"), me.Point("I")
    insertion.set_pos(origin, q * N.x)
    names = sm.symbols("F_max l_opt l_slack v_max alpha beta")
    muscle = bio.MusculotendonDeGroote2016(
        "m", me.LinearPathway(origin, insertion), bio.FirstOrderActivationDeGroote2016.with_defaults("m"),
        musculotendon_dynamics=formulation, peak_isometric_force=names[0], optimal_fiber_length=names[1],
        tendon_slack_length=names[2], maximal_fiber_velocity=names[3], optimal_pennation_angle=names[4],
        fiber_damping_coefficient=names[5], with_defaults=True)
    l, v, a, state = sm.symbols("l v a state", positive=True)
    rate = muscle.rhs()[0] if formulation != bio.MusculotendonFormulation.RIGID_TENDON else sm.S.Zero
    replaced = {q.diff(): v, muscle.a: a}
    if formulation != bio.MusculotendonFormulation.RIGID_TENDON:
        replaced[muscle.x[0]] = state
    wanted = [e.doit().subs(replaced).subs(q, l) for e in (muscle.force, rate)]
    return table([*names, l, v, a, state], wanted, sample)


def sample_muscle(kind, pennation):
    def sample():
        F, l_opt, l_slack = uniform(100, 2000), uniform(0.05, 0.15), uniform(0.1, 0.4)
        alpha = uniform(0.1, 0.5) if pennation else 0.0
        fiber, force, strain = uniform(0.6, 1.4), uniform(0.05, 1.1), uniform(1.002, 1.05)
        beta = uniform(0, 0.2) if kind == "rigid" else 0.0
        projected = l_opt * float(sm.sqrt(fiber**2 - float(sm.sin(alpha)) ** 2))
        tendon = {"rigid": 1.0, "fiber": strain, "force": 0.995 + float(sm.log(5 * (force + 0.25))) / 33.9367}[kind]
        length = round(l_slack * tendon + projected, 6)
        v_max = uniform(0.5, 1.5)
        rate = uniform(-0.8, 0.8) * v_max
        return [F, l_opt, l_slack, v_max, alpha, beta, length, rate, uniform(0.1, 1),
                {"rigid": 0.0, "fiber": fiber, "force": force}[kind]]

    return sample


# ---- actuators along pathways of two bodies

q1, q2 = me.dynamicsymbols("q1 q2")
u1, u2 = me.dynamicsymbols("u1 u2")
N = me.ReferenceFrame("N")
A = N.orientnew("A", "Axis", (q1, N.z))
B = A.orientnew("B", "Axis", (q2, A.x))
O = me.Point("O")
O.set_vel(N, 0)
rates = {q1.diff(): u1, q2.diff(): u2}


def point(name, at, parent=O):
    p = parent.locatenew(name, at)
    p.set_vel(N, p.pos_from(O).dt(N).subs(rates))
    return p


def forces(loads):
    """Generalized forces of loads on u1 and u2."""
    total = [0, 0]
    for load in loads:
        if isinstance(load, me.Force):
            velocity = load.point.vel(N)
        else:
            velocity = load.frame.ang_vel_in(N).subs(rates)
        for i, u in enumerate((u1, u2)):
            total[i] += me.dot(velocity.diff(u, N, var_in_dcm=False), load[1])
    return total


def pathways():
    radius = sm.Rational(3, 10)
    P = point("P", A.y + A.z / 5)
    Q = point("Q", 4 * B.y / 5 - B.z / 2 + q2 * B.x, P)
    W = point("W", 3 * N.x / 2 - N.z / 4)
    E = point("E", 3 * A.x / 10 + A.z / 10)
    # SymPy requires the positions of points on a surface relative to its center
    S = point("S", radius * N.x)
    R = point("R", radius * A.x + (sm.Rational(2, 5) + q2) * N.z)
    T = point("T", radius * B.y)
    return {
        "straight": me.LinearPathway(Q, W),
        "through": me.ObstacleSetPathway(Q, P, E, W),
        "around a cylinder": me.WrappingPathway(S, R, me.WrappingCylinder(radius, O, N.z)),
        "around a sphere": me.WrappingPathway(S, T, me.WrappingSphere(radius, O)),
    }


def actuators(path):
    """Columns: q1, q2, u1, u2, k, k3, c, rest, F, mu, normal, sigma; the length and its rate, then pairs of
    generalized forces: LinearSpring, DuffingSpring, LinearDamper, ForceActuator, CoulombKineticFriction."""
    k, k3, c, rest, F, mu, normal, sigma = sm.symbols("k k3 c rest F mu normal sigma")
    state = sm.symbols("Q1 Q2 U1 U2")
    all_of_them = [me.LinearSpring(k, path, rest), me.DuffingSpring(k, k3, path, rest), me.LinearDamper(c, path),
                   me.ForceActuator(F, path), me.CoulombKineticFriction(mu, normal, path, sigma=sigma)]
    wanted = [path.length, path.extension_velocity]
    for each in all_of_them:
        wanted += forces(each.to_loads())
    wanted = [sm.sympify(e).subs(rates).subs(dict(zip((u1, u2, q1, q2), state[2:] + state[:2]))) for e in wanted]
    return table([*state, k, k3, c, rest, F, mu, normal, sigma], wanted,
                 lambda: [uniform(0.3, 2.2), uniform(0.2, 1.2), uniform(-2, 2), uniform(-2, 2), uniform(1, 9),
                          uniform(1, 9), uniform(0.1, 2), uniform(0.1, 0.6), uniform(-5, 5), uniform(0.1, 1),
                          uniform(1, 5), uniform(0, 1)], 10)


def torque():
    """Columns: q1, q2, u1, u2, T; the generalized forces of a TorqueActuator about B.y between B and N."""
    T = sm.Symbol("T")
    state = sm.symbols("Q1 Q2 U1 U2")
    wanted = forces(me.TorqueActuator(T, B.y, B, N).to_loads())
    wanted = [sm.sympify(e).subs(rates).subs(dict(zip((u1, u2, q1, q2), state[2:] + state[:2]))) for e in wanted]
    return table([*state, T], wanted, lambda: [uniform(-2, 2) for _ in range(5)], 10)


formulation = bio.MusculotendonFormulation
tables = {
    "curves": curves(),
    "activation": activation(),
    "rigid tendon": musculotendon(formulation.RIGID_TENDON, sample_muscle("rigid", False)),
    "rigid tendon, pennate": musculotendon(formulation.RIGID_TENDON, sample_muscle("rigid", True)),
    "tendon force": musculotendon(formulation.TENDON_FORCE_EXPLICIT, sample_muscle("force", False)),
    "tendon force, pennate": musculotendon(formulation.TENDON_FORCE_EXPLICIT, sample_muscle("force", True)),
    "fiber length": musculotendon(formulation.FIBER_LENGTH_EXPLICIT, sample_muscle("fiber", False)),
    "fiber length, pennate": musculotendon(formulation.FIBER_LENGTH_EXPLICIT, sample_muscle("fiber", True)),
    "torque": torque(),
}
for name, path in pathways().items():
    tables[name] = actuators(path)
print("{")
print(",\n".join(json.dumps(name) + ": [\n" + ",\n".join(json.dumps(row) for row in rows) + "]"
                 for name, rows in tables.items()))
print("}")
