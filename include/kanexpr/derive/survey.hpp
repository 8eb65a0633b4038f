#pragma once

#include <kanexpr/derive/reader.hpp>
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

/// A word that is missing, doubled or misspelt.
template <class System>
constexpr problem check_words() {
  for (std::string_view word : {"inertial", "coordinates", "speeds", "kinematics", "bodies"})
    if (System::times_told(word) == 0) return sentence({"the system says nothing about ", word, "<…>"});
  for (std::string_view word :
       {"inertial", "coordinates", "speeds", "kinematics", "bodies", "loads", "parameters", "inputs", "values"})
    if (System::times_told(word) > 1) return sentence({"the system says ", word, "<…> twice"});
  return {};
}

template <class System>
constexpr survey survey_of() {
  survey s;
  s.mistake = check_words<System>();
  if (s.mistake) return s;
  graph g;
  mechanism m(g);
  reader r(System::record, m);
  r.read();
  s.mistake = r.mistake();
  if (!s.mistake) s.mistake = mechanics::check(m);
  if (s.mistake) return s;
  int next = 0;
  for (const sequence<expression>* list : {&m.coordinates, &m.speeds, &m.parameters, &m.inputs})
    for (const expression& e : *list)
      if (next < survey::room) s.names[next++] = g.symbol_at(e.node()).called;
  s.coordinates = m.coordinates.size();
  s.speeds = m.speeds.size();
  s.parameters = m.parameters.size();
  s.inputs = m.inputs.size();
  return s;
}

} // namespace kanexpr::derivation
