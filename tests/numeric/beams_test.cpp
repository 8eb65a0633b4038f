// builds: clang++
// Shapes of beams, their natural modes, and integrals over them.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>
#include <kanexpr/numeric/beams/gauss_legendre.hpp>
#include <kanexpr/numeric/beams/integrate_modes.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/numeric/beams/tables.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace kanexpr::numeric::beams;
using kanexpr::base::sequence;

constexpr long double pi = 3.14159265358979323846264338327950288L;
constexpr double infinity = std::numeric_limits<double>::infinity();

// An integral over [from, to] by a different rule, split into equal parts.
double integral(const std::function<double(double)>& f, double from, double to, int parts = 16) {
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double low = from + (to - from) * i / parts, high = from + (to - from) * (i + 1) / parts;
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, low, high, 0);
  }
  return sum;
}

// The root of a function in an interval, by bisection.
double root(const std::function<long double(long double)>& f, long double low, long double high) {
  const bool rises = f(low) < 0;
  for (int i = 0; i < 80; ++i) {
    const long double middle = (low + high) / 2;
    ((f(middle) < 0) == rises ? low : high) = middle;
  }
  return static_cast<double>(low);
}

void expect_near(double found, double expected, double tolerance, const std::string& what) {
  EXPECT_LE(std::abs(found - expected), tolerance * (1 + std::abs(expected)))
      << what << ": found " << found << ", expected " << expected;
}

TEST(gauss_legendre, is_exact_for_polynomials_of_degree_2n_minus_1) {
  for (const int n : {1, 2, 3, 7, 16, 40}) {
    const quadrature rule = gauss_legendre(n);
    for (int degree = 0; degree <= 2 * n - 1; ++degree) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
      EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-15) << n << " points, degree " << degree;
    }
  }
}

TEST(beam_modes, have_the_wave_numbers_of_the_frequency_equations) {
  // Blevins (1979), table 8-1
  EXPECT_NEAR(wave_number_of_bending(ends::clamped_free, 1), 1.8751040687119611, 1e-14);
  EXPECT_NEAR(wave_number_of_bending(ends::clamped_free, 2), 4.6940911329741746, 1e-14);
  EXPECT_NEAR(wave_number_of_bending(ends::free_free, 1), 4.7300407448627040, 1e-14);
  EXPECT_NEAR(wave_number_of_bending(ends::clamped_pinned, 1), 3.9266023120479188, 1e-14);
  for (const int n : {1, 2, 3, 4, 5, 8, 20, 60}) {
    const auto expect = [&](ends how, const std::function<long double(long double)>& f, long double low,
                            long double high) {
      const double expected = root(f, low * pi, high * pi);
      EXPECT_NEAR(wave_number_of_bending(how, n) / expected, 1, 1e-15) << "mode " << n;
    };
    const auto cantilever = [](long double b) { return std::cos(b) + 1 / std::cosh(b); };
    const auto symmetric = [](long double b) { return std::cos(b) - 1 / std::cosh(b); };
    const auto pinned = [](long double b) { return std::sin(b) - std::cos(b) * std::tanh(b); };
    expect(ends::clamped_free, cantilever, n - 1, n);
    expect(ends::free_free, symmetric, n, n + 1);
    expect(ends::clamped_clamped, symmetric, n, n + 1);
    expect(ends::clamped_pinned, pinned, n, n + 0.5L);
    expect(ends::pinned_free, pinned, n, n + 0.5L);
    expect(ends::pinned_pinned, [](long double b) { return std::sin(b); }, n - 0.5L, n + 0.5L);
  }
}

TEST(beam_modes, of_a_beam_with_a_tip_body_satisfy_its_frequency_equation) {
  for (const double mass : {0.01, 1.0, 30.0})
    for (const double inertia : {0.0, 1e-3, 0.5})
      for (int n = 1; n <= 6; ++n) {
        const long double b = wave_number_of_bending(ends::clamped_free, n, {mass, inertia});
        const long double m = mass, j = inertia, sine = std::sin(b), cosine = std::cos(b), t = std::tanh(b),
                          h = 1 / std::cosh(b);
        // Erturk & Inman (2011), Piezoelectric Energy Harvesting, equation C.40, divided by cosh
        const long double equation = h + cosine + m * b * (cosine * t - sine) -
                                     j * b * b * b * (t * cosine + sine) +
                                     m * j * b * b * b * b * (h - cosine);
        EXPECT_LE(std::abs(equation), 1e-13L * (1 + m * b + j * b * b * b) * (1 + b)) << n;
      }
  EXPECT_NEAR(wave_number_of_bending(ends::clamped_free, 1, {1, 0}), 1.2479174096064696, 1e-14);
}

// φ, φ' and φ'' agree with each other; the deflection of a held end and the slope of a clamped one vanish.
void check_mode(const shape& mode, bool holds_root, bool clamps_root, bool holds_tip,
                const std::string& what) {
  const double scale = 1 + mode.wave_number();
  for (const double xi : {0.13, 0.5, 0.92, 1.0}) {
    const double slope = integral([&](double x) { return mode.at(x).curvature; }, 0, xi);
    const double value = integral([&](double x) { return mode.at(x).slope; }, 0, xi);
    EXPECT_NEAR(mode.at(xi).slope - mode.at(0).slope, slope, 1e-13 * scale) << what;
    EXPECT_NEAR(mode.at(xi).value - mode.at(0).value, value, 1e-13) << what;
  }
  const double size = std::sqrt(integral([&](double x) { return std::pow(mode.at(x).value, 2); }, 0, 1));
  EXPECT_LE(holds_root ? std::abs(mode.at(0).value) : 0, 1e-14 * size) << what;
  EXPECT_LE(clamps_root ? std::abs(mode.at(0).slope) : 0, 1e-14 * size * scale) << what;
  EXPECT_LE(holds_tip ? std::abs(mode.at(1).value) : 0, 1e-14 * size) << what;
}

// ∫ φ''_k φ''_l = β_l⁴ (∫ φ_k φ_l + inertia of the tip body) holds for all k and l only if the modes satisfy
// the differential equation and all boundary conditions.
void check_modes(ends how, const tip_load& tip, bool holds_tip, const std::string& what) {
  constexpr int count = 8;
  std::vector<shape> modes;
  const bool holds_root = how != ends::free_free;
  const bool clamps_root = holds_root && how != ends::pinned_free && how != ends::pinned_pinned;
  for (int n = 1; n <= count; ++n) {
    modes.push_back(mode_of_bending(how, n, tip));
    check_mode(modes.back(), holds_root, clamps_root, holds_tip, what + " mode " + std::to_string(n));
  }
  const auto product = [&](const shape& a, const shape& b) {
    return integral([&](double x) { return a.at(x).value * b.at(x).value; }, 0, 1) +
           tip.mass * a.at(1).value * b.at(1).value + tip.inertia * a.at(1).slope * b.at(1).slope;
  };
  const auto bending = [&](const shape& a, const shape& b) {
    return integral([&](double x) { return a.at(x).curvature * b.at(x).curvature; }, 0, 1);
  };
  for (const shape& a : modes)
    for (const shape& b : modes) {
      const double size = std::sqrt(product(a, a) * product(b, b));
      const double squares = std::pow(a.wave_number() * b.wave_number(), 2);
      EXPECT_NEAR(product(a, b) / size, &a == &b ? 1 : 0, 1e-13) << what;
      EXPECT_NEAR(bending(a, b) / (size * squares), &a == &b ? 1 : 0, 1e-13) << what;
    }
}

TEST(beam_modes, satisfy_the_differential_equation_and_the_boundary_conditions) {
  check_modes(ends::clamped_free, {}, false, "clamped-free");
  check_modes(ends::clamped_free, {0.7, 0}, false, "tip mass");
  check_modes(ends::clamped_free, {0.7, 0.02}, false, "tip body");
  check_modes(ends::clamped_clamped, {}, true, "clamped-clamped");
  check_modes(ends::clamped_pinned, {}, true, "clamped-pinned");
  check_modes(ends::pinned_pinned, {}, true, "pinned-pinned");
  check_modes(ends::pinned_free, {}, false, "pinned-free");
  check_modes(ends::free_free, {}, false, "free-free");
}

TEST(beam_modes, are_scaled_to_1_at_a_free_tip_and_by_the_greatest_deflection_otherwise) {
  for (int n = 1; n <= 6; ++n) {
    for (const ends how : {ends::clamped_free, ends::pinned_free, ends::free_free})
      EXPECT_NEAR(mode_of_bending(how, n).at(1).value, 1, 1e-14);
    for (const ends how : {ends::clamped_clamped, ends::clamped_pinned, ends::pinned_pinned}) {
      const shape mode = mode_of_bending(how, n);
      double greatest = 0;
      for (int i = 0; i <= 4000; ++i) greatest = (std::max)(greatest, std::abs(mode.at(i / 4000.0).value));
      EXPECT_NEAR(greatest, 1, 1e-5);
    }
  }
}

TEST(beam_modes, with_a_heavy_tip_body_are_static_deflections) {
  for (const double ratio : {1e10, 1e13, 1e16, 1e300}) {
    const shape mode = kanexpr::numeric::beams::mode_of_bending(ends::clamped_free, 1, {ratio, 0});
    for (const double xi : {0.2, 0.5, 0.8}) // 3/2 ξ² − 1/2 ξ³
      EXPECT_NEAR(mode.at(xi).value, xi * xi * (3 - xi) / 2, 1e-7) << ratio;
  }
}

TEST(beam_modes, of_impossible_numbers_and_tip_bodies_are_empty) {
  using kanexpr::numeric::beams::mode_of_bending, kanexpr::numeric::beams::mode_of_rod;
  for (const ends how : {ends::clamped_free, ends::clamped_clamped, ends::pinned_free}) {
    EXPECT_FALSE(mode_of_bending(how, 0).is_complete());
    EXPECT_FALSE(mode_of_rod(how, -1).is_complete());
    EXPECT_TRUE(mode_of_bending(how, 60).is_complete());
  }
  EXPECT_FALSE(mode_of_bending(ends::clamped_free, 1, {-0.5, 0}).is_complete());
}

TEST(rod_modes, satisfy_their_boundary_conditions) {
  for (int n = 1; n <= 5; ++n) {
    EXPECT_NEAR(mode_of_rod(ends::clamped_free, n).at(1).slope, 0, 1e-13);
    EXPECT_NEAR(mode_of_rod(ends::clamped_free, n).at(1).value, 1, 1e-15);
    EXPECT_NEAR(mode_of_rod(ends::free_free, n).at(0).slope, 0, 1e-15);
    EXPECT_NEAR(mode_of_rod(ends::free_free, n).at(1).value, 1, 1e-14);
    EXPECT_NEAR(mode_of_rod(ends::clamped_clamped, n).at(1).value, 0, 1e-14);
    const shape loaded = mode_of_rod(ends::clamped_free, n, {0.4, 0});
    EXPECT_NEAR(loaded.at(1).slope, 0.4 * std::pow(loaded.wave_number(), 2), 1e-12 * loaded.wave_number());
  }
}

TEST(tables_of_shapes, reproduce_cubic_polynomials) {
  const sequence<double> xi{0.0, 0.2, 0.55, 0.7, 1.0};
  const auto cubic = [](double x) { return deflection{x * x * (3 - x) / 2, x * (6 - 3 * x) / 2, 3 - 3 * x}; };
  sequence<double> values, slopes;
  for (const double x : xi) values.push(cubic(x).value), slopes.push(cubic(x).slope);
  const shape splined = spline(xi, values, true), hermite = cubic_table(xi, values, slopes);
  for (const double x : {0.0, 0.1, 0.2, 0.6, 0.99, 1.0})
    for (const shape& s : {splined, hermite}) {
      EXPECT_NEAR(s.at(x).value, cubic(x).value, 1e-15);
      EXPECT_NEAR(s.at(x).slope, cubic(x).slope, 1e-14);
      EXPECT_NEAR(s.at(x).curvature, cubic(x).curvature, 1e-13);
    }
}

TEST(tables_of_shapes, are_smooth_splines) {
  const sequence<double> xi{0.0, 0.3, 0.45, 1.0}, values{0.2, -1.0, 2.0, 0.5};
  for (const bool clamped : {false, true}) {
    const shape s = spline(xi, values, clamped);
    for (int i = 0; i < xi.size(); ++i) EXPECT_NEAR(s.at(xi[i]).value, values[i], 1e-14);
    for (int i = 1; i + 1 < xi.size(); ++i) {
      const double after = std::nextafter(xi[i], infinity);
      EXPECT_NEAR(s.at(xi[i]).slope, s.at(after).slope, 1e-12);
      EXPECT_NEAR(s.at(xi[i]).curvature, s.at(after).curvature, 1e-11);
    }
    EXPECT_NEAR(clamped ? s.at(0).slope : s.at(0).curvature, 0, 1e-12);
    EXPECT_NEAR(s.at(1).curvature, 0, 1e-11);
  }
  const shape lines = linear_table(xi, values);
  EXPECT_NEAR(lines.at(0.15).value, -0.4, 1e-15);
  EXPECT_NEAR(lines.at(1).value, 0.5, 1e-15);
}

// A tapered beam with shapes of all kinds in all deformations.
beam_shapes tapered() {
  beam_shapes b;
  b.mass = linear_table({0.0, 0.3, 1.0}, {1.0, 0.9, 0.4});
  b.polar = shape::polynomial({1.0, -1.2, 0.5});
  b.stiffness[0] = shape::polynomial({1.0, -1.5, 0.7});
  b.stiffness[2] = linear_table({0.0, 0.8, 1.0}, {1.0, 0.7, 0.6});
  for (int n = 1; n <= 3; ++n)
    b.all.push({deformation::first_bending, mode_of_bending(ends::clamped_free, n)});
  b.all.push({deformation::first_bending, shape::polynomial({0.0, 0.0, 1.0, 0.5, -0.3, 0.2, 0.1})});
  b.all.push({deformation::second_bending, spline({0.0, 0.4, 0.8, 1.0}, {0.0, 0.2, 0.6, 1.0}, true)});
  b.all.push({deformation::second_bending, mode_of_bending(ends::clamped_pinned, 2)});
  b.all.push({deformation::torsion, mode_of_rod(ends::clamped_free, 1)});
  b.all.push({deformation::torsion, shape::polynomial({0.0, 1.0})});
  b.all.push({deformation::extension, mode_of_rod(ends::clamped_free, 2)});
  return b;
}

double of_piecewise(const std::function<double(double)>& f) {
  double sum = 0;
  const double ends_of_pieces[]{0, 0.3, 0.4, 0.8, 1};
  for (int i = 0; i < 4; ++i) sum += integral(f, ends_of_pieces[i], ends_of_pieces[i + 1], 4);
  return sum;
}

TEST(modal_integrals, agree_with_an_independent_quadrature) {
  const beam_shapes b = tapered();
  const int n = b.all.size();
  const sequence<double> numbers = integrate_modes(b);
  const modal_integrals found{numbers.begin(), n};
  ASSERT_EQ(numbers.size(), modal_integrals::count(n));
  const auto mass = [&](double x) { return b.mass.at(x).value; };
  expect_near(found.mass(), of_piecewise(mass), 1e-14, "mass");
  expect_near(found.first_moment(), of_piecewise([&](double x) { return x * mass(x); }), 1e-14, "ξ");
  expect_near(found.second_moment(), of_piecewise([&](double x) { return x * x * mass(x); }), 1e-14, "ξ²");
  expect_near(found.polar(), of_piecewise([&](double x) { return b.polar.at(x).value; }), 1e-14, "polar");
  for (int k = 0; k < n; ++k) {
    const beam_shape& a = b.all[k];
    const shape& factor = a.what == deformation::torsion ? b.polar : b.mass;
    const auto moment = [&](double x) { return factor.at(x).value * a.of.at(x).value; };
    expect_near(found.zeroth(k), of_piecewise(moment), 1e-14, "∫ φ");
    expect_near(found.first(k), of_piecewise([&](double x) { return x * moment(x); }), 1e-14, "∫ ξ φ");
    for (int l = 0; l < n; ++l) {
      const beam_shape& c = b.all[l];
      const bool mixes = (a.what == deformation::torsion) != (c.what == deformation::torsion);
      expect_near(found.product(k, l),
                  mixes ? 0 : of_piecewise([&](double x) { return moment(x) * c.of.at(x).value; }), 1e-13,
                  "∫ φ φ");
      const auto strain = [&](double x) {
        const deflection p = a.of.at(x), q = c.of.at(x);
        return b.stiffness[static_cast<int>(a.what)].at(x).value *
               (is_bending(a.what) ? p.curvature * q.curvature : p.slope * q.slope);
      };
      const auto slopes = [&](double x) { return a.of.at(x).slope * c.of.at(x).slope; };
      const bool alike = a.what == c.what;
      expect_near(found.stiffness(k, l), alike ? of_piecewise(strain) : 0, 1e-12, "stiffness");
      const bool shortens = alike && is_bending(a.what);
      if (!shortens) {
        EXPECT_EQ(found.shortening(k, l), 0);
        continue;
      }
      // by parts, from the root: ∫ μ G = [G ∫μ] − ∫ (∫₀^ξ μ) φ'φ'
      const auto below = [&](double x, int power) {
        double sum = 0;
        for (const auto& [from, to] : {std::pair{0.0, 0.3}, std::pair{0.3, 1.0}})
          if (x > from)
            sum +=
                integral([&](double y) { return mass(y) * std::pow(y, power); }, from, (std::min)(x, to), 1);
        return sum;
      };
      const double whole = of_piecewise(slopes);
      expect_near(found.shortening(k, l),
                  below(1, 0) * whole - of_piecewise([&](double x) { return below(x, 0) * slopes(x); }),
                  1e-13, "G");
      expect_near(found.shortening_moment(k, l),
                  below(1, 1) * whole - of_piecewise([&](double x) { return below(x, 1) * slopes(x); }),
                  1e-13, "ξ G");
    }
  }
}

TEST(modal_integrals, of_uniform_beams_have_closed_forms) {
  for (const ends how : {ends::clamped_free, ends::free_free, ends::pinned_free}) {
    beam_shapes b;
    for (int n = 1; n <= 4; ++n) b.all.push({deformation::first_bending, mode_of_bending(how, n)});
    const sequence<double> numbers = integrate_modes(b);
    const modal_integrals found{numbers.begin(), 4};
    for (int k = 0; k < 4; ++k)
      for (int l = 0; l < 4; ++l) {
        const double beta = wave_number_of_bending(how, k + 1);
        expect_near(found.product(k, l), k == l ? 0.25 : 0, 1e-14, "∫ φ² = 1/4");
        expect_near(found.stiffness(k, l) / std::pow(beta, 4), k == l ? 0.25 : 0, 1e-14, "∫ φ''²");
        if (k == l) continue; // the following vanish exactly
        EXPECT_EQ(found.product(k, l), 0);
        EXPECT_EQ(found.stiffness(k, l), 0);
        EXPECT_EQ(how == ends::free_free ? found.zeroth(k) : 0, 0);
        EXPECT_EQ(how != ends::clamped_free ? found.first(k) : 0, 0);
      }
  }
  beam_shapes b; // φ = ξ²: exact fractions
  b.all.push({deformation::first_bending, shape::polynomial({0.0, 0.0, 1.0})});
  const sequence<double> numbers = integrate_modes(b);
  const modal_integrals found{numbers.begin(), 1};
  EXPECT_NEAR(found.zeroth(0), 1.0 / 3, 1e-16);
  EXPECT_NEAR(found.product(0, 0), 1.0 / 5, 1e-16);
  EXPECT_NEAR(found.stiffness(0, 0), 4, 1e-15);
  EXPECT_NEAR(found.shortening(0, 0), 1.0 / 3, 1e-16);         // ∫ 4/3 ξ³
  EXPECT_NEAR(found.shortening_moment(0, 0), 4.0 / 15, 1e-16); // ∫ 4/3 ξ⁴
}

TEST(section_values, are_those_of_the_shapes) {
  const beam_shapes b = tapered();
  const int n = b.all.size();
  for (const double xi : {0.0, 0.25, 0.3, 0.77, 1.0}) {
    const sequence<double> numbers = values_at(b, xi);
    ASSERT_EQ(numbers.size(), section_values::count(n));
    const section_values at{numbers.begin(), n};
    for (int k = 0; k < n; ++k) {
      EXPECT_NEAR(at.value(k), b.all[k].of.at(xi).value, 1e-14);
      EXPECT_NEAR(at.slope(k), b.all[k].of.at(xi).slope, 1e-13);
      for (int l = 0; l < n; ++l) {
        const beam_shape &a = b.all[k], &c = b.all[l];
        const bool shortens = a.what == c.what && is_bending(a.what),
                   twists = a.what == deformation::first_bending && c.what == deformation::second_bending;
        const auto integrand = [&](double x) {
          return (twists ? a.of.at(x).curvature : a.of.at(x).slope) * c.of.at(x).slope;
        };
        double expected = 0;
        for (const auto& [from, to] : {std::pair{0.0, 0.4}, std::pair{0.4, 0.8}, std::pair{0.8, 1.0}})
          if (xi > from) expected += integral(integrand, from, (std::min)(xi, to), 4);
        expect_near(twists ? at.twist(k, l) : at.shortening(k, l), shortens || twists ? expected : 0, 1e-13,
                    "G");
      }
    }
  }
}

// The modes of a free beam, which is symmetric about its middle here, leave its mass center in place.
TEST(section_values, of_free_beams_are_measured_from_the_mass_center) {
  beam_shapes b;
  for (int n = 1; n <= 2; ++n) b.all.push({deformation::first_bending, mode_of_bending(ends::free_free, n)});
  const sequence<double> numbers = integrate_modes(b), at_root = values_at(b, 0), at_tip = values_at(b, 1);
  const modal_integrals found{numbers.begin(), 2};
  const section_values root{at_root.begin(), 2}, tip{at_tip.begin(), 2};
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(found.shortening(k, k), 0);
    const auto slopes = [&](double x) { return b.all[k].of.at(x).slope * b.all[k].of.at(x).slope; };
    const double half = integral(slopes, 0, 0.5, 4);
    EXPECT_NEAR(root.shortening(k, k), -half, 1e-13 * half);
    EXPECT_NEAR(tip.shortening(k, k), half, 1e-13 * half);
    const auto moment = [&](double x) { return slopes(x) * (x < 0.5 ? x * x : 1 - x * x) / 2; };
    const double expected = integral(moment, 0.5, 1, 4) - integral(moment, 0, 0.5, 4);
    EXPECT_NEAR(found.shortening_moment(k, k), expected, 1e-13 * half);
  }
}

// The same numbers at compile time.
constexpr double first_integral = [] {
  beam_shapes b;
  b.all.push({deformation::first_bending, mode_of_bending(ends::clamped_free, 1)});
  return integrate_modes(b)[4];
}();
static_assert(first_integral > 0.39149 && first_integral < 0.3915);

} // namespace
