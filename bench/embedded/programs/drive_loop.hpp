#pragma once

#include "drive.hpp"

#include <kanexpr/fixed_step.hpp>

#include <array>
#include <cmath>
#include <cstddef>

/// Two seconds of the motor with an elastic shaft and its controller, in steps of 0.5 ms: the state after
/// each half of a second. It is given the reference of the speed.
struct program {
  static constexpr std::array<double, 1> given{6};
  static constexpr std::size_t varied = given.size(), found = 25;
  static constexpr double spread = 2;

  template <class T>
  static constexpr std::array<T, 11> parameters() {
    std::array<T, 11> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = static_cast<T>(embedded::drive::calls::given[8 + i]);
    return all;
  }

  template <class T>
  static void run(const T* given, T* found) {
    using namespace elastic_drive;
    static constexpr auto numbers = parameters<T>();
    const kanexpr::parameter_values<System, T> p(Eigen::Map<const Eigen::Matrix<T, 11, 1>>(numbers.data()));
    const kanexpr::input_values<System, T> r(given[0], T(0));
    kanexpr::state<System, T> x = kanexpr::state<System, T>::Zero();
    kanexpr::status made;
    T t = 0;
    for (int part = 0; part < 4; ++part) {
      for (int step = 0; step < 1000 && made; ++step)
        made = kanexpr::runge_kutta_4<System>{}(t, x, T(0.0005), p, r);
      found = embedded::put(found, x);
    }
    *found = embedded::as_number<T>(made);
  }

  /// Whether the rotor and the disk turn with the same speed, as wanted.
  template <class T>
  static bool is_well(const T* found) {
    const T rotor = found[20], disk = found[21];
    return found[24] == 1 && std::abs(rotor - disk) < T(0.02) && disk > T(3.9) && disk < T(8.1);
  }
};
