#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/checks/check_beam.hpp>
#include <kanexpr/mechanics/checks/check_flexible_body.hpp>
#include <kanexpr/mechanics/loads/add_beam.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/section.hpp>
#include <kanexpr/numeric/beams/integrate_modes.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>
#include <kanexpr/runtime/building/beam_builder.hpp>
#include <kanexpr/runtime/building/beam_data.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// Adds the shapes of a deformation to a beam.
KANEXPR_ENGINE void beam_builder::deform(built_beam& to, mechanics::deformation what,
                                         const beam_deformation& by) {
  to.beam.stiffness[static_cast<int>(what)] = as_expression(by.stiffness);
  to.shapes.stiffness[static_cast<int>(what)] = by.profile;
  const std::string_view called = to.beam.called.view();
  check_profile(called, by.profile);
  if (by.shapes.empty()) checks_.fail({"beam ", called, " has a deformation without a shape"});
  for (const numeric::beams::shape& each : by.shapes) {
    if (each.is_empty()) {
      checks_.fail(
          {"beam ", called,
           " has an empty shape; natural modes are empty if their number is less than 1, or if a ratio "
           "of the body at the tip is negative or not finite"});
      return;
    }
    if (!each.is_complete()) {
      checks_.fail({"beam ", called,
                    " has a shape that is not given on the whole beam, by finite numbers and stations in "
                    "increasing order from 0 to 1"});
      return;
    }
    if (!each.is_smooth(numeric::beams::is_bending(what)))
      checks_.fail({"beam ", called, " has a shape with a jump",
                    numeric::beams::is_bending(what) ? " or a kink" : "", " at a station"});
    to.shapes.all.push({what, each});
    to.beam.deformations.push(what);
    if (!by.moves_root && !numeric::beams::fits_clamped_root(each, numeric::beams::is_bending(what)))
      checks_.fail({"beam ", called,
                    " has a shape that displaces or turns the root; set moves_root if this is intended"});
  }
}

/// Reports a profile that is not the factor of a property.
KANEXPR_ENGINE void beam_builder::check_profile(std::string_view beam, const numeric::beams::shape& profile) {
  if (!profile.is_complete() || !numeric::beams::is_factor(profile))
    checks_.fail({"beam ", beam, " has a profile that is negative at some place, or nowhere positive"});
}

KANEXPR_ENGINE void beam_builder::deform(built_beam& to, const beam_data& data) {
  using mechanics::deformation;
  if (data.bending.size() > 2)
    checks_.fail({"beam ", to.beam.called.view(),
                  " bends in three directions; a beam bends in one direction or in two perpendicular ones"});
  for (std::size_t i = 0; i < data.bending.size() && i < 2; ++i) {
    to.beam.across[i] = unit_direction(data.bending[i].direction, to.beam.frame);
    deform(to, i == 0 ? deformation::first_bending : deformation::second_bending, data.bending[i].by);
  }
  if (data.torsion) {
    to.beam.polar_inertia = as_expression(data.torsion->polar_inertia);
    to.shapes.polar = data.torsion->profile;
    check_profile(to.beam.called.view(), data.torsion->profile);
    deform(to, deformation::torsion, data.torsion->by);
  }
  if (data.extension) deform(to, deformation::extension, *data.extension);
}

/// A unit vector in the axes of a frame; a vector along a basis vector needs no root.
KANEXPR_ENGINE mechanics::components beam_builder::unit_direction(const vector& given, int frame) {
  if (!checks_.owns("a direction of a beam", given)) return mechanics::components(*m_.g);
  return mechanics::unit_along(mechanics::express(m_, given, frame));
}

KANEXPR_ENGINE beam_id beam_builder::beam(std::string_view called, point_id root, frame_id frame,
                                          const std::vector<expression>& amplitudes, const beam_data& data) {
  if (!checks_.is_new("bodies", called, m_.bodies) || !checks_.is_new("bodies", called, m_.flexible_bodies) ||
      !checks_.owns(called, root, frame))
    return {};
  built_beam made;
  mechanics::beam& b = made.beam;
  b.called = base::name(called);
  b.root = place(root), b.frame = place(frame);
  for (expression* e : {&b.polar_inertia, &b.stiffness[0], &b.stiffness[1], &b.stiffness[2], &b.stiffness[3]})
    *e = m_.zero();
  for (mechanics::components& each : b.across) each = mechanics::components(*m_.g);
  b.axis = unit_direction(data.axis, b.frame);
  b.length = as_expression(data.length), b.mass_per_length = as_expression(data.mass_per_length);
  made.shapes.mass = data.mass_profile;
  check_profile(called, data.mass_profile);
  deform(made, data);
  for (const expression& q : amplitudes) b.amplitudes.push(q);
  if (b.deformations.empty()) checks_.fail({"beam ", called, " has no shapes"});
  if (b.amplitudes.size() != b.deformations.size())
    checks_.fail({"expected an amplitude for each of the ", base::counted(b.deformations.size()).view(),
                  " shapes of beam ", called, ", got ", base::counted(b.amplitudes.size()).view()});
  const mechanics::beam_damping damped = damping_of(called, data);
  if (has_mistake() || !owns_beam(made, damped)) return {};
  const base::sequence<double> integrals = numeric::beams::integrate_modes(made.shapes);
  b.integrals = {integrals.begin(), b.deformations.size()};
  b.sections = numeric::beams::values_at_sections(made.shapes, mechanics::beam_outline::sections);
  mechanics::add_beam(m_, system_.loads, b, damped);
  b.integrals = {};
  beams_.push_back(made);
  return beam_id{static_cast<int>(beams_.size()) - 1};
}

KANEXPR_ENGINE mechanics::beam_damping beam_builder::damping_of(std::string_view beam,
                                                                const beam_data& data) {
  bool has_integer = data.damping_of_mass.is_whole_zero() || data.damping_of_stiffness.is_whole_zero();
  for (const number_or_expression& each : data.damping_ratios)
    has_integer = has_integer || each.is_whole_zero();
  if (has_integer) checks_.fail_integer_zero("the damping of beam " + std::string(beam) + " contains 0");
  mechanics::beam_damping damped{
      as_expression(data.damping_of_mass), as_expression(data.damping_of_stiffness), {}};
  for (const number_or_expression& each : data.damping_ratios) damped.ratios.push(as_expression(each));
  return damped;
}

KANEXPR_ENGINE bool beam_builder::owns_beam(const built_beam& made, const mechanics::beam_damping& damped) {
  const mechanics::beam& b = made.beam;
  const std::string_view called = b.called.view();
  if (!checks_.owns(called, b.length, b.mass_per_length, b.polar_inertia, b.amplitudes, damped.of_mass,
                    damped.of_stiffness, damped.ratios))
    return false;
  for (const expression& each : b.stiffness)
    if (!checks_.owns(called, each)) return false;
  const int ratios = damped.ratios.size();
  if (ratios > 1 && ratios != b.deformations.size())
    return checks_.fail({"beam ", called, " has neither one damping ratio nor a ratio for each shape"});
  sentence found = mechanics::check_beam(b);
  if (!found) found = mechanics::check_damping(damped, called);
  if (!found) found = mechanics::check_amplitudes(m_, called, b.amplitudes, m_.flexible_bodies.size());
  return !found || checks_.fail({found.view()});
}

KANEXPR_ENGINE section_ids beam_builder::section(std::string_view called, beam_id on, given_number at) {
  const double xi = at.value();
  const auto index = static_cast<std::size_t>(on);
  if (index >= beams_.size()) {
    checks_.fail({"section ", called, " is placed on a beam that does not exist"});
    return {};
  }
  const built_beam& made = beams_[index];
  const mechanics::beam& b = made.beam;
  if (!(xi >= 0 && xi <= 1)) {
    checks_.fail({"section ", called, " is not on beam ", b.called.view(),
                  "; its place is a fraction of the length, a number from 0 to 1"});
    return {};
  }
  if (at.is_whole_zero()) {
    checks_.fail({"section ", called, " of beam ", b.called.view(),
                  " is at 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 for the root"});
    return {};
  }
  if (!checks_.is_new("frames", called, m_.frames) || !checks_.is_new("points", called, m_.points)) return {};
  const base::sequence<double> numbers = numeric::beams::values_at(made.shapes, xi);
  const numeric::beams::section_values values{numbers.begin(), b.deformations.size()};
  return {frame_id{mechanics::add_frame_of_section(m_, called, b, values)},
          point_id{mechanics::add_point_of_section(m_, called, b, values)}};
}

} // namespace kanexpr::runtime
