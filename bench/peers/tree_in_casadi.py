"""The equations of a tree of links as CasADi's expressions: recursive Newton-Euler equations and composite rigid bodies
in the axes of each link (Featherstone 2008), and M u̇ = f eliminated from the tips."""

import casadi as ca


def constant(rows):
    """With zeros that products leave out."""
    return ca.SX(ca.sparsify(ca.DM(rows)))


def turn_to_parent(axis, angle):
    c, s = ca.cos(angle), ca.sin(angle)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    R = ca.SX(3, 3)
    R[axis, axis], R[j, j], R[k, k], R[j, k], R[k, j] = 1, c, c, -s, s
    return R


def turn_by_quaternion(e):
    """e1, e2, e3, e0, of norm 1."""
    x, y, z, w = ca.vertsplit(e)
    return ca.vertcat(ca.horzcat(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (z * x + w * y)),
                      ca.horzcat(2 * (x * y + w * z), 1 - 2 * (z * z + x * x), 2 * (y * z - w * x)),
                      ca.horzcat(2 * (z * x - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))


class Tree:
    def __init__(self, model):
        self.model = model
        self.q, self.u = ca.SX.sym("q", model.coordinates), ca.SX.sym("u", model.speeds)
        self.inputs = ca.SX.sym("r", model.inputs)
        self.x = ca.vertcat(self.q, self.u, self.inputs)
        self.torques = ca.vertcat(ca.SX(model.speeds - model.inputs, 1), self.inputs)
        self.first = 6 if model.floats else 0  # speeds of the link that floats
        self.to_parent, self.axes = [], []
        for i, link in enumerate(model.links):
            if link.axis < 0:
                self.to_parent.append(turn_by_quaternion(self.q[3:7]))
                self.axes.append(None)
            else:
                place = i if not model.floats else 6 + i  # its coordinate: seven of the base come before
                self.to_parent.append(constant(link.home) @ turn_to_parent(link.axis, self.q[place]))
                axis = ca.SX(3, 1)
                axis[link.axis] = 1
                self.axes.append(axis)

    def speed_of(self, i):
        return i if not self.model.floats else 5 + i

    def inverse_dynamics(self, rates):
        """The torques of rates of the speeds, gravity against them."""
        model, ground = self.model, ca.SX(3, 1)
        w, dw, a, force, moment = [], [], [], [], []
        for i, link in enumerate(model.links):
            R = self.to_parent[i].T
            if link.axis < 0:
                w.append(self.u[3:6])
                dw.append(rates[3:6])
                a.append(rates[0:3] + ca.cross(w[0], self.u[0:3]) - R @ constant(model.gravity))
            else:
                W, dW, A = (w[link.parent], dw[link.parent], a[link.parent]) if link.parent >= 0 else (
                    ground, ground, -constant(model.gravity))
                r, s, n = constant(link.joint), self.axes[i], self.speed_of(i)
                carried = R @ W
                w.append(carried + s * self.u[n])
                dw.append(R @ dW + s * rates[n] + ca.cross(carried, s * self.u[n]))
                a.append(R @ (A + ca.cross(dW, r) + ca.cross(W, ca.cross(W, r))))
            c, inertia = constant(link.centre), constant(link.inertia)
            force.append(link.mass * (a[i] + ca.cross(dw[i], c) + ca.cross(w[i], ca.cross(w[i], c))))
            moment.append(inertia @ dw[i] + ca.cross(w[i], inertia @ w[i]) + ca.cross(c, force[i]))
        torques = [None] * len(model.links)
        for i in reversed(range(len(model.links))):
            link = model.links[i]
            if link.axis < 0:
                torques[i] = ca.vertcat(force[i], moment[i])
                continue
            torques[i] = self.axes[i].T @ moment[i]
            if link.parent >= 0:
                below = self.to_parent[i] @ force[i]
                force[link.parent] += below
                moment[link.parent] += self.to_parent[i] @ moment[i] + ca.cross(constant(link.joint), below)
        return ca.vertcat(*torques)

    def mass_matrix(self):
        model, one = self.model, ca.SX.eye(3)

        def about(m, h, r):
            """What an inertia gains where it is seen from -r."""
            return 2 * ca.dot(r, h) * one - r @ h.T - h @ r.T + m * (ca.dot(r, r) * one - r @ r.T)

        mass = [link.mass for link in model.links]
        first = [link.mass * constant(link.centre) for link in model.links]
        inertia = [constant(link.inertia) + about(link.mass, ca.SX(3, 1), constant(link.centre)) for link in model.links]
        M = ca.SX(model.speeds, model.speeds)
        for i in reversed(range(len(model.links))):
            link, R = model.links[i], self.to_parent[i]
            if link.axis < 0:
                M[0:3, 0:3], M[0:3, 3:6] = mass[i] * one, -ca.skew(first[i])
                M[3:6, 0:3], M[3:6, 3:6] = ca.skew(first[i]), inertia[i]
                continue
            n, at = self.speed_of(i), i
            force, moment = ca.cross(self.axes[i], first[i]), inertia[i] @ self.axes[i]
            M[n, n] = self.axes[i].T @ moment
            while model.links[at].parent >= 0:
                force = self.to_parent[at] @ force
                moment = self.to_parent[at] @ moment + ca.cross(constant(model.links[at].joint), force)
                at = model.links[at].parent
                k = self.speed_of(at)
                if model.links[at].axis < 0:
                    M[0:6, n] = ca.vertcat(force, moment)
                    M[n, 0:6] = M[0:6, n].T
                else:
                    M[k, n] = M[n, k] = self.axes[at].T @ moment
            if link.parent >= 0:
                h, r = R @ first[i], constant(link.joint)
                mass[link.parent] += mass[i]
                first[link.parent] += h + mass[i] * r
                inertia[link.parent] += R @ inertia[i] @ R.T + about(mass[i], h, r)
        return M


def solve(M, right):
    """X in M X = right, by M = Lᵀ D L from the last unknown to the first, which keeps the zeros of a tree."""
    n = M.shape[0]
    A, b = ca.SX(M), ca.SX(right)
    for k in reversed(range(n)):
        for i in range(k):
            if A[i, k].nnz() == 0 or A[i, k].is_zero():
                continue
            ratio = A[i, k] / A[k, k]
            for j in range(i + 1):
                if A[k, j].nnz() and not A[k, j].is_zero():
                    A[i, j] -= ratio * A[k, j]
                    A[j, i] = A[i, j]
            b[i, :] -= ratio * b[k, :]
    for i in range(n):
        for j in range(i):
            if A[i, j].nnz() and not A[i, j].is_zero():
                b[i, :] -= A[i, j] * b[j, :]
        b[i, :] = b[i, :] / A[i, i]
    return b


def results(model):
    """x = [q; u; r], and for each result the expressions, in one or several ways."""
    tree = Tree(model)
    M = tree.mass_matrix()
    f = tree.torques - tree.inverse_dynamics(ca.SX(model.speeds, 1))
    udot = solve(M, f)
    rates = ca.SX.sym("a", model.speeds)
    left = tree.torques - tree.inverse_dynamics(rates)
    change = ca.substitute(ca.jacobian(left, tree.x), rates, udot)
    return tree.x, {
        "mass_matrix_and_forcing": [ca.vertcat(ca.vec(M), f)],
        "udot": [udot],
        "udot_derivatives": [ca.vec(solve(M, change)), ca.vec(ca.jacobian(udot, tree.x))],
    }
