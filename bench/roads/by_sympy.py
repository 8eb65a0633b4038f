"""Equations of motion by SymPy, as functions of CasADi of the state, the inputs and the parameters: CasADi differentiates them."""

import casadi as ca
import sympy as sm
import sympy.physics.mechanics as me


def function(kane, q, u, r, p):
    x, given, parameters = ca.SX.sym("x", len(q) + len(u)), ca.SX.sym("r", len(r)), ca.SX.sym("p", len(p))
    values = sm.lambdify([*q, *u, *r, *p], [list(kane.mass_matrix_full), list(kane.forcing_full)],
                         modules=[{"sin": ca.sin, "cos": ca.cos}])
    mass, force = values(*ca.vertsplit(x), *ca.vertsplit(given), *ca.vertsplit(parameters))
    rate = ca.solve(ca.reshape(ca.vertcat(*mass), len(force), len(force)).T, ca.vertcat(*force))
    return ca.Function("by_sympy", [x, given, parameters], [rate], ["x", "r", "p"], ["rate"])


def frame():
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    return N, O


def cart():
    q, u = me.dynamicsymbols("q0 q1"), me.dynamicsymbols("u0 u1")
    m0, m1, l, F = sm.symbols("m0 m1 l F")
    N, O = frame()
    A = N.orientnew("A", "Axis", [q[1], N.z])
    P = O.locatenew("P", q[0] * N.x)
    B = P.locatenew("B", l * A.x)
    P.set_vel(N, u[0] * N.x)
    A.set_ang_vel(N, u[1] * N.z)
    B.v2pt_theory(P, N, A)
    kane = me.KanesMethod(N, q, u, [a.diff() - b for a, b in zip(q, u)])
    kane.kanes_equations([me.Particle("P", P, m0), me.Particle("B", B, m1)],
                         [(P, F * N.x), (B, -sm.Float("9.81") * m1 * N.y)])
    return function(kane, q, u, [F], [m0, m1, l])


def double_pendulum():
    """The second speed is that of the second link in space."""
    q, u = me.dynamicsymbols("q1 q2"), me.dynamicsymbols("u1 u2")
    p = m1, m2, d1, d2, l1, I1, I2, g, c1, c2 = sm.symbols("m1 m2 d1 d2 l1 I1 I2 g c1 c2")
    T1, T2 = sm.symbols("T1 T2")
    N, O = frame()
    A = N.orientnew("A", "Axis", [q[0], N.z])
    B = A.orientnew("B", "Axis", [q[1], A.z])
    A.set_ang_vel(N, u[0] * N.z)
    B.set_ang_vel(N, u[1] * N.z)
    C, P = O.locatenew("C", d1 * A.x), O.locatenew("P", l1 * A.x)
    D = P.locatenew("D", d2 * B.x)
    C.v2pt_theory(O, N, A)
    P.v2pt_theory(O, N, A)
    D.v2pt_theory(P, N, B)
    bodies = [me.RigidBody("A", C, A, m1, (me.inertia(A, 0, 0, I1), C)),
              me.RigidBody("B", D, B, m2, (me.inertia(B, 0, 0, I2), D))]
    elbow = (T2 - c2 * (u[1] - u[0])) * N.z
    loads = [(C, -m1 * g * N.y), (D, -m2 * g * N.y), (A, (T1 - c1 * u[0]) * N.z - elbow), (B, elbow)]
    kane = me.KanesMethod(N, q, u, [q[0].diff() - u[0], q[1].diff() - (u[1] - u[0])])
    kane.kanes_equations(bodies, loads)
    return function(kane, q, u, [T1, T2], p)


def sleigh():
    """With a blade that does not slip; the speeds are u1, u3 and u2, which the blade makes zero."""
    q = me.dynamicsymbols("q1 q2 q3")
    u = u1, u3, u2 = me.dynamicsymbols("u1 u3 u2")
    p = m, a, I = sm.symbols("m a I")
    F, T = sm.symbols("F T")
    N, O = frame()
    A = N.orientnew("A", "Axis", [q[2], N.z])
    A.set_ang_vel(N, u3 * N.z)
    P = O.locatenew("P", q[0] * N.x + q[1] * N.y)
    P.set_vel(N, u1 * A.x + u2 * A.y)
    C = P.locatenew("C", a * A.x)
    C.v2pt_theory(P, N, A)
    velocity = P.vel(N)
    kinematics = [q[0].diff() - velocity.dot(N.x), q[1].diff() - velocity.dot(N.y), q[2].diff() - u3]
    kane = me.KanesMethod(N, q, [u1, u3], kinematics, u_dependent=[u2], velocity_constraints=[u2])
    kane.kanes_equations([me.RigidBody("A", C, A, m, (me.inertia(A, 0, 0, I), C))], [(P, F * A.x), (A, T * A.z)])
    return function(kane, q, u, [F, T], p)
