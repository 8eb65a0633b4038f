#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Declared vectors and scalars in the forms in which checks compare them: the symbols that they contain, and
/// their values at a generic state.
namespace kanexpr::mechanics::detail {

template <class Visit>
constexpr void each_entry(expression e, Visit&& visit) {
  visit(e);
}
template <class Visit>
constexpr void each_entry(const vector& v, Visit&& visit) {
  for (const vector::part& p : v.parts)
    for (int i = 0; i < 3; ++i) visit(p.value[i]);
}

template <class Value>
constexpr sequence<int> symbols_in(const Value& value, const contents& held,
                                   std::initializer_list<contents::kind> kinds) {
  sequence<int> nodes;
  each_entry(value, [&](expression e) {
    for (contents::kind k : kinds) held.collect(e, k, nodes);
  });
  return nodes;
}

constexpr bool are_among(const sequence<int>& some, const sequence<int>& all) {
  for (int node : some)
    if (!all.contains(node)) return false;
  return true;
}

/// Calls `visit` with the motion at a generic state, if one is found. `wanted` are the expressions to
/// evaluate.
template <class Visit>
constexpr void at_generic_motion(const mechanism& m, const contents& held, const sequence<expression>& wanted,
                                 const Visit& visit) {
  generic_motion motion(m, held, wanted);
  for (int tries = 0; tries < 6; ++tries) {
    motion.draw();
    if (motion.move(false) || motion.move_freely()) return visit(motion);
  }
}

/// Where a load acts: "at P", "between P and Q".
constexpr sentence place_of(const force& f, const load_check& by) {
  return f.against == none ? sentence({"at ", by.point(f.point)})
                           : sentence({"between ", by.both_points(f.point, f.against).view()});
}
constexpr sentence place_of(const torque& t, const load_check& by) {
  return t.against == none ? sentence({"on ", by.frame(t.frame)})
                           : sentence({"between ", by.both_frames(t.frame, t.against).view()});
}

} // namespace kanexpr::mechanics::detail
