#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/newton.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace kanexpr {

/// The result of assembling a state, that is, of making it satisfy the constraints.
struct assembly {
  bool assembled = false;
  int steps = 0;                     ///< Newton steps taken
  double configuration_residual = 0; ///< the largest final magnitude
  double velocity_residual = 0;
  base::sentence failure{};

  explicit operator bool() const { return assembled; }
  /// Returns the cause of a failure as a sentence; empty on success.
  std::string cause() const { return failure.cause(); }
};

/// The result of checking whether a state satisfies the constraints.
struct consistency {
  double configuration_residual = 0; ///< the largest magnitude
  double velocity_residual = 0;
  base::sentence failure{};

  explicit operator bool() const { return !failure; }
  /// Returns the violated constraint and its residual as a sentence; empty if all constraints hold.
  std::string cause() const { return failure.cause(); }
};

/// Options of the search for a state that satisfies the constraints: the maximum number of Newton steps, and
/// the tolerance, the largest permitted relative change in the Jacobian over the last step.
using assembly_options = numeric::newton_options;

namespace numeric {

/// Returns a message that ends in a number.
inline base::sentence with_number(std::string_view before, double number, int precision = 3) {
  char digits[32];
  const int length = std::snprintf(digits, sizeof digits, "%.*g", precision, number + 0.0);
  return base::sentence({before, std::string_view(digits, static_cast<std::size_t>(length))});
}

/// Returns the larger of two numbers, or NaN if either is NaN.
inline double larger(double a, double b) { return !is_finite(a) || a > b ? a : b; }

/// Returns the typical magnitude of the terms of constraints near a state, even if the terms vanish there:
/// the largest magnitude at the state and at a few points around it. The distances of these points match the
/// magnitudes of the coordinates, in any units.
template <class Terms, class State>
auto typical_terms(const Terms& terms, const State& x, int coordinates) {
  using number = typename State::Scalar;
  auto most = terms(x);
  State nearby = x;
  number way = 0, largest = 0, least = 0;
  for (int i = 0; i < coordinates; ++i) largest = (std::max)(largest, number(std::abs(x(i))));
  const auto counts = [&](int i) { return std::abs(x(i)) > number(1e-9) * largest; };
  for (int i = 0; i < coordinates; ++i)
    if (counts(i)) least = least > 0 ? (std::min)(least, number(std::abs(x(i)))) : number(std::abs(x(i)));
  if (!(largest > 0)) least = 1; // an angle
  for (int samples = 0; samples < 3; ++samples) {
    for (int i = 0; i < coordinates; ++i) {
      way = std::fmod(way + number(0.618034), number(1)); // any number that does not divide a full turn
      nearby(i) = x(i) + (2 * way - 1) * (counts(i) ? std::abs(x(i)) : least);
    }
    most = most.cwiseMax(terms(nearby)).eval();
  }
  return most;
}

/// Whether a residual is no larger than the rounding of its terms.
template <class Vector>
bool is_within_rounding(const Vector& left, const Vector& terms) {
  constexpr auto rounding = 64 * std::numeric_limits<typename Vector::Scalar>::epsilon();
  if (!all_finite(left) || !all_finite(terms)) return false;
  for (Eigen::Index i = 0; i < left.size(); ++i)
    if (!(std::abs(left(i)) <= rounding * terms(i))) return false;
  return true;
}

/// Returns a message that names the first constraint violated relative to its terms, with its residual.
template <class Vector, class Terms, class State>
base::sentence first_violated(const Vector& left, const Terms& terms_at, const State& x, int coordinates,
                              double tolerance, std::string_view which) {
  constexpr double rounding = 1e-5; // tolerance for terms that vanish here but are usually large
  const auto terms = terms_at(x);
  for (int i = 0; i < left.size(); ++i)
    if (const double residual = static_cast<double>(left(i));
        !(is_finite(residual) &&
          (std::abs(residual) <= tolerance * static_cast<double>(terms(i)) ||
           std::abs(residual) <=
               rounding * tolerance * static_cast<double>(typical_terms(terms_at, x, coordinates)(i)))))
      return with_number(base::sentence({which, base::counted(i + 1).view(), " has a residual of "}).view(),
                         residual);
  return {};
}

/// Returns a message that names the first redundant constraint that is violated.
template <class Constraints, class State>
base::sentence violated_redundant(Constraints& c, const State& x, double tolerance) {
  return first_violated(
      c.redundant_residual(x), [&](const State& at) { return c.redundant_terms(at); }, x, c.all_coordinates(),
      tolerance, "redundant constraint ");
}

/// Returns a message that names the first redundant constraint whose rate does not vanish. The rate vanishes
/// if the other constraints hold exactly; the closer these are to being linearly dependent, the more their
/// residuals are amplified.
template <class Constraints, class State>
base::sentence violated_redundant_rate(Constraints& c, const State& x, double tolerance) {
  constexpr double nearly_dependent = 1e3;
  return first_violated(
      c.redundant_rate(x), [&](const State& at) { return c.redundant_rate_terms(at); }, x,
      c.all_coordinates(), nearly_dependent * tolerance, "the rate of redundant constraint ");
}

/// Sets the dependent speeds of a state so that constraints that are not linear in them hold, by Newton's
/// method from the given values; returns a message if this fails.
template <class Constraints, class State>
base::sentence find_speeds(Constraints& c, State& placed, const newton_options& options, assembly& report) {
  using vector = typename Constraints::speed_vector;
  vector u(c.dependent_speeds());
  for (int i = 0; i < c.dependent_speeds(); ++i) u(i) = placed(c.place_of_speed(i));
  State tried = placed;
  const auto at = [&](const vector& speeds) -> const State& {
    for (int i = 0; i < c.dependent_speeds(); ++i) tried(c.place_of_speed(i)) = speeds(i);
    return tried;
  };
  const newton_report found = newton(
      u, [&](const vector& speeds) -> vector { return c.velocity_residual(at(speeds)); },
      [&](const vector& speeds) { return c.velocity_jacobian_by_dependent(at(speeds)); }, options);
  report.steps += found.steps;
  if (found.converged || c.velocities_hold(at(u))) {
    placed = at(u);
    return {};
  }
  if (c.velocities_hold(placed)) return {};
  report.velocity_residual = found.residual;
  return with_number(
      found.singular ? "the search for the dependent speeds ended at a singularity of the velocity "
                       "constraints, with a residual of "
                     : "the search for the dependent speeds did not converge; it ended with a residual of ",
      found.residual);
}

/// Solves the velocity constraints for the dependent speeds of a state; returns a message if this fails.
template <class Constraints, class State>
base::sentence place_speeds(Constraints& c, State& placed, const newton_options& options, assembly& report) {
  if constexpr (!Constraints::only_linear)
    if (!c.velocities_are_linear()) return find_speeds(c, placed, options, report);
  const status solved = c.solve_speeds(placed);
  if (solved || c.velocities_hold(placed)) return {};
  return base::sentence({solved.view()});
}

/// Normalizes the quaternions, solves the configuration constraints for the dependent coordinates, starting
/// from those of `x`, then solves the velocity constraints for the dependent speeds, starting from those of
/// `x` if the constraints are not linear in them. On failure, `x` is unchanged. If the constraints cannot be
/// solved, a state that satisfies them up to rounding is accepted without changes.
///
/// `Constraints` provides the residuals at a state, the Jacobian with respect to the dependent coordinates,
/// the dependent speeds, the indices of the dependent entries, and whether the constraints hold up to
/// rounding; unless `only_linear`, also whether the velocity constraints are linear, and their Jacobian with
/// respect to the dependent speeds.
template <class Constraints, class State>
assembly assemble(Constraints& c, State& x, const newton_options& options) {
  using vector = typename Constraints::coordinate_vector;
  assembly report;
  State placed = x;
  if (const status unit = c.normalize_quaternions(placed); !unit) {
    report.failure = base::sentence({unit.view()});
    return report;
  }
  vector q(c.coordinates());
  for (int i = 0; i < c.coordinates(); ++i) q(i) = placed(c.place_of_coordinate(i));
  const vector from = q;
  const auto at = [&](const vector& tried) -> const State& {
    for (int i = 0; i < c.coordinates(); ++i) placed(c.place_of_coordinate(i)) = tried(i);
    return placed;
  };
  newton_report found;
  found.converged = true; // without configuration constraints
  if constexpr (vector::RowsAtCompileTime != 0)
    found = newton(
        q, [&](const vector& tried) -> vector { return c.configuration_residual(at(tried)); },
        [&](const vector& tried) { return c.configuration_jacobian_by_all(at(tried)); }, options);
  report.steps = found.steps;
  report.configuration_residual = found.residual;
  if (!found.converged) found.converged = c.configuration_holds(at(q));
  if (!found.converged || !((q - from).norm() <= 1e-6 * (1 + from.norm()))) {
    if (c.configuration_holds(at(from))) { // a search would not converge to a singular state
      q = from;
      report.configuration_residual = largest(c.configuration_residual(at(q)));
      found.converged = true;
    }
  }
  if (!found.converged) {
    report.failure = with_number(
        found.singular
            ? "the search for the dependent coordinates ended at a singularity of the configuration "
              "constraints, with a residual of "
            : "the search for the dependent coordinates did not converge; it ended with a residual of ",
        found.residual);
    return report;
  }
  at(q);
  c.normalize_quaternions(placed);
  if (report.failure = place_speeds(c, placed, options, report); report.failure) return report;
  report.velocity_residual = largest(c.velocity_residual(placed));
  if (!is_finite(report.velocity_residual)) {
    report.failure = base::sentence({"the velocity constraints are not finite at this state"});
    return report;
  }
  if (report.failure = violated_redundant(c, placed, 1e-9); report.failure) return report;
  if (report.failure = violated_redundant_rate(c, placed, 1e-9); report.failure) return report;
  report.assembled = true;
  x = placed;
  return report;
}

/// Checks whether a state satisfies the constraints within `tolerance`, relative to the terms of each
/// constraint, and reports the first violation.
template <class Constraints, class State>
consistency check_consistency(Constraints& c, const State& x, double tolerance) {
  consistency report;
  const auto check_residual = [&](const auto& residual, const auto& terms, std::string_view which) {
    if (!report.failure)
      report.failure = first_violated(residual, terms, x, c.all_coordinates(), tolerance, which);
    return largest(residual);
  };
  report.configuration_residual = check_residual(
      c.configuration_residual(x), [&](const State& at) { return c.configuration_terms(at); },
      "configuration constraint ");
  report.velocity_residual = check_residual(
      c.velocity_residual(x), [&](const State& at) { return c.velocity_terms(at); }, "velocity constraint ");
  if (!report.failure) report.failure = violated_redundant(c, x, tolerance);
  if (!report.failure) report.failure = violated_redundant_rate(c, x, tolerance);
  report.configuration_residual = larger(report.configuration_residual, largest(c.redundant_residual(x)));
  report.velocity_residual = larger(report.velocity_residual, largest(c.redundant_rate(x)));
  const auto halves = c.quaternion_residual(x); // (e·e − 1)/2
  for (int i = 0; i < halves.size() && !report.failure; ++i)
    if (const double norm = std::sqrt(1 + 2 * static_cast<double>(halves(i)));
        !(is_finite(norm) && std::abs(norm - 1) <= tolerance))
      report.failure = with_number(
          base::sentence({"the norm of ", c.quaternion_called(i).view(), " is "}).view(), norm, 10);
  return report;
}

} // namespace numeric

} // namespace kanexpr
