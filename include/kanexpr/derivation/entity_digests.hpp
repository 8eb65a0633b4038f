#pragma once

#include <kanexpr/base/digest.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/check_words.hpp>
#include <kanexpr/describe/beam_record.hpp>
#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/describe/external.hpp>
#include <kanexpr/describe/flexible_record.hpp>
#include <kanexpr/describe/formulation.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/describe/tyre_record.hpp>
#include <kanexpr/describe/wheel_record.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace kanexpr::derivation {

/// One hash per entity of a system; each covers everything that describes the entity. Two source files may
/// define different entities with the same name; the linker keeps one of them. A program that derives a
/// system at run time detects this by comparing with the hashes that the compiler computed in the intended
/// file.
class entity_digests {
  using frame_record = describe::frame_record;
  using point_record = describe::point_record;
  using phrase = describe::phrase;
  template <class Record>
  using listing = describe::listing<Record>;
  template <class Content>
  using sequence = base::sequence<Content>;

public:
  /// The order is: the system, bodies, joints, loads and blocks, then the entities that these mention, in
  /// order of first mention. Therefore the first difference between two descriptions identifies an entity
  /// that is itself described differently.
  constexpr explicit entity_digests(const describe::system_record& of) {
    take_system(of);
    for (const describe::body_record& r : of.bodies) take(r);
    for (const describe::joint_record& r : of.joints) take(r);
    for (const describe::load_record& r : of.loads) take(r);
    for (const describe::block_record& r : of.blocks) take(r);
    for (int f = 0, p = 0; f < frames_.size() || p < points_.size();) {
      while (f < frames_.size()) take(*frames_[f++]);
      while (p < points_.size()) take(*points_[p++]);
    }
  }

  constexpr int size() const { return contents_.size(); }
  constexpr std::uint64_t operator[](int i) const { return contents_[i]; }

  /// Returns a message that names the first entity that the intended file describes differently; empty if
  /// there is none.
  constexpr sentence first_difference(std::span<const std::uint64_t> meant) const {
    for (int i = 0; i < size() && static_cast<std::size_t>(i) < meant.size(); ++i)
      if (contents_[i] != meant[static_cast<std::size_t>(i)])
        return sentence({"two source files have different ", kinds_[i], names_[i]});
    return {};
  }

private:
  constexpr void begin() { now_ = {}; }
  constexpr void end(std::string_view called, std::string_view kind = "entities called ") {
    contents_.push(now_.value()), names_.push(called), kinds_.push(kind);
  }

  template <class Record>
  constexpr void mention(sequence<const Record*>& known, const Record* one) {
    int place = one == nullptr ? -1 : known.find(one);
    if (place < 0 && one != nullptr) place = known.size(), known.push(one);
    now_.take(place);
  }
  constexpr void mention(const frame_record* one) { mention(frames_, one); }
  constexpr void mention(const point_record* one) { mention(points_, one); }

  constexpr void take(const phrase& p) {
    now_.take(256 * p.size + static_cast<int>(p.kind));
    for (const describe::token& t : p) {
      now_.take((static_cast<std::uint64_t>(t.what) << 40) ^ (static_cast<std::uint64_t>(t.operation) << 32) ^
                static_cast<std::uint32_t>(t.index));
      if (t.what == describe::token_kind::number)
        now_.take(t.number.numerator), now_.take(t.number.denominator), now_.take(t.number.real);
      if (t.symbol != nullptr) now_.take(t.symbol->kind), now_.take(t.symbol->called.view());
      if (t.symbol != nullptr && t.symbol->value != nullptr) now_.take(t.symbol->value->value());
      if (t.frame != nullptr) mention(t.frame);
      if (t.point != nullptr) mention(t.point);
      if (t.external != nullptr) now_.take(t.external->called);
      if (t.load != nullptr) take_parts(*t.load);
    }
  }
  constexpr void take(const listing<phrase>& all) {
    now_.take(all.size);
    for (const phrase& p : all) take(p);
  }

  constexpr void take_system(const describe::system_record& r) {
    begin();
    now_.take(r.derived_by);
    mention(r.inertial);
    for (const listing<phrase>* each :
         {&r.coordinates, &r.speeds, &r.parameters, &r.inputs, &r.added_inputs, &r.kinematics, &r.states,
          &r.dynamics, &r.configuration_constraints, &r.velocity_constraints, &r.acceleration_constraints,
          &r.dependent, &r.auxiliary, &r.values, &r.used_elsewhere, &r.lagrangian})
      take(*each);
    for (const int number : r.redundant) now_.take(number);
    if (r.formulation != nullptr) take(*r.formulation);
    for (int each : {r.bodies.size, r.joints.size, r.loads.size, r.reactions.size, r.blocks.size})
      now_.take(each);
    end("", "systems with the same name");
  }
  constexpr void take(const describe::formulation_record& r) {
    now_.take(16 * static_cast<int>(r.solved_by) + static_cast<int>(r.speeds));
    for (const describe::frame_formulation_record& each : r.frames) {
      mention(each.frame), mention(each.axes);
      now_.take(each.about_the_center ? 1 : 0);
    }
    const symbolic::operation_weights& w = r.weights;
    for (int each :
         {w.multiplication, w.addition, w.fused, w.division, w.square_root, w.trigonometric, w.other})
      now_.take(each);
  }
  constexpr void take(const describe::body_record& r) {
    begin();
    now_.take(r.called);
    now_.take(4 * r.rigid + 2 * r.inertia_changes + r.effective);
    mention(r.center), mention(r.frame), mention(r.inertia_axes), mention(r.about);
    take(r.mass), take(r.inertia_dyadic);
    for (const phrase& each : r.inertia) take(each);
    if (r.beam != nullptr) take(*r.beam);
    if (r.flexible != nullptr) take(*r.flexible);
    end(r.called);
  }
  constexpr void take(const describe::beam_record& r) {
    take(r.axis), take(r.length), take(r.mass_per_length), take(r.polar_inertia);
    for (const phrase& each : r.across) take(each);
    for (const phrase& each : r.stiffness) take(each);
    take(r.coordinates), take(r.speeds), take(r.kinematics);
    take(r.damping_of_mass), take(r.damping_of_stiffness), take(r.damping_ratios);
    for (int k = 0; k < r.integrals.shapes; ++k) now_.take(r.deformations[k]);
    const int count = r.integrals.numbers == nullptr ? 0 : r.integrals.count(r.integrals.shapes);
    for (int i = 0; i < count; ++i) now_.take(r.integrals.numbers[i]);
  }
  constexpr void take(const describe::flexible_record& r) {
    take(r.coordinates), take(r.speeds), take(r.kinematics);
    if (r.data == nullptr) return;
    const mechanics::flexible_data d = r.data();
    now_.take(d.mass);
    for (const sequence<double>* each :
         {&d.first_moment.coefficients, &d.inertia.coefficients, &d.angular.coefficients, &d.modal_mass,
          &d.stiffness, &d.damping, &d.preload})
      for (const double number : *each) now_.take(number);
  }
  constexpr void take(const describe::joint_record& r) {
    begin();
    now_.take(r.called);
    mention(r.frame), mention(r.point), mention(r.home), mention(r.parent_frame), mention(r.parent_point);
    take(r.axes), take(r.coordinates), take(r.speeds), take(r.kinematics), take(r.place);
    for (int i = 0; i < 2 && r.rotor != nullptr; ++i) take(r.rotor[i]);
    end(r.called);
    if (r.body != nullptr) take(*r.body);
    if (r.stops != nullptr) take(*r.stops);
  }
  constexpr void take(const describe::load_record& r) {
    begin();
    take_parts(r);
    end("", "loads with the same name");
  }
  constexpr void take_parts(const describe::load_record& r) {
    now_.take(r.what);
    mention(r.point), mention(r.other_point), mention(r.frame), mention(r.other_frame);
    take(r.value), take(r.angle), take(r.rest), take(r.states), take(r.dynamics);
    if (r.friction != nullptr) take(*r.friction);
    if (r.contact != nullptr) take(*r.contact);
    if (r.tyre != nullptr) take(*r.tyre);
    if (r.wheel != nullptr) take(*r.wheel);
    for (int i = 0; i < r.terms_given; ++i) take(r.terms[i]);
    for (int i = 0; i < 2 && r.rotor != nullptr; ++i) take(r.rotor[i]);
    if (r.path != nullptr) take(*r.path);
  }
  constexpr void take(const describe::path_record& r) {
    now_.take(4 * static_cast<int>(r.what) + 2 * r.first_is_on_surface + r.last_is_on_surface);
    now_.take(r.sense);
    now_.take(r.points.size);
    for (const point_record& p : r.points) mention(&p);
    mention(r.center), mention(r.frame);
    take(r.length), take(r.axis), take(r.size);
  }
  constexpr void take(const describe::block_record& r) {
    begin();
    now_.take(r.called);
    take(r.states), take(r.dynamics);
    end(r.called);
  }
  constexpr void take(const describe::friction_record& r) {
    now_.take(static_cast<int>(r.kind));
    take(r.sliding), take(r.sticking), take(r.slip_speed), take(r.viscous);
    take(r.stiffness), take(r.damping), take(r.stribeck_speed);
  }
  constexpr void take(const describe::contact_record& r) {
    now_.take(static_cast<int>(r.shapes));
    mention(r.frame), mention(r.other_frame);
    for (const phrase* each : {&r.normal, &r.axis, &r.radius, &r.other_radius, &r.level, &r.stiffness,
                               &r.exponent, &r.width, &r.damping, &r.approach_speed, &r.direction, &r.ratio,
                               &r.lever, &r.rolling_rate, &r.spinning_lever, &r.spinning_rate})
      take(*each);
    now_.take(r.restitution);
    if (r.friction != nullptr) take(*r.friction);
  }
  constexpr void take(const describe::wheel_record& r) {
    now_.take(static_cast<int>(r.rim) * 4 + static_cast<int>(r.ground));
    now_.take(r.steps);
    mention(r.center), mention(r.frame), mention(r.place), mention(r.ground_frame);
    for (const phrase* each : describe::phrases_of(r)) take(*each);
  }
  constexpr void take(const describe::tyre_record& r) {
    take(*r.wheel);
    now_.take(static_cast<int>(r.model));
    for (const phrase* each : {&r.slip_stiffness, &r.cornering_stiffness, &r.camber_stiffness, &r.trail,
                               &r.friction, &r.load, &r.stiffness, &r.damping, &r.width, &r.standstill,
                               &r.effective_radius, &r.forward_length, &r.lateral_length})
      take(*each);
    if (r.formula == nullptr) return;
    const auto take_all = [&](const auto&... c) { (take(c), ...); };
    tyre_coefficients::each_coefficient(*r.formula, take_all);
    tyre_coefficients::each_factor(*r.formula, take_all);
  }
  constexpr void take(const describe::tyre_coefficient& c) {
    take(c.symbol);
    now_.take(c.number);
  }
  constexpr void take(const frame_record& r) {
    begin();
    now_.take(r.called);
    now_.take(2 * static_cast<int>(r.orientation) + r.turns_apart);
    mention(r.parent), mention(r.reference);
    for (char letter : r.sequence) now_.take(static_cast<int>(letter));
    if (r.parent != nullptr)
      for (const phrase& each : r.given) take(each);
    take(r.axis), take(r.angular_velocity);
    end(r.called);
  }
  constexpr void take(const point_record& r) {
    begin();
    now_.take(r.called);
    now_.take(2 * r.moves_apart + r.from_parent);
    mention(r.parent), mention(r.origin_of), mention(r.fixed_in), mention(r.reference);
    take(r.offset), take(r.velocity);
    end(r.called);
  }

  base::digest now_{};
  sequence<const frame_record*> frames_{};
  sequence<const point_record*> points_{};
  sequence<std::uint64_t> contents_{};
  sequence<std::string_view> names_{}, kinds_{};
};

/// The hashes of a system as this source file defines it: a combined one, followed by one per entity.
template <class System>
constexpr auto digests_in_this_file() {
  if constexpr (requires { System::record; }) {
    constexpr int size = words_of<System>.mistake ? 0 : entity_digests(System::record).size();
    std::array<std::uint64_t, static_cast<std::size_t>(size + 1)> all{};
    if constexpr (size > 0) {
      const entity_digests found(System::record);
      base::digest whole;
      for (int i = 0; i < size; ++i) all[static_cast<std::size_t>(i + 1)] = found[i], whole.take(found[i]);
      all[0] = whole.value();
    }
    return all;
  } else {
    return std::array<std::uint64_t, 1>{};
  }
}

/// The hashes for use at compile time, when no other file is known.
template <class System>
inline constexpr auto compile_time_digests = digests_in_this_file<System>();

/// The hashes for use at run time. The combined hash is part of the name, so that the linker does not
/// substitute the hashes of another file.
template <class System, std::uint64_t of_all>
inline constexpr auto linked_digests = compile_time_digests<System>;

} // namespace kanexpr::derivation
