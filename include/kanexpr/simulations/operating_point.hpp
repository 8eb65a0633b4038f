#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/linearization_point.hpp>
#include <kanexpr/simulations/trim/trim.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulations/trim/trim_search.hpp>
#endif

namespace kanexpr {

/// Options of the search for an operating point.
template <class System>
struct operating_point_options {
  guessed_inputs<System> inputs = {};
  std::vector<symbol_name> held = {};     ///< states and inputs fixed at their guess
  std::vector<symbol_name> freed = {};    ///< parameters and prescribed quantities to solve for
  std::vector<symbol_name> changing = {}; ///< coordinates or speeds with arbitrary rates
  std::vector<named_value> rates = {};    ///< `{dot(q1), 0.3}`: nonzero rates
  double t = 0;
  double tolerance = 1e-10; ///< permitted residual of each equation, relative to its magnitude
  int most_iterations = 200;
};

/// A state and inputs at which a system is in equilibrium or in steady motion: the constraints hold,
/// quaternions have norm 1, and all rates of coordinates and speeds are zero, except those that the options
/// name. `operating_point<System> turn(guess, p, {.held = {q2, u3}, .changing = {q1}});`
///
/// The unknowns are all coordinates, speeds and inputs that are not held, and everything that is freed.
/// Prescribed quantities and their derivatives are known, so they stay fixed unless they are freed. There may
/// be more equations than unknowns if they are consistent; if there are fewer, the search ends near the
/// guess.
template <class System>
class operating_point {
public:
  double t = 0; ///< the time
  kanexpr::state<System> x;
  parameter_values<System> p;
  input_values<System> r;
  int iterations = 0;
  int freedom =
      0; ///< the number of independent directions in which the unknowns may move along operating points

  /// A residual with its name: "the rate of speed u2".
  using residual = simulations::residual;

  explicit operating_point(const guessed_state<System>& guess,
                           const given_parameters<System>& parameters = {},
                           const operating_point_options<System>& options = {})
      : t(options.t), x(guess.values), p(parameters.values), r(options.inputs.values) {
    for (const base::sentence* mistake : {&guess.mistake, &parameters.mistake, &options.inputs.mistake})
      if (cause_.empty()) cause_ = mistake->view();
    if (cause_.empty()) cause_ = mistake_in(options);
    if (cause_.empty()) find(options);
  }

  explicit operator bool() const { return cause_.empty(); }
  /// Returns why the search failed, as a sentence; empty on success. After a failure, x, p and r
  /// contain the point where the search ended.
  std::string cause() const { return cause_; }
  /// Returns the residual of each equation.
  const std::vector<residual>& residuals() const { return residuals_; }

  /// Converts to the point at which a run-time model is linearized.
  operator linearization_point() const { return runtime::point_with(known, t, all().data()); }

private:
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int states = known.coordinates + known.speeds;

  Eigen::VectorXd all() const {
    Eigen::VectorXd values(known.symbols());
    std::copy(r.begin(), r.end(),
              std::copy(p.begin(), p.end(), std::copy(x.begin(), x.end(), values.data())));
    return values;
  }

  static std::string mistake_in(const operating_point_options<System>& o) {
    if (!numeric::is_finite(o.tolerance)) return "the tolerance is not finite";
    if (!(o.tolerance > 0)) return "the tolerance must be positive";
    if (o.most_iterations <= 0) return "the maximum number of iterations must be positive";
    return numeric::is_finite(o.t) ? "" : "the time is not finite";
  }

  void find(const operating_point_options<System>& o) {
    simulations::search_result found = simulations::find(
        functions(), {o.held, o.freed, o.changing, o.rates, o.t, o.tolerance, o.most_iterations}, all());
    const double* values = found.values.data();
    std::copy_n(values, states, x.data());
    std::copy_n(values + states, known.parameters, p.data());
    std::copy_n(values + states + known.parameters, known.inputs, r.data());
    iterations = found.iterations;
    freedom = found.freedom;
    cause_ = std::move(found.failure);
    residuals_ = std::move(found.residuals);
  }

  static constexpr bool is_constrained = known.constraints + known.configuration_constraints != 0;

  using number = std::complex<double>;
  template <int size>
  using vector = Eigen::Matrix<number, size, 1>;

  /// Unless a library contains them, the functions are interpreted: a search evaluates them only a few
  /// hundred times, and compiled code for complex numbers would be long.
  static simulations::system_functions functions() {
    simulations::system_functions of{known, System::record, type_name<System>(), nullptr, nullptr, nullptr};
    if constexpr (compiled::is_linked<System>) {
      of.compiled = evaluate;
    } else {
      if constexpr (is_constrained) of.constraints = &table_for<mechanics::quantity::constraint_residual>();
      of.rates = &table_for<mechanics::quantity::rhs>();
    }
    return of;
  }
  template <mechanics::quantity wanted>
  static const compiled::code_table& table_for() {
    return compiled::table_for<System, number, vector<states>, vector<known.parameters>, vector<known.inputs>,
                               wanted>();
  }

  static std::string_view evaluate(double t, const number* at, number* result) {
    using mechanics::quantity;
    const vector<states> x_at(at);
    const vector<known.parameters> p_at(at + states);
    const vector<known.inputs> r_at(at + states + known.parameters);
    const auto put = [&result](const auto& part) { result = std::copy_n(part.data(), part.size(), result); };
    if constexpr (is_constrained) {
      const auto [left, rates] =
          out_of_line<function<System, quantity::constraint_residual, quantity::rhs>>{}(t, x_at, p_at, r_at);
      put(left), put(rates);
      return rates.status.view();
    } else {
      const auto rates = out_of_line<function<System, quantity::rhs>>{}(t, x_at, p_at, r_at);
      put(rates);
      return rates.status.view();
    }
  }

  std::string cause_{};
  std::vector<residual> residuals_{};
};

} // namespace kanexpr
