// The compiled code and the interpreted derivation, compared to the last bit on random states.
#pragma once

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>

namespace agreement {

/// Random values, the same in every run.
template <class Vector>
Vector random(std::mt19937_64& source, double from, double to) {
  std::uniform_real_distribution<double> distribution(from, to);
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = distribution(source);
  return v;
}

template <class Compiled, class Interpreted>
void expect_same_bits(const Compiled& compiled, const Interpreted& interpreted) {
  ASSERT_EQ(compiled.rows(), interpreted.rows());
  ASSERT_EQ(compiled.cols(), interpreted.cols());
  for (Eigen::Index i = 0; i < compiled.rows(); ++i)
    for (Eigen::Index j = 0; j < compiled.cols(); ++j)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(compiled(i, j)), std::bit_cast<std::uint64_t>(interpreted(i, j)))
          << "entry " << i << ", " << j << ": " << compiled(i, j) << " and " << interpreted(i, j);
}

/// The rates ẋ of one system, which depend on all other results.
template <class System>
void check_rhs() {
  using eom = kanexpr::equations_of_motion<System>;
  auto derived = kanexpr::derive<System>();
  ASSERT_EQ(derived.mistake(), "");
  auto rhs = derived.function(derived.rhs());
  std::mt19937_64 source(19);
  for (int round = 0; round < 50; ++round) {
    const auto x = random<typename eom::state>(source, -3, 3);
    const auto p = random<typename eom::parameters>(source, 0.5, 2);
    const auto r = random<typename eom::inputs>(source, -5, 5);
    expect_same_bits(eom::rhs(x, p, r), rhs(x, p, r));
  }
}

/// Mass matrix, forcing and ẋ of one system; one compiled function gives all three.
template <class System>
void check() {
  using eom = kanexpr::equations_of_motion<System>;
  auto derived = kanexpr::derive<System>();
  ASSERT_EQ(derived.mistake(), "");
  auto mass_matrix = derived.function(derived.mass_matrix());
  auto forcing = derived.function(derived.forcing());
  auto rhs = derived.function(derived.rhs());

  std::mt19937_64 source(20);
  for (int round = 0; round < 50; ++round) {
    const auto x = random<typename eom::state>(source, -3, 3);
    const auto p = random<typename eom::parameters>(source, 0.5, 2);
    const auto r = random<typename eom::inputs>(source, -5, 5);
    const auto [m, f, rate] = eom::together(eom::mass_matrix, eom::forcing, eom::rhs)(x, p, r);
    expect_same_bits(m, mass_matrix(x, p, r));
    expect_same_bits(f, forcing(x, p, r));
    expect_same_bits(rate, rhs(x, p, r));
  }
}

} // namespace agreement
