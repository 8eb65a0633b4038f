// builds: g++
// The steps of tests/exporting/models_in_c.cpp, compiled as C, compared with the compiled steps.
#include "bead.hpp"

#include <kanexpr/fixed_step.hpp>
#include <models/appell_hamel.hpp>
#include <steps/quaternions.hpp>

#include <appell_hamel.h>
#include <appell_hamel_in_float.h>
#include <bead.h>
#include <bead_in_float.h>
#include <sliding.h>
#include <sliding_in_float.h>

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;

/// Compares the steps from 300 random states; returns how many of them succeeded.
template <class System, class Number, class Written, class Step>
int steps_made(const Written& written, const char* const causes[], const Step& step) {
  std::mt19937 random{3};
  const auto number = [&](double from, double to) {
    return static_cast<Number>(std::uniform_real_distribution<double>(from, to)(random));
  };
  int made = 0;
  for (int repetition = 0; repetition < 300; ++repetition) {
    state<System, Number> x;
    parameter_values<System, Number> p;
    input_values<System, Number> r;
    for (auto& e : x.reshaped()) e = number(-0.9, 0.9);
    for (auto& e : p.reshaped()) e = number(0.1, 1.5);
    for (auto& e : r.reshaped()) e = number(-3, 3);
    Number t = number(-1, 1);
    const Number h = number(-0.01, 0.03);
    std::vector<Number> next(x.begin(), x.end());
    const unsigned long long bits = written(t, next.data(), h, p.data(), r.data(), next.data());
    const status compiled = step(t, x, h, p, r);
    EXPECT_EQ(bits == 0, static_cast<bool>(compiled)) << compiled.cause();
    if (bits != 0) {
      EXPECT_EQ(causes[std::countr_zero(bits)], compiled.cause() == steps::singular_position
                                                    ? steps::singular_position_elsewhere
                                                    : compiled.view());
      continue;
    }
    ++made;
    for (std::size_t i = 0; i < next.size(); ++i)
      EXPECT_EQ(next[i], x[static_cast<Eigen::Index>(i)]) << "to the last bit, entry " << i;
  }
  return made;
}

TEST(StepsInC, HaveTheBitsOfCompiledOnes) {
  using bead::System;
  EXPECT_GT(
      (steps_made<System, double>(bead_runge_kutta_4, bead_runge_kutta_4_causes, runge_kutta_4<System>{})),
      250);
  EXPECT_GT((steps_made<System, double>(bead_ralston_3, bead_ralston_3_causes, ralston_3<System>{})), 250);
  EXPECT_GT((steps_made<System, float>(bead_in_float_runge_kutta_4, bead_in_float_runge_kutta_4_causes,
                                       runge_kutta_4<System>{})),
            250);
}

TEST(StepsInC, ReturnToConstraintsAndNorms) {
  using quaternions::Sliding;
  const int by_runge_kutta = steps_made<Sliding, double>(sliding_runge_kutta_4, sliding_runge_kutta_4_causes,
                                                         runge_kutta_4<Sliding>{}),
            by_euler = steps_made<Sliding, float>(sliding_in_float_euler, sliding_in_float_euler_causes,
                                                  semi_implicit_euler<Sliding, 2>{});
  EXPECT_GT(by_runge_kutta, 40);
  EXPECT_LT(by_runge_kutta, 300) << "some norms are far from 1, some steps pass a singular position";
  EXPECT_GT(by_euler, 30);
}

// Two Newton steps for the dependent speed.
TEST(StepsInC, ReturnToConstraintsThatAreNotLinear) {
  using appell_hamel::System;
  EXPECT_GT((steps_made<System, double>(appell_hamel_runge_kutta_4, appell_hamel_runge_kutta_4_causes,
                                        runge_kutta_4<System>{})),
            100);
  EXPECT_GT((steps_made<System, double>(appell_hamel_euler, appell_hamel_euler_causes,
                                        semi_implicit_euler<System, 2>{})),
            100);
  EXPECT_GT((steps_made<System, float>(appell_hamel_in_float_euler, appell_hamel_in_float_euler_causes,
                                       semi_implicit_euler<System, 2>{})),
            100);
}

} // namespace
