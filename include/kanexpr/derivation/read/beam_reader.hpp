#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/kinematics_reader.hpp>
#include <kanexpr/derivation/read/units_of_motion.hpp>
#include <kanexpr/describe/beam_record.hpp>
#include <kanexpr/mechanics/checks/check_beam.hpp>
#include <kanexpr/mechanics/loads/add_beam.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

using describe::beam_record;
using describe::body_record;

/// Reads the beams among the bodies of a model, except for their symbols, which follow those of the model's
/// lists and of its joints.
class beam_reader : part_reader {
public:
  constexpr beam_reader(const part_reader& parts, kinematics_reader& kinematics)
      : part_reader(parts), kinematics_(kinematics) {}

  /// Calls `read` with each beam, as long as there is no mistake.
  template <class Read>
  constexpr void each(Read read) const {
    for (const body_record& r : reading_.from.bodies)
      if (r.beam != nullptr && !reading_.mistake) read(r, *r.beam);
  }

  /// Checks the words of all beams; called before any part of them is read.
  constexpr void check_all() {
    each([&](const body_record& r, const beam_record& b) {
      if (!reading_.check_base_conflict(r.conflict, r.called)) return;
      if (r.called != r.declared_name) return reading_.fail_by_self("body", r.called, r.declared_name);
      if (!b.mistake.empty())
        reading_.fail({"beam ", r.called, " ", b.mistake, b.form.empty() ? "" : "; write ", b.form});
      int times = 0;
      for (const body_record& other : reading_.from.bodies) times += &other == &r ? 1 : 0;
      if (times > 1) reading_.fail({"body ", r.called, " is listed twice"});
    });
  }

  constexpr void read_kinematics() {
    each([&](const body_record&, const beam_record& b) {
      for (const phrase& equation : b.kinematics)
        if (!reading_.mistake) kinematics_.read(equation);
    });
  }

  /// Reads a beam and adds it to the system.
  constexpr void read(const body_record& r) {
    const beam_record& from = *r.beam;
    mechanics::beam b;
    b.called = base::name(r.called);
    b.root = entities_.point(r.center, r.called);
    if (!reading_.mistake) b.frame = entities_.frame(r.frame, r.called);
    for (const phrase& p : from.coordinates)
      if (!reading_.mistake) b.amplitudes.push(symbols_.symbol(*p.tokens[0].symbol, r.called));
    for (int k = 0; k < from.integrals.shapes; ++k) b.deformations.push(from.deformations[k]);
    b.integrals = from.integrals;
    if (!std::is_constant_evaluated() && from.sections != nullptr)
      b.sections = from.sections(mechanics::beam_outline::sections);
    b.axis = direction(from.axis, "the axis of beam ", r);
    for (int i = 0; i < 2; ++i)
      b.across[i] = direction(from.across[i], "the direction of bending of beam ", r);
    b.length = scalar(from.length, "the length of beam ", r);
    b.mass_per_length = scalar(from.mass_per_length, "the mass per length of beam ", r);
    b.polar_inertia = scalar(from.polar_inertia, "the polar inertia of beam ", r);
    for (int i = 0; i < 4; ++i) b.stiffness[i] = scalar(from.stiffness[i], "a stiffness of beam ", r);
    const mechanics::beam_damping damped = read_damping(r);
    if (!reading_.mistake) reading_.mistake = mechanics::check_beam(b);
    if (!reading_.mistake) reading_.mistake = mechanics::check_damping(damped, r.called);
    if (!reading_.mistake) mechanics::add_beam(m_, reading_.into.loads, b, damped);
  }

private:
  /// A direction in the axes of the frame of a beam; zero if the beam lacks it.
  constexpr components direction(const phrase& p, std::string_view what, const body_record& r) {
    if (p.kind == shape::nothing || reading_.mistake) return components(*m_.g);
    const mechanics::vector given = phrases_.vector_of(p, {what, r.called}, r.called);
    const int frame = entities_.frame(r.frame, r.called);
    return reading_.mistake ? components(*m_.g) : mechanics::express(m_, given, frame);
  }
  constexpr expression scalar(const phrase& p, std::string_view what, const body_record& r) {
    if (p.kind == shape::nothing || reading_.mistake) return m_.zero();
    const expression given = phrases_.scalar_of(p, {what, r.called}, r.called);
    reading_.hides_units |= given.is_constant();
    return reading_.for_units ? as_symbol(reading_, given) : given;
  }

  constexpr mechanics::beam_damping read_damping(const body_record& r) {
    const auto factor = [&](const phrase& p) { return scalar(p, "the damping of beam ", r); };
    mechanics::beam_damping damped;
    damped.of_mass = factor(r.beam->damping_of_mass);
    damped.of_stiffness = factor(r.beam->damping_of_stiffness);
    for (const phrase& p : r.beam->damping_ratios) damped.ratios.push(factor(p));
    return damped;
  }

  kinematics_reader& kinematics_;
};

} // namespace kanexpr::derivation
