#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <Eigen/Core>

/// Quaternions within a vector, given by the indices of their entries.
namespace kanexpr::lower {

template <class State, class Places>
[[gnu::always_inline]] inline typename State::Scalar squared_norm(const State& x, const Places& places) {
  using Number = typename State::Scalar;
  Number sum = scalar_math<Number>::from(0);
  for (const int place : places) sum = Number(sum + Number(x(place) * x(place)));
  return sum;
}

/// The admissible norms of a quaternion before normalization.
struct norm_range {
  double least = 0, most = numeric::infinity<double>;
};

/// Divides a quaternion by its norm; the argument is the square of the norm.
template <class State, class Places>
[[gnu::always_inline]] inline void divide_by_norm(State& x, const Places& places,
                                                  const typename State::Scalar& square) {
  using Number = typename State::Scalar;
  using math = scalar_math<Number>;
  const Number scale = Number(math::from(1) / math::template by_name<symbolic::operation::sqrt>(square));
  for (const int place : places) x(place) = Number(x(place) * scale);
}

/// Normalizes a quaternion; returns false if its norm is outside the range.
template <class State, class Places>
[[gnu::always_inline]] inline bool normalize(State& x, const Places& places, const norm_range& from) {
  using Number = typename State::Scalar;
  using math = scalar_math<Number>;
  const Number square = squared_norm(x, places);
  if (!math::exceeds(square, math::from(from.least * from.least)) ||
      !math::exceeds(Number(-square), math::from(-(from.most * from.most))))
    return false;
  divide_by_norm(x, places, square);
  return true;
}

/// Removes the component along the quaternion from derivatives with respect to a unit quaternion. The result
/// is the derivative of the function of the normalized quaternion.
template <class Jacobian, class State, class Places>
void leave_norm_out(Jacobian& by_all, const State& x, const Places& places) {
  for (Eigen::Index i = 0; i < by_all.rows(); ++i) {
    auto along = by_all(i, 0) * 0;
    for (const int place : places) along += by_all(i, place) * x(place);
    for (const int place : places) by_all(i, place) -= along * x(place);
  }
}

} // namespace kanexpr::lower
