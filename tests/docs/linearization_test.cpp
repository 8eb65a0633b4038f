// builds: clang++
// Linearization: docs/guide/linearization.md, except for the bicycle.
#include "docs/printed.hpp"
#include "docs/text.hpp"
#include "models/four_bar.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <iostream>

namespace {

using namespace kanexpr;

namespace linkage {

using namespace four_bar;

class linearized : public testing::Test {
protected:
  const state<System> x{{q1, -2.27}, {q2, 3}, {q3, -1.5}, {u1, -1.96}, {u2, 0}, {u3, 0}};
  const parameter_values<System> p{{l0, 2}, {l1, 1}, {l2, 2},   {l3, 1.5}, {d1, 0.5}, {d2, 1},   {d3, 0.75},
                                   {m1, 1}, {m2, 2}, {m3, 1.5}, {I1, 0.1}, {I2, 0.7}, {I3, 0.3}, {g, 9.81}};
  const input_values<System> r{{T, 0}};
};

TEST_F(linearized, by_the_compiler) {
#include <docs/guide/linearization/compiled.cpp>
  EXPECT_EQ(Ac.rows(), 2);
  EXPECT_EQ(Bc.cols(), 1);
  EXPECT_EQ(Cc.cols(), 2);
  EXPECT_EQ(Dc.rows(), Cc.rows());
  EXPECT_EQ(by_state.cols(), 6);
  EXPECT_EQ(by_inputs.cols(), 1);
}

TEST_F(linearized, beside_frames_of_the_same_names) {
#include <docs/guide/linearization/hidden.cpp>
  EXPECT_NEAR(axis(0), std::cos(-2.27), 1e-12);
  EXPECT_NEAR(rate(2), -1.96, 1e-12);
}

} // namespace linkage

namespace pendulum {

using namespace simple_pendulum;

TEST(linearization, is_printed) {
  const docs::printed here;
#include <docs/guide/linearization/run_time.cpp>

#include <docs/guide/linearization/failures.cpp>
  EXPECT_EQ(here.text(), docs::text("docs/guide/linearization/run_time.text"));
}

} // namespace pendulum
} // namespace
