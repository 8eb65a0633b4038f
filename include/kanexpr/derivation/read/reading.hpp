#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

using std::string_view_literals::operator""sv; // compilers need not count the letters

using base::sentence;
using base::sequence;
using describe::point_record;
using describe::system_record;
using mechanics::mechanism;
using mechanics::none;
using symbolic::expression;

/// The state shared by all readers of a model: its records, the system that is built, the current position
/// and the first mistake.
struct reading {
  const system_record& from;
  mechanics::multibody_system& into;
  mechanics::known_motion* known = nullptr; ///< null while frames and points are read
  std::string_view part{}; ///< the part of an entity that is being read: "the offset of point "
  const describe::frame_record* parent = nullptr; ///< the parent of the frame whose orientation is being read
  int describing = none;                          ///< the frame that `own` denotes
  bool is_on_surface = false;                     ///< whether the coordinates of a surface may occur
  bool for_units = false;    ///< whether the model is read to infer units (units_of_motion.hpp)
  bool states_units = false; ///< whether any symbol has a stated or implied unit
  bool checks_units = false; ///< whether any symbol has a stated unit
  /// Whether something was read that has a different value if the model is read to infer units: a number in
  /// place of a symbol, or a motion.
  bool hides_units = false;
  sentence mistake{};
  /// Whether the compiler has already reported an error about the type that contains the mistake.
  bool follows_from_unparsed = false;

  constexpr reading(const system_record& records, mechanics::multibody_system& system)
      : from(records), into(system) {}

  /// Registers the unit that the model states for a symbol.
  constexpr void state_unit(const mechanics::stated_unit& s) {
    states_units = true;
    if (!s.is_implied) checks_units = true;
    if (mistake) return;
    sequence<mechanics::stated_unit>& all = into.mechanism.stated_units;
    const int id = s.symbol.node();
    mechanics::stated_unit* const before = all.begin(); // compilers interpret every call to operator[]
    for (int i = all.size() - 1; i >= 0; --i)
      if (before[i].symbol.node() == id && before[i].unit == s.unit) {
        if (!s.is_implied) before[i].is_implied = false;
        return;
      }
    all.push(s);
  }

  /// True for Lagrange's method.
  constexpr bool takes_rates_as_speeds() const { return from.derived_by == describe::method::lagrange; }

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake) mistake = sentence(pieces);
  }

  constexpr void fail_by_unparsed(std::string_view called, std::string_view whom) {
    if (!mistake) follows_from_unparsed = true;
    fail({called, ", which ", whom, " uses, has no base class"});
  }

  /// Checks that an entity has no word twice and no word of a different kind of entity.
  constexpr bool check_base_conflict(describe::base_conflict conflict, std::string_view called) {
    if (conflict == nullptr) return true;
    const std::string_view text = conflict;
    const std::size_t first = text.find('@'), second = text.find('@', first + 1);
    const std::string_view rest = text.substr(first + 1, second - first - 1);
    if (second == std::string_view::npos)
      fail({text.substr(0, first), called, rest});
    else
      fail({text.substr(0, first), called, rest, called, text.substr(second + 1)});
    return false;
  }

  /// Reports an entity that passes a different entity's name where its own belongs, and would define that
  /// entity a second time: `struct B : rotated<A, ...>`.
  constexpr void fail_by_self(std::string_view kind, std::string_view called, std::string_view other) {
    fail({kind, " ", called, " names itself ", other, "; the first template argument of its base must be ",
          called});
  }
  constexpr void fail_by_argument_count(std::string_view kind, std::string_view called,
                                        const describe::arguments& has) {
    fail({kind, called, has.missing > 0 ? " lacks an argument" : " has too many arguments", "; write ",
          has.form});
  }
};

} // namespace kanexpr::derivation
