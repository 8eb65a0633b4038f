"""Equations of motion that were written by hand in CasADi: functions of the state, the inputs and the parameters."""

import casadi as ca


def by_lagrange(name, q, u, rates, p, r, kinetic, potential, forces):
    """q̇ = rates(u); kinetic(q, q̇), potential(q) and the generalized forces on q̇; the speeds are those of `rates`."""
    qdot = ca.SX.sym("qdot", q.numel())
    T = kinetic(q, qdot)
    momenta = ca.gradient(T, qdot)
    M = ca.jacobian(momenta, qdot)
    right = forces(qdot) + ca.gradient(T - potential(q), q) - ca.jtimes(momenta, q, qdot)
    accelerations = ca.substitute(ca.solve(M, right), qdot, rates)
    # from q̈ to u̇, as the rates are linear in the speeds
    speeds = ca.solve(ca.jacobian(rates, u), accelerations)
    return ca.Function(name, [ca.vertcat(q, u), r, p], [ca.vertcat(rates, speeds)], ["x", "r", "p"], ["rate"])


def cart():
    q, u, p, F = ca.SX.sym("q", 2), ca.SX.sym("u", 2), ca.SX.sym("p", 3), ca.SX.sym("F")
    m0, m1, l = ca.vertsplit(p)

    def kinetic(q, v):
        bob = ca.vertcat(v[0] - l * ca.sin(q[1]) * v[1], l * ca.cos(q[1]) * v[1])
        return m0 * v[0] ** 2 / 2 + m1 * ca.dot(bob, bob) / 2

    return by_lagrange("by_hand", q, u, u, p, F, kinetic, lambda q: m1 * 9.81 * l * ca.sin(q[1]),
                       lambda v: ca.vertcat(F, 0))


def double_pendulum():
    q, u, p, r = ca.SX.sym("q", 2), ca.SX.sym("u", 2), ca.SX.sym("p", 10), ca.SX.sym("r", 2)
    m1, m2, d1, d2, l1, I1, I2, g, c1, c2 = ca.vertsplit(p)

    def kinetic(q, v):
        a, b = q[0], q[0] + q[1]
        w, z = v[0], v[0] + v[1]
        end = ca.vertcat(-l1 * ca.sin(a) * w - d2 * ca.sin(b) * z, l1 * ca.cos(a) * w + d2 * ca.cos(b) * z)
        return (I1 + m1 * d1**2) * w**2 / 2 + I2 * z**2 / 2 + m2 * ca.dot(end, end) / 2

    def potential(q):
        return g * (m1 * d1 * ca.sin(q[0]) + m2 * (l1 * ca.sin(q[0]) + d2 * ca.sin(q[0] + q[1])))

    return by_lagrange("by_hand", q, u, ca.vertcat(u[0], u[1] - u[0]), p, r, kinetic, potential,
                       lambda v: ca.vertcat(r[0] - c1 * v[0], r[1] - c2 * v[1]))


def sleigh():
    """Newton's and Euler's equations with a blade that does not slip; the speeds are u1, u3 and u2."""
    x, r, p = ca.SX.sym("x", 6), ca.SX.sym("r", 2), ca.SX.sym("p", 3)
    _, _, heading, forward, turning, sideways = ca.vertsplit(x)
    m, a, I = ca.vertsplit(p)
    F, T = ca.vertsplit(r)
    return ca.Function("by_hand", [x, r, p], [ca.vertcat(
        forward * ca.cos(heading) - sideways * ca.sin(heading),
        forward * ca.sin(heading) + sideways * ca.cos(heading),
        turning,
        F / m + turning * (sideways + a * turning),
        (T - m * a * forward * turning) / (I + m * a**2),
        0)])
