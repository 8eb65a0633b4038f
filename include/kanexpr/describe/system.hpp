#pragma once

#include <kanexpr/describe/body.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/symbol.hpp>

#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>

#include <string_view>

namespace kanexpr {

namespace describe {

struct formulation_record;

/// How the equations of motion are derived.
enum class method : unsigned char { kane, lagrange };

struct system_record {
  method derived_by = method::kane;
  const frame_record* inertial = nullptr;
  listing<phrase> coordinates{}, speeds{}, parameters{}, inputs{};
  listing<phrase> added_inputs{}; ///< in a model without a list of inputs, they follow those that it mentions
  listing<phrase> kinematics{};
  listing<phrase> states{}, dynamics{};
  listing<phrase> configuration_constraints{}, velocity_constraints{}, acceleration_constraints{};
  listing<phrase> dependent{}, auxiliary{};
  listing<int> redundant{}; ///< numbers of configuration constraints
  listing<phrase> values{};
  listing<phrase> used_elsewhere{}; ///< parameters and inputs
  listing<phrase> lagrangian{};
  listing<body_record> bodies{};
  listing<load_record> loads{};
  listing<block_record> blocks{};
  listing<joint_record> joints{};
  listing<reaction_record> reactions{};
  const formulation_record* formulation = nullptr; ///< null if the library chooses it
};

/// A word of a system.
template <class Word>
concept system_word = requires(system_record& r) { Word::add_to(r); };

/// A word without its type, so that what handles all words of a system is instantiated for their number only.
/// Functions that depend on the words themselves are consteval where possible: compilers form the symbol
/// names of all others, which contain every expression of a list.
struct word_record {
  std::string_view word{};
  void (*add_to)(system_record&) = nullptr;
};

template <class Word>
consteval word_record record_word() {
  if constexpr (system_word<Word>)
    return {Word::word, &Word::add_to};
  else
    return {};
}

template <class... Records>
constexpr int count_of_word(const boost::hana::tuple<Records...>& words, std::string_view wanted) {
  int times = 0;
  boost::hana::for_each(words, [&](const word_record& each) {
    if (each.word == wanted) ++times;
  });
  return times;
}

template <class... Records>
constexpr system_record record_system(method derived_by, const boost::hana::tuple<Records...>& words) {
  system_record r;
  r.derived_by = derived_by;
  boost::hana::for_each(words, [&](const word_record& each) {
    if (each.add_to != nullptr) each.add_to(r);
  });
  return r;
}

/// A word that lists expressions in a member of the record.
template <text called, listing<phrase> system_record::* list, auto... expressions>
struct phrase_list : system_words {
  static constexpr std::string_view word = called.view();
  static constexpr void add_to(system_record& r) {
    r.*list = list_of<phrase, &phrase_of<expressions>...>::all;
  }
};

} // namespace describe

/// The inertial frame.
template <class... Frame>
struct inertial : describe::system_words {
  static constexpr std::string_view word = "inertial";
  static constexpr void add_to(describe::system_record& r) {
    const describe::frame_record* const frames[]{&describe::frame_of<Frame>..., nullptr};
    if constexpr (sizeof...(Frame) == 1) r.inertial = frames[0];
  }
};

/// The generalized coordinates, in the order of the state.
template <auto... symbols>
struct coordinates : describe::phrase_list<"coordinates", &describe::system_record::coordinates, symbols...> {
};

/// The generalized speeds, in the order of the state; they follow the coordinates.
template <auto... symbols>
struct speeds : describe::phrase_list<"speeds", &describe::system_record::speeds, symbols...> {};

/// The state variables, which follow the speeds in the state.
template <auto... symbols>
struct states : describe::phrase_list<"states", &describe::system_record::states, symbols...> {};

/// An equation for the rate of each state variable, which must be linear in this rate:
/// `dynamics<L * dot(i) == V - R * i - k * u>`. The rates may depend on everything except the rates of the
/// speeds.
template <auto... equations>
struct dynamics : describe::phrase_list<"dynamics", &describe::system_record::dynamics, equations...> {};

/// The order of the parameter vector; by default, the order of first mention in the model.
template <auto... symbols>
struct parameters : describe::phrase_list<"parameters", &describe::system_record::parameters, symbols...> {};

/// The order of the input vector; by default, the order of first mention in the model.
template <auto... symbols>
struct inputs : describe::phrase_list<"inputs", &describe::system_record::inputs, symbols...> {};

/// Parameters and inputs that appear only in expressions evaluated later, such as outputs and pictures:
/// `used_elsewhere<k, F>`. Any other symbol that is listed but not used in the system is a mistake.
template <auto... symbols>
struct used_elsewhere
    : describe::phrase_list<"used_elsewhere", &describe::system_record::used_elsewhere, symbols...> {};

/// The kinematic differential equations, in any form that is linear in the rates: `dot(q1) == u1`.
template <auto... equations>
struct kinematics : describe::phrase_list<"kinematics", &describe::system_record::kinematics, equations...> {
};

/// Parameters bound to numbers, which are folded into the derivation: `values<m == 2.2, r == 0.45>`.
template <auto... equations>
struct values : describe::phrase_list<"values", &describe::system_record::values, equations...> {};

/// The Lagrangian as an expression of coordinates, their rates, parameters, inputs and time, which replaces
/// the bodies: `lagrangian<m * l * l * dot(q) * dot(q) / 2 + m * g * l * cos(q)>`.
template <auto... scalar>
struct lagrangian : describe::system_words {
  static constexpr std::string_view word = "lagrangian";
  static constexpr void add_to(describe::system_record& r) {
    if constexpr (sizeof...(scalar) == 0)
      r.lagrangian = describe::list_of<describe::phrase, &describe::phrase_of<nullptr>>::all;
    else
      r.lagrangian = describe::list_of<describe::phrase, &describe::phrase_of<scalar>...>::all;
  }
};

/// Every particle and rigid body of the system.
template <class... Bodies>
struct bodies : describe::system_words {
  static constexpr std::string_view word = "bodies";
  static constexpr void add_to(describe::system_record& r) {
    r.bodies = describe::list_of<describe::body_record, &describe::body_of<Bodies>...>::all;
  }
};

/// Every force, torque and field that does work.
template <class... Loads>
struct loads : describe::system_words {
  static constexpr std::string_view word = "loads";
  static constexpr void add_to(describe::system_record& r) {
    r.loads = describe::list_of<describe::load_record, &describe::load_of<Loads>...>::all;
  }
};

namespace describe {

template <class Block>
constexpr block_record record_block() {
  if constexpr (requires { Block::block.dynamics; }) {
    return Block::block;
  } else {
    block_record r;
    r.called = type_name<Block>();
    r.instead = describe_kind<Block>().empty() ? "not a block" : describe_kind<Block>();
    r.unparsed = is_unparsed<Block>();
    return r;
  }
}

template <class Block>
inline constexpr block_record block_of = record_block<Block>();

} // namespace describe

/// Filters, delays and controllers, which have state variables of their own (`<kanexpr/blocks.hpp>`).
template <class... Blocks>
struct blocks : describe::system_words {
  static constexpr std::string_view word = "blocks";
  static constexpr void add_to(describe::system_record& r) {
    r.blocks = describe::list_of<describe::block_record, &describe::block_of<Blocks>...>::all;
  }
};

namespace describe {

/// A system, with its words in any order.
template <method derived_by, class... Words>
struct system_of_words : whole_systems {
  static constexpr auto words = boost::hana::make_tuple(record_word<Words>()...);
  static constexpr system_record record = record_system(derived_by, words);
};

} // namespace describe

/// A system whose equations of motion are derived by Kane's method, with its words in any order: `struct
/// System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};`
template <class... Words>
struct kane_system : describe::system_of_words<describe::method::kane, Words...> {};

/// A system whose equations of motion are derived by Lagrange's method, with its words in any order: `struct
/// System : lagrange_system<inertial<N>, coordinates<q>, bodies<Bob>, loads<gravity<g * N::x>>> {};` The
/// rates of the coordinates replace the speeds and are part of the state, [q; dq/dt].
template <class... Words>
struct lagrange_system : describe::system_of_words<describe::method::lagrange, Words...> {};

} // namespace kanexpr
