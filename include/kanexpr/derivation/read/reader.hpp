#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/beam_reader.hpp>
#include <kanexpr/derivation/read/constraint_reader.hpp>
#include <kanexpr/derivation/read/dynamics_reader.hpp>
#include <kanexpr/derivation/read/flexible_reader.hpp>
#include <kanexpr/derivation/read/formulation_reader.hpp>
#include <kanexpr/derivation/read/joint_reader.hpp>
#include <kanexpr/derivation/read/lagrange_reader.hpp>
#include <kanexpr/derivation/read/load_reader.hpp>
#include <kanexpr/derivation/read/unit_reader.hpp>
#include <kanexpr/derivation/read/value_reader.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the records of a model into a system, starting from bodies and loads and following references to
/// everything that they use. The first mistake stops the reading and is kept as a sentence. Each part of a
/// model has its own reader; the readers share a `reading`.
class reader {
  // These templates precede their callers, because clang++ does not instantiate a template for a constant
  // expression if it is declared later in the class.

  /// Calls `read` with each record, as long as there is no mistake.
  template <class Record, class Read>
  constexpr void each(const describe::listing<Record>& all, Read read) {
    for (const Record& r : all)
      if (!reading_.mistake) read(r);
  }
  /// Calls `place` with each valid symbol of a list.
  template <class Place>
  constexpr void read_list(const describe::listing<phrase>& listed, symbolic::symbol_kind kind,
                           symbol_list list, Place place) {
    for (const phrase& p : listed)
      if (const symbol_record* s = symbols_.listed_symbol(p, kind, list)) place(*s);
  }

public:
  constexpr reader(const system_record& from, mechanics::multibody_system& into) : reading_(from, into) {
    phrases_.look_up_loads(lookup_in(loads_));
  }
  reader(const reader&) = delete;
  reader& operator=(const reader&) = delete;

  /// The known symbols and entities, if there is no mistake.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.symbols_, self.entities_);
  }

  constexpr const sentence& mistake() const { return reading_.mistake; }
  constexpr const system_record& record() const { return reading_.from; }
  /// Whether the unit of any symbol is stated or implied.
  constexpr bool states_units() const { return reading_.states_units; }
  /// Whether the model states the unit of any symbol, so that its units must fit.
  constexpr bool checks_units() const { return reading_.checks_units; }
  /// Whether `read` replaced any quantity by something without its unit.
  constexpr bool hides_units() const { return reading_.hides_units; }
  /// Reads the whole model without its motion, to infer units; `read` need not be called.
  constexpr void read_for_units() {
    reading_.for_units = true;
    read();
    read_moving();
  }
  /// Reads what depends on motion, with symbols in its place, to infer units. Requires that `read` was called
  /// and hides no units.
  constexpr void read_moving_for_units() {
    reading_.for_units = true;
    read_moving();
    reading_.for_units = false;
  }
  /// Whether the mistake concerns a type about which the compiler has already reported an error.
  constexpr bool follows_from_unparsed() const { return reading_.follows_from_unparsed; }
  /// Discards the mistake in a requested expression; everything that was read before remains valid.
  constexpr void forget_mistake() { reading_.mistake = {}, reading_.follows_from_unparsed = false; }
  /// Counts the known symbols, so that `forget_mistake` can also discard those that an expression added.
  constexpr symbol_reader::count symbols_known() const { return symbols_.symbols_known(); }
  constexpr void forget_mistake(const symbol_reader::count& known) {
    forget_mistake();
    symbols_.forget_all_but(known);
  }
  /// Records this sentence as the mistake, if it is the first.
  constexpr void fail(std::string_view because) { reading_.fail({because}); }

  /// Reads the moving parts, and the loads and constraints as far as they do not depend on velocities.
  constexpr void read() {
    const system_record& from = reading_.from;
    if (from.inertial == nullptr) return reading_.fail({"inertial<...> takes one frame"});
    read_lists();
    if (reading_.mistake) return;
    entities_.frame(from.inertial, "the system"sv);
    lagrange_.visit_lagrangian();
    each(from.bodies, [&](const body_record& r) { bodies_.read(r); });
    each(from.joints, [&](const joint_record& r) { joints_.read(r); });
    joints_.read_motors();
    each(from.loads, [&](const load_record& r) { loads_.read_load(r); });
    each(from.joints, [&](const joint_record& r) {
      if (r.stops != nullptr) loads_.read_load(*r.stops);
    });
    dynamics_.read();
    each(from.kinematics, [&](const phrase& p) { kinematics_.read(p); });
    if (!reading_.takes_rates_as_speeds()) {
      joints_.read_kinematics();
      beams_.read_kinematics();
      flexible_.read_kinematics();
    }
    kinematics_.add_simple();
    constraints_.visit_constraints();
    each(from.used_elsewhere, [&](const phrase& p) { symbols_.mention_elsewhere(p); });
    if (from.formulation != nullptr && !reading_.mistake)
      read_formulation(*from.formulation, reading_, entities_);
    if (!reading_.mistake) symbols_.place_added_inputs();
    symbols_.check_values_are_used();
  }

  /// Whether the units that the model states fit, as far as its phrases decide this. Requires that `read` was
  /// called and that there is no mistake.
  constexpr bool units_fit() { return unit_reader(reading_, symbols_, phrases_, entities_).fit(); }

  /// Checks that every listed symbol is used. Requires that `read` was called.
  constexpr void check_listed_are_used() { symbols_.check_listed_are_used(); }

  /// Allows phrases to use positions, velocities and derivatives from now on.
  constexpr void set_known_motion(mechanics::known_motion& of) { reading_.known = &of; }
  constexpr void read_lagrangian() { lagrange_.read_lagrangian(); }
  /// Reads the loads, and the dynamics of state variables, that depend on motion; returns whether there are
  /// any.
  constexpr bool read_moving_loads() {
    const bool is_any_load = loads_.read_moving_loads();
    return (m_.state_variables != 0 && dynamics_.read_moving()) || is_any_load;
  }
  constexpr void read_constraints() { constraints_.read_constraints(); }

  /// Reads the entities that a phrase mentions; `add_late_entities` adds them to a derived system.
  constexpr void visit(const describe::token* tokens, int size) { entities_.visit(tokens, size); }
  constexpr void add_late_entities() { entities_.add_late_entities(); }
  /// Evaluates a phrase in the description of the entity `whom`.
  constexpr value evaluate(const phrase& p, std::string_view whom) { return phrases_.evaluate(p, whom); }
  constexpr expression symbol(const symbol_record& r, std::string_view whom) {
    return symbols_.symbol(r, whom);
  }
  /// Adds a parameter that the model itself does not mention, after all others.
  constexpr void add_parameter(const symbol_record& r) { symbols_.add_parameter(r); }

private:
  constexpr void read_moving() {
    lagrange_.read_lagrangian();
    read_moving_loads();
    constraints_.read_constraints();
  }
  constexpr void read_coordinates(const describe::listing<phrase>& listed) {
    read_list(listed, symbolic::symbol_kind::coordinate, symbol_list::coordinates,
              [&](const symbol_record& s) { m_.coordinate(s.called); });
  }
  constexpr void read_speeds(const describe::listing<phrase>& listed) {
    read_list(listed, symbolic::symbol_kind::speed, symbol_list::speeds,
              [&](const symbol_record& s) { m_.speed(s.called); });
  }

  constexpr void read_states(const describe::listing<phrase>& listed) {
    read_list(listed, symbolic::symbol_kind::speed, symbol_list::state_variables,
              [&](const symbol_record& s) { m_.state_variable(s.called); });
  }

  constexpr void read_lists() {
    using symbolic::symbol_kind;
    const system_record& from = reading_.from;
    joints_.check_all();
    beams_.check_all();
    flexible_.check_all();
    if (reading_.mistake) return;
    read_coordinates(from.coordinates);
    for (const joint_record& r : from.joints) read_coordinates(r.coordinates);
    beams_.each([&](const body_record&, const beam_record& b) { read_coordinates(b.coordinates); });
    flexible_.each([&](const body_record&, const flexible_record& f) { read_coordinates(f.coordinates); });
    lagrange_.read_rates();
    read_speeds(from.speeds);
    if (!reading_.takes_rates_as_speeds()) {
      for (const joint_record& r : from.joints) read_speeds(r.speeds);
      beams_.each([&](const body_record&, const beam_record& b) { read_speeds(b.speeds); });
      flexible_.each([&](const body_record&, const flexible_record& f) { read_speeds(f.speeds); });
    }
    read_states(from.states);
    dynamics_.check_blocks();
    for (const describe::block_record& r : from.blocks) read_states(r.states);
    for (const describe::load_record& r : from.loads)
      if (r.states.size != 0) read_states(r.states);
    read_list(from.auxiliary, symbol_kind::speed, symbol_list::auxiliary_speeds,
              [&](const symbol_record& s) { symbols_.place_auxiliary_speed(s); });
    for (const describe::reaction_record& r : from.reactions)
      read_list(r.speeds, symbol_kind::speed, symbol_list::auxiliary_speeds,
                [&](const symbol_record& s) { m_.auxiliary_speed(s.called); });
    for (const phrase& p : from.values) values_.read(p);
    read_list(from.parameters, symbol_kind::parameter, symbol_list::parameters,
              [&](const symbol_record& s) { symbols_.place_parameter(s); });
    read_list(from.inputs, symbol_kind::input, symbol_list::inputs,
              [&](const symbol_record& s) { symbols_.place_listed_input(s); });
    each(from.inputs, [&](const phrase& p) { symbols_.check_derivative(*p.tokens[0].symbol); });
    each(from.dependent, [&](const phrase& p) { constraints_.read_dependent(p); });
    for (const int number : from.redundant) reading_.into.constraints.redundant.push(number);
  }

  reading reading_;
  mechanism& m_ = reading_.into.mechanism;
  symbol_reader symbols_{reading_};
  phrase_reader phrases_{reading_, symbols_, lookup_in(entities_)};
  entity_reader entities_{reading_, phrases_};
  value_reader values_{reading_, symbols_, phrases_, entities_};
  lagrange_reader lagrange_{reading_, symbols_, phrases_, entities_};
  load_reader loads_{reading_, symbols_, phrases_, entities_};
  dynamics_reader dynamics_{reading_, symbols_, phrases_, entities_};
  kinematics_reader kinematics_{reading_, symbols_, phrases_, entities_};
  beam_reader beams_{{reading_, symbols_, phrases_, entities_}, kinematics_};
  flexible_reader flexible_{{reading_, symbols_, phrases_, entities_}, kinematics_};
  body_reader bodies_{{reading_, symbols_, phrases_, entities_}, beams_, flexible_};
  joint_reader joints_{{reading_, symbols_, phrases_, entities_}, bodies_, kinematics_};
  constraint_reader constraints_{reading_, symbols_, phrases_, entities_};
};

} // namespace kanexpr::derivation
