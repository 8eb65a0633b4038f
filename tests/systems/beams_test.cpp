// builds: clang++ all
// Beams from a builder: their integrals, frequencies and sections.
#include "systems/beams.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace beams;
using kanexpr::numeric::beams::shape;
using kanexpr::runtime::beam_data;
using kanexpr::runtime::beam_id;
using kanexpr::runtime::modes_of_bending;
using kanexpr::runtime::modes_of_rod;
using kanexpr::runtime::section_ids;

// A beam along x that bends along y.
beam_data plane_beam(bench& b, frame_id frame, const std::vector<shape>& shapes, bool moves_root = false) {
  beam_data data{.axis = b.along(frame, 1, 0, 0), .length = length, .mass_per_length = mass_per_length};
  data.bending = {{b.along(frame, 0, 1, 0), {stiffness, shapes}}};
  data.bending[0].by.moves_root = moves_root;
  return data;
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

// ---- the mass matrix at large amplitudes

// How a light hub moves: it turns about its center, where the root of the beam is, or is displaced along the
// axis of the beam, or across it; it moves freely; or it only translates, in all directions or across the
// axis.
enum class hub_motion { turns, turns_with_radius, turns_with_offset, is_free, translates, translates_across };

// A beam with modes of a cantilever in one plane or in two, on a hub.
struct moving_beam : bench {
  static constexpr double hub_mass = 1e-3, hub_inertia = 1e-5;
  hub_motion how;
  int planes, modes;
  std::vector<shape> shapes = modes_of_bending(ends::clamped_free, modes);
  std::vector<expression> q{};

  moving_beam(hub_motion how_, int planes_, int modes_) : how(how_), planes(planes_), modes(modes_) {
    q = free("q", rigid() + planes * modes);
    frame_id hub = n;
    point_id root = o;
    if (translations() == 3) root = offset("P", o, along(n, q[0], q[1], q[2]));
    if (translations() == 2) root = offset("P", o, along(n, 0, q[0], q[1]));
    if (turns() > 0) {
      const auto at = static_cast<std::size_t>(translations());
      const frame_id inner = rotated("R", n, q[at], along(n, 0, 0, 1));
      hub = rotated("H", inner, q[at + 1], along(inner, 0, 1, 0));
      const Vector3d arm = offset_of_root();
      if (!arm.isZero()) root = offset("A", root, along(hub, arm.x(), arm.y(), arm.z()));
    }
    rigid_body("Hub", root, hub, number(hub_mass), inertia(hub, hub_inertia, hub_inertia, hub_inertia));
    beam_data data = plane_beam(*this, hub, shapes);
    if (planes == 2) data.bending.push_back({along(hub, 0, 0, 1), data.bending[0].by});
    beam("B", root, hub, {q.begin() + rigid(), q.end()}, data);
  }
  int translations() const {
    return how == hub_motion::translates_across                          ? 2
           : how == hub_motion::is_free || how == hub_motion::translates ? 3
                                                                         : 0;
  }
  int turns() const { return how == hub_motion::translates || how == hub_motion::translates_across ? 0 : 2; }
  int rigid() const { return translations() + turns(); }
  int size() const { return rigid() + planes * modes; }
  Vector3d offset_of_root() const {
    if (how == hub_motion::turns_with_offset) return {0.1, 0.3, -0.2};
    return {how == hub_motion::turns_with_radius ? 0.3 : 0, 0, 0};
  }

  // That of the particles of the axis, which move by quadratic functions of the amplitudes; at the angles 0.
  MatrixXd exact_mass(const VectorXd& amplitudes) const {
    MatrixXd mass = MatrixXd::Zero(size(), size());
    const auto add = [&](double part, const Vector3d& r, const MatrixXd& bent) {
      MatrixXd velocity(3, size());
      velocity.leftCols(translations()) = Eigen::Matrix3d::Identity().rightCols(translations());
      if (turns() > 0) {
        velocity.col(rigid() - 2) = Vector3d::UnitZ().cross(r);
        velocity.col(rigid() - 1) = Vector3d::UnitY().cross(r);
      }
      velocity.rightCols(planes * modes) = bent;
      mass += part * velocity.transpose() * velocity;
    };
    add(hub_mass, offset_of_root(), MatrixXd::Zero(3, planes * modes));
    for (int i = translations(); i < rigid(); ++i) mass(i, i) += hub_inertia;
    using rule = boost::math::quadrature::gauss<double, 20>;
    for (std::size_t i = 0; i < 2 * rule::abscissa().size(); ++i) {
      const double xi = (1 + (i % 2 == 0 ? 1 : -1) * rule::abscissa()[i / 2]) / 2;
      Vector3d r = offset_of_root() + Vector3d(xi * length, 0, 0);
      MatrixXd bent = MatrixXd::Zero(3, planes * modes);
      for (int k = 0; k < planes * modes; ++k) {
        const auto value = [&](int of, double x) {
          return shapes[static_cast<std::size_t>(of % modes)].at(x);
        };
        bent(1 + k / modes, k) = value(k, xi).value;
        r(1 + k / modes) += amplitudes(k) * value(k, xi).value;
        for (int l = k / modes * modes; l < (k / modes + 1) * modes; ++l) {
          const double shortening = rule::integrate(
              [&](double x) { return value(k, x).slope * value(l, x).slope / length; }, 0.0, xi);
          bent(0, k) -= shortening * amplitudes(l);
          r(0) -= shortening * amplitudes(k) * amplitudes(l) / 2;
        }
      }
      add(mass_per_length * length * rule::weights()[i / 2] / 2, r, bent);
    }
    return mass;
  }
};

TEST(beam_mass, is_positive) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> draw(-0.1 * length, 0.1 * length);
  for (const hub_motion how :
       {hub_motion::turns, hub_motion::turns_with_radius, hub_motion::turns_with_offset, hub_motion::is_free,
        hub_motion::translates, hub_motion::translates_across})
    for (const int planes : {1, 2})
      for (const int modes : {1, 2, 3}) {
        const moving_beam b(how, planes, modes);
        ASSERT_EQ(b.check().view(), "");
        kanexpr::model m = kanexpr::derive(b);
        auto mass = m.function(m.mass_matrix());
        for (int i = 0; i < 3; ++i) {
          VectorXd x = VectorXd::Zero(2 * b.size());
          for (int k = 0; k < planes * modes; ++k)
            x(b.rigid() + k) = draw(random) / ((k % modes + 1) * (k % modes + 1));
          // at a tenth of the length, close to the exact one; with several shapes, positive at any amplitude
          for (const auto& [scale, least] : {std::pair{1, 0.8}, std::pair{10, 0.0}}) {
            if (scale > 1 && planes * modes == 1) continue;
            const MatrixXd found = mass(VectorXd(scale * x));
            const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ratio(
                found, b.exact_mass(scale * x.segment(b.rigid(), planes * modes)));
            EXPECT_GT(ratio.eigenvalues().minCoeff(), least)
                << planes << ' ' << modes << ' ' << static_cast<int>(how);
          }
        }
      }
}

// ---- operations

int operations(const bench& b) {
  EXPECT_EQ(b.check().view(), "");
  kanexpr::model m = kanexpr::derive(b);
  const auto cost = m.function(m.udot()).cost();
  return cost.multiplications + cost.additions + cost.divisions;
}

// An arm with parameters on a hub that is turned by a torque, or that moves freely in a plane.
struct arm_with_parameters : bench {
  arm_with_parameters(int modes, bool is_free) {
    const std::vector<expression> q = free("q", (is_free ? 3 : 1) + modes);
    const frame_id hub = rotated("H", n, q[0], along(n, 0, 0, 1));
    const point_id root = is_free ? offset("P", o, along(n, q[1], q[2], 0)) : o;
    const expression inertia_of_hub = parameter("J"), zero = number(0.0);
    rigid_body("Hub", root, hub, parameter("M"), inertia(hub, zero, zero, inertia_of_hub));
    beam_data data{
        .axis = along(hub, 1, 0, 0), .length = parameter("L"), .mass_per_length = parameter("rho")};
    data.bending = {{along(hub, 0, 1, 0), {parameter("EI"), modes_of_bending(ends::clamped_free, modes)}}};
    beam("B", root, hub, {q.end() - modes, q.end()}, data);
    torque(hub, input("T") * along(n, 0, 0, 1));
  }
};

TEST(beam_operations, of_an_arm_on_a_hub_grow_with_its_modes) {
  constexpr int turning[]{37, 104, 155}, moving[]{119, 293, 447};
  for (int modes = 1; modes <= 3; ++modes) {
    EXPECT_LE(operations(arm_with_parameters(modes, false)), turning[modes - 1]) << modes;
    EXPECT_LE(operations(arm_with_parameters(modes, true)), moving[modes - 1]) << modes;
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

// The mistake after a change of the data of a valid beam.
std::string mistake_of(const std::function<void(bench&, beam_data&, std::vector<expression>&)>& change) {
  bench b;
  std::vector<expression> q = b.free("q", 2);
  beam_data data = plane_beam(b, b.n, modes_of_bending(ends::clamped_free, 2));
  change(b, data, q);
  b.beam("B", b.o, b.n, q, data);
  return std::string(b.check().view());
}

TEST(beam_mistakes, of_a_builder_are_sentences) {
  const auto expect = [](const std::function<void(bench&, beam_data&, std::vector<expression>&)>& change,
                         const std::string& sentence) { EXPECT_EQ(mistake_of(change), sentence); };
  using amplitudes = std::vector<expression>;
  expect([](bench&, beam_data&, amplitudes&) {}, "");
  expect([](bench&, beam_data& d, amplitudes&) { d.bending[0].by.shapes.clear(); },
         "beam B has a deformation without a shape");
  expect([](bench&, beam_data& d, amplitudes&) { d.bending.clear(); }, "beam B has no shapes");
  expect([](bench&, beam_data&, amplitudes& q) { q.pop_back(); },
         "expected an amplitude for each of the 2 shapes of beam B, got 1");
  expect([](bench&, beam_data&, amplitudes& q) { q[1] = q[0]; },
         "q1 is listed twice among the amplitudes of B");
  expect([](bench&, beam_data& d, amplitudes&) { d.bending[0].by.shapes[1] = shape::polynomial({0.0, 1.0}); },
         "beam B has a shape that displaces or turns the root; set moves_root if this is intended");
  expect([](bench&, beam_data& d, amplitudes&) { d.bending.assign(3, d.bending[0]); },
         "beam B bends in three directions; a beam bends in one direction or in two perpendicular ones");
  expect([](bench& b, beam_data& d, amplitudes&) { d.bending[0].direction = b.along(b.n, 1, 1, 0); },
         "beam B bends in a direction that is not perpendicular to its axis");
  expect([](bench&, beam_data& d, amplitudes&) { d.bending.push_back(d.bending[0]); },
         "expected an amplitude for each of the 4 shapes of beam B, got 2");
  expect([](bench& b, beam_data& d, amplitudes&) { d.axis = b.along(b.n, 0.0, 0.0, 0.0); },
         "beam B has an axis of zero length");
  expect([](bench&, beam_data& d, amplitudes&) { d.bending[0].direction = {}; },
         "beam B bends in a direction of zero length");
  const std::string incomplete = "beam B has a shape that is not given on the whole beam, by finite numbers "
                                 "and stations in increasing order from 0 to 1";
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const std::string empty = "beam B has an empty shape; natural modes are empty if their number is less than "
                            "1, or if a ratio of the body at the tip is negative or not finite";
  for (const shape& each :
       {shape{}, shape::polynomial({}), kanexpr::numeric::beams::mode_of_bending(ends::clamped_free, 0),
        kanexpr::numeric::beams::mode_of_bending(ends::clamped_free, 1, {-0.5, 0}),
        kanexpr::numeric::beams::mode_of_bending(ends::clamped_free, 1, {0, not_a_number})})
    expect([&](bench&, beam_data& d, amplitudes&) { d.bending[0].by.shapes[1] = each; }, empty);
  for (const shape& each :
       {shape::polynomial({0.0, 0.0, not_a_number}), shape::piecewise({0.0, 2.0}, 2, {0.0, 0.0, 1.0}),
        shape::piecewise({0.0, 0.5, 1.0}, 2, {0.0, 0.0, 1.0})})
    expect([&](bench&, beam_data& d, amplitudes&) { d.bending[0].by.shapes[1] = each; }, incomplete);
  expect(
      [](bench&, beam_data& d, amplitudes&) {
        d.bending[0].by.shapes[1] = shape::piecewise({0.0, 0.5, 1.0}, 1, {0.0, 0.0, 0.0, 1.0});
      },
      "beam B has a shape with a jump or a kink at a station");
  const std::string negative = "beam B has a profile that is negative at some place, or nowhere positive";
  expect([](bench&, beam_data& d, amplitudes&) { d.mass_profile = shape::polynomial({1.0, -1.5}); },
         negative);
  expect([](bench&, beam_data& d, amplitudes&) { d.bending[0].by.profile = shape{}; }, negative);
  expect([](bench&, beam_data& d, amplitudes&) { d.length = -1; }, "the length of beam B is not positive");
  const std::string extreme =
      "the numbers of beam B are too large or too small: its mass or its stiffness is "
      "not a finite number greater than 0";
  expect([](bench&, beam_data& d, amplitudes&) { d.length = 1e-300; }, extreme);
  expect([](bench&, beam_data& d, amplitudes&) { d.length = 1e150; }, extreme);
  expect([](bench&, beam_data& d, amplitudes&) { d.bending[0].by.stiffness = 1e308, d.length = 0.1; },
         extreme);
  expect([](bench&, beam_data& d, amplitudes&) { d.mass_per_length = 1e-300, d.length = 1e-100; }, extreme);
  expect([](bench&, beam_data& d, amplitudes& q) { d.mass_per_length = q[0]; },
         "the mass per length of beam B may vary; it may contain only numbers and parameters");
  expect([](bench&, beam_data& d, amplitudes&) { d.damping_ratios = {0.1, 0.1, 0.1}; },
         "beam B has neither one damping ratio nor a ratio for each shape");
  expect([](bench&, beam_data& d, amplitudes&) { d.damping_ratios = {1 / 2}; },
         "the damping of beam B contains 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 if you "
         "mean "
         "zero");
  expect([](bench&, beam_data& d, amplitudes&) { d.damping_of_stiffness = 1 / 200; },
         "the damping of beam B contains 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 if you "
         "mean "
         "zero");
  expect([](bench&, beam_data& d, amplitudes&) { d.damping_of_mass = -0.1; },
         "the damping of beam B is negative");
}

// With its first mode, an arm on a hub without inertia has a positive kinetic energy up to a deflection of
// 0.446 L, where (1/3 − 0.0483 q²)/4 = 0.2844².
TEST(beam_status, reports_a_deflection_beyond_which_the_kinetic_energy_is_not_positive) {
  bench b;
  const std::vector<expression> q = b.free("q", 2);
  const frame_id r = b.rotated("R", b.n, q[0], b.along(b.n, 0, 0, 1));
  b.beam("B", b.o, r, {q[1]}, plane_beam(b, r, modes_of_bending(ends::clamped_free, 1)));
  kanexpr::model m = kanexpr::derive(b);
  auto udot = m.function(m.udot());
  const auto status_at = [&](double deflection) {
    udot(Eigen::Vector4d(0.3, deflection * length, 0, 0), VectorXd(0));
    return std::string(udot.status().view());
  };
  EXPECT_EQ(status_at(0.44), "");
  for (const double deflection : {0.45, -0.5, 3.0, 10.0})
    EXPECT_EQ(
        status_at(deflection),
        "the mass matrix is not positive definite at this state: its elimination fails at the speed u_q1; "
        "a flexible body may be deformed too much");
}

TEST(beam_mistakes, in_sections_of_a_builder_are_sentences) {
  const auto mistake = [](const kanexpr::runtime::given_number& xi, int beams) {
    bench b;
    const std::vector<expression> q = b.free("q", 1);
    if (beams > 0) b.beam("B", b.o, b.n, q, plane_beam(b, b.n, modes_of_bending(ends::clamped_free, 1)));
    b.section("S", beam_id{}, xi);
    return std::string(b.mistake().view());
  };
  EXPECT_EQ(mistake(0.5, 1), "");
  EXPECT_EQ(mistake(1.5, 1),
            "section S is not on beam B; its place is a fraction of the length, a number from 0 to 1");
  EXPECT_EQ(
      mistake(0, 1),
      "section S of beam B is at 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 for the root");
  EXPECT_EQ(mistake(0.0, 1), "");
  EXPECT_EQ(mistake(0.5, 0), "section S is placed on a beam that does not exist");
}

} // namespace
