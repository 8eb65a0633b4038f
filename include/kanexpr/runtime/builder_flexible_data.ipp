#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/add_flexible_body.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/flexible_expressions.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::runtime {

namespace detail {

/// A mistake in the numbers of a body; an empty message if there is none.
inline sentence mistake_in(const mechanics::flexible_data& data, std::string_view body) {
  if (!data.is_complete())
    return sentence({"the numbers of ", body,
                     " are incomplete: a list has a length that does not fit the number of amplitudes, or a "
                     "term the index of no amplitude"});
  bool finite = true;
  const auto inspect = [&](const base::sequence<double>& numbers) {
    for (const double each : numbers) finite = finite && each - each <= 0;
  };
  for (const base::sequence<double>* each : {&data.stiffness, &data.damping, &data.preload}) inspect(*each);
  for (const mechanics::elastic_term& t : data.elastic_terms)
    finite = finite && t.coefficient - t.coefficient <= 0;
  for (const mechanics::damping_term& t : data.damping_terms)
    finite = finite && t.coefficient - t.coefficient <= 0;
  for (const mechanics::flexible_node& n : data.nodes) {
    if (!n.is_complete(data.amplitudes))
      return sentence({"node ", n.called.view(), " of ", body,
                       " is incomplete: a list has a length that does not fit the number of amplitudes"});
    inspect(n.position.coefficients), inspect(n.orientation), inspect(n.rotation), inspect(n.second_rotation);
  }
  return finite ? sentence() : sentence({body, " contains a number that is not finite"});
}

} // namespace detail

KANEXPR_ENGINE flexible_body_id builder::flexible_body(std::string_view called, point_id reference,
                                                       frame_id frame,
                                                       const std::vector<expression>& amplitudes,
                                                       const mechanics::flexible_data& data) {
  if (!is_new_body(called)) return flexible_body_id{-1};
  if (data.amplitudes < 1) {
    checks_.fail({"flexible body ", called, " has ", base::counted(data.amplitudes).view(),
                  " amplitudes; expected at least 1"});
    return flexible_body_id{-1};
  }
  if (static_cast<int>(amplitudes.size()) != data.amplitudes) {
    checks_.fail({"expected ", base::counted(data.amplitudes).view(), " amplitudes of ", called, ", got ",
                  base::counted(static_cast<int>(amplitudes.size())).view()});
    return flexible_body_id{-1};
  }
  if (const sentence found = detail::mistake_in(data, called)) {
    checks_.fail({found.view()});
    return flexible_body_id{-1};
  }
  base::sequence<expression> q;
  for (const expression& each : amplitudes) q.push(each);
  if (!checks_.owns(called, frame, reference, q)) return flexible_body_id{-1};
  const mechanics::flexible_expressions of(data, q);
  const mechanics::flexible_body b = of.body(called, place(frame), place(reference));
  if (!owns_flexible_body(b) || !has_elasticity(called, q, of.stiffness(), of.damping()))
    return flexible_body_id{-1};
  mechanics::add_flexible_body(m_, system_.loads, b, of);
  bodies_with_data_.push_back({b, data});
  return flexible_body_id{static_cast<int>(bodies_with_data_.size()) - 1};
}

KANEXPR_ENGINE section_ids builder::node(std::string_view called, flexible_body_id of,
                                         std::string_view node) {
  const auto place_of_body = static_cast<std::size_t>(of);
  if (place_of_body >= bodies_with_data_.size()) {
    checks_.fail({"node ", called, " belongs to a flexible body of a different builder, or to none"});
    return {};
  }
  const body_with_data& on = bodies_with_data_[place_of_body];
  for (const mechanics::flexible_node& each : on.data.nodes) {
    if (each.called.view() != node) continue;
    const mechanics::flexible_expressions expressions(on.data, on.body.amplitudes);
    const mechanics::components r = expressions.position(each), s = expressions.turn(each);
    const mechanics::matrix3 cosines = expressions.orientation(each);
    const frame_id axes{on.body.frame};
    section_ids made;
    made.point = offset(called, point_id{on.body.reference}, along(axes, r.x, r.y, r.z));
    const std::string turned = std::string(called) + (cosines.is_identity() ? "" : "_turned");
    made.frame = modified_rodrigues(turned, axes, s.x, s.y, s.z);
    if (!cosines.is_identity()) made.frame = direction_cosines(called, made.frame, cosines);
    return made;
  }
  checks_.fail({"flexible body ", on.body.called.view(), " has no node ", node});
  return {};
}

} // namespace kanexpr::runtime
