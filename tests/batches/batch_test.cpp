// builds: clang++ sanitize
#include "no_heap.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/kanexpr.hpp>
#include <models/double_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace kanexpr;
using bars = equations_of_motion<double_pendulum::System>;

template <class Number>
parameter_values<double_pendulum::System, Number> bar_parameters() {
  parameter_values<double_pendulum::System, Number> p;
  p << Number(1.1), Number(0.6), Number(0.4), Number(0.35), Number(0.9), Number(0.07), Number(0.02),
      Number(9.81), Number(0.03), Number(0.02);
  return p;
}

template <std::size_t lanes, class Number>
void expect_the_bits_of_single_systems() {
  using namespace double_pendulum;
  using side_by_side = batch<lanes, Number>;
  typename side_by_side::template state<System> x;
  typename side_by_side::template inputs<System> r;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const Number i = static_cast<Number>(lane);
    side_by_side::set(x, lane,
                      {{q1, Number(0.4) + i}, {q2, Number(-0.3) * i}, {u1, 2 - i}, {u2, Number(0.7)}});
    side_by_side::set(r, lane, {{T1, Number(0.1) * i}, {T2, 1}});
  }
  constexpr auto all = bars::together(bars::mass_matrix, bars::rhs, bars::kinetic_energy);
  const auto p = bar_parameters<Number>();
  const auto [M, rates, energy] = [&] {
    no_heap::guard guard;
    return all(x, p, r);
  }();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto [own_M, own_rates, own_energy] =
        all(side_by_side::get(x, lane), p, side_by_side::get(r, lane));
    EXPECT_EQ(side_by_side::get(M, lane), own_M);
    EXPECT_EQ(side_by_side::get(rates, lane), own_rates);
    EXPECT_EQ(batches::lane_of(energy.value, lane), own_energy.value);
  }
}

TEST(batch, has_the_bits_of_single_systems) {
  expect_the_bits_of_single_systems<2, double>();
  expect_the_bits_of_single_systems<4, float>();
  expect_the_bits_of_single_systems<batches::default_lanes<double>, double>();
  expect_the_bits_of_single_systems<1, double>();
}

TEST(batch, has_entries_by_name) {
  using namespace double_pendulum;
  batch<2>::state<System> x;
  batch<2>::parameters<System> p;
  x[u2][1] = 3;
  p[g] = lower::scalar_math<batch<2>::number>::from(9.81);
  EXPECT_EQ(batch<2>::get(x, 0)[u2], 0);
  EXPECT_EQ(batch<2>::get(x, 1)[u2], 3);
  EXPECT_EQ(batch<2>::get(p, 1)[g], 9.81);
  EXPECT_EQ(batch<2>::get(p, 1).mistake().cause(), "parameter m1 has no value");
}

// Angles, some so large that the C library reduces them, next to small ones.
template <std::size_t lanes, class Number>
void expect_sines_of_single_angles() {
  using pack = typename batch<lanes, Number>::number;
  using math = lower::scalar_math<pack>;
  const Number angles[]{0,
                        -0.0F,
                        1,
                        -2.5F,
                        131072,
                        -131073,
                        1e6F,
                        -3e20F,
                        std::numeric_limits<Number>::infinity(),
                        std::numeric_limits<Number>::denorm_min(),
                        100000,
                        0.5F};
  constexpr std::size_t count = std::size(angles);
  for (std::size_t first = 0; first < count; ++first) {
    pack all[2], sine[2], cosine[2];
    for (std::size_t i = 0; i < 2 * lanes; ++i) all[i / lanes][i % lanes] = angles[(first + i) % count];
    math::sincos(all, sine, cosine);
    for (std::size_t i = 0; i < 2 * lanes; ++i) {
      Number s, c;
      lower::scalar_math<Number>::sincos(angles[(first + i) % count], s, c);
      const Number found[]{sine[i / lanes][i % lanes], cosine[i / lanes][i % lanes]}, own[]{s, c};
      const bool none = std::isnan(s) && std::isnan(found[0]) && std::isnan(found[1]);
      EXPECT_TRUE(none || std::memcmp(found, own, sizeof own) == 0) << angles[(first + i) % count];
    }
  }
}

TEST(batch, has_the_sines_of_single_angles) {
  expect_sines_of_single_angles<2, double>();
  expect_sines_of_single_angles<2, float>();
  expect_sines_of_single_angles<4, float>();
}

} // namespace
