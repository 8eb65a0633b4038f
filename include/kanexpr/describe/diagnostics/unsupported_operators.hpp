#pragma once

#include <kanexpr/describe/operand.hpp>

/// Operators that C++ provides but models do not support, such as `q^2`. The operands are kept, followed by
/// the mistake, so that the model reader can report it with its location.
namespace kanexpr {

#define KANEXPR_UNSUPPORTED_OPERATOR(symbol, kind, mistake)                                                  \
  template <class Left, class Right>                                                                         \
    requires describe::operands_of_a_model<Left, Right>                                                      \
  constexpr auto operator symbol(const Left& x, const Right& y) {                                            \
    return describe::misused<describe::shape::kind>(describe::misuse::mistake, x, y);                        \
  }

KANEXPR_UNSUPPORTED_OPERATOR(!=, equation, comparison)
KANEXPR_UNSUPPORTED_OPERATOR(<, equation, comparison)
KANEXPR_UNSUPPORTED_OPERATOR(>, equation, comparison)
KANEXPR_UNSUPPORTED_OPERATOR(<=, equation, comparison)
KANEXPR_UNSUPPORTED_OPERATOR(>=, equation, comparison)
KANEXPR_UNSUPPORTED_OPERATOR(<=>, equation, comparison)
KANEXPR_UNSUPPORTED_OPERATOR(^, scalar, caret)
KANEXPR_UNSUPPORTED_OPERATOR(%, scalar, remainder)
KANEXPR_UNSUPPORTED_OPERATOR(&, scalar, unsupported_operator)
KANEXPR_UNSUPPORTED_OPERATOR(|, scalar, unsupported_operator)
KANEXPR_UNSUPPORTED_OPERATOR(<<, scalar, unsupported_operator)
KANEXPR_UNSUPPORTED_OPERATOR(>>, scalar, unsupported_operator)
KANEXPR_UNSUPPORTED_OPERATOR(+=, equation, change)
KANEXPR_UNSUPPORTED_OPERATOR(-=, equation, change)
KANEXPR_UNSUPPORTED_OPERATOR(*=, equation, change)
KANEXPR_UNSUPPORTED_OPERATOR(/=, equation, change)

template <describe::expression_of_a_model Operand>
constexpr auto operator!(const Operand& x) {
  return describe::misused<describe::shape::equation>(describe::misuse::negation, x);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator~(const Operand& x) {
  return describe::misused<describe::shape::scalar>(describe::misuse::unsupported_operator, x);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator*(const Operand& x) {
  return describe::misused<describe::shape::scalar>(describe::misuse::unsupported_operator, x);
}

// g++'s -Weffc++ warns about the mere existence of these operators, but without them there would be no error
// message.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"
KANEXPR_UNSUPPORTED_OPERATOR(&&, equation, logical_operator)
KANEXPR_UNSUPPORTED_OPERATOR(||, equation, logical_operator)
template <describe::expression_of_a_model Operand>
constexpr auto operator++(const Operand& x) {
  return describe::misused<describe::shape::scalar>(describe::misuse::change, x);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator++(const Operand& x, int) {
  return describe::misused<describe::shape::scalar>(describe::misuse::change, x);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator--(const Operand& x) {
  return describe::misused<describe::shape::scalar>(describe::misuse::change, x);
}
template <describe::expression_of_a_model Operand>
constexpr auto operator--(const Operand& x, int) {
  return describe::misused<describe::shape::scalar>(describe::misuse::change, x);
}
#pragma GCC diagnostic pop

#undef KANEXPR_UNSUPPORTED_OPERATOR

template <describe::expression_of_a_model Operand>
constexpr auto dot(const Operand& x) {
  return describe::misused<describe::shape::scalar>(describe::misuse::rate, x);
}

template <describe::expression_of_a_model Left, class Right, class Third, class... More>
constexpr auto dot(const Left& x, const Right&, const Third&, const More&...) {
  return describe::misused<describe::shape::scalar>(describe::misuse::operands, x);
}
template <describe::expression_of_a_model Left, class Right, class Third, class... More>
constexpr auto cross(const Left& x, const Right&, const Third&, const More&...) {
  return describe::misused<describe::shape::vector>(describe::misuse::operands, x);
}

} // namespace kanexpr
