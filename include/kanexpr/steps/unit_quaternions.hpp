#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/causes.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/unit_quaternion.hpp>
#include <kanexpr/symbolic/cost.hpp>

#include <Eigen/Core>
#include <array>
#include <utility>

namespace kanexpr::steps {

/// Returns, for example, "the quaternion e0, e1, e2 and e3".
constexpr base::sentence quaternion_called(const derivation::survey& known, int k) {
  base::sentence p = base::sentence({"the quaternion "});
  int left = 0;
  for (int i = 0; i < known.coordinates; ++i) left += known.quaternion_of[i] == k + 1;
  bool is_first = true;
  for (int i = 0; i < known.coordinates; ++i) {
    if (known.quaternion_of[i] != k + 1) continue;
    p = base::sentence({p.view(), is_first ? "" : left > 1 ? ", " : " and ", known.names[i].view()});
    is_first = false, --left;
  }
  return p;
}

/// Returns the reason why a quaternion cannot be normalized.
constexpr base::sentence far_from_norm_1(const derivation::survey& known, int k) {
  return base::sentence({"the norm of ", quaternion_called(known, k).view(), " is far from 1"});
}

/// The indices in the state of the dependent coordinates, followed by those for the dependent speeds.
template <class System>
inline constexpr auto dependent_places = [] {
  constexpr const derivation::survey& known = compiled::survey_of<System>;
  std::array<int, static_cast<std::size_t>(known.configuration_constraints + known.constraints + 1)> found{};
  std::size_t next = 0;
  for (int i = 0; i < known.coordinates + known.speeds; ++i)
    if (known.dependent[i]) found[next++] = i;
  return found;
}();

/// The quaternions of a system; the motion preserves their unit norms.
template <class System>
class unit_quaternions {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;

public:
  static constexpr int count = known.quaternions;

  /// Whether a constraint is solved for a coordinate of a quaternion.
  static constexpr bool are_bound = [] {
    bool found = false;
    for (int i = 0; i < known.coordinates; ++i)
      found = found || (known.quaternion_of[i] != 0 && known.dependent[i]);
    return found;
  }();

  static constexpr base::sentence called(int k) { return quaternion_called(known, k); }

  /// Normalizes all quaternions; the status reports one whose norm is outside the range.
  template <class State>
  [[gnu::always_inline]] static kanexpr::status normalize(State& x, const lower::norm_range& from) {
    return for_each(x, from, std::make_integer_sequence<int, count>{});
  }

  /// Returns the deviations of the norms from 1, to first order.
  template <class State>
  static Eigen::Matrix<typename State::Scalar, count, 1> residual(const State& x) {
    Eigen::Matrix<typename State::Scalar, count, 1> left;
    each([&](int k, const auto& places) { left(k) = (lower::squared_norm(x, places) - 1.0) / 2.0; });
    return left;
  }

  /// Returns the derivatives of `residual` with respect to all coordinates.
  template <class State>
  static Eigen::Matrix<typename State::Scalar, count, known.coordinates> jacobian(const State& x) {
    Eigen::Matrix<typename State::Scalar, count, known.coordinates> by_all;
    by_all.setZero();
    each([&](int k, const auto& places) {
      for (const int place : places) by_all(k, place) = x(place);
    });
    return by_all;
  }

  /// Replaces the derivatives of a function with respect to all coordinates by the derivatives of the same
  /// function applied to normalized quaternions.
  template <class Jacobian, class State>
  static void leave_norms_out(Jacobian& by_all, const State& x) {
    each([&](int, const auto& places) { lower::leave_norm_out(by_all, x, places); });
  }

  /// Calls f for each quaternion, with its number and the indices of its coordinates.
  template <class Function>
  static constexpr void each(const Function& f) {
    [&]<int... place>(std::integer_sequence<int, place...>) {
      (f(place, places<place>), ...);
    }(std::make_integer_sequence<int, count>{});
  }

  /// Returns the number of operations needed to normalize all quaternions.
  static constexpr symbolic::cost cost() {
    symbolic::cost total;
    each([&](int, const auto& places) {
      total.multiplications += 2 * static_cast<int>(places.size());
      total.additions += static_cast<int>(places.size()) - 1;
      total.divisions += 1;
      total.other += 1;
    });
    return total;
  }
  /// Returns the number of operations of `leave_norms_out` for the given number of rows.
  static constexpr symbolic::cost cost_of_leaving_out(int rows) {
    symbolic::cost total;
    each([&](int, const auto& places) {
      total.multiplications += 2 * rows * static_cast<int>(places.size());
      total.additions += rows * (2 * static_cast<int>(places.size()) - 1);
    });
    return total;
  }

private:
  template <int place>
  static constexpr std::size_t size = [] {
    std::size_t entries = 0;
    for (int i = 0; i < known.coordinates; ++i)
      if (known.quaternion_of[i] == place + 1) ++entries;
    return entries;
  }();
  template <int place>
  static constexpr auto places = [] {
    std::array<int, size<place>> found{};
    std::size_t next = 0;
    for (int i = 0; i < known.coordinates; ++i)
      if (known.quaternion_of[i] == place + 1) found[next++] = i;
    return found;
  }();

  template <int place>
  static constexpr auto far_from_one = derivation::only_cause([] { return far_from_norm_1(known, place); });

  template <class State, int... place>
  [[gnu::always_inline]] static kanexpr::status for_each(State& x, const lower::norm_range& from,
                                                         std::integer_sequence<int, place...>) {
    kanexpr::status s;
    static_cast<void>((... && (lower::normalize(x, places<place>, from) ||
                               (s = kanexpr::status(far_from_one<place>[0]), false))));
    return s;
  }
};

} // namespace kanexpr::steps
