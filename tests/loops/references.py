"""Writes references.hpp, the reference values for the closed loops of examples/loops.

    python3 references.py > references.hpp

Needs NumPy and SciPy, and reads two of the oracles beside this folder. The equations are written by hand: the cart and
the filter as in textbooks, the bicycle by its benchmark matrices, the arm by recursive Newton-Euler equations.
"""

import json
from pathlib import Path

import numpy as np
import scipy
from scipy.linalg import expm, solve_discrete_are

ORACLES = Path(__file__).parent / "../oracles"


def braces(m):
    m = np.asarray(m, float)
    if m.ndim == 0:
        return repr(float(m))
    return "{" + ", ".join(braces(row) for row in m) + "}"


def constant(name, m):
    sizes = "".join(f"[{n}]" for n in np.shape(m))
    print(f"inline constexpr double {name}{sizes}{'' if sizes else ' = '}{braces(m)};")


def held(a, b, h):
    """A and B over a step in which the inputs are constant."""
    n, m = b.shape
    e = expm(h * np.block([[a, b], [np.zeros((m, n + m))]]))
    return e[:n, :n], e[:n, n:]


def feedback(a, b, q, r):
    p = solve_discrete_are(a, b, q, r)
    return np.linalg.solve(r + b.T @ p @ b, b.T @ p @ a)


def slope(f, x):
    columns = []
    for i in range(len(x)):
        moved = x.astype(complex)
        moved[i] += 1e-30j
        columns.append(f(moved).imag / 1e-30)
    return np.array(columns).T


def step(rates, x, h):
    k1 = rates(x)
    k2 = rates(x + h / 2 * k1)
    k3 = rates(x + h / 2 * k2)
    k4 = rates(x + h * k3)
    return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


# A cart with a pendulum: [x, angle, v, rate], the angle from the track.

def cart_rates(x, force):
    m0, m1, length, gravity = 1.5, 0.4, 0.8, 9.81
    s, c = np.sin(x[1]), np.cos(x[1])
    mass = np.array([[m0 + m1, -m1 * length * s], [-m1 * length * s, m1 * length**2]])
    right = np.array([force + m1 * length * c * x[3]**2, -m1 * gravity * length * c])
    return np.concatenate([x[2:], np.linalg.solve(mass, right)])


class Noise:
    """The generator in examples/loops/noise.hpp."""

    state = 0

    def next(self):
        total = 0
        for _ in range(12):
            self.state = (1664525 * self.state + 1013904223) % 2**32
            total += self.state >> 9
        return (total - 6 * 2**23) / 2**23


def cart():
    h, place_noise, angle_noise, disturbing_force = 0.005, 0.005, 0.01, 0.5
    upright = np.array([0, np.pi / 2, 0, 0])
    a = slope(lambda x: cart_rates(x, 0), upright)
    b = (cart_rates(upright, 1) - cart_rates(upright, 0)).reshape(4, 1)
    ad, bd = held(a, b, h)
    k = feedback(ad, bd, np.diag([1, 1, 0.1, 0.1]), np.array([[0.1]]))
    constant("gain", k[0])

    q, r = disturbing_force**2 * bd @ bd.T, np.diag([place_noise**2, angle_noise**2])
    c = np.eye(4)[:2]
    noise, truth = Noise(), np.array([-0.5, np.pi / 2 + 0.2, 0, 0])
    x, p = np.array([-0.4, np.pi / 2 + 0.1, 0, 0]), np.diag([0.01, 0.01, 0.04, 0.04])
    truths, estimates, covariances, forces = [], [], [], []
    for period in range(1, 1001):
        y = truth[0] + place_noise * noise.next(), truth[1] + angle_noise * noise.next()
        gain = np.linalg.solve(c @ p @ c.T + r, c @ p).T
        x = x + gain @ (y - x[:2])
        p = p - gain @ c @ p
        force = -(k @ (x - upright))[0]
        transition = expm(h * slope(lambda s: cart_rates(s, force), x))
        x = step(lambda s: cart_rates(s, force), x, h)
        p = transition @ p @ transition.T + q
        p = (p + p.T) / 2  # what is not symmetric by rounding would grow
        acting = force + disturbing_force * noise.next()
        truth = step(lambda s: cart_rates(s, acting), truth, h)
        if period % 200 == 0:
            truths.append(truth)
            estimates.append(x)
            covariances.append(p)
            forces.append(force)
    constant("truths", truths)
    constant("estimates", estimates)
    constant("covariances", covariances)
    constant("forces", forces)


# The benchmark of Meijaard, Papadopoulos, Ruina & Schwab with a torque between frame and fork.

def bicycle():
    h = 0.01
    with open(ORACLES / "bicycle_canonical.json") as file:
        known = json.load(file)
    mass, damping, k0, k2 = (np.array(known[name]) for name in ("M", "C1", "K0", "K2"))
    inverse = np.linalg.inv(mass)

    def linear(v):
        a = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ (9.81 * k0 + v * v * k2), -v * inverse @ damping]])
        return held(a, np.concatenate([np.zeros(2), inverse[:, 1]]).reshape(4, 1), h)

    speeds = np.linspace(2, 6, 9)
    gains = np.array([feedback(*linear(v), np.diag([10, 1, 1, 0.1]), np.array([[0.01]]))[0] for v in speeds])
    constant("gains", gains)

    def closed(v):
        a, b = linear(v)
        return a - b @ np.array([[np.interp(v, speeds, column) for column in gains.T]])

    def radius(a):
        return np.abs(np.linalg.eigvals(a)).max()

    between = np.linspace(2, 6, 33)
    constant("speeds", between)
    constant("radius_closed", [radius(closed(v)) for v in between])
    constant("radius_open", [radius(linear(v)[0]) for v in between])

    v, x = 3.2, np.array([1e-5, -2e-5, 3e-5, 1e-5])  # lean, steer and their rates
    constant("small_speed", v)
    constant("small_start", x)
    kept = []
    for period in range(1, 301):
        x = closed(v) @ x
        if period % 50 == 0:
            kept.append(x)
    constant("small_motion", kept)


# The arm: each link in its parent's frame, rotating about its own z axis.

with open(ORACLES / "arm_iiwa.json") as file:
    links = json.load(file)["links"]
for link in links:
    assert link["axis"] == "z"
    link["rotation"] = np.array(link["rotation"]).reshape(3, 3)
    xx, yy, zz, xy, yz, xz = link["inertia_com"]
    link["inertia"] = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    link["position"], link["com"] = np.array(link["position"]), np.array(link["com"])


def torques(q, u, a, gravity=9.81):
    """Recursive Newton-Euler equations."""
    z = np.array([0, 0, 1.0])
    omega, alpha, acceleration = np.zeros(3), np.zeros(3), np.array([0, 0, gravity])
    forces, moments, turns = [], [], []
    for i, link in enumerate(links):
        s, c = np.sin(q[i]), np.cos(q[i])
        turn = link["rotation"] @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])  # own axes in the parent's
        acceleration = turn.T @ (acceleration + np.cross(alpha, link["position"])
                                 + np.cross(omega, np.cross(omega, link["position"])))
        carried = turn.T @ omega
        alpha = turn.T @ alpha + a[i] * z + np.cross(carried, u[i] * z)
        omega = carried + u[i] * z
        centre = acceleration + np.cross(alpha, link["com"]) + np.cross(omega, np.cross(omega, link["com"]))
        forces.append(link["mass"] * centre)
        moments.append(link["inertia"] @ alpha + np.cross(omega, link["inertia"] @ omega)
                       + np.cross(link["com"], forces[-1]))
        turns.append(turn)
    found = np.zeros(len(links))
    for i in reversed(range(len(links))):
        found[i] = moments[i][2]
        if i > 0:
            force = turns[i] @ forces[i]
            forces[i - 1] += force
            moments[i - 1] += turns[i] @ moments[i] + np.cross(links[i]["position"], force)
    return found


def arm_rates(x, torque):
    q, u = x[:7], x[7:]
    rest = np.zeros(7)
    mass = np.array([torques(q, rest, unit, 0) for unit in np.eye(7)]).T
    return np.concatenate([u, np.linalg.solve(mass, torque - torques(q, u, rest))])


def arm():
    h, duration = 0.001, 2
    begin = np.array([0, -0.6, 0, 1.4, 0, -1.0, 0])
    end = np.array([1.5, 0.7, -0.8, -1.2, 1.0, 0.9, 1.5])
    way = np.poly1d([6, -15, 10, 0, 0, 0])
    start = np.concatenate([begin + 0.2 * np.array([-1, 1, -1, 1, -1, 1, -1]), np.zeros(7)])
    constant("start", start)
    x, kept, acting = start, [], []
    for period in range(2500):
        s = min(period * h / duration, 1)
        angles = begin + (end - begin) * way(s)
        speeds = (end - begin) * way.deriv()(s) / duration
        accelerations = (end - begin) * way.deriv(2)(s) / duration**2
        torque = torques(x[:7], x[7:], accelerations + 20 * (speeds - x[7:]) + 100 * (angles - x[:7]))
        x = step(lambda s: arm_rates(s, torque), x, h)
        if period % 500 == 499:
            kept.append(x)
            acting.append(torque)
    constant("states", kept)
    constant("torques", acting)


def main():
    print(f"// Written by references.py, with NumPy {np.__version__} and SciPy {scipy.__version__}.")
    print("#pragma once\n\nnamespace references {\n\n// clang-format off")
    for name, write in (("cart", cart), ("bicycle", bicycle), ("arm", arm)):
        print(f"\nnamespace {name} {{\n")
        write()
        print(f"\n}} // namespace {name}")
    print("\n// clang-format on\n\n} // namespace references")


main()
