"""What CasADi makes of exported models: with_casadi.py FOLDER GUIDE, with their libraries and the guide's code."""

import contextlib
import io
import os
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import casadi as ca
import numpy as np

import by_sympy

guide = Path(sys.argv[2]).resolve()
os.chdir(sys.argv[1])
random = np.random.default_rng(5)


def external_of(library, name):
    return ca.external(name, f"./{library}.so")


def external(name):
    return external_of(name, name)


def at_random(f):
    return [random.uniform(0.5, 1.5, f.size1_in(i)) * (0.1 if f.name_in(i) == "h" else 1) for i in range(f.n_in())]


def symbols_of(f):
    return [ca.MX.sym(f.name_in(i), f.size1_in(i)) for i in range(f.n_in())]


def difference(found, expected):
    found, expected = np.array(ca.DM(found)), np.array(ca.DM(expected))
    return np.abs(found - expected).max(initial=0) / np.abs(expected).max(initial=1)


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


def runge_kutta(f):
    """A step of it, as CasADi differentiates it."""
    x, r, p = symbols_of(f)
    h = ca.MX.sym("h")
    k = [f(x, r, p)]
    for reach in (0.5, 0.5, 1):
        k.append(f(x + reach * h * k[-1], r, p))
    return ca.Function("step", [x, r, p, h], [x + h / 6 * (k[0] + 2 * k[1] + 2 * k[2] + k[3])], ["x", "r", "p", "h"],
                       ["next"])


def compare(name, tolerance=1e-10):
    f, reference = external(name), getattr(by_sympy, name)()
    structure = ca.jacobian(f(*symbols_of(f)), symbols_of(f)[0])
    assert structure.nnz() < structure.numel(), "a Jacobian of rates is never full"
    for what, of, by in ((name, f, reference), (f"{name}_step", external_of(name, f"{name}_step"), runge_kutta(reference))):
        found, expected = derivatives(of), derivatives(by)
        worst = 0
        for _ in range(20):
            at = [*at_random(of), random.uniform(-1, 1, of.size1_out(0)), random.uniform(-1, 1, of.nnz_in())]
            worst = max(worst, *(difference(a, b) for a, b in zip(found(*at), expected(*at))))
        assert worst < tolerance, f"{what} is off by {worst}"
        print(f"{what}: values, Jacobian, Hessian, directional and adjoint derivatives within {worst:.1e} of CasADi's")
    solve_implicit(name, reference)


def solve_implicit(name, reference):
    """The residual vanishes at SymPy's rates, and the rates that follow from it have their derivatives."""
    residual = external_of(name, f"{name}_implicit")
    x, rate, r, p = symbols_of(residual)
    found = ca.rootfinder("found", "newton", {"x": rate, "p": ca.vertcat(x, r, p), "g": residual(x, rate, r, p)},
                          {"abstol": 1e-12})
    z = ca.vertcat(x, r, p)
    solution, expected = found(ca.MX.zeros(rate.numel()), z), reference(x, r, p)
    worst = 0
    at = at_random(reference)
    for a, b in ((solution, expected), (ca.jacobian(solution, z), ca.jacobian(expected, z))):
        off = ca.Function("off", [x, r, p], [a, b])(*at)
        worst = max(worst, difference(*off))
    assert worst < 1e-10, worst
    print(f"{name}_implicit: the rates that it leaves no residual at, with their Jacobian, within {worst:.1e} of SymPy's")


def solved(problem, options=None):
    problem.solver("ipopt", {"print_time": False, **(options or {})}, {"print_level": 0, "sb": "yes"})
    solution = problem.solve()
    stats = solution.stats()
    assert stats["success"]
    return solution, stats["iter_count"]


def swing_up_by_steps(step):
    """Multiple shooting: an interval is two steps."""
    n = 40
    problem, h = ca.Opti(), 2 / n / 2
    x, r, p = problem.variable(4, n + 1), problem.variable(1, n), [1, 0.3, 0.5]
    for k in range(n):
        problem.subject_to(x[:, k + 1] == step(step(x[:, k], r[k], p, h), r[k], p, h))
    problem.subject_to(x[:, 0] == [0, -ca.pi / 2, 0, 0])
    problem.subject_to(x[:, n] == [0, ca.pi / 2, 0, 0])
    problem.set_initial(x[1, :], np.linspace(-np.pi / 2, np.pi / 2, n + 1))
    problem.minimize(h * ca.sumsqr(r))
    solution, iterations = solved(problem)
    return solution.value(problem.f), iterations


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


def integrated_implicitly(name):
    """The rates are algebraic variables, of which the residual is zero."""
    x, rate, r, p = symbols_of(external_of(name, f"{name}_implicit"))
    residual = external_of(name, f"{name}_implicit")(x, rate, r, p)
    move = ca.integrator("move", "idas", {"x": x, "z": rate, "p": ca.vertcat(r, p), "ode": rate, "alg": residual}, 0, 2,
                         {"reltol": 1e-11, "abstol": 1e-12})
    x, p = ca.MX.sym("x", move.size1_in("x0")), ca.MX.sym("p", move.size1_in("p"))
    end = move(x0=x, p=p)["xf"]
    return ca.Function("end", [x, p], [end, ca.jacobian(end, x), ca.jacobian(end, p)])


def acados_files(model, options):
    """Files as acados generates them, by casadi_function_generation.py of its interface, from the expressions of a model,
    compiled with the library that they call."""
    x, xdot, u, p, z, t = model.x, model.xdot, model.u, model.p, ca.MX.sym("z", 0), ca.MX.sym("t", 0)
    rate, residual, step = model.f_expl_expr, model.f_impl_expr, model.disc_dyn_expr
    library = options.model_external_shared_lib_name
    link = [f"-L{options.model_external_shared_lib_dir}", f"-l{library}", "-Wl,-rpath,$ORIGIN", "-Wl,--no-undefined", "-lm"]
    nx, nu = x.numel(), u.numel()
    Sx, Su, weights = ca.MX.sym("Sx", nx, nx), ca.MX.sym("Su", nx, nu), ca.MX.sym("lambdaX", nx)
    xu, ux = ca.vertcat(x, u), ca.vertcat(u, x)
    S = ca.vertcat(ca.horzcat(Sx, Su), ca.horzcat(ca.DM.zeros(nu, nx), ca.DM.eye(nu)))
    adjoint = ca.jtimes(rate, xu, weights, True)
    hessian = ca.mtimes(ca.transpose(S), ca.jtimes(adjoint, xu, S))
    hessian = ca.vertcat(*(hessian[i, j] for j in range(nx + nu) for i in range(j, nx + nu)))
    adjoint_of_step = ca.jtimes(step, ux, weights, True)
    by_x, by_xdot, by_u, by_z = (ca.jacobian(residual, each) for each in (x, xdot, u, z))
    given = [x, xdot, u, z, t, p]
    x_xdot_z_u = ca.vertcat(x, xdot, z, u)
    adjoint_of_residual = ca.jtimes(residual, x_xdot_z_u, weights, True)
    functions = {
        "expl_ode_fun": ([x, u, p], [rate]),
        "expl_vde_forw": ([x, Sx, Su, u, p],
                          [rate, ca.jtimes(rate, x, Sx), ca.jacobian(rate, u) + ca.jtimes(rate, x, Su)]),
        "expl_vde_adj": ([x, weights, u, p], [adjoint]),
        "expl_ode_hess": ([x, Sx, Su, weights, u, p], [adjoint, hessian]),
        "dyn_disc_phi_fun": ([x, u, p], [step]),
        "dyn_disc_phi_fun_jac": ([x, u, p], [step, ca.jacobian(step, ux).T]),
        "dyn_disc_phi_fun_jac_hess": ([x, u, weights, p],
                                      [step, ca.jacobian(step, ux).T, ca.jacobian(adjoint_of_step, ux)]),
        "impl_dae_fun": (given, [residual]),
        "impl_dae_fun_jac_x_xdot_z": (given, [residual, by_x, by_xdot, by_z]),
        "impl_dae_fun_jac_x_xdot_u": (given, [residual, by_x, by_xdot, by_u]),
        "impl_dae_jac_x_xdot_u_z": (given, [by_x, by_xdot, by_u, by_z]),
        "impl_dae_hess": ([x, xdot, u, z, weights, t, p], [ca.jacobian(adjoint_of_residual, x_xdot_z_u)]),
    }
    for end, (given, wanted) in functions.items():
        called = f"{model.name}_{end}"
        direct = ca.Function(called, given, wanted)
        direct.generate(called, {"mex": False, "casadi_int": "int", "casadi_real": "double", "force_canonical": False})
        text = Path(f"{called}.c").read_text()
        assert any(f"{library}{end}(" in text for end in ("", "_step", "_implicit")), "it calls what was exported"
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", f"{called}.c", "-o", f"lib{called}.so", *link], check=True)
        symbols = subprocess.run(["nm", "-D", f"lib{called}.so"], check=True, capture_output=True, text=True).stdout
        for symbol in ("", "_work", "_sparsity_in", "_sparsity_out", "_n_in", "_n_out"):
            assert re.search(rf" T {called}{symbol}$", symbols, re.M), symbol
        # CasADi reads 64-bit integers; the same text with these
        direct.generate(f"{called}_wide.c")
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", f"{called}_wide.c", "-o", f"{called}_wide.so", *link], check=True)
        generated = ca.external(called, f"./{called}_wide.so")
        at = [random.uniform(0.5, 1.5, (direct.size1_in(i), direct.size2_in(i))) for i in range(direct.n_in())]
        for a, b in zip(generated.call(at), direct.call(at)):
            assert difference(a, b) < 1e-14
    print(f"acados: {', '.join(functions)} have their symbols, and the values of CasADi")


for each in ("cart", "double_pendulum", "sleigh"):
    compare(each)

cost, iterations = swing_up(external("cart"))
expected, iterations_expected = swing_up(by_sympy.cart())
assert iterations == iterations_expected and abs(cost / expected - 1) < 1e-8
assert iterations <= 20
print(f"swing-up of a cart's pendulum: {iterations} iterations of IPOPT, as with SymPy's equations")

cost, iterations = swing_up_by_steps(external_of("cart", "cart_step"))
expected, iterations_expected = swing_up_by_steps(runge_kutta(by_sympy.cart()))
assert iterations == iterations_expected and abs(cost / expected - 1) < 1e-8
assert iterations <= 40
print(f"the same by multiple shooting, of steps: {iterations} iterations, as with SymPy's equations")

turning, slip, iterations = lane_change(external("vehicle"))
assert turning < 2e-3 and slip < 1e-9, (turning, slip)
assert iterations <= 10
print(f"lane change: {iterations} iterations of IPOPT, constraints within {turning:.1e} rad/s")

cart, reference = integrated(external("cart")), integrated(by_sympy.cart())
start = [0, 0.3, 0.1, 0], [0, 1, 0.3, 0.5]
worst = max(difference(a, b) for a, b in zip(cart(*start), reference(*start)))
assert worst < 1e-7, worst
print(f"CVODES: end, and its derivatives by state and parameters, within {worst:.1e}")
worst = max(difference(a, b) for a, b in zip(integrated_implicitly("cart")(*start), reference(*start)))
assert worst < 1e-7, worst
print(f"IDAS with the implicit form: the same within {worst:.1e}")

told_acados = {"model": SimpleNamespace(), "ocp": SimpleNamespace(code_gen_options=SimpleNamespace())}
subprocess.run(["sh", "-eu", guide / "acados-library.sh"], check=True)
exec((guide / "acados.python").read_text(), told_acados)
acados_files(told_acados["model"], told_acados["ocp"].code_gen_options)

with contextlib.redirect_stdout(io.StringIO()):
    of_session = {}
    exec((guide / "session.python").read_text(), of_session)
assert np.abs(of_session["found"][:, -1] - [0, np.pi / 2, 0, 0]).max() < 1e-7
print(f"the session of the guide: {of_session['problem'].stats()['iter_count']} iterations")
