"""Uses FMUs through the functions of FMI 3.0, as a tool does: fmi_test.py FOLDER, with modules of the same models in fmus/modules."""

import ctypes
import importlib
import math
import pathlib
import sys
import threading
import xml.etree.ElementTree as xml
import zipfile

folder = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(folder / "fmus" / "modules"))
sys.dont_write_bytecode = True

import bead
import sliding

OK, DISCARD, ERROR = 0, 2, 3
double, flag, size = ctypes.c_double, ctypes.c_bool, ctypes.c_size_t
Log = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)


class Fmu:
    def __init__(self, name):
        with zipfile.ZipFile(folder / f"{name}.fmu") as archive:
            assert archive.testzip() is None
            assert {f"sources/{name}{end}" for end in (".c", ".h", "_fmi.c")} < set(archive.namelist())
            archive.extractall(folder / "fmus" / name)
        description = xml.parse(folder / "fmus" / name / "modelDescription.xml").getroot()
        self.token = description.get("instantiationToken")
        variables = list(description.find("ModelVariables"))
        self.names = [each.get("name") for each in variables]
        assert [int(each.get("valueReference")) for each in variables] == list(range(len(variables)))
        assert len(set(self.names)) == len(self.names)
        self.units = {each.get("name"): each.find("BaseUnit").attrib for each in description.iter("Unit")}
        self.unit = {each.get("name"): each.get("unit") for each in variables if each.get("unit")}
        assert set(self.unit.values()) == set(self.units), "each unit is defined and used"
        self.of_model = {each.get("name"): each.get("description") for each in variables if each.get("description")}
        self.start = {each.get("name"): float(each.get("start")) for each in variables if each.get("start")}
        self.attributes = {each.get("name"): each.attrib for each in variables}
        of_rates = [int(each.get("valueReference"))
                    for each in description.find("ModelStructure").iter("ContinuousStateDerivative")]
        self.states = [self.names[int(variables[i].get("derivative"))] for i in of_rates]
        self.rates = [self.names[i] for i in of_rates]
        self.indicators = len(list(description.find("ModelStructure").iter("EventIndicator")))
        [library] = (folder / "fmus" / name / "binaries").glob(f"*/{name}.*")
        self.library = ctypes.CDLL(str(library))
        self.library.fmi3GetVersion.restype = ctypes.c_char_p
        assert self.library.fmi3GetVersion() == b"3.0"
        for kind in ("ModelExchange", "CoSimulation", "ScheduledExecution"):
            getattr(self.library, "fmi3Instantiate" + kind).restype = ctypes.c_void_p

    def references(self, names):
        return (ctypes.c_uint32 * len(names))(*map(self.names.index, names)), size(len(names))


class Instance:
    def __init__(self, fmu, kind, token=None):
        self.fmu, self.told = fmu, []
        self.log = Log(lambda _, status, category, message: self.told.append((status, message.decode())))
        given = [b"one", (token or fmu.token).encode(), None, flag(False), flag(True)]
        if kind == "CoSimulation":
            given += [flag(False), flag(False), None, size(0)]
        given += [None, self.log]
        if kind == "CoSimulation":
            given.append(None)
        self.pointer = ctypes.c_void_p(getattr(fmu.library, "fmi3Instantiate" + kind)(*given))

    def status(self, function, *given):
        return getattr(self.fmu.library, "fmi3" + function)(self.pointer, *given)

    def __getattr__(self, function):
        def call(*given):
            status = self.status(function, *given)
            assert status == OK, (function, status, self.told)
        return call

    def enter_initialization(self, tolerance=None, start=0):
        return self.status("EnterInitializationMode", flag(tolerance is not None), double(tolerance or 0), double(start),
                           flag(False), double(0))

    def initialize(self, tolerance=None, **values):
        assert self.enter_initialization(tolerance) == OK
        self.set(values)
        self.ExitInitializationMode()
        return self

    def status_of_set(self, values):
        references, count = self.fmu.references(list(values))
        return self.status("SetFloat64", references, count, (double * len(values))(*values.values()), count)

    def set(self, values):
        assert self.status_of_set(values) == OK, self.told

    def get(self, *names):
        references, count = self.fmu.references(names)
        found = (double * len(names))()
        self.GetFloat64(references, count, found, count)
        return list(found)

    def row(self, function, count):
        found = (double * count)()
        getattr(self, "Get" + function)(found, size(count))
        return list(found)

    def state(self):
        return self.row("ContinuousStates", len(self.fmu.states))

    def at(self, t, x):
        self.SetTime(double(t))
        self.SetContinuousStates((double * len(x))(*x), size(len(x)))

    def rates(self):
        return self.row("ContinuousStateDerivatives", len(self.fmu.states))

    def product(self, which, unknowns, knowns, seed):
        (u, count), (k, known_count) = self.fmu.references(unknowns), self.fmu.references(knowns)
        found = (double * (len(unknowns) if which == "Directional" else len(knowns)))()
        status = self.status(f"Get{which}Derivative", u, count, k, known_count, (double * len(seed))(*seed), size(len(seed)),
                             found, size(len(found)))
        return list(found) if status == OK else status

    def events(self):
        """Whether anything had to change, and whether the motion ends."""
        again, ends, nominals, changed, has_time = [flag() for _ in range(5)]
        self.UpdateDiscreteStates(*map(ctypes.byref, (again, ends, nominals, changed, has_time)), ctypes.byref(double()))
        assert not again and not nominals and not has_time
        return changed.value, ends.value

    def wants_event_mode(self):
        wanted, ends = flag(), flag()
        self.CompletedIntegratorStep(flag(True), ctypes.byref(wanted), ctypes.byref(ends))
        assert not ends
        return wanted.value

    def step(self, t, length):
        reached = double()
        status = self.status("DoStep", double(t), double(length), flag(True), *[ctypes.byref(flag()) for _ in range(3)],
                             ctypes.byref(reached))
        return status, reached.value

    def free(self):
        self.fmu.library.fmi3FreeInstance(self.pointer)


def near(found, expected, tolerance):
    assert len(found) == len(expected)
    assert all(abs(a - b) <= tolerance * max(1, abs(b)) for a, b in zip(found, expected)), (found, expected)


def exchange(fmu, **values):
    made = Instance(fmu, "ModelExchange").initialize(**values)
    made.events()
    made.EnterContinuousTimeMode()
    return made


def stepped(fmu, x, count, **values):
    """A co-simulation with its internal step."""
    made, motion = Instance(fmu, "CoSimulation").initialize(**x, **values), []
    for k in range(count):
        status, reached = made.step(k / 8, 1 / 8)
        assert (status, reached) == (OK, (k + 1) / 8), made.told
        motion.append(made.get(*fmu.states))
    made.free()
    return motion


# Rates, outputs and derivatives of a pendulum, compared with closed forms; start values; tunable parameters.
pendulum = Fmu("pendulum")
assert pendulum.start == {"q": 0.3, "u": 0, "m": 2, "l": 0.5, "g": 9.81, "c": 0.1, "T": 0}
assert all(pendulum.attributes[p]["variability"] == "tunable" for p in "mlgc")
one = exchange(pendulum)
assert one.state() == [0.3, 0.0]
for q, u, T, l in ((0.4, 0.7, 0.0, 0.5), (-2.0, 1.1, 0.3, 0.8)):
    one.EnterEventMode()
    one.set({"T": T, "l": l})
    one.EnterContinuousTimeMode()
    one.at(0.5, [q, u])
    inertia = 2 * l * l
    near(one.rates(), [u, (T - 0.1 * u) / inertia - 9.81 / l * math.sin(q)], 1e-14)
    near(one.get("tip[1]", "tip[2]", "tip[3]", "kinetic_energy", "time"),
         [l * math.cos(q), l * math.sin(q), 0, inertia * u * u / 2, 0.5], 1e-14)
    unknowns, knowns = ["der(q)", "der(u)", "kinetic_energy"], ["q", "u", "T"]
    slopes = [[0, 1, 0], [-9.81 / l * math.cos(q), -0.1 / inertia, 1 / inertia], [0, inertia * u, 0]]
    for k in range(3):
        seed = [float(i == k) for i in range(3)]
        near(one.product("Directional", unknowns, knowns, seed), [row[k] for row in slopes], 1e-14)
        near(one.product("Adjoint", unknowns, knowns, seed), slopes[k], 1e-14)
assert not one.wants_event_mode()

# Results that do not exist are discarded and reported.
one.EnterEventMode()
one.set({"m": 0})
one.EnterContinuousTimeMode()
assert one.status("GetContinuousStateDerivatives", (double * 2)(), size(2)) == DISCARD
assert one.told[0] == (DISCARD, "the mass matrix is singular at this state: its elimination fails at the speed u")
one.set({"m": 2})
one.rates()

# Angles may be arbitrarily large, as in a simulation.
one.at(0.5, [2e5, 0.0])
near(one.rates(), [0, 0.3 / inertia - 9.81 / 0.8 * math.sin(2e5)], 1e-14)

# Unknown requests are errors.
references, count = pendulum.references(["der(q)"])
assert one.status("SetFloat64", references, count, (double * 1)(), count) == ERROR
assert one.told[-1] == (ERROR, "this variable cannot be set")
assert one.status("GetString", references, count, None, count) == ERROR
assert one.told[-1] == (ERROR, "fmi3GetString is not supported")
assert one.status("ExitInitializationMode") == ERROR
one.Terminate()
one.Reset()
one.initialize(q=1.5)
assert one.get("q", "m", "l") == [1.5, 2, 0.5], "reset to the values of the model"
one.free()
other = Instance(pendulum, "ModelExchange", token="{another}")
assert not other.pointer and other.told == [(ERROR, "the instantiation token belongs to a different model description")]

# Names that XML or C do not allow
strange = Fmu("strange")
assert strange.states == ["time", "ω <&>"] and strange.rates == ["der(time)_", "der(ω <&>)"]
assert strange.names[0] == "time_"
assert strange.of_model == {'"a_b_': '"a_b_ in the model', "der(ω <&>)_": "der(ω <&>) in the model"}
one = exchange(strange)
one.at(0.7, [0.2, 3.0])
near(one.get("time", "time_", '"a_b_', "der(ω <&>)_"), [0.2, 0.7, 0.6, 0.04], 1e-15)
near(one.rates(), [3, 2 * math.sin(1.4) * math.cos(0.2) / 6 - 9.81 / 2 * math.sin(0.2)], 1e-14)
near(one.product("Directional", ["der(ω <&>)"], ["time_"], [1.0]), [4 * math.cos(1.4) * math.cos(0.2) / 6], 1e-13)
one.free()

# Events that end the motion, and events that do not
one = Instance(strange, "CoSimulation").initialize()
ends, reached = flag(), double()
one.DoStep(double(0), double(1), flag(True), ctypes.byref(flag()), ctypes.byref(ends), ctypes.byref(flag()),
           ctypes.byref(reached))
assert ends and abs(reached.value - 0.5) < 1e-15
one.free()
one = Instance(strange, "CoSimulation").initialize(**{"time": 0.01, "ω <&>": -1.0})
status, reached = one.step(0, 1)
assert status == DISCARD and one.told == [(DISCARD, "more than 100 events happen in one internal step")]
assert 0.0099 < reached < 0.0101
near(one.get("time", "time_"), [0, reached], 1e-12)
one.free()

# A bouncing ball compared with closed forms
ball = Fmu("ball")
restitution, g, height = 0.8, 9.81, 1.2


def bounced(t):
    v, fallen = 0.0, math.sqrt(2 * height / g)
    if t < fallen:
        return [height - g * t * t / 2, -g * t]
    t, v = t - fallen, restitution * g * fallen
    while t > 2 * v / g:
        t, v = t - 2 * v / g, restitution * v
    return [v * t - g * t * t / 2, v - g * t]


assert ball.indicators == 1
one = Instance(ball, "CoSimulation").initialize()
for k in range(80):
    assert one.step(0.05 * k, 0.05)[0] == OK
    near(one.get("h", "v"), bounced(0.05 * (k + 1)), 1e-10)
one.free()

# On the ground at the start: a ball that moves down touches it immediately, and one that moves up touches it later. A
# ball at rest there touches it repeatedly and does not fall through.
for v, rebound in ((-1.0, 0.8), (1.0, 1.0)):
    one = Instance(ball, "CoSimulation").initialize(h=0, v=v)
    assert one.step(0, 0.05)[0] == OK
    near(one.get("h", "v"), [rebound * 0.05 - g * 0.05**2 / 2, rebound - g * 0.05], 1e-10)
    assert one.step(0.05, 0.2)[0] == OK
    assert one.get("h")[0] > 0
    one.free()
    one = exchange(ball, h=0, v=v)
    assert one.row("EventIndicators", 1)[0] > 0, "a change of sign is to come"
    one.at(1e-3, [v * 1e-3, v])
    assert (one.row("EventIndicators", 1)[0] < 0) is one.wants_event_mode() is (v < 0)
    one.free()
for x in ({"h": 0, "v": 0}, {"h": 1e-7, "v": -1e-5}):
    one = Instance(ball, "CoSimulation").initialize(**x)
    assert one.step(0, 0.05)[0] == DISCARD
    assert one.told == [(DISCARD, "more than 100 events happen in one internal step")]
    assert abs(one.get("h")[0]) < 1e-7
    one.free()

# A jump set by an event is not a crossing, however large it is; later crossings are events. Internal steps may be as
# long as the communication steps, and endless steps are rejected.
lift = Fmu("lift")
assert lift.unit == {"time": "s", "h": "m", "v": "m/s", "der(h)": "m/s", "der(v)": "m/s2", "arrival": "m", "four": "m"}
assert lift.units["m/s2"] == {"m": "1", "s": "-2"}
one = Instance(lift, "CoSimulation").initialize()
assert one.step(0, 1.5)[0] == OK
near(one.get("h", "v"), [4.5, -1], 1e-11)
assert one.step(1.5, 1)[0] == OK
near(one.get("h", "v"), [3.5, -1], 1e-11)
one.free()
one, t = Instance(lift, "CoSimulation").initialize(), 0.0
for _ in range(1000):
    status, t = one.step(t, 9e-10)
    assert status == OK
near(one.get("h"), [1 - t], 1e-12)
for length, why in ((math.inf, "the length of a step must be positive and finite"), (math.nan, "the length of a step must be positive and finite"),
                    (1e300, "a step may consist of at most 1e10 internal steps"),
                    (1e-30, "the internal step is below the resolution of the time")):
    assert one.step(t, length) == (ERROR, t) and one.told[-1] == (ERROR, why)
assert one.step(math.inf, 1) == (ERROR, t)

# Rejected calls have no effect.
h = one.get("h")
assert one.enter_initialization(start=77) == ERROR and one.get("time") == [t]
assert one.status_of_set({"h": 3}) == ERROR and one.told[-1] == (ERROR, "the state of a co-simulation changes only by steps")
assert one.status("SetContinuousStates", (double * 2)(3, 3), size(2)) == ERROR
assert one.status("CompletedIntegratorStep", flag(True), ctypes.byref(flag()), ctypes.byref(flag())) == ERROR
assert one.get("h") == h
one.free()
one = exchange(ball)
assert one.status_of_set({"h": 3, "der(v)": 1}) == ERROR and one.get("h") == [height]
one.Terminate()
assert one.status_of_set({"g": 1}) == ERROR and one.told[-1] == (ERROR, "no variable can be set after fmi3Terminate")
assert one.status("SetTime", double(5)) == one.status("SetContinuousStates", (double * 2)(), size(2)) == ERROR
assert one.get("g", "h", "time") == [g, height, 0]
one.free()

# A solver may end a step at which an indicator is exactly zero: it has then crossed zero, whatever its direction.
one = exchange(lift, h=3.5, v=1)
for t, x, passes in ((1, [3.75, 1], False), (2, [4, 1], True), (3, [4.5, 7], False), (4, [4, 7], False), (5, [4.5, 7], False),
                     (6, [3.5, 7], False), (7, [4, 6], True)):
    one.at(t, x)
    assert one.wants_event_mode() == passes, (t, x)
    if passes:
        one.EnterEventMode()
        assert one.events() == (True, False) and one.state() == [4, 7] and one.events() == (False, False)
        one.EnterContinuousTimeMode()
one.free()

# The same, integrated by a tool whose steps are exact here
one = exchange(ball)
x, t, bounces = one.state(), 0.0, 0
assert x == [height, 0.0]


def moved(x, s):
    return [x[0] + x[1] * s - g * s * s / 2, x[1] - g * s]


while t < 2 and bounces < 9:
    step = min(0.01, 2 - t)
    one.at(t + step, moved(x, step))
    if one.row("EventIndicators", 1)[0] < 0:
        low, step = 0.0, step
        for _ in range(60):
            middle = (low + step) / 2
            one.at(t + middle, moved(x, middle))
            low, step = (low, middle) if one.row("EventIndicators", 1)[0] < 0 else (middle, step)
        one.at(t + step, moved(x, step))
        assert one.wants_event_mode()
        one.EnterEventMode()
        assert one.events() == (True, False) and one.events() == (False, False)
        one.EnterContinuousTimeMode()
        bounces += 1
    assert not one.wants_event_mode()
    t, x = t + step, one.state()
assert bounces == 3
near(x, bounced(2), 1e-9)
one.free()

# State variables are states like coordinates and speeds.
arm = Fmu("motor_arm")
assert arm.states == ["q", "u", "i", "f", "e"] and arm.unit["der(i)"] == "A/s" and arm.start["i"] == 0.3
one = exchange(arm)
one.at(0, [0.4, 0.7, 0.9, 1.1, -0.2])
voltage = 30 * (1.1 - 0.4) + 20 * -0.2
near(one.rates(), [0.7, (20 * 0.05 * 0.9 - 2 * 9.81 * 0.5 * math.sin(0.4)) / (2 * 0.5 * 0.5),
                   (voltage - 0.8 * 0.9 - 20 * 0.05 * 0.7) / 0.01, (1 - 1.1) / 0.25, 1.1 - 0.4], 1e-14)
near(one.get("voltage"), [voltage], 1e-14)
near(one.product("Directional", ["der(i)", "der(f)"], ["i", "f", "r"], [1.0, 2.0, 3.0]), [(30 * 2 - 0.8) / 0.01, 4], 1e-13)
one.free()
one = Instance(arm, "CoSimulation").initialize()
for k in range(8):
    assert one.step(k / 8, 1 / 8)[0] == OK
near(one.get("f"), [1 - math.exp(-4)], 1e-11)
one.free()

# Arms, cars and wheels with friction, tyres, contacts and muscles: rates and derivatives are those of the module in C.
for name, count in (("loaded_arm", 6), ("cornering_car", 14), ("driven_wheel", 24)):
    module, fmu = importlib.import_module(name), Fmu(name)
    assert fmu.states == list(module.states) and len(fmu.states) == count
    of_inputs = {each.replace("'", "_"): value for each, value in fmu.start.items()}  # as C names rates
    p, r = ([of_inputs[each] for each in names] for names in (module.parameters, module.inputs))
    one = exchange(fmu)
    at_start = one.state()
    for k in range(5):
        x = [value + 0.02 * math.sin(k * (i + 1)) for i, value in enumerate(at_start)]
        one.at(0, x)
        near(one.rates()[-len(module.udot(x, p, r)):], module.udot(x, p, r), 1e-13)
        A, _ = module.explicit_form(x, p, r)
        for j in (0, count // 3, count - 2, count - 1):
            near(one.product("Directional", fmu.rates, [fmu.states[j]], [1.0]), [row[j] for row in A], 1e-12)
    one.free()
    x, length = at_start, 1 / 1024
    one = Instance(fmu, "CoSimulation").initialize()
    for k in range(20):
        [x] = [module.runge_kutta_4(x, length, p, r)]
        assert one.step(k * length, length) == (OK, (k + 1) * length)
        assert one.get(*fmu.states) == x, name
    one.free()

# Steps of a co-simulation are those of the module in C, to the last bit: with the time and an input, and with a
# constraint and a quaternion.
x, motion = [0.4, -0.2], []
for k in range(20):
    [x] = [bead.runge_kutta_4(x, 1 / 8, [2, 1.5, 9.81], [0.7], t=k / 8)]
    motion.append(x)
assert stepped(Fmu("bead"), {"s": 0.4, "v": -0.2}, 20) == motion

slider = Fmu("sliding")
one = exchange(slider)
start = one.state()


def off_constraints(x):
    [e0, e1, e2, e3] = x[:4]
    return [e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3 - 1, 2 * 0.5 * (e1 * e3 - e0 * e2) + 0.2]


near(off_constraints(start), [0, 0], 1e-14)
assert slider.attributes["e2"]["initial"] == slider.attributes["u2"]["initial"] == "approx"
assert slider.attributes["e1"]["initial"] == "exact"
motion, x = [], start
for k in range(9):
    x = sliding.ralston_3(x, 1 / 8, [-0.2])
    motion.append(x)
assert stepped(slider, {}, 9) == motion

# A tool that violates the constraints must return to them, within its own tolerance.
for tolerance, drift, is_far in ((None, 1e-7, True), (None, 1e-9, False), (1e-4, 1e-5, False), (1e-4, 1e-3, True)):
    one.Reset()
    one.initialize(tolerance)
    assert one.events() == (False, False)
    one.EnterContinuousTimeMode()
    one.at(0.1, start)
    assert not one.wants_event_mode()
    lost = [start[0], start[1], start[2] + drift, start[3] - drift, *start[4:]]
    one.at(0.1, lost)
    assert one.wants_event_mode() is is_far
    assert one.state() == lost, "nothing moves before the event"
    one.EnterEventMode()
    assert one.events() == (is_far, False)
    if is_far:
        near(off_constraints(one.state()), [0, 0], 10 * drift * drift + 1e-14)
        near(one.state(), start, 10 * drift)
one.EnterContinuousTimeMode()
one.at(0.1, [0.1, 0.1, 0.1, 0.1, 0, 0, 0])
assert one.status("CompletedIntegratorStep", flag(True), ctypes.byref(flag()), ctypes.byref(flag())) == DISCARD
assert "norm" in one.told[-1][1], one.told[-1]
one.free()
one = Instance(slider, "ModelExchange")
assert one.enter_initialization() == OK
one.set({"h": -2})
for _ in range(2):
    assert one.status("ExitInitializationMode") == ERROR
    assert one.told[-1][0] == DISCARD, one.told
one.set({"h": -0.2, **dict(zip(slider.states, start))})
one.ExitInitializationMode()
near(one.state(), start, 1e-14)
one.free()

# A linkage: no derivatives before the dependent coordinates are found; different lengths between steps, at which it
# closes again or reports that it cannot.
linkage = Fmu("four_bar")


def gap(of):
    q1, q2, q3, l1 = of.get("q1", "q2", "q3", "l1")
    return [l1 * math.cos(q1) + 3 * math.cos(q1 + q2) + 2.5 * math.cos(q1 + q2 + q3) - 4,
            l1 * math.sin(q1) + 3 * math.sin(q1 + q2) + 2.5 * math.sin(q1 + q2 + q3)]


one = Instance(linkage, "ModelExchange")
assert one.enter_initialization() == OK
for which in ("Directional", "Adjoint"):
    assert one.product(which, ["der(u1)"], ["q1"], [1.0]) == ERROR
assert one.told[-1] == (ERROR, "derivatives are not available before the end of initialization, because dependent states follow from others")
one.ExitInitializationMode()
near(gap(one), [0, 0], 1e-13)
assert len(one.product("Directional", ["der(u1)"], ["q1"], [1.0])) == 1
one.set({"l1": 1.4})
assert one.events() == (True, False)
near(gap(one), [0, 0], 1e-13)
one.free()
one = Instance(linkage, "CoSimulation").initialize()
assert one.step(0, 0.1)[0] == OK
one.set({"l1": 1.4})
near(gap(one), [0, 0], 1e-13)
one.set({"l1": 1.0})
assert one.step(0.1, 1e-3)[0] == OK
near(gap(one), [0, 0], 1e-12)
before = one.get("q1", "q2", "q3")
one.set({"l1": 40})
assert one.step(0.101, 1e-3)[0] == DISCARD
assert one.told[-1][0] == DISCARD
one.set({"l1": 1.0})
assert one.get("q1", "q2", "q3") == before, "nothing has moved"
one.free()

# A constraint that is not linear in the speeds: the dependent speed starts at its guess, which selects the solution.
cone = Fmu("appell_hamel")
one = Instance(cone, "ModelExchange")
assert one.enter_initialization() == OK
near(one.get("w"), [2], 1e-14)
one.set({"w": -0.3})
one.ExitInitializationMode()
near(one.get("u", "v", "w"), [0.6, -0.8, -2], 1e-14)
one.free()
one = Instance(cone, "CoSimulation").initialize()
assert one.step(0, 0.1)[0] == OK
near(one.get("w"), [2 - 0.1 * 9.81 / 1.25], 1e-9)
one.free()

# A step across a position where the height cannot be solved for e2 is discarded.
one = Instance(slider, "CoSimulation").initialize()
statuses = [one.step(k / 8, 1 / 8)[0] for k in range(10)]
assert statuses == [OK] * 9 + [DISCARD]
assert one.told[-1] == (DISCARD, "the step passes through or comes close to a position where the constraints "
                         "cannot be solved for the dependent speeds: use a model with a different dependent<...> if only this "
                         "choice is singular")
one.free()


# Five threads, each with its own instance
def motions(k):
    return [stepped(slider, {"u1": 0.1 * k}, 9) for _ in range(5)]


alone, together = [motions(k) for k in range(4)], [None] * 4


def work(k):
    together[k] = motions(k)


threads = [threading.Thread(target=work, args=[k]) for k in range(4)]
for each in threads:
    each.start()
for each in threads:
    each.join()
assert together == alone and alone[0] != alone[1]
