#pragma once

#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>
#include <kanexpr/units/unit.hpp>

/// The storage of a model's words: flat arrays of tokens in postfix order, which are template arguments and
/// cost almost no compile time, and records of entities that point to each other.
namespace kanexpr::describe {

/// The kind of an expression.
enum class shape : unsigned char {
  nothing,
  scalar,
  vector,
  dyadic,
  equation,
  vanishing,  ///< zero_along
  kinematics, ///< kinematics_of
  simple,     ///< the kinematic differential equations q̇ = u
  foreign,    ///< not an expression
};

struct frame_record;
struct point_record;
struct external_record;
struct load_record;

/// Denotes "not prescribed" as the order of a derivative.
inline constexpr int unprescribed = -1;
/// In place of an order: the symbol is a state variable, which is kept as a further speed.
inline constexpr int of_state_variable = -2;

/// The `index` of a number that is the integer 0.
inline constexpr int whole_zero = 1;
/// The `index` of a number that is an argument of a word, which has the unit that the word expects.
inline constexpr int whole_quantity = 2;

struct symbol_record {
  symbolic::symbol_kind kind;
  base::name called; ///< theta'' for the second derivative of a prescribed theta
  int order = unprescribed;
  int given = 0;        ///< the number of letters given in the model, without the index and the primes
  bool is_named = true; ///< whether the name is valid for a symbol
  const units::unit* unit = nullptr;       ///< null if the model does not state it here
  const symbolic::number* value = nullptr; ///< the number that it denotes, if it is a constant with a unit
  bool is_unit_implied = false; ///< whether the unit alone is no reason to check the units of the model
};

enum class token_kind : unsigned char {
  number,
  symbol,
  scalar_function, ///< given by `operation`
  composed, ///< a composition of scalars; `index` is the symbolic::composition, `number` the count of scalars
  external, ///< `external` applied to scalars; `number` is their count
  basis,    ///< axis `index` of `frame`; null denotes the frame that is being described
  add,
  subtract,
  negate,
  multiply, ///< a scalar by any quantity
  divide,   ///< any quantity by a scalar
  dot,      ///< also of a dyadic and a vector
  cross,
  outer,
  magnitude,
  normalized,
  position, ///< position of `point` relative to its origin
  velocity,
  acceleration,
  angular_velocity, ///< angular velocity of `frame` in the inertial frame
  angular_acceleration,
  derivative, ///< derivative with respect to time; of a vector, in `frame`
  partial,    ///< derivative with respect to `symbol`
  in_axes,    ///< a vector in the axes of `frame`
  length,     ///< a scalar that must not be a negative number
  wheel_axis, ///< a vector that must be fixed in `frame`
  of_load,    ///< a quantity of `load`; `index` is the describe::load_quantity
  misused,    ///< a construct without meaning in a model; `index` is the describe::misuse
};

struct token {
  token_kind what = token_kind::number;
  symbolic::operation operation{};
  int index = 0;
  symbolic::number number{};
  const symbol_record* symbol = nullptr;
  const frame_record* frame = nullptr;
  const point_record* point = nullptr;
  const external_record* external = nullptr;
  const load_record* load = nullptr;
  bool is_of_one_file = false; ///< whether it points to an entity that is local to one source file
};

} // namespace kanexpr::describe
