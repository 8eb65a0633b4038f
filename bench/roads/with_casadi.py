"""What CasADi makes of exported models: with_casadi.py FOLDER SESSION, with their libraries and the guide's session."""

import contextlib
import io
import os
import re
import subprocess
import sys
import time
from pathlib import Path

import casadi as ca
import numpy as np

import by_hand

session = Path(sys.argv[2]).resolve()
os.chdir(sys.argv[1])
random = np.random.default_rng(5)


def external(name):
    return ca.external(name, f"./{name}.so")


def at_random(f):
    return [random.uniform(0.5, 1.5, f.size1_in(i)) for i in range(f.n_in())]


def symbols_of(f):
    return [ca.MX.sym(f.name_in(i), f.size1_in(i)) for i in range(f.n_in())]


def difference(found, expected):
    found, expected = np.array(ca.DM(found)), np.array(ca.DM(expected))
    return np.abs(found - expected).max() / max(1, np.abs(expected).max())


def derivatives(f):
    """Values, first derivatives in each way, and second derivatives of a weighted sum."""
    given = symbols_of(f)
    z, y = ca.vertcat(*given), f(*given)
    weights, direction = ca.MX.sym("weights", y.numel()), ca.MX.sym("direction", z.numel())
    sum_of_all = ca.dot(weights, y)
    return ca.Function("derivatives", [*given, weights, direction],
                       [y, ca.jacobian(y, z), ca.jtimes(y, z, direction), ca.jtimes(y, z, weights, True),
                        ca.hessian(sum_of_all, z)[0],
                        ca.jacobian(ca.gradient(sum_of_all, z), weights)])


def compare(name, tolerance=1e-10):
    f, reference = external(name), getattr(by_hand, name)()
    found, expected = derivatives(f), derivatives(reference)
    worst = 0
    for _ in range(20):
        at = [*at_random(f), random.uniform(-1, 1, f.size1_out(0)), random.uniform(-1, 1, f.nnz_in())]
        worst = max(worst, *(difference(a, b) for a, b in zip(found(*at), expected(*at))))
    assert worst < tolerance, f"{name} is off by {worst}"
    structure = ca.jacobian(external(name)(*symbols_of(f)), symbols_of(f)[0])
    assert structure.nnz() < structure.numel(), "a Jacobian of rates is never full"
    print(f"{name}: values, Jacobian, Hessian, directional and adjoint derivatives within {worst:.1e} of CasADi's")


def solved(problem, options=None):
    problem.solver("ipopt", {"print_time": False, **(options or {})}, {"print_level": 0, "sb": "yes"})
    solution = problem.solve()
    stats = solution.stats()
    assert stats["success"]
    return solution, stats["iter_count"]


def swing_up(f):
    n = 40
    problem, h = ca.Opti(), 2 / n
    x, r = problem.variable(4, n + 1), problem.variable(1, n + 1)
    rate = [f(x[:, k], r[k], [1, 0.3, 0.5]) for k in range(n + 1)]
    for k in range(n):
        problem.subject_to(x[:, k + 1] - x[:, k] == h / 2 * (rate[k] + rate[k + 1]))
    problem.subject_to(x[:, 0] == [0, -ca.pi / 2, 0, 0])
    problem.subject_to(x[:, n] == [0, ca.pi / 2, 0, 0])
    problem.subject_to(problem.bounded(-20, r, 20))
    problem.set_initial(x[1, :], np.linspace(-np.pi / 2, np.pi / 2, n + 1))
    problem.minimize(h * ca.sumsqr(r))
    solution, iterations = solved(problem)
    return solution.value(problem.f), iterations


def lane_change(f):
    """3.5 m to the left within 3 s, at 10 m/s before and after."""
    n = 40
    problem, h = ca.Opti(), 3 / n
    x, r = problem.variable(8, n + 1), problem.variable(2, n + 1)
    rate = [f(x[:, k], r[:, k], [1200, 1500, 2, 1.3, 2.6]) for k in range(n + 1)]
    for k in range(n):
        problem.subject_to(x[:, k + 1] - x[:, k] == h / 2 * (rate[k] + rate[k + 1]))
    problem.subject_to(x[:, 0] == [0, 0, 0, 0, 10, 0, 0, 0])
    problem.subject_to(x[1:5, n] == [3.5, 0, 0, 10])
    problem.subject_to(problem.bounded(-0.5, x[3, :], 0.5))
    problem.set_initial(x[4, :], 10)
    problem.set_initial(x[0, :], np.linspace(0, 30, n + 1))
    problem.minimize(h * (ca.sumsqr(r[0, :] / 1000) + ca.sumsqr(r[1, :])))
    solution, iterations = solved(problem)
    at = solution.value(x)
    turning = at[4] * np.tan(at[3]) / 2.6
    return np.abs(at[6] - turning).max(), np.abs(at[5]).max(), iterations


def integrated(f):
    """Two seconds of free motion, and its derivatives by the state in which it begins and by parameters."""
    given = symbols_of(f)
    move = ca.integrator("move", "cvodes", {"x": given[0], "p": ca.vertcat(*given[1:]), "ode": f(*given)}, 0, 2,
                         {"reltol": 1e-11, "abstol": 1e-12})
    x, p = ca.MX.sym("x", move.size1_in("x0")), ca.MX.sym("p", move.size1_in("p"))
    end = move(x0=x, p=p)["xf"]
    return ca.Function("end", [x, p], [end, ca.jacobian(end, x), ca.jacobian(end, p)])


def acados_files(f, name):
    """Files as acados generates them from `model.f_expl_expr`, compiled beside the library that they call."""
    x, u, p = symbols_of(f)
    nx, nu = x.numel(), u.numel()
    Sx, Su, weights = ca.MX.sym("Sx", nx, nx), ca.MX.sym("Su", nx, nu), ca.MX.sym("lambdaX", nx)
    rate = f(x, u, p)
    z = ca.vertcat(x, u)
    S = ca.vertcat(ca.horzcat(Sx, Su), ca.horzcat(ca.MX.zeros(nu, nx), ca.MX.eye(nu)))
    adjoint = ca.jtimes(rate, z, weights, True)
    hessian = ca.mtimes([S.T, ca.jacobian(adjoint, z), S])
    step = x + 0.01 * f(x + 0.005 * rate, u, p)
    functions = {
        "expl_ode_fun": ([x, u, p], [rate]),
        "expl_vde_forw": ([x, Sx, Su, u, p],
                          [rate, ca.jtimes(rate, x, Sx), ca.jacobian(rate, u) + ca.jtimes(rate, x, Su)]),
        "expl_vde_adj": ([x, weights, u, p], [adjoint]),
        "expl_ode_hess": ([x, Sx, Su, weights, u, p], [adjoint, hessian]),
        "dyn_disc_phi_fun_jac_hess": ([x, u, weights, p],
                                      [step, ca.jacobian(step, z).T, ca.hessian(ca.dot(weights, step), z)[0]]),
    }
    for end, (given, wanted) in functions.items():
        called = f"{name}_{end}"
        direct = ca.Function(called, given, wanted)
        direct.generate(f"{called}.c", {"casadi_int": "int", "casadi_real": "double"})
        text = Path(f"{called}.c").read_text()
        assert f"{name}(" in text
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", f"{called}.c", "-o", f"lib{called}.so", "-L.", f"-l:{name}.so",
                        "-Wl,-rpath,$ORIGIN", "-lm"], check=True)
        symbols = subprocess.run(["nm", "-D", f"lib{called}.so"], check=True, capture_output=True, text=True).stdout
        for symbol in ("", "_work", "_sparsity_in", "_sparsity_out", "_n_in", "_n_out"):
            assert re.search(rf" T {called}{symbol}$", symbols, re.M), symbol
        # CasADi reads 64-bit integers; the same text with these
        direct.generate(f"{called}_wide.c")
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", f"{called}_wide.c", "-o", f"{called}_wide.so", "-L.",
                        f"-l:{name}.so", "-Wl,-rpath,$ORIGIN", "-lm"], check=True)
        generated = ca.external(called, f"./{called}_wide.so")
        at = [random.uniform(0.5, 1.5, (direct.size1_in(i), direct.size2_in(i))) for i in range(direct.n_in())]
        for a, b in zip(generated.call(at), direct.call(at)):
            assert difference(a, b) < 1e-14
    print(f"acados: {', '.join(functions)} of {name} have their symbols, and the values of CasADi")


def timed(function, at):
    count = 20000
    buffers = function.buffer()
    buffer, call = buffers
    given = [np.ascontiguousarray(each, dtype=float) for each in at]
    results = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
    for i, each in enumerate(given):
        buffer.set_arg(i, memoryview(each))
    for i, each in enumerate(results):
        buffer.set_res(i, memoryview(each))
    best = float("inf")
    for _ in range(5):
        begin = time.perf_counter()
        for _ in range(count):
            call()
        best = min(best, (time.perf_counter() - begin) / count)
    return best * 1e6


for each in ("cart", "double_pendulum", "sleigh"):
    compare(each)

cost, iterations = swing_up(external("cart"))
cost_by_hand, iterations_by_hand = swing_up(by_hand.cart())
assert iterations == iterations_by_hand and abs(cost / cost_by_hand - 1) < 1e-8
assert iterations <= 20
print(f"swing-up of a cart's pendulum: {iterations} iterations of IPOPT, as with equations by hand")

turning, slip, iterations = lane_change(external("vehicle"))
assert turning < 2e-3 and slip < 1e-9, (turning, slip)
assert iterations <= 10
print(f"lane change: {iterations} iterations of IPOPT, constraints within {turning:.1e} rad/s")

cart, reference = integrated(external("cart")), integrated(by_hand.cart())
start = [0, 0.3, 0.1, 0], [0, 1, 0.3, 0.5]
worst = max(difference(a, b) for a, b in zip(cart(*start), reference(*start)))
assert worst < 1e-7, worst
print(f"CVODES: end, and its derivatives by state and parameters, within {worst:.1e}")

acados_files(external("cart"), "cart")

with contextlib.redirect_stdout(io.StringIO()):
    of_session = {}
    exec(session.read_text(), of_session)
assert np.abs(of_session["found"][:, -1] - [0, np.pi / 2, 0, 0]).max() < 1e-7
print(f"the session of the guide: {of_session['problem'].stats()['iter_count']} iterations")

iiwa = external("iiwa")
at = at_random(iiwa)
print(f"iiwa, in µs with the call: rates {timed(iiwa, at):.2f}, "
      f"Jacobian {timed(iiwa.jacobian(), [*at, np.zeros(14)]):.2f}, "
      f"Hessian {timed(iiwa.reverse(1).jacobian(), [*at, np.zeros(14), np.ones(14), np.zeros(14), np.zeros(7), []]):.2f}")
