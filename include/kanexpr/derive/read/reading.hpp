#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derive/read/misfit_wording.hpp>
#include <kanexpr/derive/read/wording.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>

namespace kanexpr::deriving {

using describe::point_record;
using describe::system_record;
using mechanics::mechanism;
using mechanics::none;
using mechanics::sentence;
using symbolic::expression;
using symbolic::sequence;

/// What all readers of one model share: its records, the system that they become, where the reading is, and
/// its first mistake.
struct reading {
  const system_record& from;
  mechanics::multibody_system& into;
  mechanics::known_motion* known = nullptr; ///< null while frames and points are read
  std::string_view part{};                  ///< of an entity, that is being read: "the offset of point "
  const describe::frame_record* parent = nullptr; ///< of the frame whose orientation is read
  int describing = none;                          ///< the frame whose own axes `own` means
  sentence mistake{};
  bool follows_from_unparsed = false; ///< the mistake, of which the compiler has reported one already

  constexpr reading(const system_record& records, mechanics::multibody_system& system)
      : from(records), into(system) {}

  /// Of Lagrange's method.
  constexpr bool takes_rates_as_speeds() const { return from.derived_by == describe::method::lagrange; }

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake) mistake = sentence(pieces);
  }

  constexpr void fail_by_unparsed(std::string_view called, std::string_view whom) {
    if (!mistake) follows_from_unparsed = true;
    fail({called, ", which ", whom, " uses, is derived from nothing"});
  }

  /// Whether an entity has no word twice, and only words that belong to it.
  constexpr bool words_belong(describe::misfit beside, std::string_view called) {
    if (beside == describe::misfit::none) return true;
    fail({misfit_of(beside, called).view()});
    return false;
  }

  /// `struct B : rotated<A, ...>` would be a second A.
  constexpr void slip(std::string_view kind, std::string_view called, std::string_view other) {
    fail({kind, called, " calls itself ", other, "; the first argument of what it is derived from must be ",
          called});
  }
  constexpr void wrong_count(std::string_view kind, std::string_view called, const describe::arguments& has) {
    fail({kind, called, has.missing > 0 ? " lacks an argument" : " has an argument too many", "; write ",
          has.form});
  }
};

} // namespace kanexpr::deriving
