// builds: clang++ sanitize
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/graph/substitute.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using graph_evaluation::evaluate;

class substitute : public testing::Test, protected symbols {};

TEST_F(substitute, replaces_everywhere_and_at_once) {
  substitution swap(g);
  swap.replace(x, y);
  swap.replace(y, x);
  EXPECT_EQ(swap.in(x - y), y - x);
  EXPECT_EQ(swap.in(sin(x) / (y * y)), sin(y) / (x * x));
  EXPECT_EQ(swap.in(power(x, a) * atan2(y, b)), power(y, a) * atan2(x, b));
}

TEST_F(substitute, simplifies_on_the_way) {
  substitution at_rest(g);
  at_rest.replace(q1, number(0));
  at_rest.replace(u1, number(0));
  EXPECT_EQ(at_rest.in(m * r * u1 * u1 + a * cos(q1)), a);
  EXPECT_EQ(at_rest.in(sin(q1) * (x + y) + u1), number(0));
  EXPECT_EQ(at_rest.in(sqrt(q1_rate * q1 + 4) * a), 2 * a);
}

TEST_F(substitute, keeps_what_holds_nothing_of_it) {
  const expression e = sin(a) * b + c;
  const int size = g.size();
  substitution s(g);
  s.replace(x, y);
  EXPECT_EQ(s.in(e), e);
  EXPECT_EQ(g.size(), size);
}

TEST_F(substitute, replaces_whole_expressions) {
  substitution s(g);
  s.replace(sin(q1), x);
  EXPECT_EQ(s.in(sin(q1) * sin(q1) + cos(q1) * q1), x * x + cos(q1) * q1);
}

TEST_F(substitute, keeps_the_value_where_the_new_parts_have_the_value_of_the_old) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    for (int i = 0; i < 40; ++i) {
      const random_formulas::formula f = random.make(1 + i % 5);
      const std::vector<long double>& at = random.point(0);
      const auto number_at = [&](expression e) { return s.number(static_cast<double>(evaluate(e, at))); };
      substitution by(s.g);
      by.replace(s.a, s.b + number_at(s.a - s.b));
      by.replace(s.q1, s.u1 * number_at(s.q1 / s.u1));
      const long double tolerance = 1e-12L * std::abs(f.value[0]) + 1000 * f.error[0];
      ASSERT_PRED3(are_close, evaluate(by.in(f.e), at), f.value[0], tolerance) << seed << ' ' << i;
    }
  }
}

} // namespace
