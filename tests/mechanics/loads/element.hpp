// A force element as a row of the table of elements: a mechanism with this element as its only load, and the
// power of the element by its own law, in plain numbers.
#pragma once

#include <Eigen/Core>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/model.hpp>

#include <functional>
#include <string>
#include <vector>

namespace elements {

using Eigen::VectorXd;
using kanexpr::symbolic::expression;

enum class nature {
  conservative, ///< its power is the rate at which its energy falls
  dissipative,  ///< its power and the rate of its energy are negative together
  driven,       ///< it may give energy
};

struct mechanism_with_element {
  kanexpr::model model;
  std::vector<expression> measured; ///< lengths, rates and slip speeds, from which the law follows
  expression stored{};              ///< energy of the element that is no potential energy; may be omitted
};

struct element {
  std::string name;
  nature is{};
  std::function<mechanism_with_element()> build;
  std::function<double(const VectorXd& measured)> power;
  std::function<void(VectorXd& state)> settle = [](VectorXd&) {}; ///< moves a random state to a valid one
};

} // namespace elements
