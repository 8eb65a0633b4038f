#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/arguments.hpp>
#include <kanexpr/describe/functions.hpp>
#include <kanexpr/describe/misfit.hpp>
#include <kanexpr/describe/shape.hpp>
#include <kanexpr/describe/unparsed.hpp>
#include <kanexpr/describe/what_it_is.hpp>

/// What a model's entities are read from: plain constants that point at each other and at their expressions.
namespace kanexpr::describe {

/// An expression in static storage.
struct phrase {
  shape kind = shape::nothing;
  const token* tokens = nullptr;
  int size = 0;

  constexpr bool is_whole_zero() const {
    return size == 1 && tokens[0].what == token_kind::misused &&
           tokens[0].index == static_cast<int>(misuse::zero);
  }
};

template <int size>
constexpr shape shape_of(const scalar<size>&) {
  return shape::scalar;
}
template <int size>
constexpr shape shape_of(const vector<size>&) {
  return shape::vector;
}
template <int size>
constexpr shape shape_of(const dyadic<size>&) {
  return shape::dyadic;
}
template <int size>
constexpr shape shape_of(const equation<size>&) {
  return shape::equation;
}

template <class Written>
constexpr auto with_numbers_as_scalars(const Written& value) {
  if constexpr (plain_number<Written>)
    return number(value);
  else if constexpr (numeric::letter<Written>)
    return scalar<1>{{misused(misuse::letter)}};
  else
    return value;
}

namespace {
struct this_file;
}

/// Whether an expression mentions what only one source file knows.
template <auto value>
inline constexpr bool is_of_one_file = [] {
  if constexpr (requires { value.tokens[0].is_of_one_file; })
    for (const token& t : value.tokens)
      if (t.is_of_one_file) return true;
  return false;
}();

/// Two source files may each have entities of one name in an unnamed namespace. g++ does not look at what the
/// values of template arguments point at, so it would let the linker take one file's expressions for the
/// other's. A type that no other file has keeps them apart.
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

/// The phrase for any expression that a model gives as a template argument.
template <auto value, class Where = file_of<value>>
inline constexpr phrase phrase_of = stored<value, Where>::words;

inline constexpr phrase no_phrase = phrase_of<constant(0)>;

/// The phrases for the expressions that a word is given, and behind them zeros for those that it is not.
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

/// The same of values among which 0 is common, and which are checked in another way.
template <auto... values>
inline constexpr auto& given_phrases_with_zeros = given_phrases<with_zeros(values)...>;

/// A list of records in static storage.
template <class Record>
struct listing {
  const Record* const* entries = nullptr;
  int size = 0;
  constexpr const Record& operator[](int i) const { return *entries[i]; }
};

template <class Record, const Record*... entries>
struct list_of {
  static constexpr const Record* storage[sizeof...(entries) + 1]{entries..., nullptr};
  static constexpr listing<Record> all{storage, sizeof...(entries)};
};

enum class orientation_word : unsigned char;

struct frame_record {
  std::string_view called{};
  std::string_view calls_itself{}; ///< the first template argument of its orientation
  arguments fits{};
  bool unparsed = false;
  orientation_word orientation{}; ///< by default that of an inertial frame
  const frame_record* parent = nullptr;
  phrase given[9]{}; ///< angles, quaternion or matrix
  std::string_view given_as = "an angle of frame ";
  phrase axis{};
  char sequence[4]{}; ///< "zxz" or "313"
  const frame_record* reference = nullptr;
  phrase angular_velocity{};
  bool turns_apart = false;   ///< from its orientation
  std::string_view instead{}; ///< what it is, if it is not a frame
  std::string_view its_own{}; ///< the frame of that
  bool is_of_joint = false;
  misfit beside = misfit::none;

  constexpr bool is_inertial() const { return parent == nullptr; }
};

struct point_record {
  std::string_view called{};
  std::string_view calls_itself{};
  arguments fits{};
  bool unparsed = false;
  const point_record* parent = nullptr; ///< none: an origin
  const frame_record* origin_of = nullptr;
  phrase offset{};
  const frame_record* fixed_in = nullptr;
  const frame_record* reference = nullptr;
  phrase velocity{};
  bool moves_apart = false;   ///< from its position
  bool from_parent = false;   ///< the velocity, also where `reference` is the inertial frame
  std::string_view instead{}; ///< what it is, if it is not a point
  std::string_view its_own{}; ///< the point of that
  misfit beside = misfit::none;

  constexpr bool is_origin() const { return parent == nullptr; }
};

struct body_record {
  std::string_view called{};
  std::string_view calls_itself{};
  arguments fits{};
  bool rigid = false;
  const point_record* center = nullptr;
  const frame_record* frame = nullptr;
  phrase mass{};
  const frame_record* inertia_axes = nullptr; ///< of the six scalars
  phrase inertia[6]{};
  phrase inertia_dyadic{};
  const point_record* about = nullptr;
  std::string_view instead_of_inertia{}; ///< what takes its place and is none
  std::string_view instead{};            ///< what it is, if it is not a body
  bool has_whole_zeros = false;          ///< for all scalars of its inertia
  bool inertia_changes = false;
  bool effective = false; ///< the inertia need not be that of a distribution of mass
  misfit beside = misfit::none;
  bool unparsed = false;
};

/// What the values of a load mean; the words are in load.hpp.
enum class load_word : unsigned char;

struct load_record {
  load_word what{};
  std::string_view word{}; ///< "the force": for sentences, which go on with what it acts on
  arguments fits{};
  const point_record* point = nullptr;
  const point_record* other_point = nullptr; ///< of two points, or none
  const frame_record* frame = nullptr;
  const frame_record* other_frame = nullptr; ///< of two frames, or none
  phrase value{};                            ///< a force or torque, energy, stiffness or damping
  phrase angle{};                            ///< of a torsional spring
  phrase rest{};                             ///< the length or angle of a spring at rest
  phrase known_by{};                         ///< what it is known by, if not by points or frames
  std::string_view called{};
  std::string_view instead{}; ///< what it is, if it is not a load
  misfit beside = misfit::none;
  bool unparsed = false;
  bool once = false; ///< the same load again is a mistake
};

/// What a joint brings to a system beside its frame and its point.
struct joint_record {
  std::string_view called{};
  std::string_view calls_itself{};
  std::string_view mistake{}; ///< in its words: "is given two homes"
  std::string_view form{};    ///< how it is written, if that is the mistake
  const frame_record* frame = nullptr;
  const point_record* point = nullptr;
  const frame_record* home = nullptr; ///< the child's where all coordinates are zero
  const frame_record* parent_frame = nullptr;
  const point_record* parent_point = nullptr;
  listing<phrase> axes{}; ///< those that may be none
  phrase place{};         ///< in the parent, if it is given along other axes than the parent's
  listing<phrase> coordinates{}, speeds{}, kinematics{};
  const body_record* body = nullptr; ///< none: it has no mass
  std::string_view instead{};        ///< what it is, if it is not a joint
  misfit beside = misfit::none;
  bool unparsed = false;
};

/// A joint whose frame and point are given auxiliary speeds, which bring out what it carries.
struct reaction_record {
  const joint_record* joint = nullptr;
  const frame_record* frame = nullptr;
  const frame_record* freed_frame = nullptr;
  const point_record* point = nullptr; ///< where the joint sits in the child
  const point_record* freed_point = nullptr;
  listing<phrase> speeds{};
  std::string_view called{};
};

} // namespace kanexpr::describe
