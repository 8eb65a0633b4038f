#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/linearization.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/control/discretize.hpp>
#include <kanexpr/control/weights.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/semidefinite_factors.hpp>
#include <kanexpr/steps/fixed_step.hpp>

#include <Eigen/Core>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr {

namespace control {

/// Whether a filter supports the measurement, that is, whether it is a scalar or vector expression.
template <auto measured>
constexpr bool is_measurable() {
  if constexpr (requires { describe::shape_of(measured); })
    return describe::shape_of(measured) == describe::shape::scalar ||
           describe::shape_of(measured) == describe::shape::vector;
  else
    return false;
}

/// Whether a matrix has the size and scalar type that the filter requires; the assertions at its uses report
/// the requirement.
template <class Matrix, class Number, int rows, int columns>
inline constexpr bool is_of_filter =
    Matrix::RowsAtCompileTime == rows && Matrix::ColsAtCompileTime == columns &&
    std::is_same_v<typename Matrix::Scalar, Number>;

} // namespace control

/// The extended Kalman filter of a system with noisy sensors: the state estimate and its covariance.
/// `measured` are expressions of the model, scalars and vectors, that may contain velocities and
/// accelerations:
///
///     ekf<System, q1, acceleration_of<P>> filter(x0, P0);
///     if (const status s = filter.predict(t, h, p, r, Q); !s) …   // the state at t + h
///     if (const status s = filter.update(y, p, r, R); !s) …       // correction by the measurements
///
/// The covariance covers the states of the linearized equations, which are the independent coordinates and
/// speeds (`linearization<System>::places`); the dependent ones follow from the constraints, and quaternions
/// keep norm 1. The filter neither allocates nor throws. If a system of equations cannot be solved, or a
/// result would not be finite, the returned status reports it and the filter is unchanged.
///
/// P may be set at any time, so each call factorizes it, P = L D Lᵀ, and rejects P, Q or R if it is not a
/// covariance. The updates of P are sums of squares: A L D (A L)ᵀ + Q, and in Joseph form V D Vᵀ + U E Uᵀ
/// with V = L − K C L, R = M E Mᵀ and U = K M. D and E are nonnegative, so rounding can neither make a
/// variance negative nor make the covariance indefinite relative to its variances, whatever cancellation
/// occurs in between.
template <class System, class Number, auto... measured>
class basic_ekf {
  using lin = linearization<System>;
  static constexpr bool are_measurable = (true && ... && control::is_measurable<measured>());

public:
  static constexpr int states = lin::states;
  static constexpr int measurements = (0 + ... + compiled::extent_of<measured, System>.rows);

  using state = kanexpr::state<System, Number>;
  using covariance = Eigen::Matrix<Number, states, states>;
  using measurement = Eigen::Matrix<Number, measurements, 1>;
  using measurement_covariance = Eigen::Matrix<Number, measurements, measurements>;

  state x;
  covariance P;
  Number t;

  basic_ekf(const state& start, const covariance& uncertainty, Number at = 0)
      : x(start), P(uncertainty), t(at) {}

  /// Predicts the state over a step of length h from t. The inputs r are constant or a function of (t, x);
  /// the disturbance is the covariance of the process noise over one step. The state is advanced by a
  /// fixed-length step, the covariance by the linearized equations.
  template <class Parameters, class Inputs, class Noise, class Step = runge_kutta_4<System>>
  status predict(Number from, Number h, const Parameters& p, const Inputs& r,
                 const Eigen::MatrixBase<Noise>& disturbance, const Step& step = {}) {
    constexpr bool is_fitting = control::is_of_filter<Noise, Number, states, states>;
    static_assert(is_fitting, "the covariance Q must have a row and a column for each independent coordinate "
                              "and speed, and the scalar type of the filter");
    if constexpr (is_fitting)
      return predicted(from, h, p, r, disturbance, step);
    else
      return {};
  }

  /// Returns the measurements expected at the state of the filter.
  template <class Parameters, class Inputs>
  with_status<measurement> expected(const Parameters& p, const Inputs& r) const {
    return measure(p, r).values;
  }

  /// Corrects the state by the measurements y at the time of the filter, given the covariance of their noise.
  template <class Given, class Parameters, class Inputs, class Noise>
  status update(const Eigen::MatrixBase<Given>& y, const Parameters& p, const Inputs& r,
                const Eigen::MatrixBase<Noise>& noise) {
    constexpr bool is_fitting = control::is_of_filter<Given, Number, measurements, 1> &&
                                control::is_of_filter<Noise, Number, measurements, measurements>;
    static_assert(is_fitting || !are_measurable, "y and its covariance R must have a row for each measured "
                                                 "component, and the scalar type of the filter");
    if constexpr (is_fitting && are_measurable)
      return updated(y, p, r, noise);
    else
      return {};
  }

  /// The innovation of the last update, the measured minus the expected values, and its covariance.
  const measurement& innovation() const { return innovation_; }
  const measurement_covariance& innovation_covariance() const { return innovation_covariance_; }

private:
  static constexpr int newton_steps = 2; ///< an update may violate the constraints more than a step does

  using square = numeric::fixed_matrix<Number, states, states>;
  using measured_square = numeric::fixed_matrix<Number, measurements, measurements>;
  using measured_by_states = numeric::fixed_matrix<Number, measurements, states>;

  template <class Parameters, class Inputs, class Noise, class Step>
  status predicted(Number from, Number h, const Parameters& p, const Inputs& r,
                   const Eigen::MatrixBase<Noise>& disturbance, const Step& step) {
    const square before = numeric::as_fixed(P), noise = numeric::as_fixed(disturbance);
    if (const status s = mistake_in(before, of_state); !s) return s;
    if (const status s = mistake_in(noise, of_disturbance); !s) return s;
    const factors<states> known = factors_of_state(before);
    if (!known) return status(of_state.negative);
    if (!factors<states>(noise, rounding<states>, rounding<states>)) return status(of_disturbance.negative);
    constexpr function<System, mechanics::quantity::state_matrix> state_matrix{};
    const auto& inputs = steps::inputs_at(r, from, x);
    const auto linear = discretize(state_matrix(from, x, p, inputs), Eigen::Matrix<Number, states, 0>(), h);
    if (!linear) return compiled::not_finite<System>::cause_of(linear.status, x, p, inputs);
    const square ad = numeric::as_fixed(linear.A);
    const square after = known.squares(known.times_lower(ad), noise);
    if (!numeric::is_finite(after)) return status(of_state.infinite);
    Number to = from;
    state next = x;
    if (const status s = step(to, next, h, p, r); !s) return s;
    x = next;
    P = numeric::as_eigen(after);
    t = to;
    return {};
  }

  template <class Given, class Parameters, class Inputs, class Noise>
  status updated(const Eigen::MatrixBase<Given>& y, const Parameters& p, const Inputs& r,
                 const Eigen::MatrixBase<Noise>& noise) {
    const square before = numeric::as_fixed(P);
    const measured_square uncertainty = numeric::as_fixed(noise);
    if (const status s = mistake_in(before, of_state); !s) return s;
    if (const status s = mistake_in(uncertainty, of_noise); !s) return s;
    const factors<states> known = factors_of_state(before);
    if (!known) return status(of_state.negative);
    const factors<measurements> sensed(uncertainty, rounding<measurements>, rounding<measurements>);
    if (!sensed) return status(of_noise.negative);
    const measured_values now = measure(p, r);
    if (!now.values.status) return now.values.status;
    if (!now.slopes.status) return now.slopes.status;
    const numeric::fixed_matrix<Number, measurements, 1> difference = numeric::as_fixed(y - now.values);
    const measured_by_states c = numeric::as_fixed(now.slopes);
    if (!numeric::is_finite(difference)) return status("a measurement is not finite");
    const measured_by_states seen_factors = known.times_lower(c);
    const measured_square s = known.squares(seen_factors, uncertainty);
    if (!numeric::is_finite(s)) return status("the covariance of the innovation is not finite");
    const numeric::positive_factors<Number, measurements> solved(s);
    if (!solved) return status("the covariance of the innovation is not positive definite");
    const auto k = numeric::transposed(solved.solve(c * before));
    const auto change = k * difference;
    state next = x;
    for (int i = 0; i < states; ++i) next(lin::places[static_cast<std::size_t>(i)]) += change(i);
    using correct = steps::correction<System, newton_steps>;
    if constexpr (correct::is_needed)
      if (const status corrected = correct::apply(t, next, p, r); !corrected) return corrected;
    if (!numeric::is_finite(numeric::as_fixed(next)))
      return status("the state after the update is not finite");
    const square after = sensed.squares(sensed.times_lower(k), // Joseph's form
                                        known.squares(known.lower() - k * seen_factors));
    if (!numeric::is_finite(after)) return status(of_state.infinite);
    x = next;
    P = numeric::as_eigen(after);
    innovation_ = numeric::as_eigen(difference);
    innovation_covariance_ = numeric::as_eigen(s);
    return {};
  }

  struct measured_values {
    with_status<measurement> values;
    with_status<Eigen::Matrix<Number, measurements, states>> slopes;
  };

  template <class Parameters, class Inputs>
  measured_values measure(const Parameters& p, const Inputs& r) const {
    constexpr function<System, measured..., derivation::sensitivity<false, measured...>{}> evaluate{};
    const auto found = evaluate(t, x, p, r);
    measured_values now{};
    int row = 0;
    [&]<std::size_t... index>(std::index_sequence<index...>) {
      (put(now.values, row, std::get<index>(found)), ...);
    }(std::make_index_sequence<sizeof...(measured)>{});
    const auto& slopes = std::get<sizeof...(measured)>(found);
    static_cast<Eigen::Matrix<Number, measurements, states>&>(now.slopes) = slopes;
    now.slopes.status = status_of(slopes);
    if (now.values.status) now.values.status = finite(now.values);
    if (now.slopes.status) now.slopes.status = finite(now.slopes);
    if (!now.values.status)
      now.values.status = compiled::not_finite<System>::cause_of(now.values.status, x, p, r);
    return now;
  }

  template <class Found>
  static void put(with_status<measurement>& into, int& row, const Found& found) {
    if (into.status) into.status = status_of(found);
    if constexpr (requires { found.rows(); })
      for (int i = 0; i < static_cast<int>(found.size()); ++i) into(row++) = found(i);
    else
      into(row++) = static_cast<Number>(found);
  }

  template <int order>
  using factors = numeric::semidefinite_factors<Number, order>;
  template <int order>
  static constexpr Number rounding = 8 * Number(order) * std::numeric_limits<Number>::epsilon();

  /// The covariance of the state may be less accurate, for example because it was written to and read from a
  /// file.
  static factors<states> factors_of_state(const square& m) {
    constexpr Number of_half = numeric::power_of_two<Number>(-std::numeric_limits<Number>::digits / 2);
    const factors<states> found(m, rounding<states> / 8, rounding<states>);
    return found ? found : factors<states>(m, of_half, of_half);
  }

  /// The messages for an invalid covariance, worded like those of `lqr` for the weights.
  struct sentences {
    std::string_view infinite, asymmetric, negative;
  };
  static constexpr sentences of_state{"the covariance of the state is not finite",
                                      "the covariance of the state is not symmetric",
                                      "the covariance of the state is not positive semidefinite"},
      of_disturbance{"the covariance of the disturbance is not finite",
                     "the covariance of the disturbance is not symmetric",
                     "the covariance of the disturbance is not positive semidefinite"},
      of_noise{"the covariance of the noise is not finite", "the covariance of the noise is not symmetric",
               "the covariance of the noise is not positive semidefinite"};

  template <int order>
  static status mistake_in(const numeric::fixed_matrix<Number, order, order>& m, const sentences& of) {
    if (!numeric::is_finite(m)) return status(of.infinite);
    return control::is_symmetric(m) ? status() : status(of.asymmetric);
  }

  template <class Matrix>
  static status finite(const Matrix& m) {
    return numeric::is_finite(numeric::as_fixed(m))
               ? status()
               : status("a measured expression is not finite at this state");
  }

  measurement innovation_ = measurement::Zero();
  measurement_covariance innovation_covariance_ = measurement_covariance::Zero();

  // Placed last because clang++ does not instantiate the members that follow a failed assertion.
  static_assert(are_measurable, "a filter can measure only scalar and vector expressions of the model");
};

/// The extended Kalman filter in `double`; `basic_ekf<System, float, …>` selects a different scalar type.
template <class System, auto... measured>
using ekf = basic_ekf<System, double, measured...>;

} // namespace kanexpr

#include <kanexpr/base/letters_back.hpp>
