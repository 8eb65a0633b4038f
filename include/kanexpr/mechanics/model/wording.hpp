#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Phrases for the error messages about a mechanism.
namespace kanexpr::mechanics {

using base::sentence;

constexpr std::string_view called(const mechanism& m, expression symbol) {
  return m.g->symbol_at(symbol.node()).called.view();
}

/// Returns, for example, "3 configuration constraints".
constexpr sentence several(int n, std::string_view one, std::string_view what = {}) {
  return sentence({base::counted(n).view(), " ", one, n == 1 ? "" : "s", what});
}

/// Returns the separator that precedes entry `i` in a list of `count` entries, as in "q1, q2 and q3".
constexpr std::string_view before_entry(int i, int count) {
  return i == 0 ? "" : i + 1 < count ? ", " : " and ";
}

/// Returns "q1", "q1 and q2" or "q1, q2 and q3", preceded by a noun in the singular or plural. A long list
/// names ten entries and gives the number of the others.
constexpr sentence enumerated(const mechanism& m, const sequence<expression>& symbols,
                              const sequence<int>& places, std::string_view noun = {}) {
  constexpr int most_named = 10;
  const int named = places.size() > most_named + 1 ? most_named : places.size();
  const int entries = named < places.size() ? named + 1 : named;
  sentence p = sentence({noun, noun.empty() ? "" : places.size() == 1 ? " " : "s "});
  for (int i = 0; i < named; ++i)
    p = sentence({p.view(), before_entry(i, entries), called(m, symbols[places[i]])});
  if (named == places.size()) return p;
  return sentence(
      {p.view(), before_entry(named, entries), base::counted(places.size() - named).view(), " others"});
}

/// Returns "configuration constraint 3 follows; add redundant<3> to drop it", with the verb given in the
/// singular and in the plural.
constexpr sentence dropping(const sequence<int>& numbers, std::string_view verb,
                            std::string_view verb_of_many) {
  const bool is_one = numbers.size() == 1;
  sentence named, listed; // "3, 4 and 5", and "3, 4, 5"
  for (int i = 0; i < numbers.size(); ++i) {
    const name number = base::counted(numbers[i]);
    named = sentence({named.view(), before_entry(i, numbers.size()), number.view()});
    listed = sentence({listed.view(), i == 0 ? "" : ", ", number.view()});
  }
  return sentence({"configuration constraint", is_one ? " " : "s ", named.view(),
                   is_one ? verb : verb_of_many, "; add redundant<", listed.view(), "> to drop ",
                   is_one ? "it" : "them"});
}

/// Whether a name is that of a state variable.
constexpr bool is_state_variable(const mechanism& m, std::string_view name) {
  for (int i = m.speeds_of_motion(); i < m.speeds.size(); ++i)
    if (called(m, m.speeds[i]) == name) return true;
  return false;
}

/// Returns "speed u1"; for Lagrange's method "rate of coordinate q1"; "state variable z".
constexpr sentence speed_called(const mechanism& m, std::string_view speed) {
  if (is_state_variable(m, speed)) return sentence({"state variable ", speed});
  if (m.derived_by == method::kane) return sentence({"speed ", speed});
  return sentence({"rate of coordinate ", speed.substr(0, speed.size() - 1)});
}

/// Returns "rate of speed u1"; for Lagrange's method "second derivative of coordinate q1"; "rate of state
/// variable z".
constexpr sentence speed_rate_called(const mechanism& m, std::string_view speed) {
  if (is_state_variable(m, speed)) return sentence({"rate of state variable ", speed});
  if (m.derived_by == method::kane) return sentence({"rate of speed ", speed});
  return sentence({"second derivative of coordinate ", speed.substr(0, speed.size() - 1)});
}

/// Returns "speeds u1 and u2"; for Lagrange's method "rates of coordinates q1 and q2".
constexpr sentence speeds_called(const mechanism& m, const sequence<int>& places) {
  if (m.derived_by == method::kane) return enumerated(m, m.speeds, places, "speed");
  return sentence({places.size() == 1 ? "rate of " : "rates of ",
                   enumerated(m, m.coordinates, places, "coordinate").view()});
}

/// Returns "speed"; for Lagrange's method "rate of a coordinate".
constexpr std::string_view a_speed(const mechanism& m) {
  return m.derived_by == method::kane ? "speed" : "rate of a coordinate";
}

} // namespace kanexpr::mechanics
