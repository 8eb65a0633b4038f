#pragma once

#include <kanexpr/symbolic.hpp>
#include <models/arm6.hpp>
#include <models/bicycle.hpp>
#include <models/n_pendulum_cart.hpp>

#include <Eigen/Core>

#include <limits>
#include <random>
#include <string>
#include <vector>

/// Systems with symbols for all their parameters, and for each an operating point that gives everything a
/// number.
namespace linearized {

using kanexpr::linearization_point;

/// The benchmark bicycle, upright and straight ahead at 4.6 m/s.
struct bicycle {
  using System = ::bicycle::System;
  static constexpr const char* name = "bicycle";

  static linearization_point point() {
    linearization_point at;
    const auto& benchmark = ::bicycle::BoundSystem::record.values;
    for (int i = 0; i < benchmark.size; ++i) {
      const kanexpr::describe::token* const equation = benchmark[i].tokens; // parameter, number, subtract
      at.set(std::string(equation[0].symbol->called.view()), equation[1].number.value());
    }
    for (const char* still : {"q1", "q2", "q4", "q5", "u1", "u2", "u4", "u5"}) at.set(still, 0);
    return at.set("u3", 4.6 / 0.3).set("u6", 4.6 / 0.35);
  }
};

/// Values between two limits, the same in each run.
class values {
public:
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(source_);
  }

private:
  std::mt19937_64 source_{6};
};

/// A chain of ten pendulums, nearly upright and in motion, on a cart that is pushed.
struct cart {
  static constexpr int pendulums = 10;
  using System = n_pendulum_cart::System<pendulums>;
  static constexpr const char* name = "cart";

  static linearization_point point() {
    linearization_point at{{"g", 9.81}, {"F", 3.0}, {"q0", 0.2}, {"u0", -0.4}, {"m0", 5.0}};
    values random;
    for (int i = 1; i <= pendulums; ++i) {
      const std::string bob = std::to_string(i), rod = std::to_string(i - 1);
      at.set("q" + bob, random.between(1.2, 1.9)).set("u" + bob, random.between(-0.5, 0.5));
      at.set("m" + bob, random.between(0.5, 2)).set("l" + rod, random.between(0.3, 0.8));
    }
    return at;
  }
};

/// An arm of six links in motion.
struct arm {
  using System = arm6::System;
  static constexpr const char* name = "arm";

  static linearization_point point() {
    linearization_point at{{"g", 9.81}};
    values random;
    for (int i = 1; i <= 6; ++i) {
      const std::string link = std::to_string(i);
      at.set("q" + link, random.between(-3, 3)).set("u" + link, random.between(-1, 1));
      at.set("T" + link, random.between(-5, 5)).set("m" + link, random.between(1, 4));
      for (const char* moment : {"Ixx", "Iyy", "Izz"}) at.set(moment + link, random.between(0.2, 0.3));
      for (const char* product : {"Ixy", "Iyz", "Izx"}) at.set(product + link, random.between(-0.03, 0.03));
      for (const char* of_center : {"x", "y", "z"}) at.set(of_center + link, random.between(-0.2, 0.2));
      if (i < 6)
        for (const char* of_joint : {"a", "b", "d"}) at.set(of_joint + link, random.between(-0.4, 0.4));
    }
    return at;
  }
};

struct result {
  Eigen::MatrixXd A, B;
  std::vector<std::string> failures;
};

/// Derives one of the above and linearizes it about its point. What is no number comes out as not-a-number.
template <class Case>
result from_the_start(const linearization_point& at) {
  auto model = kanexpr::derive<typename Case::System>();
  auto linear = model.linearize(at);
  const auto numbers = [&](const kanexpr::symbolic::matrix& m) {
    Eigen::MatrixXd found(m.rows, m.columns);
    for (int i = 0; i < m.rows; ++i)
      for (int j = 0; j < m.columns; ++j)
        found(i, j) = m(i, j).is_constant() ? model.graph().number_at(m(i, j).node()).value()
                                            : std::numeric_limits<double>::quiet_NaN();
    return found;
  };
  const auto& [A, B] = linear.explicit_form();
  return {numbers(A), numbers(B), linear.failures()};
}

} // namespace linearized
