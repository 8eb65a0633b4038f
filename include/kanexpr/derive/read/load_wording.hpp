#pragma once

#include <kanexpr/base/problem.hpp>
#include <kanexpr/derive/read/wording.hpp>

namespace kanexpr::derivation {

using describe::load_record;

/// "the force at P", "the spring between P and Q", for sentences about a load.
constexpr mechanics::problem name_of(const load_record& r) {
  using describe::load_word;
  const auto between = [&](std::string_view what) {
    if (r.point != nullptr)
      return mechanics::sentence({what, " between ", r.point->called, " and ", r.other_point->called});
    return mechanics::sentence({what, " between ", r.frame->called, " and ", r.other_frame->called});
  };
  const auto with = [](std::string_view what, const phrase& p) {
    const std::string_view held = name_in(p);
    return mechanics::sentence({what, held.empty() ? "" : " with ", held});
  };
  switch (r.what) {
  case load_word::force:
    if (r.other_point != nullptr) return between("the force");
    return mechanics::sentence({"the force at ", r.point->called});
  case load_word::torque:
    if (r.other_frame != nullptr) return between("the torque");
    return mechanics::sentence({"the torque on ", r.frame->called});
  case load_word::gravity: return mechanics::sentence({"gravity"});
  case load_word::potential_energy: return with("the potential energy", r.value);
  case load_word::spring: return between("the spring");
  case load_word::damper: return between("the damper");
  case load_word::torsional_spring: return with("the torsional spring", r.angle);
  case load_word::torsional_damper: return between("the torsional damper");
  case load_word::none: break;
  }
  return mechanics::sentence({r.called});
}

} // namespace kanexpr::derivation
