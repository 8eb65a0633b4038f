// builds: clang++
// Pathways: the power of loads along them, their lengths compared with geodesics that are integrated
// numerically, energy, and Kane's method compared with Lagrange's.
#include "arm.hpp"

#include <Eigen/Core>
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::wrapping;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::pathway;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::matrix;
using mechanics::quantity;
using mechanisms::arm;

VectorXd random_state(std::mt19937_64& source) {
  std::uniform_real_distribution<double> value(-1.2, 1.2);
  VectorXd x(8);
  for (double& each : x) each = value(source);
  return x;
}

const VectorXd nothing(0);

TEST(pathways, power_is_tension_times_rate) {
  int touching = 0;
  for (std::size_t i = 0; i < arm().pathways().size(); ++i) {
    arm b;
    const auto [name, path] = b.pathways()[i];
    SCOPED_TRACE(name);
    const expression tension = b.input("T");
    b.force_along(path, tension);
    const expression length = b.length_of(path);
    mechanics::known_motion known(b.mechanism());
    matrix wanted(b.graph(), 2, 1);
    wanted.entries[0] = length;
    wanted.entries[1] = known.moving().rate(length);
    auto model = kanexpr::derive(b);
    ASSERT_EQ(model.mistake(), "");
    auto forces = model.function(model.get(quantity::load_compensation));
    auto lengths = model.function(wanted);
    std::mt19937_64 source(5);
    for (int k = 0; k < 60; ++k) {
      const VectorXd x = random_state(source), r = VectorXd::Constant(1, 2.5);
      const MatrixXd l = lengths(x, nothing, r), f = forces(x, nothing, r);
      if (!l.allFinite()) continue;
      const double power = -f.col(0).dot(x.tail(4));
      EXPECT_NEAR(power, -2.5 * l(1), 1e-12 * (1 + f.norm() * x.norm())) << k;
      ++touching;
    }
  }
  EXPECT_GT(touching, 600);
}

// Springs, cubic springs and stops: the equations of Kane's method, which applies forces along the lines,
// agree with those of Lagrange's method, which differentiates the energy.
TEST(pathways, agree_with_lagrange) {
  const auto model_of = [](arm& b, std::size_t i, bool damped) {
    const pathway path = b.pathways()[i].second;
    b.linear_spring(path, b.number(3), b.number(0.4));
    b.cubic_spring(path, b.number(1.5), b.number(0.7), b.number(0.3));
    b.stop(path, b.number(0.6), b.number(0.9), b.number(50), b.number(damped ? 0.3 : 0.0), b.number(0.05));
    return kanexpr::derive(b);
  };
  for (std::size_t i = 0; i < arm().pathways().size(); ++i)
    for (const bool damped : {false, true}) {
      arm by_kane, by_lagrange(true);
      SCOPED_TRACE(by_kane.pathways()[i].first);
      auto kane = model_of(by_kane, i, damped), lagrange = model_of(by_lagrange, i, damped);
      ASSERT_EQ(kane.mistake(), "");
      ASSERT_EQ(lagrange.mistake(), "");
      auto first = kane.function(kane.get(quantity::udot)),
           second = lagrange.function(lagrange.get(quantity::udot));
      std::mt19937_64 source(11);
      for (int k = 0; k < 30; ++k) {
        const VectorXd x = random_state(source);
        VectorXd rates = x;
        rates(5) -= 0.5 * x(4);
        const VectorXd udot = first(x), qddot = second(rates);
        if (!udot.allFinite()) continue;
        VectorXd accelerations = udot;
        accelerations(1) -= 0.5 * udot(0);
        EXPECT_LT((accelerations - qddot).norm(), 1e-11 * (1 + qddot.norm())) << k;
      }
    }
}

// The linearization agrees with complex steps, in which the pathways are evaluated with complex lengths.
TEST(pathways, have_derivatives) {
  for (std::size_t i = 0; i < arm().pathways().size(); ++i) {
    arm b;
    const auto [name, path] = b.pathways()[i];
    SCOPED_TRACE(name);
    b.cubic_spring(path, b.number(3), b.number(0.7), b.number(0.3));
    b.linear_damper(path, b.number(0.4));
    b.stop(path, b.number(0.6), b.number(0.9), b.number(50), b.number(0.3), b.number(0.4));
    auto model = kanexpr::derive(b);
    ASSERT_EQ(model.mistake(), "");
    auto jacobian = model.function(model.get(quantity::state_jacobian));
    auto rhs = model.function<std::complex<double>>(model.get(quantity::rhs));
    auto in_float = model.function<float>(model.get(quantity::rhs));
    auto in_double = model.function(model.get(quantity::rhs));
    auto elsewhere = kanexpr::runtime::derive_in_own_graph(b);
    auto copied = elsewhere.function(elsewhere.get(quantity::rhs));
    std::mt19937_64 source(21);
    for (int k = 0; k < 10; ++k) {
      const VectorXd x = random_state(source);
      const MatrixXd exact = jacobian(x);
      if (!exact.allFinite()) continue;
      MatrixXd by_steps(8, 8);
      for (int j = 0; j < 8; ++j) {
        Eigen::VectorXcd moved = x;
        moved(j) += std::complex<double>(0, 1e-30);
        by_steps.col(j) = Eigen::VectorXcd(rhs(moved)).imag() / 1e-30;
      }
      EXPECT_LT((exact - by_steps).norm(), 1e-10 * exact.norm()) << k;
      const VectorXd rates = in_double(x);
      EXPECT_LT((VectorXd(copied(x)) - rates).norm(), 1e-12 * (1 + rates.norm()));
      EXPECT_LT((Eigen::VectorXf(in_float(Eigen::VectorXf(x.cast<float>()))).cast<double>() - rates).norm(),
                3e-4 * (1 + rates.norm()));
    }
  }
}

// A surface f = 0 with its gradient and its second derivative along a direction.
struct surface {
  std::function<double(const Vector3d&)> f;
  std::function<Vector3d(const Vector3d&)> gradient;
  std::function<double(const Vector3d&)> curvature; ///< v·(∂²f) v

  // A geodesic: x'' = −(x'·∂²f x') ∂f/|∂f|², by the method of Runge and Kutta.
  void move(Vector3d& x, Vector3d& v, double distance) const {
    constexpr int steps = 1000;
    const double h = distance / steps;
    const auto a = [&](const Vector3d& at, const Vector3d& along) -> Vector3d {
      const Vector3d n = gradient(at);
      return -curvature(along) / n.squaredNorm() * n;
    };
    for (int i = 0; i < steps; ++i) {
      const Vector3d k1 = v, l1 = a(x, v), k2 = v + h / 2 * l1, l2 = a(x + h / 2 * k1, k2),
                     k3 = v + h / 2 * l2, l3 = a(x + h / 2 * k2, k3), k4 = v + h * l3, l4 = a(x + h * k3, k4);
      x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
  }
};

const double radius = 0.3, slope = std::tan(0.4);
const surface cylinder{[](const Vector3d& x) { return x.head<2>().squaredNorm() - radius * radius; },
                       [](const Vector3d& x) { return Vector3d(2 * x(0), 2 * x(1), 0); },
                       [](const Vector3d& v) { return 2 * v.head<2>().squaredNorm(); }};
const surface ball{[](const Vector3d& x) { return x.squaredNorm() - radius * radius; },
                   [](const Vector3d& x) { return Vector3d(2 * x); },
                   [](const Vector3d& v) { return 2 * v.squaredNorm(); }};
const surface cone{
    [](const Vector3d& x) { return x.head<2>().squaredNorm() - slope * slope * x(2) * x(2); },
    [](const Vector3d& x) { return Vector3d(2 * x(0), 2 * x(1), -2 * slope * slope * x(2)); },
    [](const Vector3d& v) { return 2 * (v.head<2>().squaredNorm() - slope * slope * v(2) * v(2)); }};

// Two points and a pathway between them around a surface whose axis is z.
struct wrapped : builder {
  matrix result;
  std::vector<expression> at;

  wrapped(mechanics::pathway_form form, wrapping sense, bool first_on, bool last_on) : builder("N") {
    for (int i = 0; i < 6; ++i) at.push_back(coordinate("q" + std::to_string(i)));
    rates_as_speeds();
    const frame_id n = inertial_frame();
    const point_id o = origin("O"), p = offset("P", o, along(n, at[0], at[1], at[2])),
                   q = offset("Q", o, along(n, at[3], at[4], at[5]));
    particle("first", p, number(1));
    particle("last", q, number(1));
    const auto axis = along(n, 0, 0, 1);
    const kanexpr::runtime::end_of_path first(p, first_on), last(q, last_on);
    const pathway path = form == mechanics::pathway_form::around_cylinder
                             ? around_cylinder(n, o, axis, number(radius), first, last, sense)
                         : form == mechanics::pathway_form::around_sphere
                             ? around_sphere(o, number(radius), first, last)
                             : around_cone(n, o, axis, number(0.4), first, last, sense);
    force_along(path, number(1));
    result = matrix(graph(), 1, 1);
    result.entries[0] = length_of(path);
  }
};

// The distance at which a straight line touches a surface.
double distance_to_touch(const surface& s, const Vector3d& from, const Vector3d& along) {
  const double second = s.curvature(along) / 2, first = s.gradient(from).dot(along);
  return -first / (2 * second);
}

// Follows the line from its first point, with the direction given by the force there, along the tangent, the
// geodesic and the second tangent; it must arrive at the last point, in the direction of the force there.
void expect_geodesic(const surface& s, mechanics::pathway_form form, wrapping sense, bool first_on,
                     bool last_on, const std::function<Vector3d(std::mt19937_64&, bool)>& point) {
  wrapped b(form, sense, first_on, last_on);
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  auto length = model.function(b.result), force = model.function(model.get(quantity::load_compensation));
  std::mt19937_64 source(3);
  int touching = 0;
  for (int k = 0; k < 20; ++k) {
    VectorXd x = VectorXd::Zero(12);
    x.head<3>() = point(source, first_on), x.segment<3>(3) = point(source, last_on);
    const double l = length(x)(0);
    const VectorXd away = VectorXd(force(x));
    const Vector3d p = x.head<3>(), q = x.segment<3>(3), leaving = -away.head<3>(), arriving = away.tail<3>();
    if (!std::isfinite(l)) continue; // it slips over the tip of the cone
    EXPECT_NEAR(leaving.norm(), 1, 1e-13);
    EXPECT_NEAR(arriving.norm(), 1, 1e-13);
    if (std::abs(l - (q - p).norm()) < 1e-12) continue;
    ++touching;
    const double first = first_on ? 0 : distance_to_touch(s, p, leaving),
                 last = last_on ? 0 : distance_to_touch(s, q, -arriving);
    Vector3d at = p + first * leaving, along = leaving;
    EXPECT_NEAR(s.f(at), 0, 1e-12);
    EXPECT_NEAR(s.gradient(at).dot(along), 0, 1e-12);
    EXPECT_GE(first, 0);
    EXPECT_GE(last, 0);
    s.move(at, along, l - first - last);
    EXPECT_LT((at + last * arriving - q).norm(), 2e-9);
    EXPECT_LT((along - arriving).norm(), 2e-9);
    if (form == mechanics::pathway_form::around_sphere) continue;
    const double turning = p.cross(leaving)(2);
    EXPECT_EQ(turning > 0, sense == wrapping::counterclockwise);
  }
  EXPECT_GT(touching, 2);
}

TEST(pathways, are_geodesics) {
  std::uniform_real_distribution<double> value(-1, 1);
  const auto around = [&](std::mt19937_64& source, double at_least) {
    const double angle = std::numbers::pi * value(source), distance = at_least * (1.2 + 0.8 * value(source));
    return Vector3d(distance * std::cos(angle), distance * std::sin(angle), 0);
  };
  for (const bool first_on : {false, true})
    for (const bool last_on : {false, true}) {
      for (const wrapping sense : {wrapping::counterclockwise, wrapping::clockwise}) {
        SCOPED_TRACE(std::to_string(first_on) + std::to_string(last_on));
        expect_geodesic(cylinder, mechanics::pathway_form::around_cylinder, sense, first_on, last_on,
                        [&](std::mt19937_64& source, bool is_on) {
                          Vector3d x = around(source, is_on ? 1.0 : 2.6 * radius);
                          if (is_on) x *= radius / x.norm();
                          x(2) = value(source);
                          return x;
                        });
        expect_geodesic(cone, mechanics::pathway_form::around_cone, sense, first_on, last_on,
                        [&](std::mt19937_64& source, bool is_on) {
                          const double height = 1 + 0.5 * value(source);
                          Vector3d x = around(source, is_on ? 1.0 : 2.6 * slope * height);
                          if (is_on) x *= slope * height / x.norm();
                          x(2) = height;
                          return x;
                        });
      }
      expect_geodesic(ball, mechanics::pathway_form::around_sphere, wrapping::clockwise, first_on, last_on,
                      [&](std::mt19937_64& source, bool is_on) {
                        Vector3d x(value(source), value(source), value(source));
                        x *= (is_on ? radius : radius * (1.8 + 0.7 * value(source))) / x.norm();
                        return x;
                      });
    }
}

// The length and its first derivatives are continuous where the line lifts off.
TEST(pathways, lift_off_smoothly) {
  wrapped b(mechanics::pathway_form::around_cylinder, wrapping::counterclockwise, false, false);
  auto model = kanexpr::derive(b);
  auto length = model.function(b.result), force = model.function(model.get(quantity::load_compensation));
  VectorXd x = VectorXd::Zero(12);
  const double distance = 0.8, touch = std::acos(radius / distance);
  const auto at = [&](double angle) {
    x.head<3>() << distance, 0, 0.1;
    x.segment<3>(3) << distance * std::cos(angle), distance * std::sin(angle), -0.4;
  };
  at(2 * touch - 1e-9);
  const double before = length(x)(0);
  EXPECT_NEAR(before, (x.head<3>() - x.segment<3>(3)).norm(), 1e-15);
  const VectorXd force_before = force(x);
  at(2 * touch + 1e-9);
  EXPECT_GT(length(x)(0), (x.head<3>() - x.segment<3>(3)).norm() - 1e-15);
  EXPECT_NEAR(length(x)(0), before, 3e-9);
  EXPECT_LT((VectorXd(force(x)) - force_before).norm(), 1e-8);
}

// The mistake in an arm, as a sentence.
std::string mistake_of(void (*is_made)(arm&)) {
  arm b;
  is_made(b);
  return std::string((b.check)().view());
}

TEST(pathways, report_mistakes) {
  EXPECT_EQ(mistake_of([](arm& b) { b.force_along(b.through({b.hand}), b.number(1)); }),
            "a pathway passes through fewer than two points");
  EXPECT_EQ(mistake_of([](arm& b) { b.force_along(pathway(), b.number(1)); }),
            "a force along a pathway acts along a pathway that has no points");
  EXPECT_EQ(mistake_of([](arm& b) {
              b.force_along(
                  b.around_cylinder(b.a, b.mast, {}, b.number(0.2), b.hand, b.wall, wrapping::clockwise),
                  b.number(1));
            }),
            "a pathway is wrapped around an axis of zero length");
  EXPECT_EQ(mistake_of([](arm& b) {
              b.force_along(b.around_cone(b.a, b.mast, b.along(b.b, 1, 0, 0), b.number(0.2), b.hand, b.wall,
                                          wrapping::clockwise),
                            b.number(1));
            }),
            "a pathway is wrapped around an axis that is not fixed in A");
  EXPECT_EQ(mistake_of([](arm& b) {
              const point_id apart = b.origin("Apart");
              b.linear_damper(b.around_sphere(b.mast, b.number(0.2), b.hand, apart), b.number(1));
            }),
            "the position of Apart from M is not known: they are measured from two origins, Apart and O");
  EXPECT_EQ(mistake_of([](arm& b) { b.linear_spring(b.through({b.hand, b.wall, b.wall}), b.number(1)); }),
            "a linear spring acts between point W and itself");
  EXPECT_EQ(mistake_of([](arm& b) {
              b.stop(b.straight(b.hand, b.wall), b.number(2), b.number(1), b.number(10), b.number(0.1));
            }),
            "the greatest length of the stop between H and W does not exceed the least length");
}

// A rope of beads slides over a drum on an arc of 2 rad. The tension of the springs between the beads presses
// them against the drum, and friction acts by this normal force.
struct rope : builder {
  static constexpr double radius = 0.5, arc = 2, mu = 0.3, stiffness = 1e4, slack = 10;
  std::vector<expression> angles;
  VectorXd state;      // in which the beads slide at the same speed and without acceleration
  double pull = slack; // the tension at the end that moves forward; the other one is `slack`

  explicit rope(int beads) : builder("N"), state(2 * beads) {
    const frame_id n = inertial_frame();
    const point_id o = origin("O");
    for (int i = 0; i < beads; ++i) {
      const std::string k = std::to_string(i);
      angles.push_back(coordinate("a" + k));
      const expression w = speed("w" + k), &a = angles.back();
      kinematic_equation(dot(a) - w);
      beads_.push_back(offset("P" + k, o, along(n, radius * cos(a), radius * sin(a), 0)));
      particle("Bead" + k, beads_.back(), number(0.1));
    }
    // the rope leaves the drum along its tangents
    force_along(given_length(-radius * angles.front()), number(-slack));
    place_beads();
    for (int i = 0; i < beads; ++i) add_friction(i);
    force_along(given_length(-radius * angles.back()), number(pull));
  }

private:
  // Each spring balances the bead before it: T cos δ − μ T sin δ = T' cos δ' + μ T' sin δ', where a spring
  // with the tension T spans the angle 2 δ.
  void place_beads() {
    const int beads = static_cast<int>(angles.size());
    const double rest = 2 * radius * std::sin(arc / (2 * (beads - 1)));
    double place = 0, half = 0;
    for (int i = 0; i < beads; ++i) {
      state(i) = place, state(beads + i) = 2;
      const double behind = pull * (std::cos(half) + mu * std::sin(half));
      if (i + 1 == beads) {
        pull = behind;
        break;
      }
      for (int step = 0; step < 60; ++step) {
        half = std::asin(rest * (1 + pull / stiffness) / (2 * radius));
        pull = behind / (std::cos(half) - mu * std::sin(half));
      }
      springs_.push_back(through_beads(i, rest));
      place += 2 * half;
    }
    total_angle = place;
  }
  expression through_beads(int i, double rest) {
    const pathway line = straight(point_of(i), point_of(i + 1));
    const expression tension = stiffness * (length_of(line) / rest - 1);
    linear_spring(line, number(stiffness / rest), number(rest));
    return tension *
           sin(0.5 * (angles[static_cast<std::size_t>(i) + 1] - angles[static_cast<std::size_t>(i)]));
  }
  void add_friction(int i) {
    const std::size_t k = static_cast<std::size_t>(i);
    expression pressing = number(0.0);
    if (k > 0) pressing = pressing + springs_[k - 1];
    if (k < springs_.size()) pressing = pressing + springs_[k];
    friction_along(given_length(radius * angles[k]), pressing,
                   mechanics::friction_law::coulomb(number(mu), number(1e-9)));
  }
  point_id point_of(int i) const { return beads_[static_cast<std::size_t>(i)]; }

  std::vector<point_id> beads_;
  std::vector<expression> springs_; // the normal forces that a spring adds to both of its ends

public:
  double total_angle = 0;
};

// The ratio of the tensions tends to Euler and Eytelwein's exp(μ φ).
TEST(pathways, hold_a_rope_on_a_drum_as_a_capstan_does) {
  const auto error_with = [](int beads) {
    rope b(beads);
    auto model = kanexpr::derive(b);
    EXPECT_EQ(model.mistake(), "");
    const MatrixXd udot = model.function(model.udot())(b.state, nothing, nothing);
    EXPECT_LT(udot.cwiseAbs().maxCoeff(), 1e-8 * rope::slack / (0.1 * rope::radius)) << beads << " beads";
    return std::log(b.pull / rope::slack) / (rope::mu * b.total_angle) - 1;
  };
  const double coarse = error_with(8), fine = error_with(15), finest = error_with(29);
  EXPECT_NEAR(coarse / fine, 4, 0.1); // 7, 14 and 28 intervals
  EXPECT_NEAR(fine / finest, 4, 0.05);
  EXPECT_LT(std::abs(finest), 1e-3);
}

TEST(pathways, of_another_builder) {
  builder b("N");
  {
    arm other;
    for (const auto& [name, path] : other.pathways()) {
      builder small("N");
      small.force_along(path, small.number(1));
      EXPECT_NE(std::string(small.mistake().view()), "") << name;
    }
    b.length_of(other.given_length(other.q[0]));
  }
  EXPECT_EQ(
      std::string(b.mistake().view()),
      "the length of a pathway contains an expression that belongs to a different mechanism or to none");
}

} // namespace
