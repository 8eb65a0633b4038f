#pragma once

#include <kanexpr/describe/shape.hpp>
#include <kanexpr/describe/vector.hpp>

#include <type_traits>
#include <utility>

/// The possible operands of an operator, whether or not they make sense there.
namespace kanexpr::describe {

template <int size>
constexpr const scalar<size>& operand(const scalar<size>& x) {
  return x;
}
template <int size>
constexpr const vector<size>& operand(const vector<size>& x) {
  return x;
}
template <int size>
constexpr const dyadic<size>& operand(const dyadic<size>& x) {
  return x;
}
template <int size>
constexpr const equation<size>& operand(const equation<size>& x) {
  return x;
}
template <class Operand>
  requires(!std::is_class_v<Operand> &&
           std::is_arithmetic_v<Operand>) // in this order, because few types reach the second condition
constexpr scalar<1> operand(Operand x) {
  if constexpr (std::is_same_v<Operand, bool>)
    return {{misused(misuse::boolean)}};
  else if constexpr (base::letter<Operand>)
    return {{misused(misuse::character)}};
  else
    return number(x);
}

/// Returns the argument itself; used where the integer 0 is allowed.
template <class Operand>
constexpr auto with_zeros(const Operand& x) {
  if constexpr (plain_number<Operand>)
    return constant(x);
  else
    return x;
}

template <class Operand>
concept written = requires(const Operand& x) { operand(x); };

template <int size>
constexpr shape shape_at(const scalar<size>*) {
  return shape::scalar;
}
template <int size>
constexpr shape shape_at(const vector<size>*) {
  return shape::vector;
}
template <int size>
constexpr shape shape_at(const dyadic<size>*) {
  return shape::dyadic;
}
template <int size>
constexpr shape shape_at(const equation<size>*) {
  return shape::equation;
}

template <written Operand>
inline constexpr shape shape_of_operand = shape_at(
    static_cast<std::remove_reference_t<decltype(operand(std::declval<const Operand&>()))>*>(nullptr));

template <class Operand>
concept no_scalar = written<Operand> && shape_of_operand<Operand> != shape::scalar;
template <class Operand>
concept no_vector = written<Operand> && shape_of_operand<Operand> != shape::vector;

/// The operands followed by the operation.
template <template <int> class Kind, std::size_t size>
constexpr Kind<static_cast<int>(size + 1)> followed_by(const token (&x)[size], const token& last) {
  return join<Kind<static_cast<int>(size + 1)>>(x, last);
}
template <template <int> class Kind, std::size_t left_size, std::size_t right_size>
constexpr Kind<static_cast<int>(left_size + right_size + 1)>
followed_by(const token (&x)[left_size], const token (&y)[right_size], const token& last) {
  return join<Kind<static_cast<int>(left_size + right_size + 1)>>(x, y, last);
}

} // namespace kanexpr::describe
