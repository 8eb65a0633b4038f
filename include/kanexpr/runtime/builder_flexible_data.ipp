#pragma once

#include <kanexpr/base/name.hpp>
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

KANEXPR_ENGINE void builder::flexible_body(std::string_view called, point_id reference, frame_id frame,
                                           const std::vector<expression>& amplitudes,
                                           const mechanics::flexible_data& data) {
  if (!checks_.is_new("bodies", called, m_.bodies) || !checks_.is_new("bodies", called, m_.flexible_bodies))
    return;
  if (amplitudes.empty() || static_cast<int>(amplitudes.size()) != data.amplitudes) {
    checks_.fail({"expected ", base::counted(data.amplitudes).view(), " amplitudes of ", called, ", got ",
                  base::counted(static_cast<int>(amplitudes.size())).view()});
    return;
  }
  base::sequence<expression> q;
  for (const expression& each : amplitudes) q.push(each);
  if (!checks_.owns(called, frame, reference, q)) return;
  const mechanics::flexible_expressions of(data, q);
  const mechanics::flexible_body b = of.body(called, place(frame), place(reference));
  if (!owns_flexible_body(b)) return;
  mechanics::add_flexible_body(m_, system_.loads, b, of);
  data_of_bodies_.emplace_back(std::string(called), data);
}

/// Appends the number of a shape, unless it is the only one, and the name of the body.
KANEXPR_ENGINE std::string builder::name_of_amplitude(char letter, int k, int of, std::string_view body) {
  return std::string(1, letter) + (of == 1 ? "" : std::to_string(k + 1)) + "_" + std::string(body);
}

KANEXPR_ENGINE std::vector<symbolic::expression>
builder::flexible_body(std::string_view called, point_id reference, frame_id frame,
                       const mechanics::flexible_data& data) {
  std::vector<expression> amplitudes;
  for (int k = 0; k < data.amplitudes; ++k) {
    amplitudes.push_back(coordinate(name_of_amplitude('q', k, data.amplitudes, called)));
    const bool is_rate = m_.derived_by == mechanics::method::lagrange;
    const std::string rate = is_rate ? name_of_amplitude('q', k, data.amplitudes, called) + "'"
                                     : name_of_amplitude('u', k, data.amplitudes, called);
    kinematic_equation(dot(amplitudes.back()) - speed(rate));
  }
  flexible_body(called, reference, frame, amplitudes, data);
  return amplitudes;
}

KANEXPR_ENGINE builder::attachment builder::node(std::string_view called, std::string_view body,
                                                 std::string_view node) {
  for (const auto& [name, data] : data_of_bodies_) {
    if (name != body) continue;
    for (const mechanics::flexible_node& each : data.nodes)
      if (each.called.view() == node) return attach(called, body, data, each);
    checks_.fail({"body ", body, " has no node ", node});
    return {};
  }
  checks_.fail({"there is no flexible body ", body, " with nodes"});
  return {};
}

KANEXPR_ENGINE builder::attachment builder::attach(std::string_view called, std::string_view body,
                                                   const mechanics::flexible_data& data,
                                                   const mechanics::flexible_node& node) {
  for (const mechanics::flexible_body& b : m_.flexible_bodies) {
    if (b.called.view() != body) continue;
    const mechanics::flexible_body found = b;
    const mechanics::flexible_expressions of(data, found.amplitudes);
    const mechanics::components r = of.position(node), s = of.turn(node);
    const frame_id axes{found.frame};
    attachment made;
    made.point = offset(called, point_id{found.reference}, along(axes, r.x, r.y, r.z));
    const mechanics::matrix3 cosines = of.orientation(node);
    if (cosines.is_identity()) {
      made.frame = modified_rodrigues(called, axes, s.x, s.y, s.z);
    } else {
      const frame_id turned = modified_rodrigues(std::string(called) + "_turned", axes, s.x, s.y, s.z);
      made.frame = direction_cosines(called, turned, cosines);
    }
    return made;
  }
  return {};
}

} // namespace kanexpr::runtime
