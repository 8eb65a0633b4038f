#pragma once

#include <kanexpr/derive/read/load_wording.hpp>
#include <kanexpr/derive/read/symbol_reader.hpp>

/// Checks that a system has all required words and no others.
namespace kanexpr::deriving {

/// Reports a symbol in place of a list, such as `speed<u>` instead of `speeds<u>`.
constexpr sentence check_symbol_among_words(const describe::token& t, std::string_view system) {
  using symbolic::symbol_kind;
  const symbol_kind kind = t.symbol != nullptr ? t.symbol->kind : symbol_kind::time;
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

/// Checks for base classes next to a system or one of its words: `struct System : kane_system<…>, loads<…>`.
template <class Told>
constexpr sentence word_beside() {
  constexpr bool is_system = __is_base_of(describe::whole_systems, Told);
  if constexpr (__is_base_of(describe::load_words, Told)) {
    return sentence(
        {"a load is a separate base class of ", type_name<Told>(), "; list it in the system's loads<...>"});
  } else if constexpr (describe::has_word_beside<Told>()) {
    return sentence(
        {type_name<Told>(), " is described as a system and as part of a system; give each its own name"});
  } else if constexpr (is_system && __is_base_of(describe::system_words, Told)) {
    std::string_view word = "a word";
    if constexpr (requires { Told::word; }) word = Told::word;
    return sentence({word, word == "a word" ? "" : "<...>", " is a separate base class of ",
                     type_name<Told>(), "; list it among the words of the system, between its < >"});
  } else {
    return {};
  }
}

/// Checks that an argument of a system is one of its words.
template <class Told>
constexpr sentence check_word(std::string_view system) {
  if constexpr (describe::system_word<Told>)
    return word_beside<Told>();
  else if constexpr (requires { typename Told::extended_base; })
    return sentence({system, " extends ", type_name<typename Told::extended_base>(),
                     ", which is not a system; extended<System, ...> takes a system and the words to add"});
  else if constexpr (requires { Told::joint_told(); })
    return sentence({"joint ", type_name<Told>(), " is among the words of ", system, "; write joints<",
                     type_name<Told>(), ">"});
  else if constexpr (requires { Told::content(); })
    return sentence({"body ", type_name<Told>(), " is among the words of ", system, "; write bodies<",
                     type_name<Told>(), ">"});
  else if constexpr (std::derived_from<Told, scalar<1>>)
    return check_symbol_among_words(Told{}.tokens[0], system);
  else if constexpr (requires { Told::orientation(); })
    return sentence({"frame ", type_name<Told>(), " is among the words of ", system, "; write inertial<",
                     type_name<Told>(), ">"});
  else if constexpr (requires { Told::load.what; })
    return sentence(
        {name_of(Told::load).view(), " is among the words of ", system, "; list it in loads<...>"});
  else if constexpr (requires { Told::place(); })
    return sentence(
        {"point ", type_name<Told>(), " is among the words of ", system, "; points need not be listed"});
  else
    return sentence(
        {short_name(type_name<Told>()).view(), " is not a word of a system, but ", system, " lists it"});
}

template <describe::method by, class... Words>
constexpr sentence check_each_word(std::string_view system, const describe::system_told_by<by, Words...>*) {
  sentence found;
  ((found = found ? found : check_word<Words>(system)), ...);
  return found;
}

constexpr bool brings_body(const describe::listing<describe::joint_record>& joints) {
  for (int i = 0; i < joints.size; ++i)
    if (joints[i].body != nullptr || joints[i].calls_itself.empty() || !joints[i].mistake.empty())
      return true; // mistakes in loads are reported later
  return false;
}

constexpr bool lists_joint(const describe::listing<describe::body_record>& bodies) {
  for (int i = 0; i < bodies.size; ++i)
    if (bodies[i].instead == describe::joint_out_of_place) return true; // reported later
  return false;
}

/// Checks for words of one method in a system of the other, and for incompatible words.
template <class System>
constexpr sentence check_method(std::string_view called) {
  const bool bodies = System::times_told("bodies") != 0 || brings_body(System::record.joints),
             whole = System::times_told("lagrangian") != 0;
  if (System::record.derived_by == describe::method::kane) {
    if (whole)
      return sentence({"the system ", called, " has lagrangian<...>, which only a lagrange_system takes"});
    return {};
  }
  for (std::string_view word : {"speeds", "kinematics", "auxiliary", "reactions"})
    if (System::times_told(word) != 0)
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
constexpr sentence check_words() {
  constexpr std::string_view called = type_name<System>();
  if constexpr (describe::is_unparsed<System>()) {
    return sentence({called, " has no base class; derive it from kane_system<...> or lagrange_system<...>"});
  } else if constexpr (!requires { System::record; }) {
    if constexpr (!__is_base_of(describe::whole_systems, System))
      return sentence({called, " is not a system; derive it from kane_system<...> or lagrange_system<...>"});
    else if (describe::hides<describe::whole_systems>(static_cast<System*>(nullptr)))
      return sentence({called, " inherits privately; declare it as a struct"});
    else
      return sentence({called, " is derived from two systems; give each its own name"});
  } else {
    if (const sentence beside = word_beside<System>()) return beside;
    const sentence foreign = check_each_word(called, static_cast<const System*>(nullptr));
    if (foreign) return foreign;
    sentence found = check_method<System>(called);
    const auto needs = [&](std::initializer_list<std::string_view> words) {
      for (std::string_view word : words)
        if (!found && System::times_told(word) == 0)
          found = sentence({"the system ", called, " has no ", word, "<...>"});
    };
    needs({"inertial"});
    const bool is_kane = System::record.derived_by == describe::method::kane;
    if (lists_joint(System::record.bodies)) return found;
    if (System::times_told("joints") == 0) {
      needs({"coordinates"});
      if (is_kane) needs({"speeds", "kinematics", "bodies"});
    } else if (is_kane && !brings_body(System::record.joints)) {
      needs({"bodies"});
    }
    if (found) return found;
    for (std::string_view word :
         {"inertial", "coordinates", "speeds", "auxiliary", "kinematics", "configuration_constraints",
          "velocity_constraints", "acceleration_constraints", "dependent", "redundant", "bodies",
          "lagrangian", "loads", "joints", "reactions", "parameters", "inputs", "values", "used_elsewhere"})
      if (System::times_told(word) > 1)
        return sentence({"the system ", called, " lists ", word, "<...> twice; write one list"});
    return {};
  }
}

/// The words of a system, used both at compile time and at run time. If one of them is a mistake, the record
/// is empty.
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

} // namespace kanexpr::deriving
