// builds: clang++
// Curves through points, compared with those of SciPy.
#include "references.hpp"
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/tabulated.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace kanexpr::symbolic;

class table_of_points : public testing::Test, protected symbols {
protected:
  double at(expression e, double x_is) const {
    return values_at(g, {e.node()}, [&](int id) { return id == x.node() ? x_is : given(id); })[0];
  }
  /// The points are numbers, or parameters with these values.
  template <std::size_t count>
  sequence<expression> expressions(const double (&points)[count], bool is_bound) {
    sequence<expression> all;
    for (const double each : points) {
      static constexpr char letters[] = "abcdefghijklmnopqrst";
      const char called[]{letters[all.size()], '\0'};
      expression one = number(each);
      if (!is_bound) {
        one = of(kind::parameter, called);
        values_.push_back(each);
        nodes_.push_back(one.node());
      }
      all.push(one);
    }
    return all;
  }
  template <std::size_t count>
  expression curve(const double (&points)[count], bool is_bound) {
    return tabulated(x, expressions(points, is_bound).begin(), static_cast<int>(count) / 2);
  }
  template <std::size_t size, std::size_t count>
  void expect_curve(const double (&points)[size], const references::on_curve (&there)[count]) {
    for (const bool is_bound : {true, false}) {
      const expression e = curve(points, is_bound), slope = differentiate(e, x),
                       curvature = differentiate(slope, x);
      accumulation reverse(g, {e});
      reverse.seed(e, number(1));
      reverse.run();
      for (const references::on_curve& on : there) {
        SCOPED_TRACE(on.x);
        EXPECT_NEAR(at(e, on.x), on.value, 2e-14 * (1 + std::abs(on.value)));
        EXPECT_NEAR(at(slope, on.x), on.slope, 1e-12 * (1 + std::abs(on.slope)));
        EXPECT_NEAR(at(reverse.by(x), on.x), on.slope, 1e-12 * (1 + std::abs(on.slope)));
        EXPECT_NEAR(at(curvature, on.x), on.curvature, 1e-10 * (1 + std::abs(on.curvature)));
      }
      expect_ends(e, points);
    }
  }
  template <std::size_t size>
  void expect_ends(expression e, const double (&points)[size]) {
    const expression slope = differentiate(e, x);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double before : {points[0], points[0] - 1, -1e300, -infinity}) {
      EXPECT_EQ(at(e, before), points[1]);
      EXPECT_EQ(at(slope, before), 0);
    }
    for (const double beyond : {points[size - 2], points[size - 2] + 1, 1e300, infinity}) {
      EXPECT_NEAR(at(e, beyond), points[size - 1], 4e-15 * (1 + std::abs(points[size - 1])));
      EXPECT_EQ(at(slope, beyond), 0);
    }
    EXPECT_TRUE(std::isnan(at(e, std::nan(""))));
    for (std::size_t i = 0; i < size; i += 2)
      EXPECT_NEAR(at(e, points[i]), points[i + 1], 4e-15 * (1 + std::abs(points[i + 1])));
  }

private:
  double given(int id) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i] == id) return values_[i];
    return 0;
  }
  std::vector<int> nodes_{};
  std::vector<double> values_{};
};

TEST_F(table_of_points, curve_goes_with_a_plateau) {
  expect_curve(references::force_points, references::force);
}
TEST_F(table_of_points, curve_of_two_points_is_straight) {
  expect_curve(references::line_points, references::line);
}
TEST_F(table_of_points, curve_turns_at_points) {
  expect_curve(references::zigzag_points, references::zigzag);
}
TEST_F(table_of_points, curve_bends_at_its_ends) { expect_curve(references::bend_points, references::bend); }

/// The slopes on both sides of a point are equal.
TEST_F(table_of_points, curve_has_one_slope_at_a_point) {
  const expression slope = differentiate(curve(references::zigzag_points, true), x);
  for (const double point : {1.0, 2.5, 3.0}) {
    EXPECT_NEAR(at(slope, point), at(slope, point + 1e-12), 1e-10);
    EXPECT_NEAR(at(slope, point), at(slope, point - 1e-12), 1e-10);
  }
}

TEST_F(table_of_points, curve_is_monotone_where_its_points_are) {
  const expression e = curve({0.0, 0.0, 1.0, 1e-3, 1.1, 5.0, 4.0, 5.0, 4.5, 5.5}, true);
  for (double place = 0.01, before = 0; place < 4.6; place += 0.01) {
    const double now = at(e, place);
    EXPECT_GE(now, before - 2e-15);
    before = now;
  }
}

TEST_F(table_of_points, periodic_curve_goes_on) {
  constexpr double period = 2.5;
  for (const bool is_bound : {true, false}) {
    const expression e = periodic(x, expressions(references::wave_points, is_bound).begin(), 5);
    const expression slope = differentiate(e, x), curvature = differentiate(slope, x);
    for (const references::on_curve& on : references::wave)
      for (const int turns : {0, 1, -3, 1000}) {
        const double place = on.x + turns * period;
        SCOPED_TRACE(place);
        const double lost = 1e-15 * (1 + std::abs(place));
        EXPECT_NEAR(at(e, place), on.value, 20 * lost);
        EXPECT_NEAR(at(slope, place), on.slope, 300 * lost);
        EXPECT_NEAR(at(curvature, place), on.curvature, 3000 * lost);
      }
    // on both sides of the end of a period
    for (const double place : {0.5 - 1e-9, 0.5, 0.5 + 1e-9, 3.0, 3 - 1e-9}) {
      EXPECT_NEAR(at(e, place), 2, 1e-7);
      EXPECT_NEAR(at(slope, place), at(slope, 0.5), 1e-6);
    }
    EXPECT_TRUE(std::isnan(at(e, std::nan(""))));
  }
}

TEST_F(table_of_points, curve_of_numbers_cannot_fail) {
  const expression e = curve(references::force_points, true);
  const sequence<int> outputs{e.node(), differentiate(e, x).node()};
  EXPECT_TRUE(finiteness(g, outputs, live_list(g, outputs), {}).outputs_to_check().empty());
}

TEST_F(table_of_points, curve_counts_its_intervals) {
  const cost of_six = cost_of(g, {curve(references::force_points, true).node()});
  EXPECT_LE(of_six.multiplications, 6 * 3);
  EXPECT_LE(of_six.additions, 3 + 1 + 6 * 6);
  EXPECT_EQ(of_six.divisions, 0);
}

} // namespace
