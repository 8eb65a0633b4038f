#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/expression.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

/// The possible operands of an operator, whether or not they make sense there.
namespace kanexpr::describe {

template <shape kind, int size>
  requires(kind <= shape::equation)
constexpr const postfix_expression<kind, size>& operand(const postfix_expression<kind, size>& x) {
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

/// Returns the argument as an expression if it is a number, which may be the integer 0.
template <class Operand>
constexpr auto with_zeros(const Operand& x) {
  if constexpr (plain_number<Operand>)
    return constant(x);
  else
    return x;
}

/// Returns an operand, which may be the integer 0.
template <class Operand>
constexpr decltype(auto) operand_or_zero(const Operand& x) {
  if constexpr (plain_number<Operand>)
    return constant(x);
  else
    return operand(x);
}

template <class Operand>
concept written = requires(const Operand& x) { operand(x); };
template <class Operand>
concept expression_of_a_model = std::is_class_v<Operand> && written<Operand>;
/// Two operands, at least one of which is an expression; all other pairs are left to the built-in C++
/// operators.
template <class Left, class Right>
concept operands_of_a_model =
    (std::is_class_v<Left> || std::is_class_v<Right>) && written<Left> && written<Right>;

template <written Operand>
inline constexpr shape shape_of_operand =
    std::remove_cvref_t<decltype(operand(std::declval<const Operand&>()))>::kind;

template <shape kind, int size>
constexpr shape shape_of(const postfix_expression<kind, size>&) {
  return kind;
}

template <class... Operands>
inline constexpr bool are_scalars = ((shape_of_operand<Operands> == shape::scalar) && ...);

/// Whether operands are scalars, vectors or dyadics, not equations, truth values or characters.
template <class... Operands>
inline constexpr bool are_quantities =
    ((std::is_class_v<Operands> ? shape_of_operand<Operands> != shape::equation : plain_number<Operands>) &&
     ...);

template <std::size_t size>
constexpr token* append(token* to, const token (&from)[size]) {
  for (const token& each : from) *to++ = each;
  return to;
}

template <class... Expressions>
inline constexpr int size_of_all = static_cast<int>((sizeof(Expressions::tokens) + ... + 0) / sizeof(token));

/// Returns the expressions, followed by the operation.
template <shape kind, class... Expressions>
constexpr auto joined(const token& last, const Expressions&... x) {
  postfix_expression<kind, size_of_all<Expressions...> + 1> all{};
  token* to = all.tokens;
  ((to = append(to, x.tokens)), ...);
  *to = last;
  return all;
}

/// Returns an operation on operands, whether or not their kinds match, as in `u1 + N::x`; the reader of the
/// model can report a mismatch together with the point or frame to which it belongs. An equation is stored
/// without its ==, so an equation among the operands is reported as a different mistake.
template <shape kind, class... Operands>
constexpr auto as_written(const token& last, const Operands&... x) {
  constexpr bool has_equation = ((shape_of_operand<Operands> == shape::equation) || ...);
  return joined<kind>(has_equation ? misused(misuse::inner_equation) : last, operand_or_zero(x)...);
}

template <shape kind, class... Operands>
constexpr auto misused(misuse what, const Operands&... x) {
  return joined<kind>(misused(what), operand_or_zero(x)...);
}

/// Returns the expression with the given index.
template <std::size_t wanted, auto first, auto... rest>
constexpr auto one_of() {
  if constexpr (wanted == 0)
    return first;
  else
    return one_of<wanted - 1, rest...>();
}

} // namespace kanexpr::describe
