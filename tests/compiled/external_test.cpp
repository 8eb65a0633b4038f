// builds: clang++
// A tire whose force is computed by a user's function, compared with the same force as an expression of the
// model.

#include <kanexpr/batch.hpp>
#include <kanexpr/lower/complex_math.hpp>

#include "models/simple_pendulum.hpp"

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

namespace {

using namespace simple_pendulum;

/// A function of slip and load.
struct brush {
  template <class S>
  constexpr S operator()(const S& slip, const S& load) const {
    return S(load * slip / (slip * slip + S(2)) - load * load * slip / S(8));
  }
};
struct brush_slopes {
  template <class S>
  constexpr std::array<S, 2> operator()(const S& slip, const S& load) const {
    const S square = slip * slip, below = square + S(2);
    return {S(load * (S(2) - square) / (below * below) - load * load / S(8)),
            S(slip / below - load * slip / S(4))};
  }
};
constexpr external<"tyre", brush, brush_slopes> tyre;

template <class S>
constexpr auto tyre_in_words(const S& slip, const auto& load) {
  return load * slip / (slip * slip + 2) - load * load * slip / 8;
}

constexpr parameter<"c"> c;
constexpr auto rate = constant<1, radian / second>;

template <auto force>
struct with
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c>,
                  inputs<T>, bodies<Bob>, loads<gravity<g * N::x>, torque<A, (T - c * force) * N::z>>> {};
using Called = with<tyre(u, 1 + q * q)>;
using Written = with<tyre_in_words(u / rate, 1 + q * q)>;

template <class System, class S>
auto accelerations(const S& angle, const S& speed) {
  kanexpr::state<System, S> x;
  x[q] = angle;
  x[u] = speed;
  const kanexpr::parameter_values<System> p{{m, 1}, {l, 0.8}, {g, 9.81}, {c, 0.3}};
  const kanexpr::input_values<System> r{{T, 0.2}};
  return equations_of_motion<System>::udot(x, p.template cast<S>(), r.template cast<S>());
}

using called = equations_of_motion<Called>;
const called::parameters numbers{{m, 1}, {l, 0.8}, {g, 9.81}, {c, 0.3}};
const called::inputs torque_on{{T, 0.2}};

TEST(external, is_that_of_every_scalar_type) {
  for (const double speed : {-3.0, -0.4, 0.0, 1.3}) {
    const auto udot = accelerations<Called>(0.5, speed);
    EXPECT_TRUE(udot.status);
    const double written = accelerations<Written>(0.5, speed)(0);
    EXPECT_NEAR(udot(0), written, 1e-14);
    EXPECT_NEAR(accelerations<Called>(0.5F, static_cast<float>(speed))(0), written, 1e-5);
    EXPECT_NEAR(static_cast<double>(accelerations<Called>(0.5L, static_cast<long double>(speed))(0)), written,
                1e-14);
    using number = Eigen::AutoDiffScalar<Eigen::Vector2d>;
    const Eigen::Vector2d slopes =
        accelerations<Called>(number(0.5, 2, 0), number(speed, 2, 1))(0).derivatives();
    const called::state x{{q, 0.5}, {u, speed}};
    const auto [A, B] = linearization<Called>::explicit_form(x, numbers, torque_on);
    const auto [A_written, B_written] = linearization<Written>::explicit_form(
        equations_of_motion<Written>::state{{q, 0.5}, {u, speed}},
        equations_of_motion<Written>::parameters{{m, 1}, {l, 0.8}, {g, 9.81}, {c, 0.3}},
        equations_of_motion<Written>::inputs{{T, 0.2}});
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(A(1, i), A_written(1, i), 1e-13);
      EXPECT_NEAR(slopes(i), A_written(1, i), 1e-13);
    }
    EXPECT_NEAR(B(1), B_written(1), 1e-14);
    using complex = std::complex<double>;
    const complex step = accelerations<Called>(complex(0.5), complex(speed, 1e-30))(0);
    EXPECT_NEAR(step.imag() / 1e-30, A_written(1, 1), 1e-13);
  }
}

TEST(external, is_called_lane_by_lane) {
  using side_by_side = batch<2>;
  side_by_side::state<Called> x;
  for (std::size_t lane = 0; lane < side_by_side::lanes; ++lane) {
    const double along = 0.4 * static_cast<double>(lane) - 0.5;
    side_by_side::set(x, lane, {{q, along}, {u, 2 * along + 0.1}});
  }
  const auto udot = called::udot(x, numbers, torque_on);
  for (std::size_t lane = 0; lane < side_by_side::lanes; ++lane)
    EXPECT_EQ(udot(0)[lane], called::udot(side_by_side::get(x, lane), numbers, torque_on)(0));
}

TEST(external, is_a_constant) {
  constexpr auto udot = called::udot.constant({0.5, -1}, {1, 0.8, 9.81, 0.3}, {0.2});
  EXPECT_NEAR(udot(0), accelerations<Called>(0.5, -1.0)(0), 1e-14);
}

template <auto force>
constexpr int functions_of() {
  using eom = equations_of_motion<with<force>>;
  return eom::cost(eom::udot).other;
}

TEST(external, is_one_operation) {
  static_assert(functions_of<u>() == 0);
  static_assert(functions_of<tyre(u, q) * tyre(u, q) + tyre(u, q)>() == 1);
}

/// Functions that the compiler cannot evaluate, and functions with a pole.
struct steep {
  double operator()(double x) const { return std::tanh(x) / (x - 1); }
};
struct steepness {
  double operator()(double x) const {
    const double t = std::tanh(x);
    return (1 - t * t) / (x - 1) - t / ((x - 1) * (x - 1));
  }
};
constexpr external<"steep", steep, steepness> hill;

TEST(external, need_not_be_constant_nor_finite) {
  using on_a_hill = equations_of_motion<with<hill(q)>>;
  using in_words = equations_of_motion<with<tanh(q) / (q - 1)>>;
  const on_a_hill::parameters p{{m, 1}, {l, 0.8}, {g, 9.81}, {c, 0.3}};
  const in_words::parameters p_in_words{{m, 1}, {l, 0.8}, {g, 9.81}, {c, 0.3}};
  const auto udot = on_a_hill::udot(on_a_hill::state{{q, 0.4}, {u, 0}}, p, on_a_hill::inputs{{T, 0.2}});
  EXPECT_TRUE(udot.status);
  EXPECT_NEAR(udot(0),
              in_words::udot(in_words::state{{q, 0.4}, {u, 0}}, p_in_words, in_words::inputs{{T, 0.2}})(0),
              1e-14);
  const auto at_pole = on_a_hill::udot(on_a_hill::state{{q, 1}, {u, 0}}, p, on_a_hill::inputs{{T, 0.2}});
  EXPECT_FALSE(at_pole.status);
  EXPECT_EQ(kanexpr::status_of(at_pole).cause(), at_pole.status.cause());
  EXPECT_TRUE(kanexpr::status_of(at_pole.size())); // a result that cannot fail has no status
  EXPECT_TRUE(at_pole.status.cause().starts_with("the results are not finite at this state"))
      << at_pole.status.cause();
}

/// The energy of a spring, with as many derivatives as a linearization needs.
struct quartic {
  constexpr double operator()(double x) const { return x * x * x * x + x * x; }
};
struct quartic_slope {
  constexpr double operator()(double x) const { return 4 * x * x * x + 2 * x; }
};
struct quartic_curvature {
  constexpr std::array<double, 1> operator()(double x) const { return {12 * x * x + 2}; }
};
constexpr external<"V", quartic, quartic_slope, quartic_curvature> V;

template <auto energy>
struct stored : lagrange_system<inertial<N>, coordinates<q>, parameters<m, l>, bodies<Bob>,
                                loads<potential_energy<energy>>> {};

TEST(external, is_a_potential_energy) {
  using sprung = equations_of_motion<stored<V(q)>>;
  const sprung::parameters p{{m, 0.7}, {l, 0.8}};
  const sprung::state x{{q, 0.6}, {dot(q), 0.1}};
  const double inertia = 0.7 * 0.8 * 0.8;
  EXPECT_NEAR(sprung::udot(x, p)(0), -quartic_slope()(0.6) / inertia, 1e-13);
  EXPECT_NEAR(sprung::potential_energy(x, p), quartic()(0.6), 1e-14);
  const auto [A, B] = linearization<stored<V(q)>>::explicit_form(x, p);
  EXPECT_NEAR(A(1, 0), -quartic_curvature()(0.6)[0] / inertia, 1e-12);
  kanexpr::state<stored<V(q)>, std::complex<double>> stepped = x.cast<std::complex<double>>();
  stepped[q] += std::complex<double>(0, 1e-30); // not accepted by the functions themselves
  EXPECT_NEAR(sprung::udot(stepped, p.cast<std::complex<double>>())(0).imag() / 1e-30, A(1, 0), 1e-12);
}

} // namespace
