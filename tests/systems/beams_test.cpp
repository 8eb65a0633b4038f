// Beams: their integrals, frequencies and sections, from words and from a builder.
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>
#include <kanexpr/beams.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::linearization_point;
using kanexpr::base::sequence;
using kanexpr::numeric::beams::ends;
using kanexpr::numeric::beams::shape;
using kanexpr::runtime::beam_data;
using kanexpr::runtime::beam_id;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::modes_of_bending;
using kanexpr::runtime::modes_of_rod;
using kanexpr::runtime::point_id;
using kanexpr::runtime::section_ids;
using kanexpr::symbolic::expression;
using mechanics::deformation;
using mechanics::quantity;

// The values of expressions at a state; `by` provides them for coordinates and speeds.
struct values {
  VectorXd q, u;

  MatrixXd of(const kanexpr::symbolic::matrix& wanted) const {
    sequence<int> outputs;
    for (const expression& e : wanted.entries) outputs.push(e.node());
    kanexpr::runtime::interpreter<double> code(kanexpr::lower::tape_of(wanted.entries[0].owner(), outputs));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(wanted.rows,
                                                                                  wanted.columns);
    const auto value_of = [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      if (l.from == symbol_kind::coordinate) return q[l.position];
      if (l.from == symbol_kind::speed) return u[l.position];
      return std::numeric_limits<double>::quiet_NaN();
    };
    code.evaluate(value_of, result.data());
    return result;
  }
  MatrixXd of(const std::vector<expression>& column) const {
    kanexpr::symbolic::matrix m(column[0].owner(), static_cast<int>(column.size()), 1);
    for (int i = 0; i < m.rows; ++i) m(i, 0) = column[static_cast<std::size_t>(i)];
    return of(m);
  }
  Vector3d of(const mechanics::components& c) const { return of(std::vector{c.x, c.y, c.z}); }
};

values random_values(int q, int u, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  const auto draw = [&](int n) {
    return VectorXd(VectorXd::NullaryExpr(n, [&] { return between(random); }));
  };
  values v;
  v.q = draw(q), v.u = draw(u);
  return v;
}

void expect_equal(const MatrixXd& found, const MatrixXd& expected, const std::string& what,
                  double tolerance = 1e-12) {
  ASSERT_EQ(found.rows(), expected.rows()) << what;
  ASSERT_EQ(found.cols(), expected.cols()) << what;
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), tolerance * (1 + expected.cwiseAbs().maxCoeff()))
      << what << "\nfound\n"
      << found << "\nexpected\n"
      << expected;
}

// The eigenvalues of a system without parameters, linearized at rest.
Eigen::VectorXcd eigenvalues_at_rest(kanexpr::model system) {
  EXPECT_EQ(system.mistake(), "");
  linearization_point rest;
  for (const std::string& name : system.linearize().states()) rest.set(name, 0);
  kanexpr::runtime::linearization linear = system.linearize(rest);
  const kanexpr::symbolic::matrix a = linear.explicit_form().A;
  EXPECT_TRUE(linear) << linear.failures().front();
  return values{}.of(a).eigenvalues();
}

// The positive natural frequencies of an undamped system, lowest first.
std::vector<double> frequencies(const kanexpr::model& system) {
  std::vector<double> found;
  for (const std::complex<double>& e : eigenvalues_at_rest(system))
    if (e.imag() > 1e-3) found.push_back(e.imag());
  std::sort(found.begin(), found.end());
  return found;
}

void expect_frequencies(const kanexpr::model& system, const std::vector<double>& expected,
                        const std::string& what) {
  const std::vector<double> found = frequencies(system);
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i] / expected[i], 1, 1e-12) << what << ' ' << i;
}

// A builder of beams with three coordinates of a plane body.
struct bench : builder {
  frame_id n = inertial_frame();
  point_id o = origin("O");
  bench() : builder("N") {}

  std::vector<expression> free(const std::string& name, int count) {
    std::vector<expression> q;
    for (int i = 0; i < count; ++i) {
      const std::string index = std::to_string(i + 1);
      q.push_back(coordinate(name + index));
      kinematic_equation(dot(q.back()) - speed("u_" + name + index));
    }
    return q;
  }
};

constexpr double length = 1.7, mass_per_length = 0.6, stiffness = 3.1;
const double bending_rate = std::sqrt(stiffness / mass_per_length) / (length * length);

// A beam along x that bends along y.
beam_data plane_beam(bench& b, frame_id frame, const std::vector<shape>& shapes, bool moves_root = false) {
  beam_data data{.axis = b.along(frame, 1, 0, 0), .length = length, .mass_per_length = mass_per_length};
  data.bending = {{b.along(frame, 0, 1, 0), {stiffness, shapes}}};
  data.bending[0].by.moves_root = moves_root;
  return data;
}

std::vector<double> rates_of(ends how, int count, const kanexpr::numeric::beams::tip_load& tip = {}) {
  std::vector<double> all;
  for (int n = 1; n <= count; ++n)
    all.push_back(bending_rate * std::pow(kanexpr::numeric::beams::wave_number_of_bending(how, n, tip), 2));
  return all;
}

TEST(beam_frequencies, of_clamped_and_pinned_beams_are_exact_with_their_modes) {
  for (const auto& [how, moves_root] :
       {std::pair{ends::clamped_free, false}, std::pair{ends::clamped_clamped, false},
        std::pair{ends::clamped_pinned, false}, std::pair{ends::pinned_pinned, true}}) {
    bench b;
    b.beam("B", b.o, b.n, b.free("q", 4), plane_beam(b, b.n, modes_of_bending(how, 4), moves_root));
    ASSERT_EQ(b.check().view(), "");
    expect_frequencies(kanexpr::derive(b), rates_of(how, 4), std::to_string(static_cast<int>(how)));
  }
}

TEST(beam_frequencies, of_a_beam_on_a_hinge_are_exact_with_its_modes) {
  bench b;
  const std::vector<expression> q = b.free("q", 4);
  const frame_id r = b.rotated("R", b.n, q[0], b.along(b.n, 0, 0, 1));
  b.beam("B", b.o, r, {q[1], q[2], q[3]}, plane_beam(b, r, modes_of_bending(ends::pinned_free, 3), true));
  ASSERT_EQ(b.check().view(), "");
  expect_frequencies(kanexpr::derive(b), rates_of(ends::pinned_free, 3), "pinned-free");
}

TEST(beam_frequencies, of_a_free_beam_are_exact_with_its_modes) {
  bench b;
  const std::vector<expression> q = b.free("q", 6);
  const point_id root = b.offset("P", b.o, b.along(b.n, q[0], q[1], 0));
  const frame_id r = b.rotated("R", b.n, q[2], b.along(b.n, 0, 0, 1));
  b.beam("B", root, r, {q[3], q[4], q[5]}, plane_beam(b, r, modes_of_bending(ends::free_free, 3), true));
  ASSERT_EQ(b.check().view(), "");
  expect_frequencies(kanexpr::derive(b), rates_of(ends::free_free, 3), "free-free");
}

TEST(beam_frequencies, of_a_beam_with_a_body_at_the_tip_are_exact_with_its_modes) {
  const double mass = 0.8 * mass_per_length * length,
               inertia = 0.05 * mass_per_length * length * length * length;
  for (const bool has_inertia : {false, true}) {
    bench b;
    const kanexpr::numeric::beams::tip_load tip{0.8, has_inertia ? 0.05 : 0};
    const beam_id beam = b.beam("B", b.o, b.n, b.free("q", 3),
                                plane_beam(b, b.n, modes_of_bending(ends::clamped_free, 3, tip)));
    const section_ids end = b.section("Tip", beam, 1);
    if (has_inertia)
      b.rigid_body("Load", end.point, end.frame, b.number(mass),
                   b.inertia(end.frame, inertia, inertia, inertia));
    else
      b.particle("Load", end.point, b.number(mass));
    ASSERT_EQ(b.check().view(), "");
    expect_frequencies(kanexpr::derive(b), rates_of(ends::clamped_free, 3, tip), "tip body");
  }
}

TEST(beam_frequencies, of_polynomials_converge_from_above) {
  const std::vector<double> exact = rates_of(ends::clamped_free, 1);
  double before = 1e9;
  for (int count = 1; count <= 5; ++count) {
    bench b;
    std::vector<shape> powers;
    for (int i = 0; i < count; ++i) {
      sequence<double> coefficients(i + 3, 0.0);
      coefficients[i + 2] = 1;
      powers.push_back(shape::polynomial(coefficients));
    }
    b.beam("B", b.o, b.n, b.free("q", count), plane_beam(b, b.n, powers));
    const double found = frequencies(kanexpr::derive(b))[0];
    EXPECT_GT(found, exact[0] * (1 - 1e-11));
    EXPECT_LT(found, before);
    EXPECT_NEAR(count == 1 ? found : 0, count == 1 ? bending_rate * std::sqrt(20.0) : 0, 1e-12);
    before = found;
  }
  EXPECT_NEAR(before / exact[0], 1, 1e-7);
}

TEST(beam_frequencies, of_torsion_and_extension_are_those_of_rods) {
  bench b;
  beam_data data{.axis = b.along(b.n, 0, 0, -1), .length = length, .mass_per_length = mass_per_length};
  data.torsion = {.polar_inertia = 0.02, .by = {7.0, modes_of_rod(ends::clamped_free, 2)}};
  data.extension = {50.0, modes_of_rod(ends::clamped_free, 2)};
  b.beam("B", b.o, b.n, b.free("q", 4), data);
  ASSERT_EQ(b.check().view(), "");
  const double pi = 3.141592653589793, twist = std::sqrt(7 / 0.02) / length * pi / 2,
               stretch = std::sqrt(50 / mass_per_length) / length * pi / 2;
  expect_frequencies(kanexpr::derive(b), {stretch, twist, 3 * stretch, 3 * twist}, "rod");
}

TEST(beam_damping, by_ratios_is_that_of_each_mode) {
  bench b;
  beam_data data = plane_beam(b, b.n, modes_of_bending(ends::clamped_free, 2));
  data.damping_ratios = {0.02, 0.1};
  b.beam("B", b.o, b.n, b.free("q", 2), data);
  const std::vector<double> rate = rates_of(ends::clamped_free, 2);
  const Eigen::VectorXcd found = eigenvalues_at_rest(kanexpr::derive(b));
  for (const auto& [i, ratio] : {std::pair{0u, 0.02}, std::pair{1u, 0.1}}) {
    const std::complex<double> expected(-ratio * rate[i], rate[i] * std::sqrt(1 - ratio * ratio));
    double distance = 1e9;
    for (const std::complex<double>& each : found) distance = (std::min)(distance, std::abs(each - expected));
    EXPECT_LE(distance, 1e-12 * rate[1]);
  }
}

TEST(beam_damping, in_proportion_to_mass_and_stiffness) {
  bench b;
  beam_data data = plane_beam(b, b.n, modes_of_bending(ends::clamped_free, 2));
  data.damping_of_mass = 0.3, data.damping_of_stiffness = 0.004;
  b.beam("B", b.o, b.n, b.free("q", 2), data);
  double sum = 0; // of the real parts: −α − β ω²
  for (const std::complex<double>& each : eigenvalues_at_rest(kanexpr::derive(b))) sum += each.real();
  const std::vector<double> rate = rates_of(ends::clamped_free, 2);
  EXPECT_NEAR(sum, -2 * 0.3 - 0.004 * (rate[0] * rate[0] + rate[1] * rate[1]), 1e-11);
}

// A tapered beam with shapes of all kinds along a skew axis.
struct skew_beam : bench {
  Vector3d axis{1 / 3.0, 2 / 3.0, 2 / 3.0}, first{2 / 3.0, 1 / 3.0, -2 / 3.0},
      second{2 / 3.0, -2 / 3.0, 1 / 3.0};
  shape mass = shape::polynomial({1.0, -0.7, 0.2}), polar = shape::polynomial({0.9, -0.4});
  std::vector<shape> bends = modes_of_bending(ends::clamped_free, 2),
                     across{shape::polynomial({0.0, 0.0, 1.4, -0.4})}, twists{shape::polynomial({0.0, 1.0})},
                     stretches{shape::polynomial({0.0, 2.0, -1.0})};
  const double polar_inertia = 0.03;
  std::vector<expression> q = free("q", 5);
  beam_id beam_made;

  skew_beam() {
    const auto vector = [&](const Vector3d& v) { return along(n, 3 * v.x(), 3 * v.y(), 3 * v.z()); };
    beam_data data{.axis = vector(axis), .length = length, .mass_per_length = mass_per_length};
    data.mass_profile = mass;
    data.bending = {{vector(first), {stiffness, bends}}, {vector(second), {2.0, across}}};
    data.torsion = {.polar_inertia = polar_inertia, .by = {7.0, twists}, .profile = polar};
    data.extension = {50.0, stretches};
    beam_made = beam("B", o, n, q, data);
  }

  // The displacement of the axis at ξ for amplitudes q, with the foreshortening integrated numerically.
  Vector3d position(double xi, const VectorXd& a) const {
    const auto v = [&](double x) { return a[0] * bends[0].at(x).slope + a[1] * bends[1].at(x).slope; };
    const auto w = [&](double x) { return a[2] * across[0].at(x).slope; };
    const double shortening = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [&](double x) { return v(x) * v(x) + w(x) * w(x); }, 0.0, xi, 0);
    return (xi * length + a[4] * stretches[0].at(xi).value - shortening / (2 * length)) * axis +
           (a[0] * bends[0].at(xi).value + a[1] * bends[1].at(xi).value) * first +
           a[2] * across[0].at(xi).value * second;
  }
  Vector3d derivative(double xi, const VectorXd& a, int k) const {
    VectorXd step = VectorXd::Zero(5); // exact for a quadratic function
    step[k] = 1;
    return (position(xi, a + step) - position(xi, a - step)) / 2;
  }
};

// The terms of a polynomial of degree 4 in t up to a power, at t = 1.
VectorXd truncated(const std::function<VectorXd(double)>& f, int power) {
  Eigen::Matrix<double, 5, 5> powers;
  MatrixXd all(5, f(0).size());
  for (int i = 0; i < 5; ++i) {
    const double t = i - 2;
    for (int j = 0; j < 5; ++j) powers(i, j) = std::pow(t, j);
    all.row(i) = f(t);
  }
  const MatrixXd coefficients = powers.partialPivLu().solve(all);
  return coefficients.topRows(power + 1).colwise().sum();
}

TEST(beam_integrals, are_those_of_the_position_to_the_stated_order) {
  skew_beam b;
  ASSERT_EQ(b.check().view(), "");
  const mechanics::flexible_body& body = b.mechanism().flexible_bodies[0];
  const values now = random_values(5, 0, 7);
  const auto over_mass = [&](const std::function<double(double)>& f) {
    double sum = 0;
    for (int i = 0; i < 2; ++i)
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [&](double x) { return mass_per_length * length * b.mass.at(x).value * f(x); }, i / 2.0,
          (i + 1) / 2.0, 0);
    return sum;
  };
  const auto integral = [&](int size, const std::function<VectorXd(double)>& f) {
    VectorXd sum(size);
    for (int i = 0; i < size; ++i) sum[i] = over_mass([&](double x) { return f(x)[i]; });
    return sum;
  };
  const double polar = b.polar_inertia * length * 0.7; // ∫ 0.9 − 0.4 ξ
  expect_equal(now.of(std::vector{body.mass}), MatrixXd::Constant(1, 1, over_mass([](double) { return 1; })),
               "m");
  expect_equal(now.of(body.first_moment), integral(3, [&](double x) { return b.position(x, now.q); }), "S");
  const auto inertia = [&](double t) {
    return integral(6, [&](double x) {
      const Vector3d r = b.position(x, t * now.q);
      VectorXd j(6);
      j << r.y() * r.y() + r.z() * r.z(), r.z() * r.z() + r.x() * r.x(), r.x() * r.x() + r.y() * r.y(),
          -r.x() * r.y(), -r.y() * r.z(), -r.z() * r.x();
      return j;
    });
  };
  const Vector3d& a = b.axis;
  VectorXd spinning(6);
  spinning << a.x() * a.x(), a.y() * a.y(), a.z() * a.z(), a.x() * a.y(), a.y() * a.z(), a.z() * a.x();
  const mechanics::symmetric& j = body.inertia;
  expect_equal(now.of(std::vector{j.xx, j.yy, j.zz, j.xy, j.yz, j.zx}),
               truncated(inertia, 2) + polar * spinning, "J");
  for (int k = 0; k < 5; ++k) {
    const auto angular = [&](double t) {
      return integral(3, [&](double x) {
        return VectorXd(b.position(x, t * now.q).cross(b.derivative(x, t * now.q, k)));
      });
    };
    const double twist = b.polar_inertia * length * (0.9 / 2 - 0.4 / 3);
    expect_equal(now.of(body.angular[k]), k == 3 ? VectorXd(twist * a) : VectorXd(truncated(angular, 1)),
                 "H" + std::to_string(k));
    for (int l = 0; l < 5; ++l) {
      const VectorXd zero = VectorXd::Zero(5);
      const double moving =
          over_mass([&](double x) { return b.derivative(x, zero, k).dot(b.derivative(x, zero, l)); });
      const double turning = k == 3 && l == 3 ? b.polar_inertia * length * (0.9 / 3 - 0.4 / 4) : 0;
      expect_equal(now.of(std::vector{body.modal_mass(k, l)}), MatrixXd::Constant(1, 1, moving + turning),
                   "M");
    }
  }
}

// The axes of sections as columns in the inertial axes, and their positions.
struct sections {
  Vector3d position;
  Eigen::Matrix3d axes;
};
sections section_at(skew_beam& b, section_ids at, const VectorXd& q) {
  values now;
  now.q = q;
  const mechanics::mechanism& m = b.mechanism();
  const auto vector = [&](const mechanics::vector& v) { return now.of(mechanics::express(m, v, 0)); };
  sections found;
  found.position = vector(m.points[kanexpr::runtime::place(at.point)].offset);
  for (int i = 0; i < 3; ++i) found.axes.col(i) = vector(b.along(at.frame, i == 0, i == 1, i == 2));
  return found;
}

TEST(beam_sections, lie_on_the_beam_and_their_axes_are_tangent_to_the_second_order) {
  skew_beam b;
  const section_ids before = b.section("P", b.beam_made, 0.6 - 1e-4), at = b.section("Q", b.beam_made, 0.6),
                    after = b.section("R", b.beam_made, 0.6 + 1e-4);
  ASSERT_EQ(b.mistake().view(), "");
  VectorXd q = random_values(5, 0, 3).q;
  expect_equal(section_at(b, at, q).position, b.position(0.6, q), "position");
  q[4] = 0; // the order is that of bending and torsion
  const auto error = [&](double t) {
    const VectorXd scaled = t * q;
    const Vector3d tangent =
        (section_at(b, after, scaled).position - section_at(b, before, scaled).position) / (2e-4 * length);
    return (section_at(b, at, scaled).axes * b.axis - tangent).norm();
  };
  EXPECT_NEAR(error(0), 0, 1e-11);
  EXPECT_NEAR(error(0.2) / error(0.1), 8, 0.3); // of the third order
}

// ---- words

namespace words {
using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct R : rotated<R, N, q, N::z> {};
struct Root : offset<Root, O, 0.3 * R::x> {};
struct Blade : beam<Blade, Root, R::x, 1.7, 0.6, profile<stations<0, 1, 0.4, 0.8, 1, 0.5>>,
                    bending<R::y, 3.1, clamped_free<2>, profile<polynomial<1, -0.6>>>,
                    bending<R::z, 2.0, stations<0, 0, 0.3, 0.1, 0.7, 0.5, 1, 1>>,
                    torsion<7.0, polar_inertia<0.02, profile<polynomial<1, -0.5>>>, clamped_free<1>>,
                    extension<50.0, polynomial<0, 2, -1>>, proportional_damping<0.1, 0.002>> {};
struct Middle : section<Middle, Blade, 0.5> {};
struct Tip : section<Tip, Blade, 1> {};
struct Second
    : beam<Second, Tip, Tip::y, 0.9, 0.4, bending<Tip::x, 1.0, stations_with_slopes<0, 0, 0, 1, 1, 1.5>>,
           modal_damping<0.02>, by<coordinate<"a">{}, speed<"b">{}>> {};
struct End : section<End, Second, 1> {};
struct Arm : pin<Arm, Middle, axis<own::y>, body<0.3, 0.2 * own::x>> {};
struct Load : particle<Load, End, 0.25> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, joints<Arm>,
                            bodies<Blade, Second, Load>, loads<gravity<-9.81 * N::y>>> {};
} // namespace words

// The same system, built.
struct built_words : bench {
  built_words() {
    const expression q = add("q", "u"), arm = add("q_Arm", "u_Arm");
    std::vector<expression> blade;
    for (int i = 1; i <= 5; ++i)
      blade.push_back(add("q" + std::to_string(i) + "_Blade", "u" + std::to_string(i) + "_Blade"));
    const expression second = add("a", "b");
    const frame_id r = rotated("R", n, q, along(n, 0, 0, 1));
    beam_data data{.axis = along(r, 1, 0, 0), .length = 1.7, .mass_per_length = 0.6};
    data.mass_profile = kanexpr::numeric::beams::linear_table({0.0, 0.4, 1.0}, {1.0, 0.8, 0.5});
    const shape splined = kanexpr::numeric::beams::spline({0.0, 0.3, 0.7, 1.0}, {0.0, 0.1, 0.5, 1.0}, true);
    data.bending = {
        {along(r, 0, 1, 0), {3.1, modes_of_bending(ends::clamped_free, 2), shape::polynomial({1.0, -0.6})}},
        {along(r, 0, 0, 1), {2.0, {splined}}}};
    data.torsion = {.polar_inertia = 0.02,
                    .by = {7.0, modes_of_rod(ends::clamped_free, 1)},
                    .profile = shape::polynomial({1.0, -0.5})};
    data.extension = {50.0, {shape::polynomial({0.0, 2.0, -1.0})}};
    data.damping_of_mass = 0.1, data.damping_of_stiffness = 0.002;
    const beam_id first = beam("Blade", offset("Root", o, along(r, 0.3, 0, 0)), r, blade, data);
    const section_ids middle = section("Middle", first, 0.5), tip = section("Tip", first, 1);
    const shape cubic = kanexpr::numeric::beams::cubic_table({0.0, 1.0}, {0.0, 1.0}, {0.0, 1.5});
    beam_data other{.axis = along(tip.frame, 0, 1, 0), .length = 0.9, .mass_per_length = 0.4};
    other.bending = {{along(tip.frame, 1, 0, 0), {1.0, {cubic}}}};
    other.damping_ratios = {0.02};
    const section_ids end = section("End", beam("Second", tip.point, tip.frame, {second}, other), 1);
    const frame_id turned = rotated("Arm", middle.frame, arm, along(middle.frame, 0, 1, 0));
    particle("Load", end.point, number(0.25));
    particle("Arm", offset("C", middle.point, along(turned, 0.2, 0, 0)), number(0.3));
    gravity(along(n, 0, -9.81, 0));
  }
  expression add(const std::string& q, const std::string& u) {
    const expression e = coordinate(q);
    kinematic_equation(dot(e) - speed(u));
    return e;
  }
};

TEST(beam_words, describe_the_same_system_as_a_builder) {
  kanexpr::model found = kanexpr::derive<words::System>();
  ASSERT_EQ(found.mistake(), "");
  built_words by_hand;
  ASSERT_EQ(by_hand.check().view(), "");
  kanexpr::model expected = kanexpr::derive(by_hand);
  EXPECT_EQ(found.linearize().states(), expected.linearize().states());
  for (const unsigned seed : {1u, 2u}) {
    values now = random_values(8, 8, seed);
    now.q *= 0.3;
    for (const quantity each :
         {quantity::mass_matrix, quantity::forcing, quantity::kinetic_energy, quantity::potential_energy})
      expect_equal(now.of(found.get(each)), now.of(expected.get(each)),
                   std::string(mechanics::row_of(each).called));
  }
}

TEST(beam_words, name_the_symbols) {
  const std::vector<std::string> expected{
      "q", "q_Arm", "q1_Blade", "q2_Blade", "q3_Blade", "q4_Blade", "q5_Blade", "a",
      "u", "u_Arm", "u1_Blade", "u2_Blade", "u3_Blade", "u4_Blade", "u5_Blade", "b"};
  EXPECT_EQ(kanexpr::derive<words::System>().linearize().states(), expected);
}

// Free and pinned modes as words: a beam that floats in the plane.
namespace floating_beam {
using namespace kanexpr;
struct Ground : inertial_ground<Ground> {};
struct Base : planar<Base, Ground, axis<own::x, own::y>> {};
struct Rod : beam<Rod, Base, Base::x, 1.7, 0.6, bending<Base::y, 3.1, free_free<2>>> {};
struct System : kane_system<inertial<Ground>, joints<Base>, bodies<Rod>> {};
struct ByLagrange : lagrange_system<inertial<Ground>, joints<Base>, bodies<Rod>> {};
} // namespace floating_beam

TEST(beam_words, describe_a_floating_beam) {
  expect_frequencies(kanexpr::derive<floating_beam::System>(), rates_of(ends::free_free, 2), "free-free");
}

TEST(beam_words, give_the_same_equations_by_lagranges_method) {
  const values now = random_values(5, 5, 4);
  kanexpr::model kane = kanexpr::derive<floating_beam::System>(),
                 lagrange = kanexpr::derive<floating_beam::ByLagrange>();
  ASSERT_EQ(lagrange.mistake(), "");
  for (const quantity each : {quantity::mass_matrix, quantity::forcing})
    expect_equal(now.of(lagrange.get(each)), now.of(kane.get(each)),
                 std::string(mechanics::row_of(each).called));
}

} // namespace
