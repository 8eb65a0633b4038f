#!/usr/bin/env python3
"""Tests the scripts of bench/peers without the peers: peers_test.py COMPILER FOLDER."""

import math
import random
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "bench/peers"))

import agreement
import compare
import operations
import report
import timing
import with_kanexpr
from build import Built, Shop
from model import read_model, read_states
from peer import RESULTS

COMPILER, FOLDER = sys.argv.pop(1), Path(sys.argv.pop(1))


class Requirements(unittest.TestCase):
    def test_every_version_is_pinned(self):
        for line in (ROOT / "bench/peers/requirements.txt").read_text().splitlines():
            self.assertRegex(line, r"^[A-Za-z][\w-]*==\d+(\.\d+)+$")


class Operations(unittest.TestCase):
    def test_signs_exponents_pointers_and_comments_count_nothing(self):
        self.assertEqual(operations.in_code("void f(const double* x) { /* a = b * c; */ y[0] = -x[1] * 1e-05; }"), 1)

    def test_products_sums_and_squares_count_one(self):
        self.assertEqual(operations.in_code("a = (x[0] * -2. + 3) - sin(b);\n if (r[0]!=0) r[0][0]=casadi_sq(a);"), 4)


def made_up(ratio, **more):
    return {"operations": 100, "apart": 1e-15, "ratio": ratio, "lower": 0.99 * ratio, "upper": 1.01 * ratio,
            "reference": 150.4, **more}


MEASURED = {
    "iiwa": {"kanexpr": {result: made_up(1, seconds=1.25, megabytes=300.2, code=4000) for result in RESULTS},
             "another": {"udot": made_up(2.345)}, "a third": "it has no joints"},
    "bicycle": {"kanexpr": {result: made_up(1) for result in RESULTS}},
}


class Report(unittest.TestCase):
    def test_table(self):
        lines = report.table(MEASURED).splitlines()
        self.assertEqual(lines[2].split("|")[1].strip(), "**KUKA iiwa** (150, 150, 150 ns)")
        self.assertEqual(lines[3], "| kanexpr | 100 | 1.00 (0.990–1.01) | 100 | 1.00 (0.990–1.01) | 100 | "
                                   "1.00 (0.990–1.01) | 3.8 | 300 | 12.0 | 1e-15 |")
        self.assertIn("| another | – | – | 100 | 2.35 (2.32–2.37) | – | – | – | – | – | 1e-15 |", lines)
        self.assertIn("| a third | it has no joints |", lines[5])
        self.assertEqual(len(set(line.count("|") for line in lines)), 1)

    def test_page_has_its_place(self):
        page = (ROOT / "docs/measured.md").read_text()
        text = report.section(MEASURED, ["c++ 1", "-O3", "peer 1"], Built("", 193.4, 4847.6, 0))
        written = report.replaced(page, text)
        self.assertIn("it has no joints", written)
        self.assertIn("takes 193 s and 4848 MB", written)
        self.assertEqual(report.replaced(written, text), written)

    def test_figure(self):
        blocks = report.points(MEASURED).split("\n\n\n")
        self.assertEqual([block.splitlines()[0] for block in blocks], ['"kanexpr"', '"another"', '"a third"'])
        self.assertEqual(blocks[1].splitlines()[1], "0 1 2.345 2.32155 2.36845")

    def test_disagreement_is_reported(self):
        self.assertEqual(report.worst(MEASURED), 0)
        self.assertEqual(report.worst({"iiwa": {"wrong": {"udot": made_up(1, apart=math.nan)}}}), 1)


class Agreement(unittest.TestCase):
    def test_elimination(self):
        x = agreement.solved([[0, 2, 1], [1, 1, 0], [3, 0, 1]], [7, 3, 6])
        for found, expected in zip(x, [1, 2, 3]):
            self.assertAlmostEqual(found, expected)

    def test_rates_of_a_quaternion_turn_its_axes(self):
        """Ṙ v = R (ω × v), by differences."""
        source = random.Random(3)
        e = [source.gauss(0, 1) for _ in range(4)]
        x = [0, 0, 0, *(entry / math.hypot(*e) for entry in e)]
        speeds = [source.gauss(0, 1) for _ in range(6)]
        rates, h = agreement.times(agreement.rates_of_speeds(x), speeds), 1e-6
        v = [1, 2, 3]
        ends = [agreement.times(agreement.rotation([a + way * h * b for a, b in zip(x, rates)]), v)
                for way in (1, -1)]
        expected = agreement.times(agreement.rotation(x), agreement.cross(speeds[3:], v))
        for after, before, rate in zip(*ends, expected):
            self.assertAlmostEqual((after - before) / (2 * h), rate, places=8)


class Harness(unittest.TestCase):
    def test_states_stand_side_by_side(self):
        self.assertEqual(timing.side_by_side([[1, 2], [3, 4], [5, 6], [7, 8]], 2), [[1, 3, 2, 4], [5, 7, 6, 8]])
        self.assertEqual(compare.parts([6, 7, 0, 5], [(3, 1), (0, 2)]), [5, 6, 7])

    def test_compiled_beside_interpreted(self):
        shop, flags = Shop(FOLDER / "built"), ["-O0", "-std=c++20"]
        models = with_kanexpr.write_models(shop, COMPILER, FOLDER / "models", flags)
        compiled = with_kanexpr.Compiled(COMPILER, flags)
        interpreted = with_kanexpr.Interpreted(COMPILER, flags)
        model = read_model(models / "pendulum6.model")
        self.assertEqual((model.coordinates, model.speeds, model.inputs, len(model.links)), (6, 6, 0, 6))
        self.assertEqual(model.links[5].joint, [1, 0, 0])
        at_once = with_kanexpr.Compiled(COMPILER, flags, lanes=2, results=["mass_matrix_and_forcing"])
        many = with_kanexpr.Many(COMPILER, 64, flags)
        measured = compare.compare(model, read_states(models / "pendulum6.states"), [interpreted, at_once, many],
                                   compiled, shop, models, compare.timer_of(shop, COMPILER), pairs=3)
        cells = measured[interpreted.name]
        self.assertEqual(list(cells), RESULTS)
        self.assertEqual(list(measured[at_once.name]), ["mass_matrix_and_forcing"])
        self.assertEqual(list(measured[many.name]), ["udot_derivatives"])
        for cell in [cell for peer in (interpreted, at_once, many) for cell in measured[peer.name].values()]:
            self.assertLess(cell["apart"], 1e-13)
            self.assertGreater(cell["ratio"], 0)
        self.assertGreater(measured[compiled.name]["udot"]["code"], 0)
        self.assertTrue(re.search("pendulum6\tkanexpr, interpreted\t", report.as_text(model.name, interpreted.name, cells)))


if __name__ == "__main__":
    unittest.main()
