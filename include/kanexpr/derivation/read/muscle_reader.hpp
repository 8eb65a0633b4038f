#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/describe/muscle_record.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads muscles.
class muscle_reader : load_parts {
public:
  constexpr explicit muscle_reader(const load_parts& by) : load_parts(by) {}

  constexpr void read() {
    const load_record& r = record;
    if (r.terms == nullptr)
      return reading_.fail({whom, " takes muscle_parameters{...} after its excitation"});
    mechanics::muscle made;
    made.called = r.called;
    made.formulation = r.muscle->formulation;
    made.along = path();
    made.activation = scalar(r.value, "the activation of ");
    read_parameters(made);
    if (r.muscle->tendon_state.kind != shape::nothing && !reading_.mistake)
      made.tendon_state = symbols_.symbol(*r.muscle->tendon_state.tokens[0].symbol, whom);
    if (reading_.mistake) return;
    into.add(made);
    if (made.tendon_state.is_given()) into.state_rates.push({m_.speeds.find(made.tendon_state), {}, {}});
  }

private:
  constexpr void read_parameters(mechanics::muscle& to) {
    struct part {
      expression& value;
      std::string_view called;
    };
    const part parts[]{{to.peak_force, "peak isometric force"},
                       {to.optimal_length, "optimal fiber length"},
                       {to.slack_length, "tendon slack length"},
                       {to.maximal_velocity, "maximal fiber velocity"},
                       {to.pennation, "pennation"},
                       {to.damping, "fiber damping"},
                       {to.tendon_strain, "tendon strain"},
                       {to.passive_strain, "passive strain"}};
    const phrase* given = record.terms;
    for (const part& each : parts) {
      const sentence of({"the ", each.called, " of "});
      if (given->kind == shape::nothing)
        reading_.fail({whom, " has no ", each.called, "; set it in muscle_parameters{...}"});
      else
        each.value = scalar(*given, of.view());
      ++given;
    }
  }
};

constexpr void read_muscle(load_parts& by) { muscle_reader(by).read(); }

constexpr expression tension_of_muscle(const mechanics::loads& alone, mechanics::observed_motion& on) {
  return alone.all<mechanics::muscle>()[0].tension(on);
}

} // namespace kanexpr::derivation
