#pragma once

#include <kanexpr/compiled/state.hpp>

#include <Eigen/Core>
#include <type_traits>

namespace kanexpr::batches {

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

/// The type of a vector of a system, or of a matrix, with a different scalar type; a result with a status
/// becomes a plain matrix.
template <class Vector, class Scalar>
using with_scalar = typename decltype(detail::exchanged<Scalar>(static_cast<const Vector*>(nullptr)))::type;

} // namespace kanexpr::batches
