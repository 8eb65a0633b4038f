#pragma once

#include <kanexpr/compiled/linearization.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <Eigen/Dense>
#include <cvode/cvode.h>
#include <cvode/cvode_proj.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

/// Loops around CVODE as one writes them for one problem, over the compiled equations of motion, with the
/// settings that `simulate` has by default.
namespace by_hand {

inline constexpr double rtol = 1e-8, atol = 1e-10;

template <class System>
struct solution {
  struct sample {
    double t;
    kanexpr::state<System> x;
  };
  std::vector<sample> path;
  long steps = 0;
};

/// What the functions that CVODE calls are given.
template <class Motion>
struct user_data {
  kanexpr::parameter_values<typename Motion::System> p = Motion::parameters();
  void* cvode_mem = nullptr;
  N_Vector weights = nullptr;
};

inline void check(int flag, const char* call) {
  if (flag >= 0) return;
  std::fprintf(stderr, "%s failed with flag %d\n", call, flag);
  std::exit(1);
}

template <class Motion>
int f(realtype t, N_Vector y, N_Vector ydot, void* of) {
  using System = typename Motion::System;
  using vector = typename kanexpr::state<System>::base;
  const auto& data = *static_cast<const user_data<Motion>*>(of);
  const kanexpr::state<System> x(Eigen::Map<const vector>(NV_DATA_S(y)));
  kanexpr::input_values<System> r;
  Motion::give_inputs(t, x, r);
  const auto rates = kanexpr::equations_of_motion<System>::rhs(t, x, data.p, r);
  if (!kanexpr::status_of(rates)) return 1;
  Eigen::Map<vector>(NV_DATA_S(ydot)) = rates;
  return 0;
}

template <class Motion>
int jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix j, void* of, N_Vector, N_Vector, N_Vector) {
  using System = typename Motion::System;
  constexpr int size = kanexpr::state<System>::SizeAtCompileTime;
  const auto& data = *static_cast<const user_data<Motion>*>(of);
  const kanexpr::state<System> x(Eigen::Map<const Eigen::Matrix<double, size, 1>>(NV_DATA_S(y)));
  kanexpr::input_values<System> r;
  Motion::give_inputs(t, x, r);
  const auto [by_state, by_inputs] = kanexpr::linearization<System>::jacobian(t, x, data.p, r);
  if (!kanexpr::status_of(by_state)) return 1;
  Eigen::Map<Eigen::Matrix<double, size, size>>(SM_DATA_D(j)) = by_state;
  return 0;
}

/// The least change, in tolerances, that J takes to b.
template <class Jacobian, class Units, class Right>
auto least_change(const Jacobian& J, const Units& units, const Right& b) {
  constexpr int rows = Jacobian::RowsAtCompileTime, columns = Jacobian::ColsAtCompileTime;
  const Eigen::Matrix<double, columns, rows> spread = units.asDiagonal() * J.transpose();
  const Eigen::Matrix<double, rows, rows> square = J * spread;
  return Eigen::Matrix<double, columns, 1>(spread * square.llt().solve(Eigen::Matrix<double, rows, 1>(b)));
}

/// Newton's method for the coordinates, then the speeds; error estimates lose what points off the
/// constraints.
template <class Motion>
int project(realtype t, N_Vector y, N_Vector correction, realtype, N_Vector error, void* of) {
  using System = typename Motion::System;
  using eom = kanexpr::equations_of_motion<System>;
  constexpr int n = eom::coordinates, o = eom::speeds;
  using vector = typename kanexpr::state<System>::base;
  const auto& data = *static_cast<const user_data<Motion>*>(of);
  CVodeGetErrWeights(data.cvode_mem, data.weights);
  const Eigen::Map<const vector> start(NV_DATA_S(y)), weights(NV_DATA_S(data.weights));
  const vector units = weights.cwiseAbs2().cwiseInverse();
  kanexpr::input_values<System> r;
  kanexpr::state<System> x(start);
  Motion::give_inputs(t, x, r);

  for (int iteration = 0;; ++iteration) {
    if (iteration == 10) return 1;
    const auto [residual, J] =
        eom::together(eom::configuration_residual, eom::configuration_jacobian_by_all)(t, x, data.p, r);
    const auto change = least_change(J, units.template head<n>(), residual);
    x.q() -= change;
    if (change.cwiseProduct(weights.template head<n>()).cwiseAbs().maxCoeff() > 1e-2) continue;
    if (error != nullptr) {
      Eigen::Map<Eigen::Matrix<double, n, 1>> e(NV_DATA_S(error));
      e -= least_change(J, units.template head<n>(), J * e);
    }
    break;
  }
  const auto [residual, J] = eom::together(eom::velocity_residual, eom::constraint_jacobian)(t, x, data.p, r);
  x.u() -= least_change(J, units.template tail<o>(), residual);
  if (error != nullptr) {
    Eigen::Map<Eigen::Matrix<double, o, 1>> e(NV_DATA_S(error) + n);
    e -= least_change(J, units.template tail<o>(), J * e);
  }
  Eigen::Map<vector>(NV_DATA_S(correction)) = x - start;
  return 0;
}

enum class samples { as_interpolated, on_constraints };

/// A sample each `every` seconds; `formulas` is CV_ADAMS or CV_BDF. Between two steps CVODE interpolates, and
/// leaves the constraints by a little.
template <class Motion, int formulas, samples kept = samples::as_interpolated>
solution<typename Motion::System> run(double every) {
  using System = typename Motion::System;
  constexpr int size = kanexpr::state<System>::SizeAtCompileTime;
  constexpr bool constrained = kanexpr::compiled::survey_of<System>.constraints != 0;
  const auto [from, to] = Motion::span;

  SUNContext context;
  check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  user_data<Motion> data;
  kanexpr::state<System> x = Motion::start();
  kanexpr::input_values<System> r;
  Motion::give_inputs(from, x, r);
  if constexpr (constrained)
    if (!kanexpr::assemble<System>(x, data.p, r, from)) std::exit(1);

  N_Vector y = N_VNew_Serial(size, context);
  Eigen::Map<typename kanexpr::state<System>::base>(NV_DATA_S(y)) = x;
  N_Vector tolerances = N_VNew_Serial(size, context);
  N_VConst(atol, tolerances);
  N_Vector correction = N_VNew_Serial(size, context);
  data.weights = N_VNew_Serial(size, context);

  void* cvode_mem = CVodeCreate(formulas, context);
  data.cvode_mem = cvode_mem;
  check(CVodeInit(cvode_mem, f<Motion>, from, y), "CVodeInit");
  check(CVodeSetUserData(cvode_mem, &data), "CVodeSetUserData");
  check(CVodeSVtolerances(cvode_mem, rtol, tolerances), "CVodeSVtolerances");
  check(CVodeSetMinStep(cvode_mem, 4 * std::numeric_limits<double>::epsilon() * to), "CVodeSetMinStep");
  check(CVodeSetStopTime(cvode_mem, to), "CVodeSetStopTime");

  SUNMatrix A = nullptr;
  SUNLinearSolver linear_solver = nullptr;
  SUNNonlinearSolver iteration = nullptr;
  if constexpr (formulas == CV_ADAMS) {
    iteration = SUNNonlinSol_FixedPoint(y, 0, context);
    check(CVodeSetNonlinearSolver(cvode_mem, iteration), "CVodeSetNonlinearSolver");
  } else {
    A = SUNDenseMatrix(size, size, context);
    linear_solver = SUNLinSol_Dense(y, A, context);
    check(CVodeSetLinearSolver(cvode_mem, linear_solver, A), "CVodeSetLinearSolver");
    check(CVodeSetJacFn(cvode_mem, jacobian<Motion>), "CVodeSetJacFn");
    if constexpr (constrained) check(CVodeSetProjFn(cvode_mem, project<Motion>), "CVodeSetProjFn");
  }

  solution<System> found;
  found.path.push_back({from, x});
  realtype t = from;
  for (int i = 1; t < to; ++i) {
    const double target = i * every < to * (1 - 1e-12) ? i * every : to;
    check(CVode(cvode_mem, target, y, &t, CV_NORMAL), "CVode");
    x = Eigen::Map<const typename kanexpr::state<System>::base>(NV_DATA_S(y));
    if constexpr (kept == samples::on_constraints) {
      check(-project<Motion>(t, y, correction, 0, nullptr, &data), "project");
      x += Eigen::Map<const typename kanexpr::state<System>::base>(NV_DATA_S(correction));
    }
    found.path.push_back({t, x});
  }
  CVodeGetNumSteps(cvode_mem, &found.steps);

  CVodeFree(&cvode_mem);
  SUNLinSolFree(linear_solver);
  SUNNonlinSolFree(iteration);
  SUNMatDestroy(A);
  N_VDestroy(data.weights);
  N_VDestroy(correction);
  N_VDestroy(tolerances);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return found;
}

} // namespace by_hand
