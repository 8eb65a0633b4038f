#pragma once

#include <kanexpr/compiled/state.hpp>
#include <kanexpr/lower/pack.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <type_traits>

namespace kanexpr {

namespace batches {

namespace detail {

template <class Scalar, class System, class Before>
std::type_identity<state<System, Scalar>> exchanged(const state<System, Before>*);
template <class Scalar, class System, class Before>
std::type_identity<parameter_values<System, Scalar>> exchanged(const parameter_values<System, Before>*);
template <class Scalar, class System, class Before>
std::type_identity<input_values<System, Scalar>> exchanged(const input_values<System, Before>*);
template <class Scalar, class Before, int rows, int columns, int options, int most_rows, int most_columns>
std::type_identity<Eigen::Matrix<Scalar, rows, columns, options, most_rows, most_columns>>
exchanged(const Eigen::Matrix<Before, rows, columns, options, most_rows, most_columns>*);

} // namespace detail

/// The type of a system's vector, or of a matrix, converted to a different scalar type; a result with a
/// status becomes a plain matrix.
template <class Vector, class Scalar>
using with_scalar = typename decltype(detail::exchanged<Scalar>(static_cast<const Vector*>(nullptr)))::type;

/// The number of scalars in one vector register.
template <class Number>
inline constexpr std::size_t default_lanes =
    (std::max)(numeric::widest_vector / sizeof(Number), std::size_t{1});

/// Returns the number in a lane; a plain number is returned unchanged.
template <class Pack>
auto lane_of(const Pack& pack, [[maybe_unused]] std::size_t lane) {
  if constexpr (lower::vector_extension<Pack>)
    return pack[lane];
  else
    return pack;
}
template <class Pack, class Number>
void set_lane(Pack& pack, [[maybe_unused]] std::size_t lane, const Number& number) {
  if constexpr (lower::vector_extension<Pack>)
    pack[lane] = number;
  else
    pack = number;
}

} // namespace batches

/// Several systems side by side: the arguments and results of a compiled function hold `width` numbers per
/// entry, so `x[q1]` of a `batch<4>::state<System>` is the coordinate of four systems. Each lane holds the
/// same bits as a separate evaluation. A status covers all lanes: it reports success only if every lane
/// succeeded.
///
/// The default width fills one vector register of the processor for which the file is compiled.
template <std::size_t width = batches::default_lanes<double>, class Number = double>
struct batch {
  static_assert(std::has_single_bit(width), "the number of lanes of a batch must be a power of two");
  static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>,
                "the numbers of a batch must be of type double or float");

  static constexpr std::size_t lanes = width;
  using element = Number;
  /// A pack of `width` numbers, one of the compiler's vector types.
  using number = typename numeric::detail::vector_of<Number, width>::type;

  template <class System>
  using state = kanexpr::state<System, number>;
  template <class System>
  using parameters = parameter_values<System, number>;
  template <class System>
  using inputs = input_values<System, number>;

  /// Returns the state, parameters, inputs or result of the system in a lane.
  template <class Vector>
  static auto get(const Vector& all, std::size_t lane) {
    batches::with_scalar<Vector, Number> one;
    for (Eigen::Index i = 0; i < all.size(); ++i) one.data()[i] = batches::lane_of(all.data()[i], lane);
    return one;
  }
  /// Stores the state, parameters, inputs or result of one system in a lane.
  template <class Vector>
  static void set(Vector& all, std::size_t lane, const batches::with_scalar<Vector, Number>& one) {
    for (Eigen::Index i = 0; i < all.size(); ++i) batches::set_lane(all.data()[i], lane, one.data()[i]);
  }
};

} // namespace kanexpr
