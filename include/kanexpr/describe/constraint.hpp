#pragma once

#include <kanexpr/describe/system.hpp>

#include <string_view>

/// The words of systems whose coordinates or speeds are constrained.
namespace kanexpr {

namespace describe {

/// Placeholder for a list with an entry that is not an expression.
struct foreign {};

/// A vector followed by the directions along which its components are zero.
template <auto... expressions>
constexpr auto one_after_another() {
  if constexpr (sizeof...(expressions) == 0 || ((stored<expressions>::words.kind == shape::foreign) || ...)) {
    return foreign{};
  } else {
    postfix_expression<shape::vanishing, (stored<expressions>::words.size + ...)> all{};
    token* next = all.tokens;
    const auto append = [&](const phrase& p) {
      for (int i = 0; i < p.size; ++i) *next++ = p.tokens[i];
    };
    (append(stored<expressions>::words), ...);
    return all;
  }
}

} // namespace describe

/// A constraint that requires the components of a vector along the given directions to vanish:
/// `zero_along<velocity_of<C>, N::x, N::y>`.
template <auto... vector_and_directions>
inline constexpr auto zero_along = describe::one_after_another<vector_and_directions...>();

/// Conditions that the coordinates satisfy at all times, such as closed loops: scalar equations, or vectors
/// whose components along given directions vanish, `configuration_constraints<zero_along<position_of<P, Q>,
/// N::x, N::y>>`.
template <auto... constraints>
struct configuration_constraints
    : describe::phrase_list<"configuration_constraints", &describe::system_record::configuration_constraints,
                            constraints...> {};

/// Conditions that the speeds or coordinate rates satisfy at all times, such as rolling or, if they are not
/// linear in the speeds, a constant speed. The forces of the latter act along their derivatives with respect
/// to the speeds (Chetaev's condition). The rates of the configuration constraints need not be repeated.
template <auto... constraints>
struct velocity_constraints
    : describe::phrase_list<"velocity_constraints", &describe::system_record::velocity_constraints,
                            constraints...> {};

/// Conditions on the rates of the speeds, linear in these rates, that replace the derivatives of the velocity
/// constraints.
template <auto... constraints>
struct acceleration_constraints
    : describe::phrase_list<"acceleration_constraints", &describe::system_record::acceleration_constraints,
                            constraints...> {};

/// The coordinates and speeds for which the constraints are solved: `dependent<q3, u2, u3>`.
template <auto... symbols>
struct dependent : describe::phrase_list<"dependent", &describe::system_record::dependent, symbols...> {};

namespace describe {
template <int number>
inline constexpr int number_of_constraint = number;
}

/// The numbers, counted from 1, of configuration constraints that are satisfied whenever all others are:
/// `redundant<6>`. They are not solved, but states are checked against them.
template <int... numbers>
struct redundant : describe::system_words {
  static constexpr std::string_view word = "redundant";
  static constexpr void add_to(describe::system_record& r) {
    r.redundant = describe::list_of<int, &describe::number_of_constraint<numbers>...>::all;
  }
};

/// Speeds that are identically zero and not listed among the speeds. They bring noncontributing forces into
/// evidence if they appear in the velocity of a point or the angular velocity of a frame.
template <auto... symbols>
struct auxiliary : describe::phrase_list<"auxiliary", &describe::system_record::auxiliary, symbols...> {};

} // namespace kanexpr
