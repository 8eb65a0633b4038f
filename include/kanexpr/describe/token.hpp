#pragma once

#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

/// What the words of a model are stored as: flat arrays of tokens in postfix order, which are template
/// arguments and cost the compiler next to nothing, and records of entities that point at each other.
namespace kanexpr::describe {

struct frame_record;
struct point_record;
struct external_record;

/// Stands for "not prescribed" in place of the order of a derivative.
inline constexpr int unprescribed = -1;

/// The `index` of a number that is the whole number 0.
inline constexpr int whole_zero = 1;

struct symbol_record {
  symbolic::symbol_kind kind;
  symbolic::name called; ///< theta'' for the second derivative of a prescribed theta
  int order = unprescribed;
  int given = 0;        ///< how many letters the model gave, before an index and primes
  bool is_named = true; ///< as a symbol may be
};

enum class token_kind : unsigned char {
  number,
  symbol,
  scalar_function, ///< `operation` says which
  composed,        ///< of scalars: `index` is the symbolic::composition, `number` says of how many
  external,        ///< `external` of scalars, `number` says of how many
  basis,           ///< axis `index` of `frame`; no frame: of the frame that is being described
  add,
  subtract,
  negate,
  multiply, ///< a scalar with anything
  divide,   ///< anything by a scalar
  dot,      ///< also of a dyadic with a vector
  cross,
  outer,
  magnitude,
  normalized,
  position, ///< of `point` from its origin
  velocity,
  acceleration,
  angular_velocity, ///< of `frame` in the inertial frame
  angular_acceleration,
  derivative, ///< in time; of a vector as `frame` sees it
  partial,    ///< by `symbol`
  in_axes,    ///< of `frame`
  length,     ///< a scalar that must not be a number below zero
  wheel_axis, ///< a vector that must be fixed in `frame`
  misused,    ///< means nothing in a model: `index` is the describe::misuse
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
  bool is_of_one_file = false; ///< what it points at, which only one source file knows
};

} // namespace kanexpr::describe
