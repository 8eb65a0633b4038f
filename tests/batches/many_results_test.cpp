// builds: clang++ sanitize all
#include "no_heap.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/kanexpr.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace kanexpr;
using bars = equations_of_motion<double_pendulum::System>;
using pendulum = equations_of_motion<simple_pendulum::System>;

// Values that differ between systems and are the same in every run.
template <class Vector>
many<Vector> varied(Eigen::Index systems, double from, double to) {
  many<Vector> all(systems);
  unsigned seed = 12345;
  for (int i = 0; i < many<Vector>::entries; ++i)
    for (Eigen::Index system = 0; system < systems; ++system) {
      seed = seed * 1664525 + 1013904223;
      all(i)(system) = static_cast<typename Vector::Scalar>(from + (to - from) * (seed >> 8) / 16777216.0);
    }
  return all;
}

template <class Number>
void expect_the_bits_of_single_systems() {
  using System = double_pendulum::System;
  constexpr auto all = bars::together(bars::mass_matrix, bars::rhs, bars::kinetic_energy);
  for (Eigen::Index systems = 0; systems <= 20; ++systems) {
    const auto x = varied<state<System, Number>>(systems, -2, 2);
    const auto p = varied<parameter_values<System, Number>>(systems, 0.5, 2);
    const auto r = varied<input_values<System, Number>>(systems, -1, 1);
    many_results<std::remove_const_t<decltype(all)>, Number> found(systems);
    {
      no_heap::guard guard;
      EXPECT_TRUE(found.evaluate(x, p, r));
    }
    EXPECT_EQ(found.failures(), 0);
    for (Eigen::Index i = 0; i < systems; ++i) {
      const auto [M, rates, energy] = all(x.get(i), p.get(i), r.get(i));
      EXPECT_EQ(found.template result<0>().get(i), M);
      EXPECT_EQ(found.template result<1>().get(i), rates);
      EXPECT_EQ(found.template result<2>()(0)(i), energy.value);
      EXPECT_EQ(found(1, 0)(i), M(1, 0));
      EXPECT_TRUE(found.status_of(i));
    }
  }
}

TEST(many_results, have_the_bits_of_single_systems) {
  expect_the_bits_of_single_systems<double>();
  expect_the_bits_of_single_systems<float>();
}

TEST(many_results, take_one_vector_for_all) {
  const auto x = varied<bars::state>(13, -2, 2);
  const bars::parameters p = varied<bars::parameters>(1, 0.5, 2).get(0);
  const bars::inputs r(1, -2);
  many_results udot(bars::udot, 13);
  EXPECT_TRUE(udot.evaluate(x, p, r));
  for (int i = 0; i < 13; ++i) EXPECT_EQ(udot.result().get(i), bars::udot(x.get(i), p, r));
  many_results T(bars::kinetic_energy, 13);
  EXPECT_TRUE(T.evaluate(x, p));
  for (int i = 0; i < 13; ++i) EXPECT_EQ(T()(i), bars::kinetic_energy(x.get(i), p));
}

TEST(many_results, take_rates_and_the_time) {
  const auto x = varied<bars::state>(9, -2, 2);
  const auto a = varied<Eigen::Vector2d>(9, -3, 3);
  const bars::parameters p = varied<bars::parameters>(1, 0.5, 2).get(0);
  const bars::inputs r(1, -2);
  many_results forces(bars::inertia_forces, 9);
  EXPECT_TRUE(forces.evaluate(0.5, x, p, r, a));
  for (int i = 0; i < 9; ++i)
    EXPECT_EQ(forces.result().get(i), bars::inertia_forces(0.5, x.get(i), p, r, a.get(i)));
}

TEST(many_results, are_of_linearizations) {
  using linear = linearization<double_pendulum::System>;
  const auto x = varied<bars::state>(7, -2, 2);
  const bars::parameters p = varied<bars::parameters>(1, 0.5, 2).get(0);
  auto r = varied<bars::inputs>(7, -1, 1);
  r[double_pendulum::T2](4) = std::numeric_limits<double>::infinity();
  many_results AB(linear::explicit_form, 7);
  EXPECT_EQ(AB.evaluate(x, p, r).cause(), "T2 has no finite value");
  EXPECT_EQ(AB.failures(), 1);
  for (int i = 0; i < 7; ++i) {
    const auto [A, B] = linear::explicit_form(x.get(i), p, r.get(i));
    EXPECT_EQ(AB.status_of(i).cause(), A.status.cause());
    if (i == 4) continue;
    EXPECT_EQ(AB.result<0>().get(i), A);
    EXPECT_EQ(AB.result<1>().get(i), B);
  }
}

// Zero masses in lanes among others, in the last lane of a batch, and in the remainder.
TEST(many_results, say_which_systems_failed_and_why) {
  using namespace simple_pendulum;
  const auto x = varied<pendulum::state>(11, -2, 2);
  auto p = varied<pendulum::parameters>(11, 0.5, 2);
  const pendulum::inputs r(0.3);
  for (const int singular : {1, 4, 7, 10}) p[m](singular) = 0;
  p[l](9) = std::numeric_limits<double>::quiet_NaN();
  many_results udot(pendulum::udot, 11);
  const status first = udot.evaluate(x, p, r);
  EXPECT_EQ(first.cause(), pendulum::udot(x.get(1), p.get(1), r).status.cause());
  EXPECT_EQ(first.cause(), "the mass matrix is singular at this state: its elimination fails at the speed u");
  EXPECT_EQ(udot.failures(), 5);
  for (int i = 0; i < 11; ++i) {
    const auto own = pendulum::udot(x.get(i), p.get(i), r);
    EXPECT_EQ(udot.status_of(i).cause(), own.status.cause()) << i;
    EXPECT_EQ(std::isnan(udot(0)(i)), !own.status);
    if (own.status) {
      EXPECT_EQ(udot(0)(i), own(0));
    }
  }

  p[m] = 1, p[l] = 1;
  EXPECT_TRUE(udot.evaluate(x, p, r));
  EXPECT_EQ(udot.failures(), 0);
  for (int i = 0; i < 11; ++i) EXPECT_TRUE(udot.status_of(i));
}

// Three masses on two sliders; without the outer masses, either slider can move the inner one.
namespace sliders {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"m1"> m1;
constexpr parameter<"m2"> m2;
constexpr parameter<"m3"> m3;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P1 : offset<P1, O, q1 * N::x> {};
struct P2 : offset<P2, O, (q1 + q2) * N::x> {};
struct P3 : offset<P3, O, q2 * N::x> {};
struct First : particle<First, P1, m1> {};
struct Second : particle<Second, P2, m2> {};
struct Third : particle<Third, P3, m3> {};
struct System
    : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<dot(q1) == u1, dot(q2) == u2>,
                  parameters<m1, m2, m3>, bodies<First, Second, Third>, loads<force<P1, -q1 * N::x>>> {};

} // namespace sliders

// An infinite result in one lane does not affect a singular system in another.
TEST(many_results, do_not_notice_an_infinite_neighbour) {
  using eom = equations_of_motion<sliders::System>;
  const auto x = varied<eom::state>(2, 1, 2);
  many<eom::parameters> p(2);
  p.set(0, eom::parameters(1e-15, 1, 1e-15));
  p.set(1, eom::parameters(std::numeric_limits<double>::infinity(), 1, 1));
  many_results udot(eom::udot, 2);
  udot.evaluate(x, p);
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(udot.status_of(i).cause(), eom::udot(x.get(i), p.get(i)).status.cause()) << i;
  EXPECT_FALSE(udot.status_of(0));
}

// Bars in a line, with ever smaller bends: single precision fails before double precision.
template <class Number>
Eigen::Index failures_near_a_singular_state() {
  using System = four_bar::System;
  constexpr function<System, mechanics::quantity::dependent_speeds> f;
  many<state<System, Number>> x(60);
  for (int i = 0; i < 60; ++i) {
    auto one = state<System, Number>::Zero().eval();
    one(2) = static_cast<Number>(std::ldexp(1.0, -i));
    one(3) = 1;
    x.set(i, one);
  }
  const parameter_values<System, Number> p = parameter_values<System, Number>::Constant(1);
  many_results<std::remove_const_t<decltype(f)>, Number> speeds(60);
  EXPECT_FALSE(speeds.evaluate(x, p));
  for (int i = 0; i < 60; ++i) {
    const auto own = f(x.get(i), p);
    EXPECT_EQ(speeds.status_of(i).cause(), own.status.cause()) << i;
    if (own.status) {
      EXPECT_EQ(speeds.result().get(i), own);
    }
  }
  return speeds.failures();
}

TEST(many_results, fail_where_single_systems_do_near_a_singular_state) {
  const Eigen::Index by_double = failures_near_a_singular_state<double>();
  const Eigen::Index by_float = failures_near_a_singular_state<float>();
  EXPECT_GT(by_double, 0);
  EXPECT_GT(by_float, by_double);
  EXPECT_LT(by_float, 60);
}

TEST(many_results, refuse_other_numbers_of_systems) {
  many_results udot(bars::udot, 3);
  const bars::parameters p = bars::parameters::Constant(1);
  const bars::inputs r(0, 0);
  EXPECT_TRUE(udot.evaluate(many<bars::state>(3), p, r));
  const status s = udot.evaluate(many<bars::state>(4), p, r);
  EXPECT_EQ(s.cause(), "the arguments and the results have different numbers of systems");
  EXPECT_EQ(udot.failures(), 3);
  EXPECT_FALSE(udot.status_of(2));
  EXPECT_TRUE(udot.result()(0).isNaN().all());
  EXPECT_TRUE(udot.evaluate(many<bars::state>(3), p, r));
}

// Runs the chunks in reverse order on several threads.
struct threads {
  int count;
  template <class Chunk>
  void operator()(int chunks, const Chunk& chunk) const {
    std::vector<std::jthread> all;
    for (int k = 0; k < count; ++k)
      all.emplace_back([&, k] {
        for (int i = chunks - 1 - k; i >= 0; i -= count) chunk(i);
      });
  }
};

TEST(many_results, do_not_depend_on_threads) {
  const Eigen::Index systems = 20011;
  const auto x = varied<bars::state>(systems, -2, 2);
  auto p = varied<bars::parameters>(systems, 0.5, 2);
  for (Eigen::Index i = 5; i < systems; i += 999) p.set(i, bars::parameters::Zero());
  const bars::inputs r(1, -2);
  many_results alone(bars::rhs, systems), shared(bars::rhs, systems);
  const status first = alone.evaluate(x, p, r);
  EXPECT_FALSE(first);
  for (const int count : {1, 2, 3, 7}) {
    EXPECT_EQ(shared.evaluate(threads{count}, x, p, r).cause(), first.cause());
    EXPECT_EQ(shared.failures(), alone.failures());
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(std::memcmp(shared.result()(i).data(), alone.result()(i).data(), sizeof(double) * systems),
                0);
    for (Eigen::Index i = 0; i < systems; ++i)
      ASSERT_EQ(shared.status_of(i).cause(), alone.status_of(i).cause());
  }
}

TEST(many_results, say_which_systems_were_left_out) {
  const Eigen::Index systems = 20011;
  const auto x = varied<bars::state>(systems, -2, 2);
  const bars::parameters p = bars::parameters::Constant(1);
  const bars::inputs r(1, -2);
  many_results rhs(bars::rhs, systems);
  const auto careless = [](int chunks, const auto& chunk) {
    EXPECT_GT(chunks, 2);
    for (int i = 0; i < chunks; i += 2) chunk(i);
  };
  EXPECT_EQ(rhs.evaluate(careless, x, p, r).cause(),
            "the chunk that contains this system was not run to completion");
  EXPECT_GT(rhs.failures(), systems / 4);
  EXPECT_TRUE(rhs.status_of(0));
}

} // namespace
