#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/control/matrices.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <Eigen/Core>
#include <type_traits>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr {

/// Gains at equidistant values of a parameter, with linear interpolation between them: `K(v)`.
template <class Number, class Gain, int points>
struct scheduled_gains {
  Number from, to;
  Gain at[static_cast<std::size_t>(points)];
  kanexpr::status status; ///< the first failure among the gains

  /// Whether all gains were found.
  constexpr explicit operator bool() const { return static_cast<bool>(status); }

  /// Returns the gain at a value of the parameter, without a branch; outside the table, the gain at the
  /// nearer end. Returns NaN if the value is NaN, even with -ffast-math.
  constexpr Gain operator()(Number value) const {
    constexpr Number last = Number(points - 1), last_but_one = Number(points - 2);
    const Number given = (value - from) * (last / (to - from));
    const int is_none = numeric::is_nan(given) ? 1 : 0;
    // Selects by an index because compilers would turn conditions into branches.
    const Number places[]{given, Number(0)}, place = places[is_none];
    const Number within[]{place, Number(0), last}, below[]{place, Number(0), last_but_one};
    const int i = static_cast<int>(below[(place < 0 ? 1 : 0) + (place > last_but_one ? 2 : 0)]);
    const Number part = within[(place < 0 ? 1 : 0) + (place > last ? 2 : 0)] - static_cast<Number>(i);
    const Number parts[]{part, numeric::not_a_number<Number>};
    return control::between(at[i], at[i + 1], parts[is_none]);
  }
};

/// Converts a gain to a different scalar type.
template <class Other, control::matrix Gain>
constexpr auto in_numbers(const Gain& gain) {
  if constexpr (control::is_fixed_matrix<Gain>)
    return gain.template cast<Other>();
  else
    return gain.template cast<Other>().eval();
}

/// Converts a table to a different scalar type: `constexpr auto K = in_numbers<float>(gains);`.
template <class Other, class Number, class Gain, int points>
constexpr auto in_numbers(const scheduled_gains<Number, Gain, points>& table) {
  scheduled_gains<Other, decltype(in_numbers<Other>(table.at[0])), points> same{
      static_cast<Other>(table.from), static_cast<Other>(table.to), {}, table.status};
  for (int i = 0; i < points; ++i) same.at[i] = in_numbers<Other>(table.at[i]);
  return same;
}

/// Computes a table of gains over a parameter, at run time or at compile time: `constexpr auto K =
/// gain_schedule<21>(2.0, 8.0, [](double v) { return lqr(…); });`. The function returns a gain, or a
/// regulator with a gain K and a status.
template <int points, class From, class To, class GainAt>
constexpr auto gain_schedule(From first, To last, const GainAt& gain_at) {
  static_assert(points >= 2, "a gain schedule must have at least two points");
  using common = std::common_type_t<From, To>;
  using Number = std::conditional_t<std::is_floating_point_v<common>, common, double>;
  const Number from = static_cast<Number>(first), to = static_cast<Number>(last);
  const auto regulated = [&](int i) {
    return gain_at(static_cast<Number>(from + (to - from) * (Number(i) / Number(points - 1))));
  };
  const auto gain_of = [](const auto& found) {
    if constexpr (requires { found.K; })
      return found.K;
    else
      return found;
  };
  scheduled_gains<Number, decltype(gain_of(regulated(0))), points> table{from, to, {}, {}};
  for (int i = 0; i < points; ++i) {
    const auto found = regulated(i);
    table.at[i] = gain_of(found);
    if constexpr (requires { found.status; })
      if (table.status) table.status = found.status;
    if (table.status && !control::is_finite_gain(table.at[i]))
      table.status = status("a gain of the schedule is not finite");
  }
  if (table.status && !(numeric::is_finite(from) && numeric::is_finite(to) && (from < to || to < from)))
    table.status = status("the ends of the schedule must be finite and different");
  return table;
}

} // namespace kanexpr

#include <kanexpr/base/letters_back.hpp>
