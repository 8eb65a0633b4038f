#!/usr/bin/env python3
"""Builds the peers, compares their results and times with those of kanexpr, and writes what was measured:
compare.py FOLDER [MODEL...] builds in FOLDER. Without models it takes all, and writes into docs/measured.md.

KANEXPR_NICE is put before compilers.
"""

import ctypes
import json
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import agreement
import report
import timing
import with_casadi
import with_kanexpr
import with_mujoco
import with_pinocchio
import with_sympy
from build import Shop
from model import read_model, read_states
from peer import CXX, HERE, MARCH, RESULTS, Without

REFERENCE = with_kanexpr.Compiled("g++")


def peers():
    side_by_side = [with_kanexpr.Compiled(compiler, lanes=lanes) for lanes in (4, 8) for compiler in ("g++", "clang++-19")]
    return [with_kanexpr.Compiled("clang++-19"), *side_by_side, with_kanexpr.Many("g++", MANY), with_kanexpr.Interpreted(),
            with_pinocchio.Traced("gcc"), with_pinocchio.Traced("clang-19"), with_pinocchio.Algorithms(),
            with_casadi.Generated(), with_mujoco.Algorithms(), with_sympy.Generated(), with_sympy.Lambdified()]


ROOM = 64  # numbers beside a result: statuses
MANY = 256  # systems at once


def parts(values, places):
    """The parts of a result one after another."""
    return [entry for first, count in places for entry in values[first:first + count]]


def evaluated(offer, states, room):
    """The results at all states."""
    if offer.is_python:
        return [[float(e) for e in offer.call(x)] for x in states]
    results = []
    for group in timing.side_by_side(states, offer.lanes):
        argument = timing.aligned(group)
        result = timing.aligned([float("nan")] * ((room + ROOM) * offer.lanes))
        offer.call(argument, result)
        if offer.found:
            offer.found(result)
        each = [result[lane::offer.lanes] for lane in range(offer.lanes)]
        results += [parts(one, offer.places) if offer.places else trimmed(one) for one in each]
    return results


def states_of(offer, states):
    """In the coordinates of a peer, and as many as its calls take."""
    theirs = [offer.state_of(x) for x in states] if offer.state_of else states
    return theirs * max(1, offer.lanes // len(theirs))


def trimmed(values):
    """Without what was not written."""
    while values and values[-1] != values[-1]:
        values = values[:-1]
    return values


class Comparison:
    def __init__(self, model, states, timer, pairs):
        self.model, self.states, self.timer, self.pairs = model, states, timer, pairs

    def loop(self, offer, room):
        states = states_of(offer, self.states)
        if offer.is_python:
            return timing.PythonLoop(offer.call, states)
        return timing.NativeLoop(self.timer, offer.call, states, room + ROOM, offer.lanes)

    def of(self, result, reference, offer):
        """One cell of the table."""
        room = agreement.room(self.model, result)
        theirs = evaluated(offer, states_of(offer, self.states), room)
        ours = evaluated(reference, self.states, room)
        apart = max(agreement.apart(self.model, result, offer.form, *each)
                    for each in zip(self.states, ours, theirs))
        ratio = timing.compare(self.loop(reference, room), self.loop(offer, room), self.pairs)
        cell = {"operations": offer.operations, "apart": apart, "ratio": ratio.median, "lower": ratio.lower,
                "upper": ratio.upper, "reference": ratio.reference}
        if offer.built:
            cell.update(seconds=offer.built.seconds, megabytes=offer.built.megabytes, code=offer.built.code)
        return cell


def compare(model, states, contenders, reference, shop, models, timer, pairs=timing.PAIRS):
    """For each contender the cells by result, or why there is none."""
    ours = reference.offers(model, shop, models)
    comparison = Comparison(model, states, timer, pairs)
    found = {}
    for contender in [reference, *contenders]:
        offers = contender.offers(model, shop, models)
        if isinstance(offers, Without):
            found[contender.name] = offers.reason
            continue
        found[contender.name] = {result: comparison.of(result, ours[result], offers[result]) for result in RESULTS
                                 if result in offers}
        print(report.as_text(model.name, contender.name, found[contender.name]), flush=True)
    return found


def timer_of(shop, compiler="g++"):
    return ctypes.CDLL(shop.build(compiler, HERE / "timing.cpp", CXX).path)


def main():
    folder, wanted = Path(sys.argv[1]).resolve(), sys.argv[2:]
    shop = Shop(folder / "built", os.environ.get("KANEXPR_NICE", "").split())
    models = with_kanexpr.write_models(shop, "g++", folder / "models")
    timer = timer_of(shop)
    measured = {}
    for name in wanted or list(with_kanexpr.SYSTEMS):
        model = read_model(models / f"{name}.model")
        measured[name] = compare(model, read_states(models / f"{name}.states"), peers(), REFERENCE, shop, models, timer)
    (folder / "measured.json").write_text(json.dumps(measured, indent=1))
    if not wanted:
        tools = [", ".join(dict.fromkeys(shop.versions.values())), " ".join(MARCH), ", ".join(report.packages())]
        report.write(measured, tools, with_pinocchio.Traced.tracer(shop), folder)
    return report.worst(measured)


if __name__ == "__main__":
    sys.exit(main())
