// A motor with a limit, a one-sided stop and a suction force that contains a root for one sign only,
// evaluated by every method of evaluating functions of a model.

#include <kanexpr/batch.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/listing.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>

#include "models/simple_pendulum.hpp"

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace simple_pendulum;

constexpr parameter<"T0"> T0;
constexpr parameter<"k"> k;
constexpr parameter<"b"> b;
constexpr auto rate = constant<1, radian / second>;

struct Limited
    : kane_system<
          inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c, T0, k, b>,
          inputs<T>, bodies<Bob>,
          loads<gravity<g * N::x>, torque<A, (clamp(T - c * u, -T0, T0) + (min)(-k * (q - 1), 0)) * N::z>,
                torque<A, if_positive(u, -b* sqrt(u / rate), b* u / hypot(u, 0.5)) * N::z>>> {};

using eom = equations_of_motion<Limited>;

const eom::parameters numbers{{m, 1}, {l, 1}, {g, 9.5}, {c, 0.25}, {T0, 2}, {k, 50}, {b, 0.5}};

struct motion {
  double q, u, T;
};
constexpr motion some[]{{0.3, 0.2, 0.1}, {0.3, 0.2, 9}, {0.3, -0.4, -9},
                        {1.2, 0, 1},     {1.2, -2, 3},  {-1, 0.5, 0}};

template <class S>
S acceleration(const S& angle, const S& speed, const S& drive) {
  using std::sin, std::sqrt;
  const S wanted = drive - S(0.25) * speed;
  const S motor = wanted > S(2) ? S(2) : wanted < S(-2) ? S(-2) : wanted;
  const S stop = angle > S(1) ? S(-50) * (angle - S(1)) : S(0);
  const S suction =
      speed > S(0) ? S(S(-0.5) * sqrt(speed)) : S(S(0.5) * speed / sqrt(speed * speed + S(0.25)));
  return -S(9.5) * sin(angle) + motor + stop + suction;
}

template <class S>
S compiled(const S& angle, const S& speed, const S& drive) {
  kanexpr::state<Limited, S> x;
  x[q] = angle;
  x[u] = speed;
  const kanexpr::parameter_values<Limited, S> p(numbers.cast<S>());
  kanexpr::input_values<Limited, S> r;
  r[T] = drive;
  return eom::udot(x, p, r)(0);
}

TEST(selection, is_that_of_every_scalar_type) {
  for (const motion& at : some) {
    const double expected = acceleration(at.q, at.u, at.T);
    EXPECT_NEAR(compiled(at.q, at.u, at.T), expected, 1e-13);
    EXPECT_NEAR(compiled(static_cast<float>(at.q), static_cast<float>(at.u), static_cast<float>(at.T)),
                expected, 1e-5);
    EXPECT_NEAR(static_cast<double>(compiled<long double>(at.q, at.u, at.T)), expected, 1e-13);
    if (at.u == 0) continue;
    using number = Eigen::AutoDiffScalar<Eigen::Vector3d>;
    const number angle(at.q, 3, 0), speed(at.u, 3, 1), drive(at.T, 3, 2);
    EXPECT_LT((compiled(angle, speed, drive).derivatives() - acceleration(angle, speed, drive).derivatives())
                  .norm(),
              1e-12);
  }
}

TEST(selection, is_made_lane_by_lane) {
  using side_by_side = batch<2>;
  for (std::size_t first = 0; first < 4; first += side_by_side::lanes) {
    side_by_side::state<Limited> x;
    side_by_side::inputs<Limited> r;
    for (std::size_t lane = 0; lane < side_by_side::lanes; ++lane) {
      side_by_side::set(x, lane, {{q, some[first + lane].q}, {u, some[first + lane].u}});
      side_by_side::set(r, lane, {{T, some[first + lane].T}});
    }
    const auto udot = eom::udot(x, numbers, r);
    EXPECT_TRUE(udot.status);
    for (std::size_t lane = 0; lane < side_by_side::lanes; ++lane) {
      const auto& one = some[first + lane];
      EXPECT_EQ(udot(0)[lane], compiled(one.q, one.u, one.T));
    }
  }
}

TEST(selection, is_a_constant_where_all_is) {
  constexpr auto udot = eom::udot.constant({1.2, -2}, {1, 1, 9.5, 0.25, 2, 50, 0.5}, std::array{3.0});
  EXPECT_NEAR(udot(0), acceleration(1.2, -2.0, 3.0), 1e-13);
}

/// At negative speeds, neither the root nor its slope affects the result.
TEST(selection, has_the_status_of_what_it_chooses) {
  const eom::inputs r{{T, 1}}, no_number{{T, std::nan("")}};
  for (const double speed : {-3.0, -0.0, 0.0, 0.7}) {
    const eom::state x{{q, 0.1}, {u, speed}};
    EXPECT_TRUE(eom::udot(x, numbers, r).status) << speed;
    const auto [A, B] = linearization<Limited>::explicit_form(x, numbers, r);
    EXPECT_TRUE(A.status) << speed;
    EXPECT_TRUE(B.status) << speed;
  }
  EXPECT_FALSE(eom::udot(eom::state{{q, 0.1}, {u, std::nan("")}}, numbers, r).status);
  EXPECT_FALSE(eom::udot(eom::state{{q, std::nan("")}, {u, 1}}, numbers, r).status);
  EXPECT_FALSE(eom::udot(eom::state{{q, 0.1}, {u, 1}}, numbers, no_number).status);
}

TEST(selection, is_linearized) {
  for (const motion& at : some) {
    if (at.u == 0) continue;
    const auto [A, B] = linearization<Limited>::explicit_form(eom::state{{q, at.q}, {u, at.u}}, numbers,
                                                              eom::inputs{{T, at.T}});
    using number = Eigen::AutoDiffScalar<Eigen::Vector3d>;
    const Eigen::Vector3d slopes =
        acceleration(number(at.q, 3, 0), number(at.u, 3, 1), number(at.T, 3, 2)).derivatives();
    EXPECT_NEAR(A(1, 0), slopes(0), 1e-12);
    EXPECT_NEAR(A(1, 1), slopes(1), 1e-12);
    EXPECT_NEAR(B(1, 0), slopes(2), 1e-12);
  }
}

TEST(selection, is_interpreted_as_it_is_compiled) {
  auto system = derive<Limited>();
  auto f = system.function(system.udot());
  for (const motion& at : some)
    EXPECT_EQ(f(Eigen::Vector2d(at.q, at.u), Eigen::VectorXd(numbers), Eigen::Matrix<double, 1, 1>(at.T))(0),
              compiled(at.q, at.u, at.T));
}

/// A rope: an energy only when it is taut, differentiated by Lagrange's method in reverse mode.
struct Roped
    : lagrange_system<inertial<N>, coordinates<q>, parameters<m, l, k>,
                      lagrangian<m * l * l * dot(q) * dot(q) / 2 - k * if_positive(q, pow(q, 1.5), 0)>> {};

TEST(selection, has_an_energy) {
  using roped = equations_of_motion<Roped>;
  const roped::parameters p{{m, 2}, {l, 1}, {k, 3}};
  for (const double angle : {-2.0, 0.0, 0.25}) {
    const roped::state x{{q, angle}, {dot(q), 0.5}};
    const auto udot = roped::udot(x, p);
    EXPECT_TRUE(udot.status) << angle;
    EXPECT_NEAR(udot(0), angle > 0 ? -3 * 1.5 * std::sqrt(angle) / 2 : 0, 1e-15);
  }
}

TEST(selection, is_written_by_the_builder) {
  runtime::builder made("N");
  const auto angle = made.coordinate("q"), speed = made.speed("u"), most = made.parameter("T0");
  made.kinematic_equation(made.dot(angle) - speed);
  const auto arm =
      made.rotated("A", made.inertial_frame(), angle, made.along(made.inertial_frame(), 0, 0, 1));
  made.particle("Bob", made.offset("P", made.origin("O"), made.along(arm, 1, 0, 0)), made.number(1));
  made.torque(arm, made.along(arm, 0, 0, clamp(-speed, -most, most)));
  model pendulum = derive(made);
  EXPECT_EQ(pendulum.mistake(), "");
  auto udot = pendulum.function(pendulum.udot());
  EXPECT_EQ(udot(Eigen::Vector2d(0, 0.5), Eigen::Matrix<double, 1, 1>(2))(0), -0.5);
  EXPECT_EQ(udot(Eigen::Vector2d(0, 5), Eigen::Matrix<double, 1, 1>(2))(0), -2);
}

TEST(selection, is_a_limit_from_both_sides) {
  struct Symbols {
    symbolic::graph g;
    symbolic::expression x = variable(g, {symbolic::symbol_kind::coordinate, base::name("x"), 0}),
                         zero = symbolic::constant(g, symbolic::exactly(0));
  } s;
  const auto at_zero = [&](symbolic::expression e) {
    symbolic::matrix one(s.g, 1, 1);
    one(0, 0) = e;
    return symbolic::limits_at(s.g, one, {{s.x, s.zero}});
  };
  const auto same = at_zero(if_positive(s.x, sin(s.x) / s.x, s.x + 1));
  EXPECT_TRUE(same.singular.empty());
  EXPECT_TRUE(same.values(0, 0).is_one());
  EXPECT_FALSE(at_zero((symbolic::max)(s.x, s.zero) / s.x).singular.empty());
}

} // namespace
