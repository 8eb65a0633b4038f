#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/kinematics_reader.hpp>
#include <kanexpr/describe/beam_record.hpp>
#include <kanexpr/mechanics/loads/add_beam.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
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
      if (!b.mistake.empty())
        reading_.fail({"beam ", r.called, " ", b.mistake, b.form.empty() ? "" : "; write ", b.form});
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
    read_directions(r, b);
    b.length = property(from.length, "the length of beam ", r.called);
    b.mass_per_length = property(from.mass_per_length, "the mass per length of beam ", r.called);
    b.polar_inertia = property(from.polar_inertia, "the polar inertia of beam ", r.called);
    for (int i = 0; i < 4; ++i) b.stiffness[i] = property(from.stiffness[i], stiffness_names[i], r.called);
    const mechanics::beam_damping damped = read_damping(r);
    if (!reading_.mistake) mechanics::add_beam(m_, reading_.into.loads, b, damped);
  }

private:
  static constexpr std::string_view stiffness_names[]{
      "the bending stiffness of beam ", "the second bending stiffness of beam ",
      "the torsional stiffness of beam ", "the axial stiffness of beam "};

  constexpr void read_directions(const body_record& r, mechanics::beam& b) {
    const beam_record& from = *r.beam;
    b.axis = direction(from.axis, "the axis of beam ", r);
    for (int i = 0; i < 2; ++i) {
      b.across[i] = mechanics::components(*m_.g);
      if (from.across[i].kind == shape::nothing || reading_.mistake) continue;
      b.across[i] = direction(from.across[i], "the direction of bending of beam ", r);
      if (!reading_.mistake && !are_perpendicular(b.across[i], b.axis))
        reading_.fail({"beam ", r.called, " bends in a direction that is not perpendicular to its axis"});
    }
    if (from.across[1].kind != shape::nothing && !reading_.mistake &&
        !are_perpendicular(b.across[0], b.across[1]))
      reading_.fail({"beam ", r.called, " bends in two directions that are not perpendicular to each other"});
  }

  /// A direction fixed in the frame of a beam.
  constexpr components direction(const phrase& p, std::string_view what, const body_record& r) {
    const mechanics::vector given = phrases_.vector_of(p, {what, r.called}, r.called);
    const int frame = entities_.frame(r.frame, r.called);
    if (reading_.mistake) return components(*m_.g);
    const components c = mechanics::express(m_, given, frame);
    if (!mechanics::is_fixed(c)) reading_.fail({what, r.called, " is not fixed in ", r.frame->called});
    return c;
  }

  /// Whether a product is zero; a product of parameters must vanish as it is written.
  static constexpr bool are_perpendicular(const components& a, const components& b) {
    const expression product = mechanics::dot(a, b);
    if (!product.is_constant()) return false;
    const double value = product.owner().number_at(product.node()).value();
    return value < 1e-12 && value > -1e-12;
  }

  /// A positive property of numbers and parameters; zero if the beam lacks it.
  constexpr expression property(const phrase& p, std::string_view what, std::string_view whom) {
    if (p.kind == shape::nothing || reading_.mistake) return m_.zero();
    const expression e = phrases_.scalar_of(p, {what, whom}, whom);
    if (reading_.mistake) return m_.zero();
    if (!mechanics::is_fixed(e))
      reading_.fail({what, whom, " may vary; it may contain only numbers and parameters"});
    if (e.is_constant() && !(m_.g->number_at(e.node()).value() > 0))
      reading_.fail({what, whom, " is not positive"});
    return e;
  }

  constexpr mechanics::beam_damping read_damping(const body_record& r) {
    const auto factor = [&](const phrase& p) {
      if (p.kind == shape::nothing || reading_.mistake) return m_.zero();
      const expression e = phrases_.scalar_of(p, {"the damping of beam ", r.called}, r.called);
      if (!reading_.mistake && e.is_constant() && m_.g->number_at(e.node()).negative())
        reading_.fail({"the damping of beam ", r.called, " is negative"});
      return e;
    };
    mechanics::beam_damping damped;
    damped.of_mass = factor(r.beam->damping_of_mass);
    damped.of_stiffness = factor(r.beam->damping_of_stiffness);
    for (const phrase& p : r.beam->damping_ratios) damped.ratios.push(factor(p));
    return damped;
  }

  kinematics_reader& kinematics_;
};

} // namespace kanexpr::derivation
