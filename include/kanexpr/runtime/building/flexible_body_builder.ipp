#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_flexible_body.hpp>
#include <kanexpr/mechanics/loads/add_flexible_body.hpp>
#include <kanexpr/mechanics/loads/given_potential_energy.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/flexible_expressions.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/building/flexible_body_builder.hpp>
#include <kanexpr/runtime/building/flexible_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <cstddef>
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

KANEXPR_ENGINE mechanics::components
flexible_body_builder::as_components(const flexible_integrals::vector_entries& given) {
  return {as_expression(given[0]), as_expression(given[1]), as_expression(given[2])};
}

/// The matrix is square.
KANEXPR_ENGINE symbolic::matrix flexible_body_builder::as_matrix(const flexible_integrals::matrix& given) {
  const int order = static_cast<int>(given.size());
  symbolic::matrix made(*m_.g, order, order);
  int place = 0;
  for (const std::vector<number_or_expression>& row : given)
    for (const number_or_expression& each : row) made.entries[place++] = as_expression(each);
  return made;
}

/// Checks the numbers of integrals and the shapes of the matrices.
KANEXPR_ENGINE bool flexible_body_builder::has_shapes_of(std::string_view body, std::size_t amplitudes,
                                                         const flexible_integrals& data) {
  const auto counted = [](std::size_t n) { return base::counted(static_cast<int>(n)); };
  if (!data.angular.empty() && data.angular.size() != amplitudes)
    return checks_.fail({"expected an angular integral for each of the ", counted(amplitudes).view(),
                         " amplitudes of ", body, ", got ", counted(data.angular.size()).view()});
  const auto is_square = [&](std::string_view of, const flexible_integrals::matrix& m) {
    bool fits = m.size() == amplitudes;
    for (const std::vector<number_or_expression>& row : m) fits = fits && row.size() == amplitudes;
    return fits || checks_.fail({"the ", of, " of ", body,
                                 " must be a matrix with a row and a column for each of the ",
                                 counted(amplitudes).view(), " amplitudes"});
  };
  return is_square("modal mass", data.modal_mass) &&
         (data.stiffness.empty() || is_square("stiffness", data.stiffness)) &&
         (data.damping.empty() || is_square("damping", data.damping));
}

KANEXPR_ENGINE void flexible_body_builder::flexible_body(std::string_view called, point_id reference,
                                                         frame_id frame,
                                                         const std::vector<expression>& amplitudes,
                                                         const flexible_integrals& data) {
  if (!is_new_body(called) || !has_shapes_of(called, amplitudes.size(), data)) return;
  mechanics::flexible_body b{.called = called, .frame = place(frame), .reference = place(reference)};
  for (const expression& q : amplitudes) b.amplitudes.push(q);
  b.mass = as_expression(data.mass);
  b.first_moment = as_components(data.first_moment);
  int entry = 0;
  for (const auto member : {&mechanics::symmetric::xx, &mechanics::symmetric::yy, &mechanics::symmetric::zz,
                            &mechanics::symmetric::xy, &mechanics::symmetric::yz, &mechanics::symmetric::zx})
    b.inertia.*member = as_expression(data.inertia[static_cast<std::size_t>(entry++)]);
  for (const flexible_integrals::vector_entries& each : data.angular) b.angular.push(as_components(each));
  if (data.angular.empty()) b.angular.resize(b.amplitudes.size(), mechanics::components(*m_.g));
  b.modal_mass = as_matrix(data.modal_mass);
  const symbolic::matrix stiffness = as_matrix(data.stiffness), damping = as_matrix(data.damping);
  if (!owns_flexible_body(b) || !checks_.owns(called, stiffness.entries, damping.entries)) return;
  const sentence found = mechanics::check_symmetry(m_, stiffness, "the stiffness of ", called);
  if (found) checks_.fail({found.view()});
  if (!found) has_elasticity(called, b.amplitudes, stiffness, damping);
  m_.flexible_bodies.push(b);
  if (stiffness.rows != 0)
    system_.loads.potential_energies.push(mechanics::elastic_energy(b.amplitudes, stiffness));
  if (damping.rows != 0) system_.loads.modal_dampings.push({b.amplitudes, damping});
}

/// Checks the stiffness and the damping of a flexible body.
KANEXPR_ENGINE bool flexible_body_builder::has_elasticity(std::string_view called,
                                                          const base::sequence<expression>& amplitudes,
                                                          const symbolic::matrix& stiffness,
                                                          const symbolic::matrix& damping) {
  sentence found = mechanics::check_not_negative(m_, stiffness, "the stiffness of ", amplitudes, called);
  if (!found) found = mechanics::check_not_negative(m_, damping, "the damping of ", amplitudes, called);
  return !found || checks_.fail({found.view()});
}

KANEXPR_ENGINE bool flexible_body_builder::owns_flexible_body(const mechanics::flexible_body& b) {
  const std::string_view called = b.called.view();
  if (!checks_.owns(called, frame_id{b.frame}, point_id{b.reference}, b.amplitudes, b.mass, b.first_moment,
                    b.modal_mass.entries))
    return false;
  for (const mechanics::components& each : b.angular)
    if (!checks_.owns(called, each)) return false;
  const mechanics::symmetric& i = b.inertia;
  if (!checks_.owns(called, i.xx, i.yy, i.zz, i.xy, i.yz, i.zx)) return false;
  const sentence found = mechanics::check_amplitudes(m_, called, b.amplitudes, m_.flexible_bodies.size());
  return !found || checks_.fail({found.view()});
}

KANEXPR_ENGINE flexible_body_id flexible_body_builder::flexible_body(
    std::string_view called, point_id reference, frame_id frame, const std::vector<expression>& amplitudes,
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

KANEXPR_ENGINE section_ids flexible_body_builder::node(std::string_view called, flexible_body_id of,
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
    vector from_reference;
    from_reference.add(on.body.frame, r);
    made.point = points_.offset(called, point_id{on.body.reference}, from_reference);
    const std::string turned = std::string(called) + (cosines.is_identity() ? "" : "_turned");
    made.frame = frames_.modified_rodrigues(turned, axes, s.x, s.y, s.z);
    if (!cosines.is_identity()) made.frame = frames_.direction_cosines(called, made.frame, cosines);
    return made;
  }
  checks_.fail({"flexible body ", on.body.called.view(), " has no node ", node});
  return {};
}

} // namespace kanexpr::runtime
