// builds: clang++ all
// The contact of wheels with the ground, compared with a numeric search for the lowest point and with finite
// differences of positions.
#include <kanexpr/mechanics/loads/wheel_contact.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace {

namespace mechanics = kanexpr::mechanics;
namespace symbolic = kanexpr::symbolic;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::derive;
using kanexpr::model;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::runtime::tyre_data;
using kanexpr::runtime::wheel_on_ground;
using symbolic::expression;

/// A wheel that moves freely above a ground that moves itself. The axis of the wheel is given in the frame
/// that does not spin.
struct free_wheel : builder {
  expression x = coordinate("x"), y = coordinate("y"), z = coordinate("z"), yaw = coordinate("yaw"),
             lean = coordinate("lean"), spin = coordinate("spin"), tilt = coordinate("tilt"),
             shift = coordinate("shift");
  frame_id n = inertial_frame(), yawed{}, leaning{}, rolling{}, tilted{};
  point_id o{}, hub{}, ground{};

  free_wheel() : builder("N") {
    const std::array<expression, 8> all{x, y, z, yaw, lean, spin, tilt, shift};
    for (std::size_t i = 0; i < 8; ++i) kinematic_equation(dot(all[i]) - speed("u" + std::to_string(i)));
    yawed = rotated("Y", n, yaw, along(n, 0, 0, 1));
    leaning = rotated("L", yawed, lean, along(yawed, 1, 0, 0));
    rolling = rotated("B", leaning, spin, along(leaning, 0, 1, 0));
    tilted = rotated("G", n, tilt, along(n, 1, 0, 0));
    o = origin("O");
    hub = offset("Hub", o, along(n, x, y, z));
    ground = offset("Ground", o, along(n, 0, shift, 0));
    rigid_body("Wheel", hub, rolling, number(1), inertia(rolling, 0.1, 0.2, 0.1));
    rigid_body("Board", ground, tilted, number(1), inertia(tilted, 1, 1, 1));
  }

  kanexpr::runtime::wheel_data wheel(double radius, double tube = 0) {
    return {hub, rolling, along(leaning, 0, 1, 0), radius, tube};
  }
};

/// The numbers of a contact at a state.
struct contact_numbers {
  double penetration, camber_sine, loaded_radius;
  Vector3d normal, forward, lateral, arm, lowest;
  double approach, forward_slip, lateral_slip, spin, turn, forward_speed;
};

class contact_function {
public:
  template <class Ground>
  explicit contact_function(const Ground& lay) {
    free_wheel b;
    const wheel_on_ground w = lay(b);
    const mechanics::wheel_contact at = w.contact(b.mechanism());
    mechanics::known_motion known(b.mechanism());
    const mechanics::wheel_motion moves = w.motion_at(known.moving(), at);
    symbolic::matrix all(b.graph(), 0, 1);
    const auto add = [&](expression e) { all.entries.push(e), ++all.rows; };
    for (const expression e : {at.penetration, at.camber_sine, at.loaded_radius}) add(e);
    for (const auto& v : {at.normal, at.forward, at.lateral, at.arm, at.lowest})
      for (int i = 0; i < 3; ++i) add(v[i]);
    for (const expression e : {moves.approach, moves.forward_slip, moves.lateral_slip, moves.spin, moves.turn,
                               moves.forward_speed})
      add(e);
    model m = derive(b);
    EXPECT_EQ(m.mistake(), "");
    values_ = [function = m.function(all)](const VectorXd& state) mutable -> VectorXd {
      return function(state);
    };
  }

  contact_numbers operator()(const VectorXd& state) {
    const VectorXd v = values_(state);
    contact_numbers n{v(0),
                      v(1),
                      v(2),
                      v.segment<3>(3),
                      v.segment<3>(6),
                      v.segment<3>(9),
                      v.segment<3>(12),
                      v.segment<3>(15),
                      v(18),
                      v(19),
                      v(20),
                      v(21),
                      v(22),
                      v(23)};
    return n;
  }

private:
  std::function<VectorXd(const VectorXd&)> values_{};
};

Matrix3d about(const Vector3d& axis, double angle) { return Eigen::AngleAxisd(angle, axis).matrix(); }

Matrix3d attitude(const VectorXd& q, bool with_spin = true) {
  const Matrix3d leaning = about(Vector3d::UnitZ(), q(3)) * about(Vector3d::UnitX(), q(4));
  return with_spin ? leaning * about(Vector3d::UnitY(), q(5)) : leaning;
}
Matrix3d of_ground(const VectorXd& q) { return about(Vector3d::UnitX(), q(6)); }
/// The center of the wheel, in the axes of the ground.
Vector3d center(const VectorXd& q) { return of_ground(q).transpose() * Vector3d(q(0), q(1) - q(7), q(2)); }

VectorXd random_state(std::mt19937_64& source, double height) {
  std::uniform_real_distribution<double> values(-1, 1);
  VectorXd state = VectorXd::NullaryExpr(16, [&] { return values(source); });
  state(2) = height + 0.02 * state(2);
  state(3) *= 3, state(4) *= 0.8, state(6) *= 0.2, state(7) *= 0.1;
  return state;
}

/// The point of a torus at which a surface z = f(x, y) is closest below, from a search on a grid and
/// Newton's method on the slopes, with a Jacobian by differences. The angles are around the axis and around
/// the tube.
struct lowest_point {
  Vector3d center, ahead, down, axis;
  double circle, tube;
  std::function<Vector3d(double, double)> height; // f and its slopes

  Vector3d on_rim(double a, double b) const {
    const Vector3d radial = std::cos(a) * down + std::sin(a) * ahead;
    return center + (circle + tube * std::cos(b)) * radial + tube * std::sin(b) * axis;
  }
  double gap(double a, double b) const {
    const Vector3d p = on_rim(a, b);
    return p.z() - height(p.x(), p.y())(0);
  }
  Eigen::Vector2d slopes(double a, double b) const {
    const Vector3d p = on_rim(a, b), f = height(p.x(), p.y()), up(-f(1), -f(2), 1);
    const Vector3d radial = std::cos(a) * down + std::sin(a) * ahead;
    const Vector3d around = std::cos(a) * ahead - std::sin(a) * down;
    return {up.dot(around), tube == 0 ? b : up.dot(std::cos(b) * axis - std::sin(b) * radial)};
  }
  Vector3d find() const {
    Eigen::Vector2d best(0, 0);
    const int rows = tube == 0 ? 0 : 10;
    for (int i = -30; i <= 30; ++i)
      for (int j = -rows; j <= rows; ++j)
        if (const double a = 0.1 * i, b = 0.15 * j; gap(a, b) < gap(best(0), best(1))) best = {a, b};
    for (int i = 0; i < 12; ++i) {
      constexpr double h = 1e-6;
      Eigen::Matrix2d jacobian;
      jacobian.col(0) = (slopes(best(0) + h, best(1)) - slopes(best(0) - h, best(1))) / (2 * h);
      jacobian.col(1) = (slopes(best(0), best(1) + h) - slopes(best(0), best(1) - h)) / (2 * h);
      best -= jacobian.inverse() * slopes(best(0), best(1));
    }
    return on_rim(best(0), best(1));
  }
};

lowest_point search(const VectorXd& q, double circle, double tube,
                    std::function<Vector3d(double, double)> height) {
  const Matrix3d axes = of_ground(q).transpose() * attitude(q, false);
  return {center(q), axes.col(0), -axes.col(2), axes.col(1), circle, tube, std::move(height)};
}

TEST(wheels, on_a_plane_touch_at_their_lowest_point) {
  std::mt19937_64 source(3);
  for (const double tube : {0.0, 0.07}) {
    contact_function contact([&](free_wheel& b) {
      return b.wheel_on_plane(b.wheel(0.3, tube), b.ground, b.along(b.tilted, 0, 0, 2));
    });
    for (int i = 0; i < 50; ++i) {
      const VectorXd state = random_state(source, 0.3);
      const contact_numbers found = contact(state);
      const Vector3d lowest =
          search(state, 0.3, tube, [](double, double) { return Vector3d(0, 0, 0); }).find();
      EXPECT_LT((center(state) + found.lowest - lowest).norm(), 1e-10);
      EXPECT_NEAR(found.penetration, -lowest.z(), 1e-13);
      EXPECT_NEAR((center(state) + found.arm).z(), 0, 1e-14);
    }
  }
}

/// The bumps of the uneven ground and their slopes.
Vector3d bumps(double x, double y) {
  const double a = 1.3 * x, b = 0.7 * y + 0.3;
  return {0.1 * std::cos(a) * std::sin(b), -0.13 * std::sin(a) * std::sin(b),
          0.07 * std::cos(a) * std::cos(b)};
}

TEST(wheels, on_uneven_ground_touch_at_their_lowest_point) {
  for (const double tube : {0.0, 0.07})
    for (const int steps : {0, 1, 2, 3}) {
      std::mt19937_64 source(5);
      contact_function contact([&](free_wheel& b) {
        return b.wheel_on_surface(
            b.wheel(0.3, tube), b.ground, b.tilted,
            [](expression x, expression y) { return 0.1 * cos(1.3 * x) * sin(0.7 * y + 0.3); }, steps);
      });
      double place = 0, depth = 0;
      for (int i = 0; i < 40; ++i) {
        const VectorXd state = random_state(source, 0.35);
        const contact_numbers found = contact(state);
        const Vector3d lowest = search(state, 0.3, tube, bumps).find(), f = bumps(lowest.x(), lowest.y());
        const double gap = (lowest.z() - f(0)) / std::hypot(f(1), f(2), 1);
        place = std::max(place, (center(state) + found.lowest - lowest).norm());
        depth = std::max(depth, std::abs(found.penetration + gap));
      }
      constexpr std::array most_place{2e-2, 3e-5, 1e-9, 1e-12}, most_depth{1e-4, 1e-8, 1e-12, 1e-13};
      EXPECT_LT(place, most_place[static_cast<std::size_t>(steps)]) << tube;
      EXPECT_LT(depth, most_depth[static_cast<std::size_t>(steps)]) << tube;
    }
}

/// Checks the velocities at a state against central differences of positions.
void expect_velocities(contact_function& contact, const VectorXd& state, double of_depth, double of_place) {
  const contact_numbers found = contact(state);
  constexpr double h = 1e-5;
  const auto at = [&](double t) {
    VectorXd moved = state;
    moved.head(8) += t * state.tail(8);
    return moved;
  };
  const Vector3d in_wheel = attitude(state).transpose() * of_ground(state) * found.arm;
  const auto material = [&](double t) -> Vector3d {
    const VectorXd q = at(t);
    return center(q) + of_ground(q).transpose() * attitude(q) * in_wheel;
  };
  const auto rate = [&](const auto& f) { return ((f(h) - f(-h)) / (2 * h)).eval(); };
  const Vector3d velocity = rate(material);
  EXPECT_NEAR(found.forward_slip, velocity.dot(found.forward), 1e-8);
  EXPECT_NEAR(found.lateral_slip, velocity.dot(found.lateral), 1e-8);
  EXPECT_NEAR(found.approach, -velocity.dot(found.normal), 1e-8);
  const Vector3d place = rate([&](double t) -> Vector3d { return center(at(t)) + contact(at(t)).arm; });
  EXPECT_NEAR(found.forward_speed, place.dot(found.forward), of_place);
  const double sinking = (contact(at(h)).penetration - contact(at(-h)).penetration) / (2 * h);
  EXPECT_NEAR(found.approach, sinking, of_depth);
  EXPECT_NEAR(found.normal.cross(found.forward).dot(found.lateral), 1, 1e-13);
  EXPECT_LT((found.normal.cross(found.forward) - found.lateral).norm(), 1e-13);
}

TEST(wheels, have_the_velocities_of_finite_differences) {
  std::mt19937_64 source(11);
  for (const double tube : {0.0, 0.07}) {
    contact_function contact([&](free_wheel& b) {
      return b.wheel_on_plane(b.wheel(0.3, tube), b.ground, b.along(b.tilted, 0, 0, 1));
    });
    for (int i = 0; i < 30; ++i) expect_velocities(contact, random_state(source, 0.3), 1e-8, 1e-8);
  }
}

// On uneven ground, the spin and the approach neglect that the normal turns and that the contact is not
// closed.
TEST(wheels, on_uneven_ground_have_the_velocities_of_the_tangent_plane) {
  std::mt19937_64 source(13);
  for (const double tube : {0.0, 0.07}) {
    contact_function contact([&](free_wheel& b) {
      return b.wheel_on_surface(
          b.wheel(0.3, tube), b.ground, b.tilted,
          [](expression x, expression y) { return 0.1 * cos(1.3 * x) * sin(0.7 * y + 0.3); }, 3);
    });
    for (int i = 0; i < 30; ++i) {
      VectorXd state = random_state(source, 0.35);
      for (int k = 0; k < 3; ++k) { // close the contact
        const contact_numbers found = contact(state);
        state.head<3>() += of_ground(state) * (found.penetration * found.normal);
      }
      expect_velocities(contact, state, 1e-7, 0.05);
    }
  }
}

/// The least distance of a cone from the center line of a rail, by Newton's method on its square.
double distance_from_rail(const Vector3d& center, const Vector3d& axis, double radius, double conicity,
                          const Vector3d& line, const Vector3d& along) {
  const Vector3d ahead = axis.cross(Vector3d::UnitZ()).normalized(), down = axis.cross(ahead);
  const auto point = [&](const Eigen::Vector2d& at) -> Vector3d {
    return center + at(1) * axis +
           (radius + conicity * at(1)) * (std::cos(at(0)) * down + std::sin(at(0)) * ahead);
  };
  const auto slopes = [&](const Eigen::Vector2d& at) -> Eigen::Vector2d {
    const Vector3d radial = std::cos(at(0)) * down + std::sin(at(0)) * ahead;
    const Vector3d around = std::cos(at(0)) * ahead - std::sin(at(0)) * down;
    Vector3d from = point(at) - line;
    from -= from.dot(along) * along;
    return {from.dot(around), from.dot(axis + conicity * radial)};
  };
  Eigen::Vector2d best(0, (line - center).dot(axis));
  for (int i = 0; i < 15; ++i) {
    constexpr double h = 1e-6;
    Eigen::Matrix2d jacobian;
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(k);
      jacobian.col(k) = (slopes(best + step) - slopes(best - step)) / (2 * h);
    }
    best -= jacobian.inverse() * slopes(best);
  }
  const Vector3d from = point(best) - line;
  return (from - from.dot(along) * along).norm();
}

TEST(wheels, that_are_conical_touch_a_rail) {
  std::mt19937_64 source(17);
  const Vector3d along = Vector3d(1, 0.2, 0).normalized(), up(0, 0, 1);
  for (const double conicity : {-0.2, 0.05}) {
    contact_function contact([&](free_wheel& b) {
      kanexpr::runtime::wheel_data wheel = b.wheel(0.45);
      wheel.conicity = conicity;
      return b.wheel_on_rail(wheel,
                             {b.ground, b.along(b.tilted, 1, 0.2, 0), b.along(b.tilted, 0, 0, 1), 0.3});
    });
    for (int i = 0; i < 40; ++i) {
      VectorXd state = random_state(source, 0.45);
      state(3) *= 0.05, state(4) *= 0.1, state(1) *= 0.05, state(0) = 0;
      const contact_numbers found = contact(state);
      const Matrix3d axes = of_ground(state).transpose() * attitude(state, false);
      const double distance =
          distance_from_rail(center(state), axes.col(1), 0.45, conicity, -0.3 * up, along);
      EXPECT_NEAR(found.penetration, 0.3 - distance, 1e-13);
      const Vector3d from = center(state) + found.arm + 0.3 * up; // on the head
      EXPECT_NEAR((from - from.dot(along) * along).norm(), 0.3, 1e-13);
      expect_velocities(contact, state, 1e-8, 1);
    }
  }
}

// A wheel that spins fast in the air, where the load is zero.
TEST(wheels, in_the_air_have_finite_forces_in_single_precision) {
  free_wheel b;
  auto data = tyre_data::brush(0.9, 1e5);
  data.radial = tyre_data::radial_spring{2e5, 0.1, 1e-3}, data.standstill = 0.1;
  b.tyre(b.wheel_on_plane(b.wheel(0.3), b.o, b.along(b.n, 0, 0, 1)), data);
  model m = derive(b);
  auto rhs = m.function<float>(m.rhs());
  auto jacobian = m.function<float>(m.get(mechanics::quantity::state_jacobian));
  Eigen::VectorXf x = Eigen::VectorXf::Zero(16);
  x[2] = 1, x[13] = 300;
  EXPECT_TRUE(Eigen::VectorXf(rhs(x)).allFinite());
  EXPECT_TRUE(Eigen::MatrixXf(jacobian(x)).allFinite());
}

/// What a builder says about a tyre.
template <class Change>
std::string mistake_of_tyre(const Change& change) {
  free_wheel b;
  wheel_on_ground w = b.wheel_on_plane(b.wheel(0.3), b.o, b.along(b.n, 0, 0, 1));
  auto data = tyre_data::brush(0.9, 4e4);
  data.load = 3000.0, data.standstill = 0.1;
  change(b, w, data);
  b.tyre(w, data);
  return std::string(b.check().view());
}

TEST(wheels, in_a_builder_tell_mistakes) {
  EXPECT_EQ(mistake_of_tyre([](auto&, auto&, auto&) {}), "");
  EXPECT_EQ(mistake_of_tyre([](auto&, auto& w, auto&) {
              free_wheel far;
              w = far.wheel_on_plane(far.wheel(0.3), far.o, far.along(far.n, 0, 0, 1));
            }),
            "a tyre contains an expression that belongs to a different mechanism or to none");
  EXPECT_EQ(mistake_of_tyre([](auto&, auto& w, auto&) { w = {}; }),
            "a tyre is on a wheel that has no radius");
  EXPECT_EQ(mistake_of_tyre([](auto& b, auto&, auto&) { b.contact_point("K", wheel_on_ground{}); }),
            "K is on a wheel that has no radius");
  EXPECT_EQ(mistake_of_tyre([](auto& b, auto& w, auto&) {
              w = b.wheel_on_surface(b.wheel(0.3), b.o, b.n, [](auto x, auto) { return 0.1 * sin(x); }, 12);
            }),
            "expected 0 to 9 steps to the lowest point of a wheel, got 12");
  EXPECT_EQ(mistake_of_tyre([](auto&, auto&, auto& t) { t.slip_stiffness = {}; }),
            "a tyre has no slip stiffness");
  EXPECT_EQ(mistake_of_tyre([](auto&, auto&, auto& t) { t.friction = {}; }),
            "a tyre has no coefficient of friction");
  EXPECT_EQ(
      mistake_of_tyre([](auto&, auto&, auto& t) { t.trail = 1 / 20; }),
      "a value of a tyre is 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 if you mean zero");
  EXPECT_EQ(mistake_of_tyre([](auto&, auto&, auto& t) { t.load = -1.0; }),
            "the load of the tyre between Hub and O is negative");
  EXPECT_EQ(mistake_of_tyre([](auto& b, auto& w, auto&) {
              auto data = b.wheel(0.3);
              data.axis = b.along(b.n, 0, 1, 0);
              w = b.wheel_on_plane(data, b.o, b.along(b.n, 0, 0, 1));
            }),
            "the axis of the tyre between Hub and O turns in B, the frame of its body");
  EXPECT_EQ(mistake_of_tyre([](auto& b, auto& w, auto&) {
              auto data = b.wheel(0.3);
              data.axis = b.along(b.n, 0, 1, 0);
              w = b.wheel_on_plane(data, b.o, b.along(b.n, 0, 0, 1));
              b.contact_point("K", w);
            }),
            "the axis of the wheel between Hub and O turns in B, the frame of its body");
}

} // namespace
