#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/symbol_reader.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks that a system has all required words and no others.
namespace kanexpr::derivation {

/// Reports a symbol in place of a list, such as `speed<u>` instead of `speeds<u>`.
constexpr sentence check_symbol_among_words(const describe::token& t, std::string_view system) {
  using symbolic::symbol_kind;
  const symbol_kind kind = t.symbol != nullptr ? t.symbol->kind : symbol_kind::time;
  if (kind == symbol_kind::speed && t.symbol->order == describe::of_state_variable)
    return sentence(
        {"state_variable<...> is among the words of ", system, ", but is a symbol; the word is states<...>"});
  const std::string_view list = kind == symbol_kind::coordinate  ? "coordinates"
                                : kind == symbol_kind::speed     ? "speeds"
                                : kind == symbol_kind::parameter ? "parameters"
                                : kind == symbol_kind::input     ? "inputs"
                                                                 : "";
  if (list.empty()) return sentence({"an expression is among the words of ", system});
  const std::string_view one = list.substr(0, list.size() - 1);
  return sentence(
      {one, "<...> is among the words of ", system, ", but is a symbol; the word is ", list, "<...>"});
}

/// Checks for base classes in addition to a system or one of its words: `struct System : kane_system<…>,
/// loads<…>`.
template <class Type>
consteval sentence check_base_classes() {
  constexpr bool is_system = __is_base_of(describe::whole_systems, Type);
  if constexpr (__is_base_of(describe::load_words, Type)) {
    return sentence(
        {"a load is a separate base class of ", type_name<Type>(), "; list it in the system's loads<...>"});
  } else if constexpr (describe::has_misplaced_word<Type>()) {
    return sentence({type_name<Type>(),
                     " is described both as a system and as part of a system; give each its own name"});
  } else if constexpr (is_system && __is_base_of(describe::system_words, Type)) {
    std::string_view word = "a word";
    if constexpr (requires { Type::word; }) word = Type::word;
    return sentence({word, word == "a word" ? "" : "<...>", " is a separate base class of ",
                     type_name<Type>(), "; list it with the other words of the system, inside its < >"});
  } else {
    return {};
  }
}

/// Returns the kind of an entity among the words of a system, and the hint that follows; {} for other types.
struct kind_and_hint {
  std::string_view kind, hint, end = "";
};
template <class Type>
consteval kind_and_hint kind_of_misplaced() {
  if constexpr (requires { Type::joint_description(); })
    return {"joint ", "; write joints<", ">"};
  else if constexpr (requires { Type::content(); })
    return {"body ", "; write bodies<", ">"};
  else if constexpr (requires { Type::block.dynamics; })
    return {"block ", "; write blocks<", ">"};
  else if constexpr (requires { Type::orientation(); })
    return {"frame ", "; write inertial<", ">"};
  else if constexpr (requires { Type::place(); })
    return {"point ", "; points need not be listed"};
  else
    return {};
}

/// Checks that an argument of a system is one of its words.
template <class Type>
consteval sentence check_word(std::string_view system) {
  constexpr kind_and_hint entity = kind_of_misplaced<Type>();
  if constexpr (describe::system_word<Type>)
    return check_base_classes<Type>();
  else if constexpr (requires { typename Type::extended_base; })
    return sentence({system, " extends ", type_name<typename Type::extended_base>(),
                     ", which is not a system; extended<System, ...> takes a system and the words to add"});
  else if constexpr (std::derived_from<Type, scalar<1>>)
    return check_symbol_among_words(Type{}.tokens[0], system);
  else if constexpr (!entity.kind.empty())
    return sentence({entity.kind, type_name<Type>(), " is among the words of ", system, entity.hint,
                     entity.end.empty() ? "" : type_name<Type>(), entity.end});
  else if constexpr (requires { Type::load.what; })
    return sentence(
        {name_of(Type::load).view(), " is among the words of ", system, "; list it in loads<...>"});
  else
    return sentence(
        {short_name(type_name<Type>()).view(), " is not a word of a system, but ", system, " lists it"});
}

template <describe::method by, class... Words>
consteval sentence check_each_word(std::string_view system, const describe::system_of_words<by, Words...>*) {
  sentence found;
  ((found = found ? found : check_word<Words>(system)), ...);
  return found;
}

constexpr bool brings_body(const describe::listing<describe::joint_record>& joints) {
  for (const describe::joint_record& r : joints)
    if (r.body != nullptr || r.declared_name.empty() || !r.mistake.empty())
      return true; // mistakes in joints are reported later
  return false;
}

constexpr bool has_deforming_body(const describe::listing<describe::body_record>& bodies) {
  for (const describe::body_record& r : bodies)
    if (r.beam != nullptr || r.flexible != nullptr) return true;
  return false;
}

/// Whether a point is placed on a body that deforms. Points that are offset from themselves are reported
/// later; a second pointer at half the speed notices them.
constexpr bool is_on_deforming_body(const describe::point_record* p) {
  const describe::point_record* behind = p;
  for (bool follows = false; p != nullptr; follows = !follows) {
    if (p->on_beam != nullptr || p->on_flexible != nullptr) return true;
    p = p->parent;
    if (p == behind) return false;
    if (follows) behind = behind->parent;
  }
  return false;
}

/// Whether a body is placed on a body that deforms, which must be listed too.
constexpr bool is_on_deforming_body(const describe::listing<describe::body_record>& bodies) {
  for (const describe::body_record& r : bodies)
    if (is_on_deforming_body(r.center)) return true;
  return false;
}

constexpr bool lists_joint(const describe::listing<describe::body_record>& bodies) {
  for (const describe::body_record& r : bodies)
    if (r.instead == describe::joint_out_of_place) return true; // reported later
  return false;
}

/// Checks for words that belong to the other method, and for incompatible words.
template <class System>
consteval sentence check_method(std::string_view called) {
  const bool bodies =
                 describe::count_of_word(System::words, "bodies") != 0 || brings_body(System::record.joints),
             whole = describe::count_of_word(System::words, "lagrangian") != 0;
  if (System::record.derived_by == describe::method::kane) {
    if (whole)
      return sentence({"the system ", called, " has lagrangian<...>, which only a lagrange_system takes"});
    return {};
  }
  for (std::string_view word : {"speeds", "kinematics", "auxiliary", "reactions"})
    if (describe::count_of_word(System::words, word) != 0)
      return sentence({"the system ", called, " has ", word,
                       "<...>; the only speeds of a lagrange_system are the rates of its coordinates"});
  if (bodies && whole)
    return sentence({"the system ", called,
                     " has bodies<...> and lagrangian<...>; a Lagrangian contains the energy of all bodies"});
  if (!bodies && !whole)
    return sentence({"the system ", called, " has neither bodies<...> nor lagrangian<...>"});
  return {};
}

/// Checks for missing, repeated and unknown words.
template <class System>
consteval sentence check_words() {
  constexpr std::string_view called = type_name<System>();
  if constexpr (describe::is_unparsed<System>()) {
    return sentence({called, " has no base class; derive it from kane_system<...> or lagrange_system<...>"});
  } else if constexpr (!requires { System::record; }) {
    if constexpr (!__is_base_of(describe::whole_systems, System))
      return sentence({called, " is not a system; derive it from kane_system<...> or lagrange_system<...>"});
    else if (describe::inherits_privately<describe::whole_systems>(static_cast<System*>(nullptr)))
      return sentence({called, " inherits privately; declare it as a struct"});
    else
      return sentence({called, " is derived from two systems; define a separate struct for each"});
  } else {
    if (const sentence conflict = check_base_classes<System>()) return conflict;
    const sentence foreign = check_each_word(called, static_cast<const System*>(nullptr));
    if (foreign) return foreign;
    sentence found = check_method<System>(called);
    const auto needs = [&](std::initializer_list<std::string_view> words) {
      for (std::string_view word : words)
        if (!found && describe::count_of_word(System::words, word) == 0)
          found = sentence({"the system ", called, " has no ", word, "<...>"});
    };
    needs({"inertial"});
    const bool is_kane = System::record.derived_by == describe::method::kane;
    if (lists_joint(System::record.bodies)) return found;
    if (has_deforming_body(System::record.bodies) || is_on_deforming_body(System::record.bodies)) {
      // brings symbols and their kinematic equations
    } else if (describe::count_of_word(System::words, "joints") == 0) {
      needs({"coordinates"});
      if (is_kane) needs({"speeds", "kinematics", "bodies"});
    } else if (is_kane && !brings_body(System::record.joints)) {
      needs({"bodies"});
    }
    if (found) return found;
    const auto once = [&](std::initializer_list<std::string_view> words) {
      for (std::string_view word : words)
        if (!found && describe::count_of_word(System::words, word) > 1)
          found = sentence({"the system ", called, " lists ", word, "<...> twice; write one list"});
    };
    once({"inertial", "coordinates", "speeds", "auxiliary", "kinematics", "configuration_constraints",
          "velocity_constraints", "acceleration_constraints", "dependent", "redundant", "bodies",
          "lagrangian", "loads", "joints", "reactions", "parameters", "inputs", "values", "used_elsewhere"});
    if (System::record.states.size + System::record.dynamics.size + System::record.blocks.size != 0)
      once({"states", "dynamics", "blocks"}); // counting takes long
    if (System::record.formulation != nullptr) once({"formulation"});
    return found;
  }
}

/// The words of a system, used both at compile time and at run time. If one of them is invalid, the record is
/// empty.
struct checked_words {
  sentence mistake{};
  describe::system_record record{};
};

template <class System>
inline constexpr checked_words words_of = [] {
  checked_words words{.mistake = check_words<System>()};
  if constexpr (requires { System::record; })
    if (!words.mistake) words.record = System::record;
  return words;
}();

} // namespace kanexpr::derivation
