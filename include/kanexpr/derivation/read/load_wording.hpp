#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/wording.hpp>

#include <string_view>

namespace kanexpr::derivation {

using describe::load_record;

/// Returns the subject of sentences about a load: "the force at P", "the spring between P and Q", "the
/// potential energy with q1".
constexpr base::sentence name_of(const load_record& r) {
  if (r.other_point != nullptr)
    return base::sentence({r.word, " between ", r.point->called, " and ", r.other_point->called});
  if (r.point != nullptr) return base::sentence({r.word, " at ", r.point->called});
  if (r.other_frame != nullptr)
    return base::sentence({r.word, " between ", r.frame->called, " and ", r.other_frame->called});
  if (r.frame != nullptr) return base::sentence({r.word, " on ", r.frame->called});
  const std::string_view held = name_in(r.known_by);
  return base::sentence({r.word.empty() ? r.called : r.word, held.empty() ? "" : " with ", held});
}

} // namespace kanexpr::derivation
