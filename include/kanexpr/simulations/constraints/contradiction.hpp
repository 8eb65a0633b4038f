#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/derivation/survey.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>

namespace kanexpr::simulations {

/// Returns a message about the first dependent coordinate or speed whose given value contradicts the
/// constraints: "speed u2, which is dependent, was given as 30, but the constraints require 0". A value may
/// be rounded to four digits; a value of 0 is compared with the largest of its kind.
template <class IsGiven>
std::string contradiction(const derivation::survey& known, const Eigen::VectorXd& given,
                          const Eigen::VectorXd& found, const IsGiven& is_given) {
  constexpr double of_itself = 1e-4, of_the_largest = 1e-7;
  const auto largest = [&](int from, int count) {
    return count == 0 ? 0.0 : found.segment(from, count).cwiseAbs().maxCoeff();
  };
  const double coordinate = largest(0, known.coordinates), speed = largest(known.coordinates, known.speeds);
  for (int i = 0; i < known.coordinates + known.speeds; ++i) {
    if (!known.dependent[i] || !is_given(static_cast<std::size_t>(i))) continue;
    const double rounding = of_itself * (std::max)(std::abs(given(i)), std::abs(found(i))),
                 noise = of_the_largest * (i < known.coordinates ? coordinate : speed);
    if (std::abs(given(i) - found(i)) > rounding + noise)
      return std::string(compiled::symbol_called(known, i).view()) + ", which is dependent, was given as " +
             base::digits(given(i)) + ", but the constraints require " +
             base::digits(std::abs(found(i)) > noise ? found(i) : 0);
  }
  return {};
}

/// The same for the initial state of a motion, with a suggested remedy.
template <class IsGiven>
std::string contradiction_at_start(const derivation::survey& known, const Eigen::VectorXd& given,
                                   const Eigen::VectorXd& found, const IsGiven& is_given) {
  const std::string mistake = contradiction(known, given, found, is_given);
  return mistake.empty() ? mistake
                         : mistake + "; omit it, declare others dependent<...>, or set guesses_dependent";
}

} // namespace kanexpr::simulations
