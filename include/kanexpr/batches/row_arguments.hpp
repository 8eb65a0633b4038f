#pragma once

#include <kanexpr/batches/batch.hpp>
#include <kanexpr/batches/many.hpp>
#include <kanexpr/compiled/value_vector.hpp>

#include <Eigen/Core>
#include <cstring>

namespace kanexpr::batches {

template <class Pack, class Number>
[[gnu::always_inline]] inline Pack pack_at(const Number* first) {
  Pack pack;
  std::memcpy(&pack, first, sizeof pack);
  return pack;
}
template <class Pack, class Number>
[[gnu::always_inline]] inline void put_at(Number* first, const Pack& pack) {
  std::memcpy(first, &pack, sizeof pack);
}

/// The vectors of adjacent systems, one in each lane, read directly from the rows: an argument of a compiled
/// function.
template <class Vector, class Pack>
struct row_argument {
  using Scalar = Pack;
  static constexpr int SizeAtCompileTime = Vector::SizeAtCompileTime;
  using number = typename Vector::Scalar;

  const number* first;
  Eigen::Index stride;

  [[gnu::always_inline]] Pack operator[](Eigen::Index i) const { return pack_at<Pack>(first + i * stride); }
};

using compiled::vector_owner_of;
template <class Vector, class Pack>
decltype(vector_owner_of(static_cast<const Vector*>(nullptr)))
vector_owner_of(const row_argument<Vector, Pack>*);

/// One argument of a batch, copied into its own memory; some lanes may duplicate others.
template <class Vector, class Pack>
struct copied_argument {
  using number = typename Vector::Scalar;
  static constexpr std::size_t lanes = sizeof(Pack) / sizeof(number);
  static constexpr std::size_t entries = static_cast<std::size_t>(many<Vector>::entries);
  alignas(Pack) number numbers[entries > 0 ? entries : 1][lanes];

  /// Lane i receives system first + i, or `last` if that is smaller.
  copied_argument(const many<Vector>& all, Eigen::Index first, Eigen::Index last) {
    for (std::size_t i = 0; i < entries; ++i)
      for (std::size_t lane = 0; lane < lanes; ++lane)
        numbers[i][lane] = all.data()[static_cast<Eigen::Index>(i) * all.stride() +
                                      (std::min)(first + static_cast<Eigen::Index>(lane), last)];
  }
};

/// Returns an argument of a compiled function for the systems from `first` on.
template <class Pack, class Vector>
row_argument<Vector, Pack> argument_from_rows(const many<Vector>& all, Eigen::Index first) {
  return {all.data() + first, all.stride()};
}
template <class Pack, class Given>
const Given& argument_from_rows(const Given& given, Eigen::Index) {
  return given;
}

/// Returns the argument as a copy in separate memory.
template <class Pack, class Vector>
copied_argument<Vector, Pack> copy_argument(const many<Vector>& all, Eigen::Index first, Eigen::Index last) {
  return {all, first, last};
}
template <class Pack, class Given>
const Given& copy_argument(const Given& given, Eigen::Index, Eigen::Index) {
  return given;
}
template <class Vector, class Pack>
row_argument<Vector, Pack> argument_from_copies(const copied_argument<Vector, Pack>& copies) {
  return {copies.numbers[0], static_cast<Eigen::Index>(copies.lanes)};
}
template <class Given>
const Given& argument_from_copies(const Given& given) {
  return given;
}

/// Whether an argument has one vector for each of `systems` systems.
template <class Given>
bool has_size(const Given&, Eigen::Index) {
  return true;
}
template <class Vector>
bool has_size(const many<Vector>& all, Eigen::Index systems) {
  return all.size() == systems;
}

/// Returns the argument of one system.
template <class Vector>
Vector of_system(const many<Vector>& all, Eigen::Index system) {
  return all.get(system);
}
template <class Given>
const Given& of_system(const Given& given, Eigen::Index) {
  return given;
}

} // namespace kanexpr::batches
