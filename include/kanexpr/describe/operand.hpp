#pragma once

#include <kanexpr/describe/shape.hpp>
#include <kanexpr/describe/vector.hpp>

#include <utility>

/// What may stand beside an operator, whether it makes sense there or not.
namespace kanexpr::describe {

template <int a>
constexpr const scalar<a>& operand(const scalar<a>& x) {
  return x;
}
template <int a>
constexpr const vector<a>& operand(const vector<a>& x) {
  return x;
}
template <int a>
constexpr const dyadic<a>& operand(const dyadic<a>& x) {
  return x;
}
template <int a>
constexpr const equation<a>& operand(const equation<a>& x) {
  return x;
}
template <class T>
  requires(!std::is_class_v<T> &&
           std::is_arithmetic_v<T>) // in this order: few types of a program come to the second
constexpr scalar<1> operand(T x) {
  if constexpr (std::is_same_v<T, bool>)
    return {{misused(misuse::truth)}};
  else
    return constant(x);
}

template <class T>
concept written = requires(const T& x) { operand(x); };

template <int a>
constexpr shape shape_at(const scalar<a>*) {
  return shape::scalar;
}
template <int a>
constexpr shape shape_at(const vector<a>*) {
  return shape::vector;
}
template <int a>
constexpr shape shape_at(const dyadic<a>*) {
  return shape::dyadic;
}
template <int a>
constexpr shape shape_at(const equation<a>*) {
  return shape::equation;
}

template <written T>
inline constexpr shape shape_of_operand =
    shape_at(static_cast<std::remove_reference_t<decltype(operand(std::declval<const T&>()))>*>(nullptr));

template <class T>
concept no_scalar = written<T> && shape_of_operand<T> != shape::scalar;
template <class T>
concept no_vector = written<T> && shape_of_operand<T> != shape::vector;

/// The operands and what is done with them, one after another.
template <template <int> class Kind, std::size_t a>
constexpr Kind<static_cast<int>(a + 1)> followed_by(const token (&x)[a], const token& last) {
  return join<Kind<static_cast<int>(a + 1)>>(x, last);
}
template <template <int> class Kind, std::size_t a, std::size_t b>
constexpr Kind<static_cast<int>(a + b + 1)> followed_by(const token (&x)[a], const token (&y)[b],
                                                        const token& last) {
  return join<Kind<static_cast<int>(a + b + 1)>>(x, y, last);
}

} // namespace kanexpr::describe
