#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/image.hpp>
#include <kanexpr/derivation/model_units.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/model/inertial_parameter.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/unit_quaternions.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <concepts>
#include <optional>
#include <utility>

namespace kanexpr::derivation {

/// Reads a system from the types of a model and derives the equations that provide its results. It cannot be
/// moved. The first mistake stops the derivation.
class derived_system {
  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class Visit>
  constexpr void each_part(Visit& visit) {
    visit(system_, reader_, *equations_);
  }

public:
  constexpr explicit derived_system(const system_record& from) : system_(graph_), reader_(from, system_) {
    reader_.read();
  }
  /// Resumes a stored derivation of the same record. It is a template, like `write`, so that files that do
  /// not derive anything do not instantiate the code it needs.
  template <std::same_as<image> Image>
  constexpr derived_system(const system_record& from, const Image& stored)
      : system_(graph_), reader_(from, system_) {
    equations_.emplace(system_, mechanics::equations::for_restore{});
    reader_.set_known_motion(equations_->known());
    image_transfer read(stored, graph_, system_.mechanism);
    each_part(read);
  }
  derived_system(const derived_system&) = delete;
  derived_system& operator=(const derived_system&) = delete;

  /// Checks the system for mistakes after it was read.
  constexpr void check_model() {
    if (!mistake()) mistake_ = mechanics::check_system(system_);
    if (!mistake()) reader_.check_listed_are_used();
    if (!mistake() && reader_.checks_units() && !reader_.units_fit()) check_units();
    if (reader_.checks_units()) system_.mechanism.stated_units.clear(); // they are inferred separately
  }

  /// Determines how the equations are formed, and, unless the list is empty, the speeds for which the
  /// constraints are solved, in place of what the model states. Must precede `derive`.
  constexpr void formulate(const mechanics::formulation& form, const sequence<int>& dependent_speeds) {
    system_.mechanism.formulated = form;
    if (!dependent_speeds.empty()) system_.constraints.dependent_speeds = dependent_speeds;
  }

  /// Reads the loads that depend on motion and the constraints, and forms the starting point of the
  /// equations.
  constexpr void derive() {
    if (mistake()) return;
    mechanics::known_motion known(system_.mechanism);
    reader_.set_known_motion(known);
    reader_.read_lagrangian();
    if (reader_.read_moving_loads() && !mistake())
      mistake_ = mechanics::check_loads(system_.mechanism, system_.loads, mechanics::contents(graph_));
    if (!mistake() && system_.mechanism.state_variables != 0)
      mistake_ = mechanics::check_state_rates(system_.mechanism, system_.loads.state_rates);
    reader_.read_constraints();
    equations_.emplace(system_, std::move(known));
    reader_.set_known_motion(equations_->known());
    if (!mistake()) equations_->constrain();
  }

  /// Stores the derivation. Requires that there is no mistake and that `derive` was called.
  template <std::same_as<image> Image>
  constexpr void write(Image& into) {
    image_transfer write(into, graph_);
    each_part(write);
  }

  constexpr const sentence& mistake() const {
    if (reader_.mistake()) return reader_.mistake();
    if (mistake_ || !equations_.has_value()) return mistake_;
    return equations_->mistake();
  }

  constexpr bool is_derived() const { return equations_.has_value(); }

  constexpr symbolic::graph& graph() { return graph_; }
  constexpr const symbolic::graph& graph() const { return graph_; }
  constexpr const mechanics::multibody_system& system() const { return system_; }
  constexpr const mechanics::mechanism& mechanism() const { return system_.mechanism; }
  constexpr derivation::reader& reader() { return reader_; }

  /// Requires that there is no mistake and that `derive` was called.
  constexpr mechanics::equations& equations() { return *equations_; }

private:
  /// Infers the units of the model from what was read, if this contains all units. What depends on motion is
  /// read for this purpose only, and is then discarded.
  constexpr void check_units() {
    if (reader_.hides_units()) {
      mistake_ = model_units(reader_.record()).mistake();
      return;
    }
    const symbolic::graph::extent before = graph_.present();
    mechanics::loads loads = system_.loads;
    mechanics::given_constraints constraints = system_.constraints;
    const int expected = system_.mechanism.expected_units.size();
    reader_.read_moving_for_units();
    if (!reader_.mistake()) mistake_ = mechanics::check_units(system_);
    system_.loads = std::move(loads);
    system_.constraints = std::move(constraints);
    system_.mechanism.forget_units_after(expected);
    graph_.forget_after(before);
  }

  symbolic::graph graph_{};
  mechanics::multibody_system system_;
  derivation::reader reader_;
  sentence mistake_{};
  std::optional<mechanics::equations> equations_{};
};

constexpr bool is_moment_of(const mechanics::body& b, const expression& parameter) {
  for (const mechanics::dyadic::part& part : b.inertia.parts)
    for (int i = 0; i < 3 && part.left == part.right; ++i)
      if (part.value(i, i) == parameter) return true;
  return false;
}

constexpr void survey::take(derived_system& system) {
  take(system.system(), !system.mistake(), system.is_derived() ? &system.equations() : nullptr);
  states_units = system.reader().states_units();
  checks_units = system.reader().checks_units();
}

constexpr void survey::take(const mechanics::multibody_system& of, bool is_sound,
                            const mechanics::equations* derived) {
  const mechanism& m = of.mechanism;
  takes_rates_as_speeds = m.derived_by == mechanics::method::lagrange;
  coordinates = m.coordinates.size();
  speeds = m.speeds.size();
  state_variables = m.state_variables;
  parameters = m.parameters.size();
  inputs = m.inputs.size();
  auxiliary_speeds = m.auxiliary_speeds.size();
  for (const mechanics::body& b : m.bodies) inertial_parameters += mechanics::inertial_parameters_of(b);
  if (symbols() > room) return;
  int next = 0;
  for (const sequence<expression>* list : {&m.coordinates, &m.speeds, &m.parameters, &m.inputs})
    for (const expression& e : *list) names[next++] = m.g->symbol_at(e.node()).called;
  if (!is_sound) return;
  for (const mechanics::flexible_body& b : m.flexible_bodies)
    if (const int i = m.parameters.find(b.mass); i >= 0) is_mass[coordinates + speeds + i] = true;
  for (int i = 0; i < parameters; ++i)
    for (const mechanics::body& b : m.bodies) {
      is_mass[coordinates + speeds + i] |= b.mass == m.parameters[i];
      is_moment[coordinates + speeds + i] |= !b.effective && is_moment_of(b, m.parameters[i]);
    }
  inertial_values_reader values(m, inertial);
  values.read();
  values.read(mechanics::bounded_values(m, of.loads));
  for (const sequence<int>& places : mechanics::unit_quaternions(m)) {
    ++quaternions;
    for (int place : places) quaternion_of[place] = quaternions;
  }
  if (derived == nullptr) return;
  constraints = derived->constraints_used().size();
  nonlinear_constraints = derived->constraints_used().nonlinear;
  configuration_constraints = derived->constraints_used().on_configuration.size();
  redundant_constraints = derived->constraints_used().redundant.size();
  for (int i : derived->coordinates().dependent) dependent[i] = true;
  for (int i : derived->speeds().dependent) dependent[coordinates + i] = true;
}

} // namespace kanexpr::derivation
