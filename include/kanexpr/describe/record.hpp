#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/diagnostics/conflicting_bases.hpp>
#include <kanexpr/describe/diagnostics/misplaced_type.hpp>
#include <kanexpr/describe/diagnostics/unsupported_operators.hpp>
#include <kanexpr/describe/functions.hpp>
#include <kanexpr/describe/operators.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <cstddef>
#include <string_view>

/// The records from which a model's entities are read: plain constants that point to each other and to their
/// expressions.
namespace kanexpr::describe {

/// The result of checking the number of arguments of a word, and the form that an error message suggests.
struct arguments {
  int missing = 0;         ///< -1: too many
  std::string_view form{}; ///< how to write the word: "offset<Self, From, vector>"
  constexpr explicit operator bool() const { return missing == 0; }
};

constexpr arguments arguments_of(std::string_view form, std::size_t given, std::size_t least,
                                 std::size_t most) {
  return {given < least ? 1 : given > most ? -1 : 0, form};
}
constexpr arguments arguments_of(std::string_view form, std::size_t given, std::size_t wanted) {
  return arguments_of(form, given, wanted, wanted);
}
/// The same for a literal, whose letters compilers need not count.
template <std::size_t size, class... Counts>
constexpr arguments arguments_of(const char (&form)[size], Counts... counts) {
  return arguments_of(std::string_view(form, size - 1), static_cast<std::size_t>(counts)...);
}

/// An expression in static storage.
struct phrase {
  shape kind = shape::nothing;
  const token* tokens = nullptr;
  int size = 0;

  constexpr const token* begin() const { return tokens; }
  constexpr const token* end() const { return tokens + size; }
  constexpr bool is_whole_zero() const {
    return size == 1 && tokens[0].what == token_kind::misused &&
           tokens[0].index == static_cast<int>(misuse::zero);
  }
};

template <class Written>
constexpr auto with_numbers_as_scalars(const Written& value) {
  if constexpr (plain_number<Written>)
    return number(value);
  else if constexpr (base::letter<Written>)
    return scalar<1>{{misused(misuse::character)}};
  else
    return value;
}

/// Marks a number that is an argument of a word, if the word multiplies it by something.
template <class Written>
constexpr auto whole_argument(const Written& value) {
  auto marked = with_numbers_as_scalars(value);
  if constexpr (plain_number<Written>)
    if (marked.tokens[0].what == token_kind::number) marked.tokens[0].index = whole_quantity;
  return marked;
}

namespace {
struct this_file;
}

/// Whether an expression mentions an entity that is local to one source file.
template <auto value>
inline constexpr bool is_of_one_file = [] {
  if constexpr (requires { value.tokens[0].is_of_one_file; })
    for (const token& t : value.tokens)
      if (t.is_of_one_file) return true;
  return false;
}();

/// The same for a stored expression.
constexpr bool is_of_one_file_only(const phrase& p) {
  for (const token& t : p)
    if (t.is_of_one_file) return true;
  return false;
}

/// Two source files may each have entities with the same name in an unnamed namespace. g++ does not
/// distinguish template arguments by the objects to which they point, so the linker could confuse the
/// expressions of the two files. A type that is local to the file distinguishes them.
template <bool is_of_one_file>
struct known_in {
  using type = void;
};
template <>
struct known_in<true> {
  using type = this_file;
};

template <auto... values>
using file_of = typename known_in<(is_of_one_file<values> || ...)>::type;

template <auto value, class Where = file_of<value>>
struct stored {
  static constexpr auto expression = with_numbers_as_scalars(value);
  static constexpr phrase words = [] {
    if constexpr (requires { shape_of(expression); })
      return phrase{shape_of(expression), expression.tokens,
                    static_cast<int>(sizeof(expression.tokens) / sizeof(token))};
    else
      return phrase{shape::foreign, nullptr, 0};
  }();
};

/// The phrase for an expression that a model passes as a template argument.
template <auto value, class Where = file_of<value>>
inline constexpr phrase phrase_of = stored<value, Where>::words;

inline constexpr phrase no_phrase = phrase_of<constant(0)>;

/// The phrases for the arguments of a word, followed by zeros for the omitted ones.
template <auto... values>
inline constexpr phrase given_phrases[sizeof...(values) + 9]{phrase_of<values>...,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase,
                                                             no_phrase};

/// The phrases for values that may be 0 and are checked differently.
template <auto... values>
inline constexpr auto& given_phrases_with_zeros = given_phrases<with_zeros(values)...>;

/// A list of records in static storage.
template <class Record>
struct listing {
  struct iterator {
    const Record* const* entry;
    constexpr const Record& operator*() const { return **entry; }
    constexpr iterator& operator++() { return ++entry, *this; }
    constexpr bool operator==(const iterator&) const = default;
  };
  const Record* const* entries = nullptr;
  int size = 0;

  constexpr const Record& operator[](int i) const { return *entries[i]; }
  constexpr iterator begin() const { return {entries}; }
  constexpr iterator end() const { return {entries + size}; }
};

template <class Record, const Record*... entries>
struct list_of {
  static constexpr const Record* storage[sizeof...(entries) + 1]{entries..., nullptr};
  static constexpr listing<Record> all{storage, sizeof...(entries)};
};

enum class orientation_word : unsigned char;

struct beam_record;
struct flexible_record;
struct body_record;

/// The properties that all entities have in common.
struct entity_record {
  std::string_view called{};
  std::string_view declared_name{}; ///< the first template argument of its word; empty if it has none
  std::string_view instead{};       ///< the actual kind, if it is used as a different one
  base_conflict conflict = nullptr;
  bool unparsed = false; ///< whether it is a class without bases, as after an error in a base clause
};

struct frame_record : entity_record {
  arguments fits{};
  orientation_word orientation{}; ///< the default is that of an inertial frame
  const frame_record* parent = nullptr;
  phrase given[9]{}; ///< angles, quaternion or matrix
  std::string_view given_as = "an angle of frame "sv;
  phrase axis{};
  char sequence[4]{}; ///< "zxz" or "313"
  const frame_record* reference = nullptr;
  phrase angular_velocity{};
  bool turns_apart = false;   ///< the angular velocity is declared separately from the orientation
  std::string_view its_own{}; ///< the frame of that entity, if it has one
  bool is_of_joint = false;
  const body_record* on_beam = nullptr;     ///< the beam of a section
  const body_record* on_flexible = nullptr; ///< the body of a node
  std::string_view missing_node{};          ///< the name of a node that the body does not have

  constexpr bool is_inertial() const { return parent == nullptr; }
};

struct point_record : entity_record {
  arguments fits{};
  const point_record* parent = nullptr; ///< null for an origin
  const frame_record* origin_of = nullptr;
  phrase offset{};
  const frame_record* fixed_in = nullptr;
  const frame_record* reference = nullptr;
  phrase velocity{};
  bool moves_apart = false; ///< declared not to match its position
  bool from_parent =
      false; ///< the velocity is relative to the parent, even if `reference` is the inertial frame
  std::string_view its_own{};               ///< the point of that entity, if it has one
  const frame_record* of_joint = nullptr;   ///< the frame of the joint whose point this is
  const body_record* on_beam = nullptr;     ///< the beam of a section
  bool is_off_beam = false;                 ///< whether the section is not between root and tip
  bool is_at_whole_zero = false;            ///< whether its place is the integer 0, such as 1/2
  const body_record* on_flexible = nullptr; ///< the body of a node
  std::string_view missing_node{};          ///< the name of a node that the body does not have

  constexpr bool is_origin() const { return parent == nullptr; }
};

struct body_record : entity_record {
  arguments fits{};
  bool rigid = false;
  const point_record* center = nullptr;
  const frame_record* frame = nullptr;
  phrase mass{};
  const frame_record* inertia_axes = nullptr; ///< the frame in whose axes the six scalars are given
  phrase inertia[6]{};
  phrase inertia_dyadic{};
  const point_record* about = nullptr;
  std::string_view instead_of_inertia{}; ///< the type that is passed in its place but is not an inertia
  bool has_whole_zeros = false;          ///< whether all scalars of its inertia are the integer 0
  bool inertia_changes = false;
  bool effective = false;                    ///< the inertia need not correspond to a mass distribution
  const beam_record* beam = nullptr;         ///< null if it is not a beam
  const flexible_record* flexible = nullptr; ///< null if it is not given by numbers
};

struct friction_record;
struct contact_record;
struct muscle_record;
struct tyre_record;
struct wheel_record;

/// How the values of a load are interpreted; the enumerators are in load.hpp.
enum class load_word : unsigned char;

struct path_record;
struct joint_record;

/// An argument of a load whose value contains more than this argument.
struct coefficient_record {
  std::string_view word{}; ///< its name in messages, such as "the drag coefficient"
  units::unit unit{};
  phrase value{};
};

/// An argument of a block or a motor that must be positive.
struct positive_argument {
  phrase value{};
  std::string_view of{}; ///< its name, such as "the time constant of "
};

struct load_record {
  load_word what{};
  std::string_view
      word{}; ///< its name in messages, such as "the force"; the point or frame on which it acts follows
  arguments fits{};
  const point_record* point = nullptr;
  const point_record* other_point = nullptr; ///< null if it does not act between two points
  const frame_record* frame = nullptr;
  const frame_record* other_frame = nullptr; ///< null if it does not act between two frames
  phrase value{};                            ///< a force or torque, energy, stiffness or damping
  phrase angle{};                            ///< the angle of a torsional spring
  phrase rest{};                             ///< the length or angle of a spring at rest
  phrase known_by{}; ///< the expression that identifies it, if points or frames do not
  const friction_record* friction = nullptr; ///< the law of a friction in a joint
  const contact_record* contact = nullptr;   ///< null if it is not a contact
  const muscle_record* muscle = nullptr;     ///< null if it is not a muscle
  const tyre_record* tyre = nullptr;         ///< null if it is not a tyre
  const wheel_record* wheel = nullptr;       ///< of `contact_point` and `penetration_of`, in place of a load
  const coefficient_record* coefficient = nullptr; ///< of a force
  listing<phrase> states{}, dynamics{};            ///< its state variables, and the equations for their rates
  listing<positive_argument> positive{};           ///< the arguments of a motor that must be positive
  const path_record* path = nullptr;               ///< the pathway along which it acts
  const joint_record* joint = nullptr; ///< the joint in which a motor acts, if its rotor has an inertia
  const phrase* rotor = nullptr;       ///< the inertia of the rotor and its gear ratio
  const phrase* terms = nullptr;       ///< the arguments of its law, followed by zeros
  int terms_given = 0;
  std::string_view called{};
  std::string_view instead{}; ///< the actual kind, if it is not a load
  base_conflict conflict = nullptr;
  bool unparsed = false;
  bool once = false; ///< listing the same load again is a mistake
};

/// The state variables of a block and the equations for their rates.
struct block_record : entity_record {
  arguments fits{};
  listing<phrase> states{}, dynamics{};
  listing<positive_argument> positive{};
};

/// The contributions of a joint to a system in addition to its frame and its point.
struct joint_record : entity_record {
  std::string_view mistake{}; ///< the end of a sentence, such as "has two homes"
  std::string_view form{};    ///< the correct form, if the joint is written incorrectly
  const frame_record* frame = nullptr;
  const point_record* point = nullptr;
  const frame_record* home = nullptr; ///< the child's frame when all coordinates are zero
  const frame_record* parent_frame = nullptr;
  const point_record* parent_point = nullptr;
  listing<phrase> axes{}; ///< axes that must be checked
  phrase place{};         ///< its location in the parent, if it is given along axes other than the parent's
  listing<phrase> coordinates{}, speeds{}, kinematics{};
  const body_record* body = nullptr; ///< null if it has no mass
  const load_record* stops = nullptr;
  const phrase* rotor = nullptr; ///< its inertia and its gear ratio
  bool has_gear_ratio = false;
};

/// A joint whose frame and point have auxiliary speeds, which bring its reactions into evidence.
struct reaction_record {
  const joint_record* joint = nullptr;
  const frame_record* frame = nullptr;
  const frame_record* freed_frame = nullptr;
  const point_record* point = nullptr; ///< the location of the joint in the child
  const point_record* freed_point = nullptr;
  listing<phrase> speeds{};
  std::string_view called{};
};

} // namespace kanexpr::describe
