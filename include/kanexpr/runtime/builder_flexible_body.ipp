#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_flexible_body.hpp>
#include <kanexpr/mechanics/loads/given_potential_energy.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/flexible_integrals.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

KANEXPR_ENGINE mechanics::components builder::as_components(const flexible_integrals::vector_entries& given) {
  return {as_expression(given[0]), as_expression(given[1]), as_expression(given[2])};
}

/// The matrix is square.
KANEXPR_ENGINE symbolic::matrix builder::as_matrix(const flexible_integrals::matrix& given) {
  const int order = static_cast<int>(given.size());
  symbolic::matrix made(*graph_, order, order);
  int place = 0;
  for (const std::vector<number_or_expression>& row : given)
    for (const number_or_expression& each : row) made.entries[place++] = as_expression(each);
  return made;
}

/// Checks the numbers of integrals and the shapes of the matrices.
KANEXPR_ENGINE bool builder::has_shapes_of(std::string_view body, std::size_t amplitudes,
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

KANEXPR_ENGINE void builder::flexible_body(std::string_view called, point_id reference, frame_id frame,
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
  if (data.angular.empty()) b.angular.resize(b.amplitudes.size(), mechanics::components(*graph_));
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
KANEXPR_ENGINE bool builder::has_elasticity(std::string_view called,
                                            const base::sequence<expression>& amplitudes,
                                            const symbolic::matrix& stiffness,
                                            const symbolic::matrix& damping) {
  sentence found = mechanics::check_not_negative(m_, stiffness, "the stiffness of ", amplitudes, called);
  if (!found) found = mechanics::check_not_negative(m_, damping, "the damping of ", amplitudes, called);
  return !found || checks_.fail({found.view()});
}

KANEXPR_ENGINE bool builder::owns_flexible_body(const mechanics::flexible_body& b) {
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

} // namespace kanexpr::runtime
