// builds: clang++
// The shortest of several forms, and complete linearizations as an engineer would write them.
#include "models/double_pendulum.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/algebra.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

TEST(simplify, takes_the_shortest_form) {
  graph g;
  const auto symbol = [&](const char* called, int place) {
    return variable(g, {symbol_kind::parameter, kanexpr::base::name(called), place});
  };
  const expression a = symbol("a", 0), b = symbol("b", 1), q = symbol("q", 2);
  EXPECT_EQ(print(simplify((a * a - b * b) / (a + b))), "a - b");
  EXPECT_EQ(print(simplify(a * sin(q) * sin(q) + a * cos(q) * cos(q))), "a");
  EXPECT_EQ(print(simplify((a + b) * (a + b) * (a - b))), print((a + b) * (a + b) * (a - b)));
}

// Two point masses on rods along the vertical axis, without a motor or friction.
TEST(simplify, writes_a_linearized_double_pendulum) {
  using namespace double_pendulum;
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize({{q1, 0}, {q2, 0}, {u1, 0}, {u2, 0}}, {{c1, 0}, {c2, 0}, {I1, 0}, {I2, 0}},
                                {{d1, l1}, {d2, l1}});
  EXPECT_TRUE(linear);
  EXPECT_EQ(print(simplify(linear.explicit_form().B)), "[0,            0                       ]\n"
                                                       "[0,            0                       ]\n"
                                                       "[1/(l1^2*m1),  -2/(l1^2*m1)            ]\n"
                                                       "[-1/(l1^2*m1), (m1 + 2*m2)/(l1^2*m1*m2)]");
}

// Wobble and yaw of a disc that rolls straight ahead.
TEST(simplify, writes_a_linearized_disc) {
  using namespace rolling_disc;
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize({{q1, 0}, {q2, 0}, {u1, 0}, {u3, 0}});
  EXPECT_EQ(print(simplify(linear.explicit_form().A)), "[0, 0,         0, 0,     0, 1     ]\n"
                                                       "[0, 0,         0, 1,     0, 0     ]\n"
                                                       "[0, 0,         0, 0,     1, 0     ]\n"
                                                       "[0, 4*g/(5*r), 0, 0,     0, 6*u2/5]\n"
                                                       "[0, 0,         0, 0,     0, 0     ]\n"
                                                       "[0, 0,         0, -2*u2, 0, 0     ]");
}

} // namespace
