// builds: clang++ all
// The length of a pathway and the forces of loads as expressions: results, parts of other loads and of
// constraints.
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace box_on_a_belt {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"z", meter> z;
constexpr coordinate<"a", radian> a;
constexpr speed<"vx"> vx;
constexpr speed<"vz"> vz;
constexpr speed<"wa"> wa;
constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr parameter<"mu"> mu;
constexpr auto b = constant<0.02, meter * second / radian>;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct B : rotated<B, N, a, N::y> {};
struct C : offset<C, O, x * N::x + z * N::z> {};
struct Box : rigid_body<Box, C, B, 2.0, inertia<B, 0.1, 0.2, 0.3>> {};
struct Wall : offset<Wall, O, 2.0 * N::x + 1.0 * N::z> {};

using Rope = straight<C, Wall>;
using Spring = linear_spring<Rope, k, 0.4>;
using Damper = linear_damper<Rope, c>;
using End = stop<Rope, 0.5, 1.5, 80, 0.3>;
using Twist = cubic_spring<given_length<a>, 3, 2>;
using Floor = contact<sphere_on_plane<C, 0.2, O, N::z, B>, elastic<500, 1.5>, smoothed_over<0.01>,
                      dissipation<0.2>, coulomb_friction<mu, 0.1>>;
using Direct = spring<C, O, 5, 0.1>;

struct System
    : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>, bodies<Box>,
                  loads<gravity<-9.81 * N::z>, Spring, Damper, End, Twist, Floor, Direct>> {};

/// The length of the rope in a potential energy, and the normal force of the floor as that of a brake.
struct braked
    : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>, bodies<Box>,
                  loads<potential_energy<k*(length_of<Rope> - 0.4) * (length_of<Rope> - 0.4) / 2>, Floor,
                        torque<B, -(b* normal_force_of<Floor>)*wa * N::y>,
                        force<C, -0.1 * tension_of<Damper> * N::x>, Damper>> {};

/// A point of the box in air.
struct in_air : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>,
                            bodies<Box>, loads<drag<C, c>, damper<C, Wall, 0.7>>> {};

/// The box on a rope that does not stretch.
struct tethered : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>,
                              bodies<Box>, configuration_constraints<length_of<Rope> == 1.0>> {};
struct tethered_by_hand
    : kane_system<inertial<N>, coordinates<x, z, a>, speeds<vx, vz, wa>, kinematics<simple>, bodies<Box>,
                  configuration_constraints<magnitude(position_of<Wall, C>) == 1.0>> {};

} // namespace box_on_a_belt

namespace {

using namespace box_on_a_belt;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd some_state(std::mt19937_64& source) {
  std::uniform_real_distribution<double> unit(0, 1);
  VectorXd all(6);
  all << 0.8 + unit(source), 0.1 + 0.15 * unit(source), unit(source), unit(source) - 0.5, unit(source) - 0.5,
      unit(source);
  return all;
}
const Vector3d given(30, 4, 0.3); // k, c, mu

TEST(load_quantities, follow_their_laws) {
  model m = derive<System>();
  ASSERT_EQ(m.mistake(), "");
  auto length = m.function(m.get<length_of<Rope>>()),
       spring_tension = m.function(m.get<tension_of<Spring>>()),
       damping = m.function(m.get<tension_of<Damper>>()), stopping = m.function(m.get<tension_of<End>>()),
       twist = m.function(m.get<tension_of<Twist>>()), direct = m.function(m.get<tension_of<Direct>>()),
       normal = m.function(m.get<normal_force_of<Floor>>()),
       rubbing = m.function(m.get<friction_force_of<Floor>>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source);
    const Eigen::Vector2d d(2 - s[0], 1 - s[1]), v(s[3], s[4]);
    const double l = d.norm(), rate = -d.dot(v) / l;
    EXPECT_NEAR(length(s, given)(0), l, 1e-14);
    EXPECT_NEAR(spring_tension(s, given)(0), 30 * (l - 0.4), 1e-12);
    EXPECT_NEAR(damping(s, given)(0), 4 * rate, 1e-12);
    const double beyond = l - 1.5;
    if (beyond > 1e-3) {
      EXPECT_NEAR(stopping(s, given)(0), 80 * (beyond - 0.0005) * (1 + 0.3 * rate), 1e-11);
    }
    if (beyond < 0 && l > 0.5) {
      EXPECT_EQ(stopping(s, given)(0), 0);
    }
    EXPECT_NEAR(twist(s, given)(0), 3 * s[2] + 2 * std::pow(s[2], 3), 1e-12);
    EXPECT_NEAR(direct(s, given)(0), 5 * (s.head(2).norm() - 0.1), 1e-12);
    const double deep = 0.2 - s[1];
    const double pressed = 500 * std::pow(deep, 1.5) * (1 - 0.2 * s[4]);
    if (deep > 0.01) {
      EXPECT_NEAR(normal(s, given)(0), pressed, 1e-11);
      const double slip = s[3] - 0.2 * s[5];
      const VectorXd f = rubbing(s, given);
      EXPECT_NEAR(f[0], -0.3 * pressed * slip / std::hypot(slip, 0.1), 1e-11);
      EXPECT_EQ(f[1], 0);
      EXPECT_EQ(f[2], 0);
    }
    if (deep < -0.01) {
      EXPECT_EQ(normal(s, given)(0), 0);
    }
  }
}

// The forces of all loads on the box are its mass times its acceleration.
TEST(load_quantities, add_up_to_the_acceleration) {
  model m = derive<System>();
  auto whole = m.function(
      m.get<(tension_of<Spring> + tension_of<Damper> + tension_of<End>)*normalized(position_of<Wall, C>) -
            tension_of<Direct> * normalized(position_of<C, O>) + normal_force_of<Floor> * N::z +
            friction_force_of<Floor> - 2.0 * acceleration_of<C> - 2.0 * 9.81 * N::z>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source), rest = whole(s, given);
    EXPECT_LT(rest.norm(), 1e-11);
  }
}

TEST(load_quantities, compiled) {
  using kanexpr::function;
  model m = derive<System>();
  auto normal = m.function(m.get<normal_force_of<Floor>>()),
       damping = m.function(m.get<tension_of<Damper>>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 5; ++i) {
    const VectorXd s = some_state(source);
    const kanexpr::state<System> at{{x, s[0]}, {z, s[1]}, {a, s[2]}, {vx, s[3]}, {vz, s[4]}, {wa, s[5]}};
    const kanexpr::parameter_values<System> p{{k, 30}, {c, 4}, {mu, 0.3}};
    const auto [pressed, pulled] = function<System, normal_force_of<Floor>, tension_of<Damper>>{}(at, p);
    EXPECT_EQ(pressed, normal(s, given)(0));
    EXPECT_EQ(pulled, damping(s, given)(0));
  }
}

TEST(load_quantities, in_other_loads_and_constraints) {
  model m = derive<braked>();
  ASSERT_EQ(m.mistake(), "");
  auto torque = m.function(m.get(mechanics::quantity::active_forces));
  auto normal = m.function(m.get<normal_force_of<Floor>>()),
       damping = m.function(m.get<tension_of<Damper>>());
  auto rubbing = m.function(m.get<friction_force_of<Floor>>());
  std::mt19937_64 source(4);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source), f = torque(s, given), friction = rubbing(s, given);
    const Eigen::Vector2d d(2 - s[0], 1 - s[1]);
    EXPECT_NEAR(f[2], -0.02 * s[5] * normal(s, given)(0) - 0.2 * friction[0], 1e-12);
    const double pull = 30 * (d.norm() - 0.4) + damping(s, given)(0);
    EXPECT_NEAR(f[0], pull * d[0] / d.norm() + friction[0] - 0.1 * damping(s, given)(0), 1e-12);
  }
  model bound = derive<tethered>(), by_hand = derive<tethered_by_hand>();
  ASSERT_EQ(bound.mistake(), "");
  auto first = bound.function(bound.rhs()), second = by_hand.function(by_hand.rhs());
  const VectorXd s = some_state(source);
  EXPECT_LT((first(s) - second(s)).norm(), 1e-13 * second(s).norm());
}

TEST(load_quantities, have_units) {
  model m = derive<System>();
  const auto unit = [](const mechanics::possible_unit& u) {
    return u ? std::string(text_of(*u).view()) : "unknown";
  };
  EXPECT_EQ(unit(m.unit_of<length_of<Rope>>()), "m");
  EXPECT_EQ(unit(m.unit_of<tension_of<Spring>>()), "N");
  EXPECT_EQ(unit(m.unit_of<normal_force_of<Floor>>()), "N");
  EXPECT_EQ(unit(m.unit_of<friction_force_of<Floor>>()), "N");
  EXPECT_EQ(unit(m.units().of("k")), "N/m");
  EXPECT_EQ(unit(derive<braked>().units().of("k")), "N/m");
}

// The same forces from a builder.
TEST(load_quantities, of_a_builder) {
  const auto with_force = [](int contact, std::string& mistake) {
    runtime::builder b("N");
    const auto q = b.coordinate("z"), u = b.speed("vz");
    b.kinematic_equation(b.dot(q) - u);
    const auto floor = b.origin("O"), center = b.offset("C", floor, b.along(b.inertial_frame(), 0, 0, q));
    b.particle("Ball", center, b.number(1));
    runtime::contact_data data{.stiffness = 500, .exponent = 1.5, .width = 0.01};
    data.damping = 0.2;
    b.point_on_plane(center, floor, b.along(b.inertial_frame(), 0, 0, 1), data);
    mechanics::known_motion known(b.mechanism());
    symbolic::matrix force(b.graph(), 1, 1);
    force.entries[0] = b.normal_force_of(contact, known);
    mistake = b.mistake().view();
    return derive(b).function(force)(Eigen::Vector2d(-0.1, 0.3))(0);
  };
  std::string mistake;
  EXPECT_NEAR(with_force(1, mistake), 500 * std::pow(0.1, 1.5) * (1 - 0.2 * 0.3), 1e-12);
  EXPECT_EQ(mistake, "");
  with_force(2, mistake);
  EXPECT_EQ(mistake, "the force of contact 2 is requested, but the number of contacts is 1");
}

/// The box from a builder.
struct box : runtime::builder {
  using scalar = symbolic::expression;
  scalar x = coordinate("x"), z = coordinate("z"), a = coordinate("a"), k = parameter("k"),
         c = parameter("c"), mu = parameter("mu");
  runtime::frame_id n = inertial_frame(), frame{};
  runtime::point_id o{}, center{}, wall{};

  box() : builder("N") {
    kinematic_equation(dot(x) - speed("vx"));
    kinematic_equation(dot(z) - speed("vz"));
    kinematic_equation(dot(a) - speed("wa"));
    frame = rotated("B", n, a, along(n, 0, 1, 0));
    o = origin("O");
    center = offset("C", o, along(n, x, 0, z));
    wall = offset("Wall", o, along(n, 2, 0, 1));
    rigid_body("Box", center, frame, number(2), inertia(frame, 0.1, 0.2, 0.3));
    for (const scalar& p : {k, c, mu}) used_elsewhere(p);
  }
};

/// Compares expressions of a builder with those of types at random states; the difference is relative.
template <auto... of_types>
void expect_same(box& b, const std::vector<symbolic::expression>& of_builder) {
  model types = derive<System>();
  symbolic::matrix all(b.graph(), static_cast<int>(of_builder.size()), 1);
  for (std::size_t i = 0; i < of_builder.size(); ++i) all.entries[static_cast<int>(i)] = of_builder[i];
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  ASSERT_EQ(types.mistake(), "");
  auto built = m.function(all);
  std::vector described{types.function(types.get<of_types>())...};
  ASSERT_EQ(of_builder.size(), described.size());
  std::mt19937_64 source(9);
  for (int i = 0; i < 20; ++i) {
    const VectorXd s = some_state(source), found = built(s, given);
    for (std::size_t j = 0; j < described.size(); ++j) {
      const double expected = described[j](s, given)(0);
      EXPECT_LE(std::abs(found[static_cast<Eigen::Index>(j)] - expected), 1e-15 * std::abs(expected)) << j;
    }
  }
}

TEST(load_quantities, of_a_builder_are_those_of_types) {
  box b;
  const auto rope = b.straight(b.center, b.wall);
  const auto spring = b.linear_spring(rope, b.k, b.number(0.4)), damper = b.linear_damper(rope, b.c),
             end = b.stop(rope, b.number(0.5), b.number(1.5), b.number(80), b.number(0.3)),
             twist = b.cubic_spring(b.given_length(b.a), b.number(3), b.number(2)),
             direct = b.spring(b.center, b.o, b.number(5), b.number(0.1));
  mechanics::known_motion known(b.mechanism());
  std::vector<symbolic::expression> found;
  for (const runtime::pulling_load& each : {spring, damper, end, twist, direct})
    found.push_back(b.tension_of(each, known));
  expect_same<tension_of<Spring>, tension_of<Damper>, tension_of<End>, tension_of<Twist>, tension_of<Direct>>(
      b, found);
}

TEST(load_quantities, of_a_muscle_in_a_builder_is_its_force) {
  box b;
  const auto muscle =
      b.muscle("Rope", b.straight(b.center, b.wall), b.number(0.6),
               {.peak_isometric_force = 50, .optimal_fiber_length = 0.9, .tendon_slack_length = 0.4});
  mechanics::known_motion known(b.mechanism());
  symbolic::matrix tension(b.graph(), 1, 1);
  tension.entries[0] = b.tension_of(muscle.load, known);
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto force = m.function(m.get(mechanics::quantity::active_forces)), pull = m.function(tension);
  std::mt19937_64 source(4);
  for (int i = 0; i < 10; ++i) {
    VectorXd s(7);
    s << some_state(source), 0.3;
    const Eigen::Vector2d d(2 - s[0], 1 - s[1]);
    EXPECT_NEAR(force(s, given)(0), pull(s, given)(0) * d[0] / d.norm(), 1e-12 * std::abs(pull(s, given)(0)));
  }
}

TEST(load_quantities, air_resists_in_a_builder_as_in_types) {
  box b;
  b.damper(b.center, b.wall, b.number(0.7));
  mechanics::known_motion known(b.mechanism());
  b.drag(b.center, b.c, known);
  model m = derive(b), types = derive<in_air>();
  ASSERT_EQ(m.mistake(), "");
  auto built = m.function(m.rhs()), described = types.function(types.rhs());
  std::mt19937_64 source(9);
  const Eigen::Vector3d all(30, 4, 0.3);
  for (int i = 0; i < 10; ++i) {
    const VectorXd s = some_state(source);
    const VectorXd first = built(s, all), second = described(s, VectorXd::Constant(1, 4));
    EXPECT_LE((first - second).norm(), 1e-15 * second.norm());
    const Eigen::Vector2d v(s[3], s[4]), d = Eigen::Vector2d(2 - s[0], 1 - s[1]).normalized();
    const Eigen::Vector2d expected = (-4 * v.norm() * v - 0.7 * v.dot(d) * d) / 2;
    EXPECT_LT((first.segment<2>(3) - expected).norm(), 1e-13 * expected.norm());
  }
}

TEST(load_quantities, a_damper_of_a_builder_returns_its_load) {
  box b;
  const runtime::pulling_load damper = b.damper(b.center, b.wall, b.number(0.7));
  EXPECT_FALSE(std::holds_alternative<std::monostate>(damper));
}

TEST(vectors, of_a_builder_are_those_of_types) {
  box b;
  mechanics::known_motion known(b.mechanism());
  const auto v = b.velocity_of(b.center, known), w = b.angular_velocity_of(b.frame, known),
             line = b.position_of(b.wall, b.center), x = b.along(b.n, 1, 0, 0),
             side = b.along(b.frame, 1, 0, 0);
  const auto dyad = b.outer(line, side);
  const std::vector<symbolic::expression> found{b.dot(b.cross(w, line), x),
                                                b.magnitude(line),
                                                b.dot(b.normalized(line), side),
                                                b.dot(b.dot(dyad, v), x),
                                                b.dot(b.derivative_in(line, b.frame, known), x),
                                                b.derivative(b.dot(line, side), known),
                                                b.dot(b.in_axes_of(b.frame, v), x)};
  expect_same<dot(cross(angular_velocity_of<B>, position_of<Wall, C>), N::x), magnitude(position_of<Wall, C>),
              dot(normalized(position_of<Wall, C>), B::x),
              dot(dot(outer(position_of<Wall, C>, B::x), velocity_of<C>), N::x),
              dot(derivative_in<B>(position_of<Wall, C>), N::x), derivative(dot(position_of<Wall, C>, B::x)),
              dot(in_axes_of<B>(velocity_of<C>), N::x)>(b, found);
  const auto rates = [&](const auto& e) { return b.dot(e, side); };
  const symbolic::expression linear = rates(b.acceleration_of(b.center, known)),
                             angular =
                                 b.dot(b.angular_acceleration_of(b.frame, known), b.along(b.n, 0, 1, 0));
  EXPECT_EQ(linear, cos(b.a) * b.dot(b.mechanism().speeds[0]) - sin(b.a) * b.dot(b.mechanism().speeds[1]));
  EXPECT_EQ(angular, b.dot(b.mechanism().speeds[2]));
}

namespace aligned {
constexpr coordinate<"a1"> a1;
constexpr coordinate<"a2"> a2;
constexpr coordinate<"a3"> a3;
constexpr coordinate<"s"> s;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"u3"> u3;
constexpr speed<"v"> v;
struct T : body_fixed<T, N, "xyz", a1, a2, a3> {};
struct Tip : offset<Tip, O, s * N::x + 0.3 * T::y> {};
struct Post : offset<Post, O, 1.0 * N::x + 2.0 * N::y> {};
struct Top : rigid_body<Top, Tip, T, 2.0, inertia<T, 0.1, 0.2, 0.3>> {};

template <auto... constraints>
struct System : kane_system<inertial<N>, coordinates<a1, a2, a3, s>, speeds<u1, u2, u3, v>,
                            kinematics<simple>, bodies<Top>, configuration_constraints<constraints...>> {};

struct built : runtime::builder {
  runtime::frame_id n = inertial_frame(), t{};
  runtime::point_id o = origin("O"), tip{}, post{};
  built() : builder("N") {
    const auto first = coordinate("a1"), second = coordinate("a2"), third = coordinate("a3"),
               shift = coordinate("s");
    int number_of_speed = 0;
    for (const auto& q : {first, second, third, shift})
      kinematic_equation(dot(q) - speed("u" + std::to_string(++number_of_speed)));
    t = body_fixed("T", n, "xyz", first, second, third);
    const auto along_track = along(n, shift, 0, 0);
    auto to_tip = along(t, 0, 0.3, 0);
    to_tip.add(along_track);
    tip = offset("Tip", o, to_tip);
    post = offset("Post", o, along(n, 1, 2, 0));
    rigid_body("Top", tip, t, number(2), inertia(t, 0.1, 0.2, 0.3));
  }
};
} // namespace aligned

template <auto... constraints, class Constrain>
void expect_same_residual(const Constrain& constrain) {
  aligned::built b;
  constrain(b);
  model built = derive(b), described = derive<aligned::System<constraints...>>();
  ASSERT_EQ(built.mistake(), "");
  ASSERT_EQ(described.mistake(), "");
  auto first = built.function(built.configuration_residual()),
       second = described.function(described.configuration_residual());
  std::mt19937_64 source(3);
  std::uniform_real_distribution<double> values(-1, 1);
  for (int i = 0; i < 10; ++i) {
    const VectorXd state = VectorXd::NullaryExpr(8, [&] { return values(source); });
    const VectorXd found = first(state), expected = second(state);
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_LE((found - expected).norm(), 1e-15 * expected.norm());
  }
}

TEST(constraints, of_a_builder_are_those_of_types) {
  using namespace aligned;
  using aligned::built;
  expect_same_residual<rod_of_length<Tip, Post, 1.2>>(
      [](built& b) { b.configuration_constraint(b.rod_of_length(b.tip, b.post, b.number(1.2))); });
  expect_same_residual<coincident<Tip, Post, N::y, T::z>>([](built& b) {
    b.configuration_constraint(b.coincident(b.tip, b.post, b.along(b.n, 0, 1, 0), b.along(b.t, 0, 0, 1)));
  });
  expect_same_residual<parallel<T::z, N::z>>(
      [](built& b) { b.configuration_constraint(b.parallel(b.along(b.t, 0, 0, 1), b.n, 2)); });
  expect_same_residual<same_axes<T, N>>([](built& b) { b.configuration_constraint(b.same_axes(b.t, b.n)); });
}

TEST(load_quantities, mistakes_in_a_builder) {
  const auto mistake = [](const auto& make) {
    box b, other;
    mechanics::known_motion known(b.mechanism()), elsewhere(other.mechanism());
    make(b, known, elsewhere);
    return std::string(b.mistake().view());
  };
  using motion = mechanics::known_motion;
  EXPECT_EQ(mistake([](box& b, motion& known, motion&) { b.tension_of({}, known); }),
            "the tension is requested of a load that was not added to the builder");
  EXPECT_EQ(mistake([](box& b, motion&, motion& other) { b.tension_of(b.spring(b.o, b.wall, b.k), other); }),
            "the tension of a load is requested for the motion of a different builder");
  EXPECT_EQ(mistake([](box& b, motion& known, motion&) {
              box other;
              b.tension_of(other.spring(other.o, other.wall, other.k), known);
            }),
            "the load of a tension contains an expression that belongs to a different mechanism or to none");
  EXPECT_EQ(mistake([](box& b, motion& known, motion&) {
              box other;
              b.tension_of(other.force_along(other.straight(other.o, other.wall), other.k), known);
            }),
            "the load of a tension contains an expression that belongs to a different mechanism or to none");
  EXPECT_EQ(mistake([](box& b, motion&, motion& other) { b.velocity_of(b.o, other); }),
            "a velocity is requested for the motion of a different builder");
  EXPECT_EQ(mistake([](box& b, motion&, motion& other) { b.drag(b.center, 0.5, other); }),
            "a drag is requested for the motion of a different builder");
  EXPECT_EQ(
      mistake([](box& b, motion& known, motion&) { b.drag(b.center, 1 / 2, known); }),
      "the coefficient of a drag is 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 if you mean "
      "zero");
  EXPECT_EQ(mistake([](box& b, motion&, motion&) { b.normalized({}); }),
            "a vector of zero length is normalized");
  EXPECT_EQ(mistake([](box& b, motion&, motion&) { b.parallel(b.along(b.n, 1, 0, 0), b.frame, 3); }),
            "expected an axis of parallel from 0 to 2, got 3");
}

} // namespace
