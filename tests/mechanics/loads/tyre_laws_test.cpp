// builds: clang++
// The laws of tyres as functions of the slip: the brush model against its integral, the Magic Formula against
// plain numbers, and the properties of both. The graph is evaluated directly.
#include "tyre_law_functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <utility>

namespace {

using namespace tyre_laws;
using complex = std::complex<double>;

// The forces of a row of bristles under a parabolic pressure, from one end of the contact to the other.
struct row_of_bristles {
  double friction, load, slip, cornering, half_length;

  // F_x, F_y and M_z, by Gauss' rule of 5 points on each side of the point at which sliding begins
  std::array<double, 3> at(double x, double y) const {
    const double elastic = std::hypot(slip * x, cornering * y) / (2 * half_length * half_length);
    const double peak = 3 * friction * load / (4 * half_length * half_length * half_length);
    const double stick = std::max(0.0, 2 * half_length - elastic / peak); // from the leading edge
    const double along = slip * x / (2 * half_length * half_length),
                 across = cornering * y / (2 * half_length * half_length);
    std::array<double, 3> sum{};
    integrate(0, stick, sum, [&](double s) { return std::pair(along * s, across * s); });
    integrate(stick, 2 * half_length, sum, [&](double s) {
      const double limit = peak * s * (2 * half_length - s), size = std::hypot(along, across);
      return std::pair(limit * along / size, limit * across / size);
    });
    return sum;
  }

private:
  template <class Shear>
  void integrate(double from, double to, std::array<double, 3>& sum, const Shear& shear) const {
    constexpr double places[]{-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                              0.906179845938664};
    constexpr double weights[]{0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                               0.236926885056189};
    for (std::size_t i = 0; i < 5; ++i) {
      const double s = (from + to) / 2 + places[i] * (to - from) / 2, w = weights[i] * (to - from) / 2;
      const auto [x, y] = shear(s);
      sum[0] += w * x, sum[1] += w * y, sum[2] += w * y * (half_length - s);
    }
  }
};

TEST(brush_tyre, is_the_integral_over_its_bristles) {
  const double half = 0.06, load = 3500;
  const law_function law(brush(0.9, 7e4, 5e4, half / 3));
  const row_of_bristles row{0.9, load, 7e4, 5e4, half};
  std::mt19937_64 source(3);
  std::uniform_real_distribution<double> slips(-0.3, 0.3);
  for (int i = 0; i < 200; ++i) {
    const double x = slips(source), y = i % 3 == 0 ? 0 : slips(source);
    const auto expected = row.at(x, y);
    const auto found = law.at<double>({load, x, y, 0, 10});
    // rounding |slip| over 1e-4 of the sliding limit changes the force by less than 3e-8
    EXPECT_NEAR(found[0], expected[0], 3e-8 * load);
    EXPECT_NEAR(found[1], expected[1], 3e-8 * load);
    EXPECT_NEAR(found[4], expected[2], 3e-8 * load * half);
  }
}

// Without longitudinal slip, F_y = -C t + C² |t| t/(3 mu Fz) - C³ t³/(27 mu² Fz²), t = tan alpha: Fiala
// (1954).
TEST(brush_tyre, is_that_of_fiala_for_pure_side_slip) {
  const double c = 5e4, mu = 0.8, load = 4000;
  const law_function law(brush(mu, 7e4, c, 0.02));
  for (const double t : {-0.15, -0.03, 0.01, 0.08, 0.19}) {
    const double expected = -c * t + c * c * std::abs(t) * t / (3 * mu * load) -
                            c * c * c * t * t * t / (27 * mu * mu * load * load);
    EXPECT_NEAR(law.at<double>({load, 0, -t, 0, 10})[1], expected, 3e-8 * load);
  }
  EXPECT_NEAR(law.at<double>({load, 0, -0.25, 0, 10})[1], -mu * load, 1e-8 * load);
}

TEST(brush_tyre, is_isotropic_odd_and_takes_energy) {
  const law_function even(brush(0.9, 6e4, 6e4, 0)), uneven(brush(0.9, 9e4, 5e4, 0.03));
  std::mt19937_64 source(4);
  std::uniform_real_distribution<double> values(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double load = 5000 * std::abs(values(source)), x = std::pow(values(source), 3),
                 y = std::pow(values(source), 3), angle = 3 * values(source);
    const double turned_x = std::cos(angle) * x - std::sin(angle) * y,
                 turned_y = std::sin(angle) * x + std::cos(angle) * y;
    const auto f = even.at<double>({load, x, y, 0, 10}),
               turned = even.at<double>({load, turned_x, turned_y, 0, 10});
    EXPECT_NEAR(turned[0], std::cos(angle) * f[0] - std::sin(angle) * f[1], 1e-12 * load);
    EXPECT_NEAR(turned[1], std::sin(angle) * f[0] + std::cos(angle) * f[1], 1e-12 * load);
    const auto g = uneven.at<double>({load, x, y, 0, 10}), back = uneven.at<double>({load, -x, -y, 0, 10});
    for (std::size_t j = 0; j < 5; ++j) EXPECT_EQ(g[j], -back[j]);
    EXPECT_GE(g[0] * x + g[1] * y, 0); // the slip has the sign opposite to the slip velocity
    EXPECT_LE(std::hypot(g[0], g[1]), 0.9 * load * (1 + 1e-8));
  }
}

TEST(magic_formula, agrees_with_the_formula_of_the_book_in_plain_numbers) {
  for (const auto* of : {&magic_formula_reference::passenger_car, &magic_formula_reference::every_term}) {
    const law_function law(formula(*of));
    for (const auto& row : of->cases) {
      const auto found = law.at<double>({row[0], row[1], -row[2], row[3], row[4]});
      for (std::size_t i = 0; i < 5; ++i) {
        const double size = std::max(std::abs(row[5 + i]), 1e-3 * row[0]);
        EXPECT_NEAR(found[i], row[5 + i], 1e-12 * size) << i;
      }
      EXPECT_LT(row[10], 1e-5); // by the roundings, relative to the load
    }
  }
}

// For a tyre without asymmetries
TEST(magic_formula, is_odd_without_camber_and_shifts) {
  auto symmetric = magic_formula_reference::passenger_car;
  for (const auto& [place, name] : magic_formula_reference::asymmetries) symmetric.coefficients.at(place) = 0;
  const law_function law(formula(symmetric));
  std::mt19937_64 source(6);
  std::uniform_real_distribution<double> values(-0.4, 0.4);
  for (int i = 0; i < 200; ++i) {
    const double x = values(source), y = values(source);
    const auto f = law.at<double>({4000, x, y, 0, 20}), mirrored = law.at<double>({4000, x, -y, 0, 20});
    EXPECT_NEAR(f[0], mirrored[0], 1e-9);
    EXPECT_NEAR(f[1], -mirrored[1], 1e-9);
    EXPECT_NEAR(f[4], -mirrored[4], 1e-9);
    EXPECT_GE(f[0] * x + f[1] * y, 0);
  }
}

void expect_exact_derivatives(const law_function& law, const inputs& at) {
  const std::array<double, 5> sizes{4000, 0.2, 0.2, 0.2, 20};
  for (std::size_t j = 0; j < 5; ++j) {
    std::array<complex, 5> stepped{};
    for (std::size_t k = 0; k < 5; ++k) stepped[k] = at[k];
    stepped[j] += complex(0, 1e-30 * sizes[j]);
    const auto f = law.at<complex>(stepped);
    for (std::size_t k = 0; k < 5; ++k) {
      const double expected = f[k].imag() / 1e-30, size = std::max(std::abs(expected), 1e-3 * (1 + at[0]));
      EXPECT_NEAR(law.slope(k, j, at) * sizes[j], expected, 1e-10 * size) << k << " by " << j;
    }
  }
}

// Those of the other laws are checked with the equations of motion, in elements_test.cpp.
TEST(magic_formula, has_exact_derivatives_of_every_term) {
  const law_function law(formula(magic_formula_reference::every_term));
  std::mt19937_64 source(8);
  std::uniform_real_distribution<double> values(-1, 1);
  for (int i = 0; i < 200; ++i)
    expect_exact_derivatives(law, {4200 + 3500 * values(source), std::pow(values(source), 3),
                                   std::pow(values(source), 3), 0.3 * values(source), 30 * values(source)});
}

// Without slip, at standstill and without load
TEST(tyre_laws, have_exact_derivatives_also_at_standstill) {
  const law_function laws[]{law_function(linear(8e4, 6e4, 3e3, 0.03)),
                            law_function(brush(0.9, 9e4, 5e4, 0.03, 2e3)),
                            law_function(formula(magic_formula_reference::passenger_car)),
                            law_function(formula(magic_formula_reference::every_term))};
  int number = 0;
  for (const law_function& law : laws) {
    SCOPED_TRACE(number++);
    for (const double load : {4000.0, 0.0}) {
      const inputs rest{load, 0, 0, 0, 0};
      const auto f = law.at<double>(rest);
      for (const double each : f) EXPECT_LE(std::abs(each), load + 1e-6); // none without load
      expect_exact_derivatives(law, rest);
    }
  }
}

} // namespace
