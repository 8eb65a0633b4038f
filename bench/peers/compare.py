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
    return [with_kanexpr.Compiled("clang++-19"), with_kanexpr.Interpreted(), with_pinocchio.Traced("gcc"),
            with_pinocchio.Traced("clang-19"), with_pinocchio.Algorithms(), with_casadi.Generated(),
            with_mujoco.Algorithms(), with_sympy.Generated(), with_sympy.Lambdified()]


def evaluated(offer, state, room):
    if offer.is_python:
        return [float(e) for e in offer.call(state)]
    argument = (ctypes.c_double * len(state))(*state)
    result = (ctypes.c_double * room)(*[float("nan")] * room)
    offer.call(argument, result)
    return list(result)


def states_of(offer, states):
    return [offer.state_of(x) for x in states] if offer.state_of else states


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
        return timing.NativeLoop(self.timer, offer.call, states, room)

    def of(self, result, reference, offer):
        """One cell of the table."""
        room = agreement.room(self.model, result)
        theirs = [trimmed(evaluated(offer, x, room)) for x in states_of(offer, self.states)]
        ours = [trimmed(evaluated(reference, x, room)) for x in self.states]
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
        tools = [", ".join(shop.versions.values()), " ".join(MARCH), ", ".join(report.packages())]
        report.write(measured, tools, with_pinocchio.Traced.tracer(shop), folder)
    return report.worst(measured)


if __name__ == "__main__":
    sys.exit(main())
