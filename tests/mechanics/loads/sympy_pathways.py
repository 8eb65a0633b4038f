"""The lengths of pathways, their rates and the generalized forces of actuators along them, by SymPy 1.14.

Prints the numbers with which pathways_test.cpp compares. SymPy's positive forces
lengthen a pathway, except along a WrappingPathway.
"""

import sympy as sm
import sympy.physics.mechanics as me

q1, q2 = me.dynamicsymbols("q1 q2")
u1, u2 = me.dynamicsymbols("u1 u2")
k, k3, c, rest = sm.Rational(7), sm.Rational(3), sm.Rational(2), sm.Rational(1, 2)
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


P = point("P", A.y + sm.Rational(1, 5) * A.z)
Q = point("Q", sm.Rational(4, 5) * B.y - sm.Rational(1, 2) * B.z + q2 * B.x, P)
W = point("W", sm.Rational(3, 2) * N.x - sm.Rational(1, 4) * N.z)
E = point("E", sm.Rational(3, 10) * A.x + sm.Rational(1, 10) * A.z)
radius = sm.Rational(3, 10)
S = point("S", radius * N.x)
R = point("R", radius * A.x + (sm.Rational(2, 5) + q2) * N.z)
# SymPy requires the positions of points on a surface relative to the point on its axis
state = {q1: sm.Rational(9, 10), q2: sm.Rational(2, 5), u1: sm.Rational(13, 10), u2: -sm.Rational(7, 10)}


def forces(loads):
    """Generalized forces of loads on u1 and u2."""
    total = [0, 0]
    for load in loads:
        if isinstance(load, me.Force):
            velocity = load.point.vel(N)
        else:
            velocity = load.frame.ang_vel_in(N).subs(rates)
        value = load[1]
        for i, u in enumerate((u1, u2)):
            total[i] += me.dot(velocity.diff(u, N, var_in_dcm=False), value)
    return total


def report(name, path):
    length, rate = path.length, path.extension_velocity.subs(rates)
    spring = me.DuffingSpring(k, k3, path, rest)
    damper = me.LinearDamper(c, path)
    wanted = [length, rate, *forces(spring.to_loads()), *forces(damper.to_loads())]
    numbers = [float(sm.N(sm.sympify(e).subs(rates).subs(state), 30)) for e in wanted]
    print(f"    {{\"{name}\", {{{', '.join(repr(n) for n in numbers)}}}}},")


report("straight", me.LinearPathway(Q, W))
report("through", me.ObstacleSetPathway(Q, P, E, W))
report("around a cylinder", me.WrappingPathway(S, R, me.WrappingCylinder(radius, O, N.z)))
