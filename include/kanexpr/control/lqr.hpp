#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/control/discretize.hpp>
#include <kanexpr/control/riccati.hpp>
#include <kanexpr/control/weights.hpp>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr {

/// The linear feedback r = −K x, and the matrix P that gives the cost xᵀ P x of a motion starting at x. If
/// the status reports a failure, both are NaN.
template <class Gain, class Cost>
struct linear_regulator {
  Gain K;
  Cost P;
  kanexpr::status status;

  /// Whether a regulator was found.
  constexpr explicit operator bool() const { return static_cast<bool>(status); }
};

namespace control {

/// Checks the arguments of a regulator.
template <class Number, int states, int inputs>
constexpr status
mistake_in(const fixed_matrix<Number, states, states>& a, const fixed_matrix<Number, states, inputs>& b,
           const fixed_matrix<Number, states, states>& q, const fixed_matrix<Number, inputs, inputs>& r) {
  if (!numeric::is_finite(a)) return status("the state matrix A is not finite");
  if (!numeric::is_finite(b)) return status("the input matrix B is not finite");
  if (!numeric::is_finite(q)) return status("the weights of the states are not finite");
  if (!numeric::is_finite(r)) return status("the weights of the inputs are not finite");
  if (!is_symmetric(q)) return status("the weights of the states are not symmetric");
  if (!is_symmetric(r)) return status("the weights of the inputs are not symmetric");
  if (!is_positive_semidefinite(q)) return status("the weights of the states are not positive semidefinite");
  if (!is_positive_definite(r)) return status("the weights of the inputs are not positive definite");
  return {};
}

template <time_domain domain, class Number, int states, int inputs>
constexpr linear_regulator<fixed_matrix<Number, inputs, states>, fixed_matrix<Number, states, states>>
regulator(const fixed_matrix<Number, states, states>& a, const fixed_matrix<Number, states, inputs>& b,
          const fixed_matrix<Number, states, states>& q, const fixed_matrix<Number, inputs, inputs>& r,
          const status& given) {
  linear_regulator<fixed_matrix<Number, inputs, states>, fixed_matrix<Number, states, states>> found{
      no_numbers<Number, inputs, states>(), no_numbers<Number, states, states>(), given};
  if (found) found.status = mistake_in(a, b, q, r);
  if (!found) return found;
  fixed_matrix<Number, inputs, states> gain;
  fixed_matrix<Number, states, states> cost;
  found.status = scaled_equation<domain, Number, states, inputs>(a, b, q, r).solve(gain, cost);
  if (found) found.K = gain, found.P = cost;
  return found;
}

/// Accepts matrices of any type, each of which may carry a status; a status may also be passed separately.
template <time_domain domain, class StateMatrix, class InputMatrix, class Number, int states, int inputs>
constexpr auto regulator_of(const StateMatrix& a, const InputMatrix& b, const weights<Number, states>& q,
                            const weights<Number, inputs>& r, const status& given = {}) {
  if constexpr (!are_fitting<StateMatrix, InputMatrix>()) {
    return linear_regulator<fixed_matrix<Number, 1, 1>, fixed_matrix<Number, 1, 1>>{};
  } else {
    const auto found = regulator<domain, Number, states, inputs>(fixed(a), fixed(b), q.matrix, r.matrix,
                                                                 given ? first_failure(a, b) : given);
    const auto like = [](const auto& matrix) { return shape<StateMatrix>::like(matrix); };
    return linear_regulator<decltype(like(found.K)), decltype(like(found.P))>{like(found.K), like(found.P),
                                                                              found.status};
  }
}

template <class StateMatrix>
using weights_of_states = weights<typename shape<StateMatrix>::scalar, shape<StateMatrix>::rows>;
template <class StateMatrix, class InputMatrix>
using weights_of_inputs = weights<typename shape<StateMatrix>::scalar, shape<InputMatrix>::columns>;

} // namespace control

/// Returns the feedback r = −K x of ẋ = A x + B r that minimizes ∫ xᵀ Q x + rᵀ R r. It uses structured
/// doubling in a bounded number of steps, without heap allocation, and runs on a microcontroller as well as
/// in a constant expression. A and B are fixed-size Eigen matrices, such as those of a linearization, or
/// `numeric::fixed_matrix`. Q and R are the weights of the states and of the inputs: `lqr(A, B, {10, 1},
/// {0.1})`. If no such feedback exists, the status reports this, and K and P are NaN.
template <control::matrix StateMatrix, control::matrix InputMatrix>
constexpr auto lqr(const StateMatrix& a, const InputMatrix& b,
                   const control::weights_of_states<StateMatrix>& q,
                   const control::weights_of_inputs<StateMatrix, InputMatrix>& r) {
  return control::regulator_of<control::time_domain::continuous>(a, b, q, r);
}

/// Accepts both matrices of a linearization: `lqr(linearization<System>::explicit_form(x, p, r), {10, 1},
/// {0.1})`.
template <class StateMatrix, class InputMatrix>
constexpr auto lqr(const std::tuple<StateMatrix, InputMatrix>& both,
                   const control::weights_of_states<StateMatrix>& q,
                   const control::weights_of_inputs<StateMatrix, InputMatrix>& r) {
  return lqr(std::get<0>(both), std::get<1>(both), q, r);
}

/// Solves the corresponding problem for x⁺ = A x + B r and the sum of xᵀ Q x + rᵀ R r over all steps:
/// `dlqr(A, B, {10, 1}, {0.1})`.
template <control::matrix StateMatrix, control::matrix InputMatrix>
constexpr auto dlqr(const StateMatrix& a, const InputMatrix& b,
                    const control::weights_of_states<StateMatrix>& q,
                    const control::weights_of_inputs<StateMatrix, InputMatrix>& r) {
  return control::regulator_of<control::time_domain::discrete>(a, b, q, r);
}

/// Accepts the result of `discretize` with its status: `dlqr(discretize(A, B, h), {10, 1}, {0.1})`.
template <class StateMatrix, class InputMatrix, class Offset>
constexpr auto dlqr(const discrete_form<StateMatrix, InputMatrix, Offset>& form,
                    const control::weights_of_states<StateMatrix>& q,
                    const control::weights_of_inputs<StateMatrix, InputMatrix>& r) {
  return control::regulator_of<control::time_domain::discrete>(form.A, form.B, q, r, form.status);
}

} // namespace kanexpr

#include <kanexpr/base/letters_back.hpp>
