// Out-of-line functions give the same bits as functions that are expanded at the call.
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/kanexpr.hpp>

#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>

#include <gmock/gmock.h>

#include "no_heap.hpp"

#include <complex>
#include <cstring>
#include <random>

namespace {

using namespace kanexpr;
using mechanics::quantity;

template <class T>
T number(std::mt19937& random) {
  return static_cast<T>(std::uniform_real_distribution<double>(0.5, 1.5)(random));
}
template <>
std::complex<double> number(std::mt19937& random) {
  const double real = number<double>(random);
  return {real, number<double>(random)};
}

template <class Vector>
Vector drawn(std::mt19937& random) {
  Vector v;
  for (auto& entry : v) entry = number<typename Vector::Scalar>(random);
  return v;
}

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  if constexpr (requires { b.data(); }) {
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           std::memcmp(a.data(), b.data(), sizeof(*b.data()) * static_cast<std::size_t>(b.size())) == 0;
  } else {
    const B number = a;
    return std::memcmp(&number, &b, sizeof b) == 0;
  }
}
template <class... A, class... B>
bool same_bits(const std::tuple<A...>& a, const std::tuple<B...>& b) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (same_bits(std::get<i>(a), std::get<i>(b)) && ...);
  }(std::index_sequence_for<A...>{});
}

template <class System, class T>
struct values {
  std::mt19937 random{7};
  kanexpr::state<System, T> x = drawn<kanexpr::state<System, T>>(random);
  parameter_values<System, T> p = drawn<parameter_values<System, T>>(random);
  input_values<System, T> r = drawn<input_values<System, T>>(random);
  Eigen::Matrix<T, kanexpr::state<System>::speeds, 1> a =
      drawn<Eigen::Matrix<T, kanexpr::state<System>::speeds, 1>>(random);
};

template <class T, class System, auto... wanted>
bool is_the_same(function<System, wanted...> f) {
  const values<System, T> at;
  return same_bits(out_of_line<function<System, wanted...>>{}(0.1, at.x, at.p, at.r),
                   f(0.1, at.x, at.p, at.r));
}

template <class T, class System>
void compare() {
  using eom = equations_of_motion<System>;
  EXPECT_TRUE(is_the_same<T>(eom::rhs));
  EXPECT_TRUE(is_the_same<T>(eom::kinetic_energy));
  EXPECT_TRUE(is_the_same<T>(eom::together(eom::mass_matrix, eom::forcing)));
  const values<System, T> at;
  EXPECT_TRUE(
      same_bits(out_of_line<function<System, quantity::unreduced_forces>>{}(0.1, at.x, at.p, at.r, at.a),
                eom::unreduced_forces(0.1, at.x, at.p, at.r, at.a)));
}

TEST(out_of_line, gives_the_same_bits) {
  compare<double, double_pendulum::System>();
  compare<float, double_pendulum::System>();
  compare<std::complex<double>, double_pendulum::System>();
  compare<double, four_bar::System>();
  compare<std::complex<double>, four_bar::System>();
}

TEST(out_of_line, tells_what_cannot_be_solved) {
  using System = four_bar::System;
  const values<System, double> at;
  state<System> x = at.x;
  x.setZero(); // all bars along one line
  const auto expanded = equations_of_motion<System>::udot(0.0, x, at.p, at.r);
  const auto found = out_of_line<function<System, quantity::udot>>{}(0.0, x, at.p, at.r);
  EXPECT_FALSE(found.status);
  EXPECT_EQ(found.status.cause(), expanded.status.cause());
}

TEST(out_of_line, takes_vectors_of_other_types_and_no_memory) {
  using System = double_pendulum::System;
  const values<System, double> at;
  const Eigen::VectorXd p = at.p;
  const Eigen::Matrix<float, 2, 1> r = at.r.cast<float>();
  const auto expected = equations_of_motion<System>::rhs(0.0, at.x, p, r);
  const no_heap::guard trap;
  const out_of_line<function<System, quantity::rhs>> rhs{};
  EXPECT_TRUE(same_bits(rhs(0.0, Eigen::Map<const Eigen::Vector4d>(at.x.data()), p, r), expected));
}

} // namespace
