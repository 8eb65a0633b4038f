#!/usr/bin/env python3
"""compare_with_pinocchio.py RESULTS [FILE...]: compares mass matrix, forcing, u' and energies of robots with Pinocchio's, at
random states, on a fixed and on a floating base. RESULTS is the program of results.cpp; without files all URDF files
of example-robot-data are compared. Prints a line for each, and ends with an error where one disagrees.

compare_with_pinocchio.py --write FOLDER RESULTS FILE... writes the references of tests/robots instead."""
import pathlib
import subprocess
import sys

import numpy as np
import pinocchio as pin

TOLERANCE = 1e-11  # relative to the largest entry
STATES = 5


def all_files():
    """Those of example-robot-data, wherever it is in this environment."""
    return sorted(p for p in pathlib.Path(sys.prefix).rglob("*.urdf") if "example-robot-data" in p.parts)


def results_of(program, file, base):
    told = subprocess.run([program, str(file), base, str(STATES)], capture_output=True, text=True, timeout=600)
    if told.returncode != 0:
        return {"mistake": f"CRASH {told.returncode}: {told.stderr[-200:]}"}
    read = {"joints": [], "follows": [], "states": []}
    for line in told.stdout.splitlines():
        word, _, rest = line.partition(" ")
        if word == "mistake":
            return {"mistake": rest}
        if word == "joint":
            kind, q, u, driven, name = rest.split(" ", 4)
            read["joints"].append((name, int(q), int(u), driven == "1"))
        elif word == "follows":
            multiplier, offset, leader, name = rest.split(" ", 3)
            read["follows"].append((name, float(multiplier), float(offset), int(leader)))
        elif word == "operations":
            read["operations"] = [int(n) for n in rest.split()]
        elif word == "status":
            read["states"][-1]["status"] = rest
        else:
            if word == "state":
                read["states"].append({})
            read["states"][-1][word] = np.array([float(n) for n in rest.split()])
    return read


class Peer:
    """A model of Pinocchio in which all joints move by themselves; its q and v are those that ours give."""

    def __init__(self, file, base, ours):
        root = [pin.JointModelFreeFlyer()] if base == "floating" else []
        self.model = pin.buildModelFromUrdf(str(file), *root)
        self.data = self.model.createData()
        self.moves = [(self.joint(name), q, u, 1.0, 0.0) for name, q, u, _ in ours["joints"]]
        for name, multiplier, offset, leader in ours["follows"]:
            _, q, u, _ = ours["joints"][leader]
            self.moves.append((self.joint(name), q, u, multiplier, offset))
        self.driven = [u for _, _, u, driven in ours["joints"] if driven]
        self.speeds = max(u + j.nv for j, _, u, _, _ in self.moves)
        if sum(j.nv for j, *_ in self.moves) != self.model.nv:
            raise LookupError(f"Pinocchio has {self.model.nv} speeds, we have others")

    def joint(self, name):
        if not self.model.existJointName(name):
            raise LookupError(f"Pinocchio has no joint {name}")
        return self.model.joints[self.model.getJointId(name)]

    def q(self, ours):
        q = pin.neutral(self.model)
        for j, at, _, multiplier, offset in self.moves:
            if j.nq == 7:
                q[j.idx_q : j.idx_q + 7] = ours[at : at + 7]
            elif j.nq == 4:  # planar
                x, y, angle = ours[at : at + 3]
                q[j.idx_q : j.idx_q + 4] = x, y, np.cos(angle), np.sin(angle)
            elif j.nq == 2:  # continuous
                angle = multiplier * ours[at] + offset
                q[j.idx_q : j.idx_q + 2] = np.cos(angle), np.sin(angle)
            else:
                q[j.idx_q] = multiplier * ours[at] + offset
        return q

    def by_ours(self, q, u):
        """G and its rate, v = G u: in a plane we have velocities in the axes of the plane, Pinocchio in its own."""
        by, rate = np.zeros((self.model.nv, self.speeds)), np.zeros((self.model.nv, self.speeds))
        for j, at, of_u, multiplier, _ in self.moves:
            rows, columns = slice(j.idx_v, j.idx_v + j.nv), slice(of_u, of_u + j.nv)
            by[rows, columns] = multiplier * np.eye(j.nv)
            if j.nq == 4:
                c, s, w = np.cos(q[at + 2]), np.sin(q[at + 2]), u[of_u + 2]
                by[j.idx_v : j.idx_v + 2, of_u : of_u + 2] = [[c, s], [-s, c]]
                rate[j.idx_v : j.idx_v + 2, of_u : of_u + 2] = w * np.array([[-s, c], [-c, -s]])
        return by, rate

    def results(self, state):
        ours, u = state["state"], state["state"][-self.speeds :]
        q, (by, rate) = self.q(ours), self.by_ours(ours, u)
        v = by @ u
        mass = pin.crba(self.model, self.data, q)
        mass = np.triu(mass) + np.triu(mass, 1).T
        forcing = -by.T @ (pin.nonLinearEffects(self.model, self.data, q, v) + mass @ rate @ u)
        forcing[self.driven] += state["inputs"]
        mass = by.T @ mass @ by
        return {
            "mass": mass,
            "forcing": forcing,
            "kinetic": pin.computeKineticEnergy(self.model, self.data, q, v),
            "potential": pin.computePotentialEnergy(self.model, self.data, q),
        }


def apart(ours, theirs):
    ours, theirs = np.ravel(ours), np.ravel(theirs)
    return float(np.max(np.abs(ours - theirs)) / max(np.max(np.abs(theirs)), 1e-300))


def compare(program, file, base):
    ours = results_of(program, file, base)
    if "mistake" in ours:
        return "refused", ours["mistake"]
    peer = Peer(file, base, ours)
    worst = dict.fromkeys(["mass", "forcing", "udot", "energies"], 0.0)
    condition = 0.0
    for state in ours["states"]:
        theirs = peer.results(state)
        worst["mass"] = max(worst["mass"], apart(state["mass"], theirs["mass"]))
        worst["forcing"] = max(worst["forcing"], apart(state["forcing"], theirs["forcing"]))
        energies = [[s["kinetic"], s["potential"]] for s in (state, theirs)]
        worst["energies"] = max(worst["energies"], apart(*energies))
        # Of a mass matrix that is nearly singular u' has few digits, so it is M u' that is compared.
        terms = np.abs(theirs["mass"]) @ np.abs(state["udot"])
        rest = theirs["mass"] @ state["udot"] - theirs["forcing"]
        worst["udot"] = max(worst["udot"], float(np.max(np.abs(rest)) / np.max(terms)))
        condition = max(condition, np.linalg.cond(theirs["mass"]))
        if state["status"]:
            return "singular", state["status"]
    told = " ".join(f"{what} {value:.1e}" for what, value in worst.items())
    told += f" cond {condition:.0e} operations {ours['operations']}"
    return "agrees" if max(worst.values()) <= TOLERANCE else "DIFFERS", told


def write_reference(program, file, base, folder):
    """What tests compare with: states, inputs, and the results of Pinocchio there, a word and its numbers in a line."""
    ours = results_of(program, file, base)
    if "mistake" in ours:
        return  # a root without mass cannot float
    peer, lines = Peer(file, base, ours), []
    for state in ours["states"][:2]:
        theirs = peer.results(state)
        told = {"state": state["state"], "inputs": state["inputs"], **theirs}
        told["udot"] = np.linalg.solve(theirs["mass"], theirs["forcing"])
        lines += [" ".join([word, *(repr(float(n)) for n in np.ravel(value))]) for word, value in told.items()]
    (folder / f"{file.stem}.{base}.txt").write_text("\n".join(lines) + "\n")


def main():
    if sys.argv[1] == "--write":
        folder, program, files = pathlib.Path(sys.argv[2]), sys.argv[3], [pathlib.Path(f) for f in sys.argv[4:]]
        for file in files:
            for base in ("fixed", "floating"):
                write_reference(program, file, base, folder)
        return 0
    program, files = sys.argv[1], [pathlib.Path(f) for f in sys.argv[2:]] or all_files()
    counts = {}
    for file in files:
        for base in ("fixed", "floating"):
            try:
                verdict, told = compare(program, file, base)
            except (LookupError, ValueError, RuntimeError) as error:
                verdict, told = "not compared", str(error)
            except subprocess.TimeoutExpired:
                verdict, told = "DIFFERS", "takes more than 10 minutes"
            counts[verdict] = counts.get(verdict, 0) + 1
            print(f"{file.parent.parent.name}/{file.name}\t{base}\t{verdict}\t{told}", flush=True)
    print(counts)
    return 1 if "DIFFERS" in counts or any("CRASH" in v for v in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
