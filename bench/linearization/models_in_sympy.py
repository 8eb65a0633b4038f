"""The systems of systems.hpp in SymPy: the same symbols, frames and loads, and so the same A and B."""

from sympy import symbols
from sympy.physics.mechanics import (KanesMethod, Particle, Point, ReferenceFrame, RigidBody, dot, dynamicsymbols,
                                     inertia)


def bicycle():
    """As in SymPy's test of Kane's method, with Cramer's rule for the dependent speeds: the elimination that
    is SymPy's default divides by zero where the bicycle stands upright, and gives larger expressions."""
    q1, q2, q4, q5 = q = dynamicsymbols("q1 q2 q4 q5")
    u1, u2, u3, u4, u5, u6 = dynamicsymbols("u1:7")
    WFrad, WRrad, htangle, forkoffset, forklength, framelength = symbols(
        "WFrad WRrad htangle forkoffset forklength framelength")
    forkcg1, forkcg3, framecg1, framecg3 = symbols("forkcg1 forkcg3 framecg1 framecg3")
    Iwr11, Iwr22, Iwf11, Iwf22 = symbols("Iwr11 Iwr22 Iwf11 Iwf22")
    Ifork = symbols("Ifork11 Ifork22 Ifork33 Ifork31")
    Iframe = symbols("Iframe11 Iframe22 Iframe33 Iframe31")
    mfork, mframe, mwf, mwr, g = symbols("mfork mframe mwf mwr g")

    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q1, N.z])
    R = Y.orientnew("R", "Axis", [q2, Y.x])
    frame = R.orientnew("frame", "Axis", [q4 + htangle, R.y])
    fork = frame.orientnew("fork", "Axis", [q5, frame.x])
    level_frame = frame.orientnew("level_frame", "Axis", [-htangle, frame.y])
    level_fork = fork.orientnew("level_fork", "Axis", [-htangle, fork.y])
    rear, front = ReferenceFrame("rear"), ReferenceFrame("front")
    Y.set_ang_vel(N, u1 * Y.z)
    R.set_ang_vel(Y, u2 * R.x)
    frame.set_ang_vel(R, u4 * frame.y)
    fork.set_ang_vel(frame, u5 * fork.x)
    rear.set_ang_vel(frame, u3 * frame.y)
    front.set_ang_vel(fork, u6 * fork.y)

    rear_contact = Point("rear_contact")
    rear_center = rear_contact.locatenew("rear_center", WRrad * R.z)
    steer = rear_center.locatenew("steer", framelength * frame.z)
    frame_center = rear_center.locatenew("frame_center", -framecg1 * frame.x + framecg3 * frame.z)
    fork_center = steer.locatenew("fork_center", -forkcg1 * fork.x + forkcg3 * fork.z)
    front_center = steer.locatenew("front_center", forklength * fork.x + forkoffset * fork.z)
    down = (dot(fork.y, Y.z) * fork.y - Y.z).normalize()
    front_contact = front_center.locatenew("front_contact", WFrad * down)
    rear_contact.set_vel(N, 0)
    rear_center.v2pt_theory(rear_contact, N, rear)
    steer.v2pt_theory(rear_center, N, frame)
    frame_center.v2pt_theory(rear_center, N, frame)
    fork_center.v2pt_theory(steer, N, fork)
    front_center.v2pt_theory(steer, N, fork)
    front_contact.v2pt_theory(front_center, N, front)

    def body(name, center, turns, mass, axes, *moments):
        return RigidBody(name, center, turns, mass, (inertia(axes, *moments), center))

    bodies = [
        body("frame", frame_center, frame, mframe, level_frame, *Iframe[:3], 0, 0, Iframe[3]),
        body("fork", fork_center, fork, mfork, level_fork, *Ifork[:3], 0, 0, Ifork[3]),
        body("rear", rear_center, rear, mwr, frame, Iwr11, Iwr22, Iwr11),
        body("front", front_center, front, mwf, fork, Iwf11, Iwf22, Iwf11),
    ]
    slip = front_contact.vel(N)
    kane = KanesMethod(
        N, q_ind=[q1, q2, q5], q_dependent=[q4], u_ind=[u2, u3, u5], u_dependent=[u1, u4, u6],
        kd_eqs=[c.diff() - s for c, s in zip(q, (u1, u2, u4, u5))],
        configuration_constraints=[front_contact.pos_from(rear_contact).dot(Y.z)],
        velocity_constraints=[slip.dot(d) for d in Y], constraint_solver="CRAMER")
    kane.kanes_equations(bodies, [(b.masscenter, -b.mass * g * Y.z) for b in bodies])
    return kane


def cart(n=10):
    q, u = dynamicsymbols(f"q:{n + 1}"), dynamicsymbols(f"u:{n + 1}")
    m, l = symbols(f"m:{n + 1}"), symbols(f"l:{n}")
    g, F = symbols("g"), dynamicsymbols("F")
    N = ReferenceFrame("N")
    at = Point("P0")
    at.set_vel(N, u[0] * N.x)
    points = [at]
    for i in range(n):
        rod = N.orientnew(f"rod{i}", "Axis", [q[i + 1], N.z])
        rod.set_ang_vel(N, u[i + 1] * N.z)
        at = points[-1].locatenew(f"P{i + 1}", l[i] * rod.x)
        at.v2pt_theory(points[-1], N, rod)
        points.append(at)
    bobs = [Particle(f"bob{i}", p, mass) for i, (p, mass) in enumerate(zip(points, m))]
    kane = KanesMethod(N, q_ind=q, u_ind=u, kd_eqs=[c.diff() - s for c, s in zip(q, u)])
    kane.kanes_equations(bobs, [(b.point, -b.mass * g * N.y) for b in bobs] + [(points[0], F * N.x)])
    return kane


def move(point, joint, N, link):
    """Gives a point its velocity and acceleration, both in the axes of the link that it is fixed in."""
    point.v2pt_theory(joint, N, link)
    point.set_vel(N, point.vel(N).express(link))
    point.a2pt_theory(joint, N, link)


def arm():
    """With angular velocities, velocities and accelerations in each link's own axes, which halves what there
    is to differentiate."""
    q, u, T = dynamicsymbols("q1:7"), dynamicsymbols("u1:7"), dynamicsymbols("T1:7")
    g = symbols("g")
    N = ReferenceFrame("N")
    joint = Point("joint1")
    joint.set_vel(N, 0)
    joint.set_acc(N, 0)
    bodies, loads, below = [], [], N
    for i, axis in enumerate("zyyxyx"):
        direction = getattr(below, axis)
        link = below.orientnew(f"link{i + 1}", "Axis", [q[i], direction])
        link.set_ang_vel(N, below.ang_vel_in(N).express(link) + u[i] * getattr(link, axis))
        m, x, y, z, a, b, d = (symbols(f"{s}{i + 1}") for s in "mxyzabd")
        I = [symbols(f"I{axes}{i + 1}") for axes in ("xx", "yy", "zz", "xy", "yz", "zx")]
        center = joint.locatenew(f"center{i + 1}", x * link.x + y * link.y + z * link.z)
        move(center, joint, N, link)
        bodies.append(RigidBody(f"body{i + 1}", center, link, m, (inertia(link, *I), center)))
        loads += [(center, -m * g * N.z), (link, T[i] * direction)]
        if below != N:
            loads.append((below, -T[i] * direction))
        further = joint.locatenew(f"joint{i + 2}", a * link.x + b * link.y + d * link.z)
        move(further, joint, N, link)
        joint, below = further, link
    kane = KanesMethod(N, q_ind=q, u_ind=u, kd_eqs=[c.diff() - s for c, s in zip(q, u)])
    kane.kanes_equations(bodies, loads)
    return kane


MODELS = {"bicycle": bicycle, "cart": cart, "arm": arm}
