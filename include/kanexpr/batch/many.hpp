#pragma once

#include <kanexpr/compiled/place.hpp>
#include <kanexpr/compiled/state.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr {

namespace batches {

template <class System, compiled::symbols_of which, class Scalar, class Symbol>
constexpr int place_of(const compiled::value_vector<System, which, Scalar>*, const Symbol&) {
  return compiled::place_in<System, which, Symbol>::place;
}

/// By its bits: with -ffast-math compilers take it that no number is NaN, and leave out what writes one.
inline void leave_no_number(double* to) {
  constexpr std::uint64_t none = 0x7ff8'0000'0000'0000;
  std::memcpy(to, &none, sizeof none);
}
inline void leave_no_number(float* to) {
  constexpr std::uint32_t none = 0x7fc0'0000;
  std::memcpy(to, &none, sizeof none);
}

} // namespace batches

/// The states, parameters, inputs or results of many systems as a structure of arrays: the numbers that an
/// entry has in all of them lie one after another, as a row, `x[q1]`.
///
///     many<eom::state> x(1000);
///     x[q1] = 0.3;              // of all
///     x[u1][17] = 2;            // of one
///     eom::state one = x.get(17);
///
/// It takes memory when it is made. Rows begin on a cache line, at distances that do not crowd a cache.
template <class Vector>
class many {
public:
  using number = typename Vector::Scalar;
  static_assert(std::is_same_v<number, double> || std::is_same_v<number, float>,
                "many systems have numbers of type double or float");
  static_assert(Vector::SizeAtCompileTime != Eigen::Dynamic, "many need vectors or matrices of a fixed size");
  static constexpr int rows = Vector::RowsAtCompileTime, columns = Vector::ColsAtCompileTime,
                       entries = rows * columns;

  using row = Eigen::Map<Eigen::Array<number, 1, Eigen::Dynamic>>;
  using const_row = Eigen::Map<const Eigen::Array<number, 1, Eigen::Dynamic>>;

  /// All are the same at first: states zero, parameters and inputs not numbers until they are set. None where
  /// their number is negative.
  explicit many(Eigen::Index count) : many(count, at_first()) {}
  many(Eigen::Index count, const Vector& each)
      : size_((std::max)(count, Eigen::Index{0})), lines_in_row_(lines_for(size_)),
        lines_(static_cast<std::size_t>(entries * lines_in_row_)) {
    for (int i = 0; i < entries; ++i) row_at(i) = each.data()[i];
  }

  many(const many&) = default;
  many& operator=(const many&) = default;
  /// What is moved from has no systems.
  many(many&& from) noexcept
      : size_(std::exchange(from.size_, 0)), lines_in_row_(std::exchange(from.lines_in_row_, 0)),
        lines_(std::move(from.lines_)) {}
  many& operator=(many&& from) noexcept {
    size_ = std::exchange(from.size_, 0);
    lines_in_row_ = std::exchange(from.lines_in_row_, 0);
    lines_ = std::move(from.lines_);
    return *this;
  }

  /// How many systems there are.
  Eigen::Index size() const { return size_; }

  /// What a symbol is in all systems.
  template <describe::expression_of_a_model Symbol>
  row operator[](const Symbol& symbol) {
    return row_at(batches::place_of(static_cast<const Vector*>(nullptr), symbol));
  }
  template <describe::expression_of_a_model Symbol>
  const_row operator[](const Symbol& symbol) const {
    return row_at(batches::place_of(static_cast<const Vector*>(nullptr), symbol));
  }

  /// What an entry is in all systems.
  row operator()(int i, int j = 0) { return row_at(i + rows * j); }
  const_row operator()(int i, int j = 0) const { return row_at(i + rows * j); }

  /// That of one system.
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

  /// Leaves no number in the entries of the systems [begin, end).
  void leave_no_numbers(Eigen::Index begin, Eigen::Index end) {
    for (int i = 0; i < entries; ++i)
      for (Eigen::Index system = begin; system < end; ++system)
        batches::leave_no_number(data() + i * stride() + system);
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
  /// An odd number, so that rows are not mapped to the same few lines of a cache.
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

/// Whether what is given to systems of these numbers has such numbers, if it is `many`.
template <class Given, class Number>
inline constexpr bool is_of_numbers = true;
template <class Vector, class Number>
inline constexpr bool is_of_numbers<many<Vector>, Number> = std::is_same_v<typename Vector::Scalar, Number>;

/// One vector or matrix in the place of many.
template <class Type>
concept single = !is_many<Type> && requires { typename Type::Scalar; };

} // namespace batches

} // namespace kanexpr
