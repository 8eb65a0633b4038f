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


PAGE, LINE = 4096, 64  # bytes


def aligned(numbers):
    """An array of C that begins with a page of memory, so that where it lies does not matter."""
    memory = (ctypes.c_double * (len(numbers) + PAGE // 8))()
    begin = (ctypes.c_double * len(numbers)).from_buffer(memory, -ctypes.addressof(memory) % PAGE)
    begin[:] = numbers
    return begin


def side_by_side(states, lanes):
    """Groups of states, each as one: the first entry of all, the second entry of all, …"""
    return [[entry for entries in zip(*states[i:i + lanes]) for entry in entries]
            for i in range(0, len(states), lanes)]


class NativeLoop:
    """Calls a function of a library for each of some states, or for groups of them."""

    def __init__(self, timer, call, states, room, lanes=1):
        self.timer = timer.nanoseconds
        self.timer.restype = ctypes.c_double
        groups = side_by_side(states, lanes)
        self.call = ctypes.cast(call, ctypes.c_void_p)
        entries = [entry for group in groups for entry in group]
        begin = -len(entries) % (LINE // 8) + len(entries)  # of the result, on the next line of the cache
        self.states = aligned([*entries, *[0.0] * (begin - len(entries) + room * lanes)])
        self.groups, self.width, self.count = len(groups), len(groups[0]), len(states)
        self.result = ctypes.byref(self.states, 8 * begin)

    def take(self, turns):
        """Nanoseconds for one state."""
        taken = self.timer(self.call, self.states, self.groups, self.width, self.result, turns)
        return taken * self.groups / self.count


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
