"""Kane's equations of the bicycle of examples/models/bicycle.hpp as CasADi's expressions, in the axes Y, which yaw with
it: partial velocities by differentiation, and the rolling of the front wheel solved for u1, u4 and u6."""

import math

import casadi as ca
from tree_in_casadi import constant, solve, turn_to_parent


def turn(axis, angle):
    return turn_to_parent(axis, ca.SX(angle))


def inertia(about, xx, yy, zz, zx=0.0):
    """In the axes of a frame that is turned by `about` from level."""
    c, s = math.cos(-about), math.sin(-about)
    C = ca.DM([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return constant(C @ ca.DM([[xx, 0, zx], [0, yy, 0], [zx, 0, zz]]) @ C.T)


def solve_3(A, b):
    """By cofactors."""
    cofactors = [ca.cross(A[(i + 1) % 3, :].T, A[(i + 2) % 3, :].T) for i in range(3)]
    return (ca.horzcat(*cofactors) @ b) / ca.dot(A[0, :].T, cofactors[0])


def results(model):
    p = model.values
    q1, q2, q5, q4 = ca.vertsplit(q := ca.SX.sym("q", 4))
    u2, u3, u5, u1, u4, u6 = ca.vertsplit(u := ca.SX.sym("u", 6))
    z = constant([0, 0, 1])
    R = turn(0, q2)
    F = R @ turn(1, q4 + p["htangle"])
    K = F @ turn(0, q5)
    turning_frame = u1 * z + u2 * R[:, 0] + u4 * F[:, 1]
    turning_fork = turning_frame + u5 * K[:, 0]
    turning_rear, turning_front = turning_frame + u3 * F[:, 1], turning_fork + u6 * K[:, 1]

    up = p["WRrad"] * R[:, 2]
    to_steer = p["framelength"] * F[:, 2]
    to_front = p["forklength"] * K[:, 0] + p["forkoffset"] * K[:, 2]
    down = K[2, 1] * K[:, 1] - z
    to_ground = p["WFrad"] * down / ca.sqrt(ca.dot(down, down))
    rear = ca.cross(turning_rear, up)
    frame = rear + ca.cross(turning_frame, -p["framecg1"] * F[:, 0] + p["framecg3"] * F[:, 2])
    steer = rear + ca.cross(turning_frame, to_steer)
    fork = steer + ca.cross(turning_fork, -p["forkcg1"] * K[:, 0] + p["forkcg3"] * K[:, 2])
    front = steer + ca.cross(turning_fork, to_front)
    contact = front + ca.cross(turning_front, to_ground)
    height = (up + to_steer + to_front + to_ground)[2]

    bodies = [
        (p["mframe"], frame, turning_frame, F,
         inertia(p["htangle"], p["Iframe11"], p["Iframe22"], p["Iframe33"], p["Iframe31"])),
        (p["mfork"], fork, turning_fork, K,
         inertia(p["htangle"], p["Ifork11"], p["Ifork22"], p["Ifork33"], p["Ifork31"])),
        (p["mwr"], rear, turning_rear, F, inertia(0, p["Iwr11"], p["Iwr22"], p["Iwr11"])),
        (p["mwf"], front, turning_front, K, inertia(0, p["Iwf11"], p["Iwf22"], p["Iwf11"])),
    ]
    qdot = ca.vertcat(u1, u2, u5, u4)

    def rate(v):
        """At constant speeds, in N."""
        return ca.jtimes(v, q, qdot) + ca.cross(u1 * z, v)

    M, f = ca.SX(6, 6), ca.SX(6, 1)
    for mass, v, w, axes, moments in bodies:
        V, W = ca.jacobian(v, u), axes.T @ ca.jacobian(w, u)
        own = axes.T @ w
        M += mass * V.T @ V + W.T @ moments @ W
        f -= mass * V.T @ (rate(v) + p["g"] * z)
        f -= W.T @ (moments @ (axes.T @ rate(w)) + ca.cross(own, moments @ own))

    J = ca.jacobian(contact, u)
    A = solve_3(J[:, 3:], -J[:, :3])
    b = solve_3(J[:, 3:], -ca.jtimes(contact, q, qdot))
    B = M[3:, :3] + M[3:, 3:] @ A
    reduced = M[:3, :3] + M[:3, 3:] @ A + A.T @ B
    forcing = f[:3] + A.T @ f[3:] - B.T @ b
    independent = solve(reduced, forcing)
    udot = ca.vertcat(independent, A @ independent + b)

    # δq, then δu, along the independent q1, q2, q5, u2, u3, u5
    by_height = ca.jacobian(height, q)
    dq = ca.vertcat(ca.horzcat(ca.SX.eye(3), ca.SX(3, 3)),
                    ca.horzcat(-by_height[:3] / by_height[3], ca.SX(1, 3)))
    du = ca.horzcat(ca.SX(3, 3), ca.SX.eye(3))
    du = ca.vertcat(du, solve_3(J[:, 3:], -(J[:, :3] @ du + ca.jacobian(contact, q) @ dq)))
    derivatives = ca.jacobian(independent, q) @ dq + ca.jacobian(independent, u) @ du
    return ca.vertcat(q, u), {
        "mass_matrix_and_forcing": [ca.vertcat(ca.vec(reduced), forcing, b)],
        "udot": [udot],
        "udot_derivatives": [ca.vec(derivatives)],
    }
