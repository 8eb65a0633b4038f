#pragma once

#include <kanexpr/derivation/reader.hpp>
#include <kanexpr/mechanics/check.hpp>

namespace kanexpr::derivation {

/// What is known of a system before anything is derived: its symbols in order, and its first mistake.
struct survey {
  static constexpr int room = 512;

  problem mistake;
  int coordinates = 0;
  int speeds = 0;
  int parameters = 0;
  int inputs = 0;
  symbolic::name names[room]{}; ///< coordinates, speeds, parameters, inputs

  constexpr int first_of(symbolic::symbol_kind kind) const {
    switch (kind) {
    case symbolic::symbol_kind::speed: return coordinates;
    case symbolic::symbol_kind::parameter: return coordinates + speeds;
    case symbolic::symbol_kind::input: return coordinates + speeds + parameters;
    default: return 0;
    }
  }
  constexpr int count_of(symbolic::symbol_kind kind) const {
    switch (kind) {
    case symbolic::symbol_kind::coordinate: return coordinates;
    case symbolic::symbol_kind::speed: return speeds;
    case symbolic::symbol_kind::parameter: return parameters;
    case symbolic::symbol_kind::input: return inputs;
    default: return 0;
    }
  }
  /// Place of a symbol among those of its kind, or -1.
  constexpr int place(symbolic::symbol_kind kind, const symbolic::name& called) const {
    for (int i = 0; i < count_of(kind); ++i)
      if (names[first_of(kind) + i] == called) return i;
    return -1;
  }
};

/// What a system is told that is not one of its words.
template <class Told>
constexpr problem check_word(std::string_view system) {
  if constexpr (describe::system_word<Told>)
    return {};
  else if constexpr (requires { Told::content(); })
    return sentence({"body ", type_name<Told>(), " stands among the words of ", system, "; write bodies<",
                     type_name<Told>(), ">"});
  else if constexpr (requires { Told::orientation(); })
    return sentence({"frame ", type_name<Told>(), " stands among the words of ", system, "; write inertial<",
                     type_name<Told>(), ">"});
  else if constexpr (requires {
                       Told::load.point->called;
                       Told::load.frame->called;
                     }) {
    const describe::load_record& l = Told::load;
    const bool force = l.point != nullptr, torque = l.frame != nullptr;
    return sentence({force    ? "the force at "
                     : torque ? "the torque on "
                              : "gravity",
                     force    ? l.point->called
                     : torque ? l.frame->called
                              : "",
                     " stands among the words of ", system, "; write loads<...> around it"});
  } else
    return sentence({type_name<Told>(), " is no word of a system, and ", system, " holds it"});
}

template <class... Words>
constexpr problem check_each_word(std::string_view system, const kane_system<Words...>*) {
  problem found;
  ((found = found ? found : check_word<Words>(system)), ...);
  return found;
}

/// A word that is missing, doubled or foreign.
template <class System>
constexpr problem check_words() {
  constexpr std::string_view called = type_name<System>();
  if constexpr (!requires { System::record; }) {
    return sentence({called, " is not a system; derive it from kane_system<...>"});
  } else {
    const problem foreign = check_each_word(called, static_cast<const System*>(nullptr));
    if (foreign) return foreign;
    for (std::string_view word : {"inertial", "coordinates", "speeds", "kinematics", "bodies"})
      if (System::times_told(word) == 0)
        return sentence({"the system ", called, " is told no ", word, "<...>"});
    for (std::string_view word : {"inertial", "coordinates", "speeds", "kinematics", "bodies", "loads",
                                  "parameters", "inputs", "values"})
      if (System::times_told(word) > 1)
        return sentence({"the system ", called, " is told ", word, "<...> twice; write one list"});
    return {};
  }
}

/// Everything that is known of a system without a derivation. With a mistake, what was known before it was
/// met.
template <class System>
constexpr survey survey_of() {
  survey s;
  s.mistake = check_words<System>();
  if constexpr (requires { System::record; }) {
    if (s.mistake) return s;
    graph g;
    mechanism m(g);
    reader r(System::record, m);
    r.read();
    s.mistake = r.mistake();
    if (!s.mistake) s.mistake = mechanics::check(m);
    int next = 0;
    for (const sequence<expression>* list : {&m.coordinates, &m.speeds, &m.parameters, &m.inputs})
      for (const expression& e : *list) {
        if (next < survey::room) s.names[next] = g.symbol_at(e.node()).called;
        ++next;
      }
    if (next > survey::room && !s.mistake)
      s.mistake = sentence({type_name<System>(), " has more than 512 symbols"});
    s.coordinates = m.coordinates.size();
    s.speeds = m.speeds.size();
    s.parameters = m.parameters.size();
    s.inputs = m.inputs.size();
  }
  return s;
}

} // namespace kanexpr::derivation
