"""Times calls in pairs: one of the reference, one of another, over and over, so that what else the machine does meets
both."""

import ctypes
import statistics
import time
from dataclasses import dataclass

PAIRS = 61
SLICE = 0.7e6  # nanoseconds that a call is repeated for, short enough that few slices are interrupted


@dataclass
class Ratio:
    """Of times, to the reference: the median and the quartiles of the pairs."""
    median: float
    lower: float
    upper: float
    reference: float  # nanoseconds of one call of the reference, the median


class NativeLoop:
    """Calls a function of a library for each of some states."""

    def __init__(self, timer, call, states, room):
        self.timer = timer.nanoseconds
        self.timer.restype = ctypes.c_double
        flat = [entry for state in states for entry in state]
        self.call = ctypes.cast(call, ctypes.c_void_p)
        self.states = (ctypes.c_double * len(flat))(*flat)
        self.count, self.width = len(states), len(states[0])
        self.result = (ctypes.c_double * room)()

    def take(self, turns):
        return self.timer(self.call, self.states, self.count, self.width, self.result, turns)


class PythonLoop:
    """Calls a function of Python for each of some states."""

    def __init__(self, call, states):
        self.call, self.states, self.count = call, states, len(states)

    def take(self, turns):
        call, states = self.call, self.states
        start = time.perf_counter_ns()
        for _ in range(turns):
            for state in states:
                call(state)
        return (time.perf_counter_ns() - start) / turns / len(states)


def turns_for(loop):
    return max(1, round(SLICE / (min(loop.take(1) for _ in range(3)) * loop.count)))


def compare(reference, other, pairs=PAIRS):
    turns = [turns_for(loop) for loop in (reference, other)]
    ratios, own = [], []
    for i in range(pairs):
        if i % 2 == 0:
            a, b = reference.take(turns[0]), other.take(turns[1])
        else:
            b, a = other.take(turns[1]), reference.take(turns[0])
        ratios.append(b / a)
        own.append(a)
    lower, median, upper = statistics.quantiles(ratios, n=4)
    return Ratio(median, lower, upper, statistics.median(own))
