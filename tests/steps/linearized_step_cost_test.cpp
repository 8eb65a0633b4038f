// builds: clang++ all
// Compares the reported cost of a step with derivatives with the operations that a counting scalar performs.
#include "runtime/four_bars.hpp"

#include <kanexpr/steps/linearized_step.hpp>
#include <models/double_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

struct operations {
  int multiplications = 0, additions = 0, divisions = 0;
};
operations done;

struct counted {
  double value = 0;

  counted() = default;
  counted(double x) : value(x) {}
  counted(int x) : value(x) {}

  friend counted operator+(const counted& a, const counted& b) { return ++done.additions, a.value + b.value; }
  friend counted operator-(const counted& a, const counted& b) { return ++done.additions, a.value - b.value; }
  friend counted operator*(const counted& a, const counted& b) {
    return ++done.multiplications, a.value * b.value;
  }
  friend counted operator/(const counted& a, const counted& b) { return ++done.divisions, a.value / b.value; }
  friend counted operator-(const counted& a) { return -a.value; }
  counted& operator+=(const counted& b) { return *this = *this + b; }
  counted& operator-=(const counted& b) { return *this = *this - b; }
  counted& operator*=(const counted& b) { return *this = *this * b; }
  counted& operator/=(const counted& b) { return *this = *this / b; }
  friend bool operator>(const counted& a, const counted& b) { return a.value > b.value; }
  friend counted sin(const counted& a) { return std::sin(a.value); }
  friend counted cos(const counted& a) { return std::cos(a.value); }
  friend counted sqrt(const counted& a) { return std::sqrt(a.value); }
  friend counted abs(const counted& a) { return std::abs(a.value); }
};

} // namespace

template <>
struct Eigen::NumTraits<counted> : Eigen::NumTraits<double> {
  using Real = counted;
  using NonInteger = counted;
  using Nested = counted;
};

namespace {

using namespace kanexpr;

// The operations of the checks of a function, which its cost does not include.
template <class Function, class... Arguments>
operations of_checks(const Arguments&... at) {
  done = {};
  Function{}(at...);
  return {done.multiplications - Function::cost().multiplications,
          done.additions - Function::cost().additions, done.divisions - Function::cost().divisions};
}

template <class System, class Step>
struct evaluations {
  template <class... Arguments>
  static operations of_checks(const Arguments&... at) {
    const operations one = ::of_checks<typename steps::rates_with_derivatives<System>::evaluated>(at...);
    constexpr int n = Step::stages;
    return {n * one.multiplications, n * one.additions, n * one.divisions};
  }
};
template <class System, int corrections>
struct evaluations<System, semi_implicit_euler<System, corrections>> {
  template <class... Arguments>
  static operations of_checks(const Arguments&... at) {
    using step = steps::varied_step<semi_implicit_euler<System, corrections>>;
    operations all = ::of_checks<typename step::template varied<mechanics::quantity::udot>>(at...);
    const auto add = [&](const operations& more) {
      all.multiplications += more.multiplications;
      all.additions += more.additions;
      all.divisions += more.divisions;
    };
    add(::of_checks<typename step::template varied<mechanics::quantity::qdot>>(at...));
    using correction = steps::varied_correction<System, corrections>;
    if constexpr (compiled::survey_of<System>.configuration_constraints > 0)
      add(::of_checks<typename correction::template varied<mechanics::quantity::configuration_step>>(at...));
    if constexpr (compiled::survey_of<System>.constraints > 0)
      add(::of_checks<typename correction::template varied<mechanics::quantity::dependent_speeds>>(at...));
    if constexpr (compiled::survey_of<System>.constraints > 0)
      for (int twice = 0; twice < 2; ++twice)
        add(::of_checks<function<System, mechanics::quantity::constraint_pivots>>(at...));
    return all;
  }
};

template <class Step, class System>
void expect_cost(const state<System>& x, const parameter_values<System>& p, const input_values<System>& r) {
  const state<System, counted> at(x.template cast<counted>());
  const parameter_values<System, counted> parameters(p.template cast<counted>());
  const input_values<System, counted> inputs(r.template cast<counted>());
  const operations checks = evaluations<System, Step>::of_checks(counted(0), at, parameters, inputs);
  done = {};
  const auto next = linearized<Step>{}(counted(0), at, counted(0.01), parameters, inputs);
  ASSERT_TRUE(next.status) << next.status;
  constexpr symbolic::cost said = linearized<Step>::cost();
  EXPECT_EQ(said.multiplications, done.multiplications - checks.multiplications);
  // For a counting scalar, each check of finiteness is a subtraction: of the time, and of each state.
  EXPECT_EQ(said.additions, done.additions - checks.additions - 1 - static_cast<int>(x.size()));
  EXPECT_EQ(said.divisions, done.divisions - checks.divisions);
}

TEST(linearized_step, costs_what_it_does) {
  using System = double_pendulum::System;
  const state<System> x = state<System>::Constant(0.3);
  const parameter_values<System> p = parameter_values<System>::Constant(1.2);
  const input_values<System> r = input_values<System>::Constant(0.1);
  expect_cost<runge_kutta_4<System>>(x, p, r);
  expect_cost<ralston_3<System>>(x, p, r);
  expect_cost<semi_implicit_euler<System>>(x, p, r);
}

TEST(linearized_step, costs_what_it_does_with_constraints) {
  const four_bars closed;
  expect_cost<semi_implicit_euler<four_bars::System>>(closed.x, closed.p, closed.r);
}

} // namespace
