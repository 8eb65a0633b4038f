#pragma once

#include <kanexpr/batch/with_scalar.hpp>
#include <kanexpr/lower/pack.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <type_traits>

namespace kanexpr {

namespace batches {

/// How many numbers fill a vector of the processor.
template <class Number>
inline constexpr std::size_t widest = (std::max)(numeric::widest_vector / sizeof(Number), std::size_t{1});

/// The number in a lane; of a plain number, that number.
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

/// Systems side by side: what a compiled function takes and gives is then `width` numbers wide, `x[q1]` of a
/// `batch<4>::state<System>` is the coordinate of four systems, and each lane has the bits of its own
/// evaluation. A status is that of all lanes: good where each of them is.
///
/// Without a width as many as fill a vector of the processor for which a file is compiled.
template <std::size_t width = batches::widest<double>, class Number = double>
struct batch {
  static_assert(std::has_single_bit(width), "a batch has 1, 2, 4, 8 or another power of two of lanes");
  static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>,
                "the numbers of a batch are of type double or float");

  static constexpr std::size_t lanes = width;
  using element = Number;
  /// As many numbers, one of the compiler's own vectors.
  using number = typename numeric::detail::vector_of<Number, width>::type;

  template <class System>
  using state = kanexpr::state<System, number>;
  template <class System>
  using parameters = parameter_values<System, number>;
  template <class System>
  using inputs = input_values<System, number>;

  /// The state, parameters, inputs or result of the system in a lane.
  template <class Vector>
  static auto get(const Vector& all, std::size_t lane) {
    batches::with_scalar<Vector, Number> one;
    for (Eigen::Index i = 0; i < all.size(); ++i) one.data()[i] = batches::lane_of(all.data()[i], lane);
    return one;
  }
  /// Gives those of one system to a lane.
  template <class Vector>
  static void set(Vector& all, std::size_t lane, const batches::with_scalar<Vector, Number>& one) {
    for (Eigen::Index i = 0; i < all.size(); ++i) batches::set_lane(all.data()[i], lane, one.data()[i]);
  }
};

} // namespace kanexpr
