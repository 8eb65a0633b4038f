#pragma once

#include <kanexpr/compiled/place.hpp>
#include <kanexpr/compiled/state.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr {

namespace batches {

template <class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr int place_of(const compiled::value_vector<System, which, Scalar>*, const Symbol&) {
  return compiled::place_in<System, which, Symbol>::place;
}

/// Writes the bits of a NaN: with -ffast-math, compilers assume that no number is NaN and may omit code that
/// writes one.
template <class Number>
void set_to_nan(Number* to) {
  using bits = std::conditional_t<sizeof(Number) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
  constexpr auto none = std::bit_cast<bits>(std::numeric_limits<Number>::quiet_NaN());
  std::memcpy(to, &none, sizeof none);
}

} // namespace batches

/// The states, parameters, inputs or results of many systems as a structure of arrays: the values of an entry
/// in all systems form a contiguous row, `x[q1]`.
///
///     many<eom::state> x(1000);
///     x[q1] = 0.3;              // in all systems
///     x[u1][17] = 2;            // in one
///     eom::state one = x.get(17);
///
/// Memory is allocated on construction. Rows begin on a cache line, at strides that avoid cache conflicts.
template <class Vector>
class many {
public:
  using number = typename Vector::Scalar;
  static_assert(std::is_same_v<number, double> || std::is_same_v<number, float>,
                "the numbers of `many` systems must be of type double or float");
  static_assert(Vector::SizeAtCompileTime != Eigen::Dynamic,
                "`many` requires vectors or matrices of fixed size");
  static constexpr int rows = Vector::RowsAtCompileTime, columns = Vector::ColsAtCompileTime,
                       entries = rows * columns;

  using row = Eigen::Map<Eigen::Array<number, 1, Eigen::Dynamic>>;
  using const_row = Eigen::Map<const Eigen::Array<number, 1, Eigen::Dynamic>>;

  /// Constructs `count` identical systems: states are zero, parameters and inputs are NaN until they are set.
  /// A negative count is treated as 0.
  explicit many(Eigen::Index count) : many(count, at_first()) {}
  many(Eigen::Index count, const Vector& each)
      : size_((std::max)(count, Eigen::Index{0})), lines_in_row_(lines_for(size_)),
        lines_(static_cast<std::size_t>(entries * lines_in_row_)) {
    for (int i = 0; i < entries; ++i) row_at(i) = each.data()[i];
  }

  many(const many&) = default;
  many& operator=(const many&) = default;
  /// The moved-from object has no systems.
  many(many&& from) noexcept
      : size_(std::exchange(from.size_, 0)), lines_in_row_(std::exchange(from.lines_in_row_, 0)),
        lines_(std::move(from.lines_)) {}
  many& operator=(many&& from) noexcept {
    size_ = std::exchange(from.size_, 0);
    lines_in_row_ = std::exchange(from.lines_in_row_, 0);
    lines_ = std::move(from.lines_);
    return *this;
  }

  /// Returns the number of systems.
  Eigen::Index size() const { return size_; }

  /// Returns the row of a symbol: its values in all systems.
  template <describe::expression_of_a_model Symbol>
  row operator[](const Symbol& symbol) {
    return row_at(batches::place_of(static_cast<const Vector*>(nullptr), symbol));
  }
  template <describe::expression_of_a_model Symbol>
  const_row operator[](const Symbol& symbol) const {
    return row_at(batches::place_of(static_cast<const Vector*>(nullptr), symbol));
  }

  /// Returns the row of an entry: its values in all systems.
  row operator()(int i, int j = 0) { return row_at(i + rows * j); }
  const_row operator()(int i, int j = 0) const { return row_at(i + rows * j); }

  /// Returns the vector of one system.
  Vector get(Eigen::Index system) const {
    Vector one;
    for (int i = 0; i < entries; ++i) one.data()[i] = data()[i * stride() + system];
    return one;
  }
  void set(Eigen::Index system, const Vector& one) {
    for (int i = 0; i < entries; ++i) data()[i * stride() + system] = one.data()[i];
  }

  /// Sets every entry of all systems.
  void fill(number all) {
    for (int i = 0; i < entries; ++i) row_at(i) = all;
  }

  /// Sets all entries of the systems [begin, end) to NaN.
  void set_to_nan(Eigen::Index begin, Eigen::Index end) {
    for (int i = 0; i < entries; ++i)
      for (Eigen::Index system = begin; system < end; ++system)
        batches::set_to_nan(data() + i * stride() + system);
  }

  /// Entry (i, j) of a system is `data()[(i + rows * j) * stride() + system]`.
  number* data() { return reinterpret_cast<number*>(lines_.data()); }
  const number* data() const { return reinterpret_cast<const number*>(lines_.data()); }
  Eigen::Index stride() const { return lines_in_row_ * in_line; }

private:
  static constexpr Eigen::Index in_line = 64 / sizeof(number);
  struct alignas(64) cache_line {
    number numbers[static_cast<std::size_t>(in_line)];
  };

  static Vector at_first() {
    if constexpr (requires(const Vector& v) { v.mistake(); })
      return Vector();
    else
      return Vector::Zero();
  }
  /// Returns an odd number of cache lines, so that rows do not compete for the same few lines of a cache.
  static Eigen::Index lines_for(Eigen::Index count) { return ((count + in_line - 1) / in_line) | 1; }

  row row_at(int i) { return row(data() + i * stride(), size_); }
  const_row row_at(int i) const { return const_row(data() + i * stride(), size_); }

  Eigen::Index size_ = 0, lines_in_row_ = 0;
  std::vector<cache_line> lines_;
};

namespace batches {

template <class Type>
inline constexpr bool is_many = false;
template <class Vector>
inline constexpr bool is_many<many<Vector>> = true;

/// Whether an argument has the scalar type `Number`; true for everything except `many`.
template <class Given, class Number>
inline constexpr bool is_of_numbers = true;
template <class Vector, class Number>
inline constexpr bool is_of_numbers<many<Vector>, Number> = std::is_same_v<typename Vector::Scalar, Number>;

/// A single vector or matrix, as opposed to `many`.
template <class Type>
concept single = !is_many<Type> && requires { typename Type::Scalar; };

} // namespace batches

} // namespace kanexpr
