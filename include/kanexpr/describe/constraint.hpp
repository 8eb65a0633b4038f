#pragma once

#include <kanexpr/describe/system.hpp>

/// The words of systems whose coordinates or speeds are not free.
namespace kanexpr {

namespace describe {

/// A vector and the directions along which it is zero, one after another in postfix order.
template <int size>
struct vanishing {
  token tokens[static_cast<std::size_t>(size)];
};

template <int size>
constexpr shape shape_of(const vanishing<size>&) {
  return shape::vanishing;
}

/// What stands for a list with something in it that is not an expression.
struct foreign {};

template <auto... expressions>
constexpr auto one_after_another() {
  if constexpr (sizeof...(expressions) == 0 || ((stored<expressions>::words.kind == shape::foreign) || ...)) {
    return foreign{};
  } else {
    vanishing<(stored<expressions>::words.size + ...)> all{};
    int next = 0;
    const auto append = [&](const phrase& p) {
      for (int i = 0; i < p.size; ++i) all.tokens[next++] = p.tokens[i];
    };
    (append(stored<expressions>::words), ...);
    return all;
  }
}

} // namespace describe

/// A constraint that says that a vector is zero along directions: `zero_along<velocity_of<C>, N::x, N::y>`.
template <auto... vector_and_directions>
inline constexpr auto zero_along = describe::one_after_another<vector_and_directions...>();

/// What the coordinates satisfy at all times, such as closed loops: equations of scalars, and vectors that
/// are zero along directions: `configuration_constraints<zero_along<position_of<P, Q>, N::x, N::y>>`.
template <auto... constraints>
struct configuration_constraints : describe::system_words {
  static constexpr std::string_view word = "configuration_constraints";
  static constexpr void tell(describe::system_record& r) {
    r.configuration_constraints =
        describe::list_of<describe::phrase, &describe::phrase_of<constraints>...>::all;
  }
};

/// What the speeds satisfy at all times, such as rolling; linear in speeds or coordinate rates. The rates of
/// the configuration constraints need not be repeated.
template <auto... constraints>
struct velocity_constraints : describe::system_words {
  static constexpr std::string_view word = "velocity_constraints";
  static constexpr void tell(describe::system_record& r) {
    r.velocity_constraints = describe::list_of<describe::phrase, &describe::phrase_of<constraints>...>::all;
  }
};

/// What the rates of the speeds satisfy, in place of the derivatives of the velocity constraints; linear in
/// them.
template <auto... constraints>
struct acceleration_constraints : describe::system_words {
  static constexpr std::string_view word = "acceleration_constraints";
  static constexpr void tell(describe::system_record& r) {
    r.acceleration_constraints =
        describe::list_of<describe::phrase, &describe::phrase_of<constraints>...>::all;
  }
};

/// The coordinates and speeds that the constraints are to be solved for: `dependent<q3, u2, u3>`.
template <auto... symbols>
struct dependent : describe::system_words {
  static constexpr std::string_view word = "dependent";
  static constexpr void tell(describe::system_record& r) {
    r.dependent = describe::list_of<describe::phrase, &describe::phrase_of<symbols>...>::all;
  }
};

namespace describe {
template <int number>
inline constexpr int number_of_constraint = number;
}

/// Configuration constraints that follow from the others wherever all of them hold, by their numbers, from 1
/// on: `redundant<6>`. Nothing is solved with them; states are held against them.
template <int... numbers>
struct redundant : describe::system_words {
  static constexpr std::string_view word = "redundant";
  static constexpr void tell(describe::system_record& r) {
    r.redundant = describe::list_of<int, &describe::number_of_constraint<numbers>...>::all;
  }
};

/// Speeds that are zero at all times and are in no list of speeds. Where they enter the velocity of a point
/// or the angular velocity of a frame they bring out forces that do no work.
template <auto... symbols>
struct auxiliary : describe::system_words {
  static constexpr std::string_view word = "auxiliary";
  static constexpr void tell(describe::system_record& r) {
    r.auxiliary = describe::list_of<describe::phrase, &describe::phrase_of<symbols>...>::all;
  }
};

} // namespace kanexpr
