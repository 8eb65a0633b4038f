#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/joints/joint_word.hpp>
#include <kanexpr/describe/operand.hpp>
#include <kanexpr/describe/operators.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <cstddef>

/// Blocks: filters, controllers and delays with state variables of their own, which a system lists in
/// `blocks<…>`. A block is a struct with a record of its state variables and their dynamics, `block`, and
/// with its output, an expression of the model: `Self::output`.
namespace kanexpr::describe {

/// A state variable named after a block: y_Filter. Further ones are numbered: z2_Filter.
template <text letter, class Self>
using state_variable_of =
    symbol<symbolic::symbol_kind::speed, joint_name<letter, Self>, unnumbered, of_state_variable>;

/// The record of a block with the given state variables and the same number of equations.
template <class Self, auto... symbols>
struct states_of_block {
  template <auto... equations>
  static constexpr block_record with(const arguments& fits) {
    block_record r;
    r.called = type_name<Self>();
    r.fits = fits;
    r.states = list_of<phrase, &phrase_of<symbols>...>::all;
    r.dynamics = list_of<phrase, &phrase_of<equations>...>::all;
    return r;
  }
};

/// An argument that must be positive, with its name: `positive_of<"the rate of ", rate>`.
template <text name, auto value>
inline constexpr positive_argument positive_of{phrase_of<value>, name.view()};

/// The record of a block with arguments that must be positive.
template <const positive_argument&... all>
constexpr block_record requiring(block_record r) {
  r.positive = list_of<positive_argument, &all...>::all;
  return r;
}

/// The argument with the given index, or 0 if it was omitted; the record reports that.
template <std::size_t index, auto... given>
constexpr auto argument_or_zero() {
  if constexpr (index < sizeof...(given))
    return whole_argument(one_of<index, given...>());
  else
    return whole_argument(0.0);
}

} // namespace kanexpr::describe
