// builds: clang++
// Models whose positions are written by components with sines and cosines: M, f and u̇ are as short as by
// hand, with Kane's and with Lagrange's method, at compile time and at run time.
#include <kanexpr/derivation/cost.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

using kanexpr::mechanics::method;
using kanexpr::mechanics::quantity;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::print;

struct variant {
  method by = method::kane;
  bool multiplied_out = false; ///< R sin(q) − r sin(q), not (R − r) sin(q)
};
const std::vector<variant> variants{
    {method::kane, false}, {method::kane, true}, {method::lagrange, false}, {method::lagrange, true}};

/// A builder whose speeds are the rates of its coordinates, for either method.
struct bench : kanexpr::runtime::builder {
  std::vector<expression> q, rate;
  kanexpr::runtime::frame_id n = inertial_frame();
  kanexpr::runtime::point_id o;

  explicit bench(const variant& v, std::initializer_list<const char*> coordinates) : builder("N") {
    for (const char* called : coordinates) q.push_back(coordinate(called));
    if (v.by == method::lagrange) rates_as_speeds();
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (v.by == method::kane) {
        rate.push_back(speed("u" + std::to_string(i + 1)));
        kinematic_equation(dot(q[i]) - rate[i]);
      } else {
        rate.push_back(dot(q[i]));
      }
    }
    o = origin("O");
  }
  Eigen::VectorXd udot(const Eigen::VectorXd& x, const Eigen::VectorXd& p) {
    EXPECT_FALSE(check()) << check().view();
    kanexpr::model m = kanexpr::derive(*this);
    auto f = m.function(m.udot());
    const Eigen::VectorXd rates = f(x, p);
    EXPECT_TRUE(f.status()) << f.status().cause();
    return rates;
  }
};

/// The number of operations of some expressions, without signs.
int operations(const kanexpr::symbolic::matrix& m) {
  const kanexpr::symbolic::cost c =
      kanexpr::symbolic::cost_of(m.entries[0].owner(), kanexpr::symbolic::nodes_of(m.entries));
  return c.multiplications + c.additions + c.divisions + c.trigonometric + c.other;
}

/// In a trough of radius R: a particle, or a rolling body of radius r with the moment of inertia J.
struct trough : bench {
  expression m = parameter("m"), g = parameter("g"), R = parameter("R"), r = parameter("r");

  explicit trough(const variant& v) : bench(v, {"q"}) {
    const expression s = sin(q[0]), c = cos(q[0]);
    const expression x = v.multiplied_out ? R * s - r * s : (R - r) * s;
    const expression y = v.multiplied_out ? -(R * c - r * c) : -((R - r) * c);
    centre = offset("C", o, along(n, x, y, 0));
    gravity(along(n, 0, -g, 0));
  }
  void roll(expression J) {
    const auto f = rotated("F", n, -((R - r) / r) * q[0], along(n, 0, 0, 1));
    rigid_body("Disc", centre, f, m, inertia(f, J, J, J));
  }
  kanexpr::runtime::point_id centre;
};

TEST(gathered, sliding_in_a_trough) {
  for (const variant& v : variants) {
    trough t(v);
    t.particle("Bead", t.centre, t.m);
    kanexpr::model model = kanexpr::derive(t);
    EXPECT_EQ(print(model.mass_matrix()), "[m*(R - r)^2]");
    EXPECT_EQ(print(model.forcing()), "[-g*m*sin(q)*(R - r)]");
    EXPECT_EQ(print(model.udot()), "[-g*sin(q)/(R - r)]");
    EXPECT_EQ(operations(model.udot()), 4);
  }
}

TEST(gathered, a_cylinder_that_rolls_in_a_trough) {
  for (const variant& v : variants) {
    trough t(v);
    t.roll(t.m * t.r * t.r / 2);
    kanexpr::model model = kanexpr::derive(t);
    EXPECT_EQ(print(model.mass_matrix()), "[3*m*(R - r)^2/2]");
    EXPECT_EQ(print(model.forcing()), "[-g*m*sin(q)*(R - r)]");
    EXPECT_EQ(print(model.udot()), "[-2*g*sin(q)/(3*(R - r))]");
    EXPECT_EQ(operations(model.udot()), 5);
    auto f = model.function(model.udot()); // as large as the trough
    f(Eigen::Vector2d(0.7, -1.3), Eigen::Vector4d(1.7, 9.81, 0.3, 0.3));
    EXPECT_NE(std::string(f.status().cause()).find("the mass matrix is singular at this state"),
              std::string::npos)
        << f.status().cause();
  }
}

TEST(gathered, a_body_that_rolls_in_a_trough) {
  for (const variant& v : variants) {
    trough t(v);
    t.roll(t.parameter("J"));
    kanexpr::model model = kanexpr::derive(t);
    EXPECT_EQ(print(model.mass_matrix()), "[(J/r^2 + m)*(R - r)^2]");
    EXPECT_LE(operations(model.udot()), 9);
    const Eigen::Vector2d x(0.7, -1.3);
    for (const double R : {2.0, 0.2}) { // from the inside and from the outside
      Eigen::VectorXd p(5);
      p << 1.7, 9.81, R, 0.3, 0.05;
      const double by_hand = -9.81 * std::sin(0.7) / ((R - 0.3) * (1 + 0.05 / (1.7 * 0.09)));
      EXPECT_NEAR(t.udot(x, p)(0), by_hand, 1e-12 * std::abs(by_hand));
    }
  }
}

TEST(gathered, rolling_as_a_constraint) {
  bench b({}, {"q", "p"});
  const expression m = b.parameter("m"), g = b.parameter("g"), R = b.parameter("R"), r = b.parameter("r");
  const auto centre = b.offset("C", b.o, b.along(b.n, (R - r) * sin(b.q[0]), -((R - r) * cos(b.q[0])), 0));
  const auto f = b.rotated("F", b.n, b.q[1], b.along(b.n, 0, 0, 1));
  b.rigid_body("Disc", centre, f, m, b.inertia(f, 0, 0, m * r * r / 2));
  b.gravity(b.along(b.n, 0, -g, 0));
  b.velocity_constraint(b.along(b.n, (R - r) * b.rate[0] + r * b.rate[1], 0, 0), b.along(b.n, 1, 0, 0));
  EXPECT_FALSE(b.check()) << b.check().view();
  kanexpr::model model = kanexpr::derive(b);
  EXPECT_EQ(print(model.mass_matrix()), "[3*m*(R - r)^2/2]");
  EXPECT_EQ(print(model.forcing()), "[-g*m*sin(q)*(R - r)]");
  EXPECT_EQ(print(model.udot()), "[-2*g*sin(q)/(3*(R - r))]\n[2*g*sin(q)/(3*r)       ]");
}

TEST(gathered, with_numbers_for_all_symbols) {
  for (const method by : {method::kane, method::lagrange}) {
    bench b({.by = by}, {"q"});
    b.particle("Bead", b.offset("C", b.o, b.along(b.n, 1.1 * sin(b.q[0]), -1.1 * cos(b.q[0]), 0)),
               b.number(0.7));
    b.gravity(b.along(b.n, 0, -9.81, 0));
    kanexpr::model model = kanexpr::derive(b);
    EXPECT_TRUE(model.mass_matrix()(0, 0).is_constant());
    EXPECT_LE(operations(model.udot()), 2);
    EXPECT_NEAR(b.udot(Eigen::Vector2d(0.4, 3), Eigen::VectorXd())(0), -9.81 * std::sin(0.4) / 1.1, 1e-12);
  }
}

TEST(gathered, the_linearization_too) {
  for (const variant& v : variants) {
    trough t(v);
    t.particle("Bead", t.centre, t.m);
    kanexpr::model model = kanexpr::derive(t);
    auto linear = model.get(quantity::state_matrix);
    EXPECT_EQ(print(linear(1, 0)), "-g*cos(q)/(R - r)") << static_cast<int>(v.by) << v.multiplied_out;
    EXPECT_TRUE(linear(1, 1).is_zero());
  }
}

TEST(gathered, spherical_coordinates) {
  for (const method by : {method::kane, method::lagrange}) {
    bench b({.by = by}, {"r", "a", "b"});
    const expression r = b.q[0], s = sin(b.q[1]);
    b.particle("Bob",
               b.offset("P", b.o, b.along(b.n, r * s * cos(b.q[2]), r * s * sin(b.q[2]), r * cos(b.q[1]))),
               b.parameter("m"));
    b.gravity(b.along(b.n, 0, 0, -b.parameter("g")));
    kanexpr::model model = kanexpr::derive(b);
    EXPECT_EQ(print(model.mass_matrix()), "[m, 0,     0             ]\n"
                                          "[0, m*r^2, 0             ]\n"
                                          "[0, 0,     m*r^2*sin(a)^2]");
    EXPECT_LE(operations(model.udot()), by == method::kane ? 24 : 38);
    Eigen::VectorXd x(6);
    x << 1.3, 0.8, -0.4, 0.7, -1.2, 0.9;
    const double dr = x(3), da = x(4), db = x(5), sa = std::sin(0.8), ca = std::cos(0.8), g = 9.81;
    const Eigen::Vector3d by_hand(1.3 * (da * da + sa * sa * db * db) - g * ca,
                                  sa * ca * db * db - 2 * dr * da / 1.3 + g * sa / 1.3,
                                  -2 * db * (dr / 1.3 + da * ca / sa));
    const Eigen::VectorXd found = b.udot(x, Eigen::Vector2d(2.1, g));
    EXPECT_LE((found - by_hand).cwiseAbs().maxCoeff(), 1e-12 * by_hand.cwiseAbs().maxCoeff());
  }
}

/// Pendulums one below the other on a cart, by components and by frames.
TEST(gathered, pendulums_on_a_cart_are_those_of_frames) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> any(-2, 2), positive(0.5, 2);
  for (const method by : {method::kane, method::lagrange}) {
    const auto made = [&](bool by_frames) {
      auto b = std::make_unique<bench>(variant{.by = by},
                                       std::initializer_list<const char*>{"x", "q1", "q2", "q3"});
      auto at = b->offset("Cart", b->o, b->along(b->n, b->q[0], 0, 0));
      b->particle("Cart", at, b->parameter("m0"));
      for (int i = 1; i < 4; ++i) {
        const std::string number = std::to_string(i);
        const expression l = b->parameter("l" + number), angle = b->q[static_cast<std::size_t>(i)];
        if (by_frames) {
          const auto bar = b->rotated("B" + number, b->n, angle, b->along(b->n, 0, 0, 1));
          at = b->offset("P" + number, at, b->along(bar, 0, -l, 0));
        } else {
          at = b->offset("P" + number, at, b->along(b->n, l * sin(angle), -(l * cos(angle)), 0));
        }
        b->particle("Bob" + number, at, b->parameter("m" + number));
      }
      b->gravity(b->along(b->n, 0, -b->parameter("g"), 0));
      return b;
    };
    const auto by_components = made(false), by_frames = made(true);
    for (int sample = 0; sample < 5; ++sample) {
      Eigen::VectorXd x(8), p(8);
      for (double& each : x) each = any(engine);
      for (double& each : p) each = positive(engine);
      const Eigen::VectorXd expected = by_frames->udot(x, p), found = by_components->udot(x, p);
      EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
    }
    kanexpr::model model = kanexpr::derive(*by_components), of_frames = kanexpr::derive(*by_frames);
    EXPECT_LE(operations(model.mass_matrix()), operations(of_frames.mass_matrix()) + 12);
  }
}

} // namespace

/// The same in the words of a model, and therefore at compile time.
namespace in_words {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"m"> m;
constexpr parameter<"g"> g;
constexpr parameter<"R"> R;
constexpr parameter<"r"> r;

struct N : inertial_frame<N> {}; // y points up
struct O : origin<O, N> {};
struct C : offset<C, O, (R - r) * sin(q) * N::x - (R - r) * cos(q) * N::y> {};
struct D : rotated<D, N, -(R - r) / r * q, N::z> {};
struct Cylinder : rigid_body<Cylinder, C, D, m, inertia<D, 0, 0, m * r * r / 2>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            parameters<m, g, R, r>, bodies<Cylinder>, loads<gravity<-g * N::y>>> {};
struct LagrangeSystem : lagrange_system<inertial<N>, coordinates<q>, parameters<m, g, R, r>, bodies<Cylinder>,
                                        loads<gravity<-g * N::y>>> {};

template <class System>
void check() {
  using equations = equations_of_motion<System>;
  EXPECT_EQ(derivation::cost_of<System>({mechanics::quantity::udot}), equations::cost(equations::udot));
  const symbolic::cost c = equations::cost(equations::mass_matrix), f = equations::cost(equations::forcing),
                       rates = equations::cost(equations::udot);
  EXPECT_LE(c.nodes, 5);
  EXPECT_LE(f.nodes, 6);
  EXPECT_LE(rates.nodes, 6);
  const typename equations::state x(0.7, -1.3);
  const typename equations::parameters p(1.7, 9.81, 2, 0.3);
  const double by_hand = -2 * 9.81 * std::sin(0.7) / (3 * 1.7);
  const double compiled = equations::udot(x, p)(0);
  EXPECT_NEAR(compiled, by_hand, 1e-12 * std::abs(by_hand));
  model same = derive<System>();
  auto interpreted = same.function(same.udot());
  EXPECT_EQ(interpreted(x, p)(0), compiled);
}

} // namespace in_words

TEST(gathered, in_the_compiler_as_in_the_program) {
  in_words::check<in_words::System>();
  in_words::check<in_words::LagrangeSystem>();
}
