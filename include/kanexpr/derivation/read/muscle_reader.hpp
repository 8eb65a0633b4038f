#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/path_reader.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/describe/muscle_record.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads muscles.
class muscle_reader : part_reader {
public:
  constexpr explicit muscle_reader(const part_reader& parts) : part_reader(parts) {}

  constexpr void read(mechanics::loads& into, const load_record& r, std::string_view whom) {
    if (r.terms == nullptr)
      return reading_.fail({whom, " takes muscle_parameters{...} after its excitation"});
    mechanics::muscle made;
    made.called = r.called;
    made.formulation = r.muscle->formulation;
    made.along = path_reader(*this).read(*r.path, whom);
    made.activation = phrases_.scalar_of(r.value, {"the activation of ", whom}, whom);
    read_parameters(r, made, whom);
    if (r.muscle->tendon_state.kind != shape::nothing && !reading_.mistake)
      made.tendon_state = symbols_.symbol(*r.muscle->tendon_state.tokens[0].symbol, whom);
    if (reading_.mistake) return;
    into.muscles.push(made);
    if (made.tendon_state.is_given()) into.state_rates.push({m_.speeds.find(made.tendon_state), {}, {}});
  }

private:
  constexpr void read_parameters(const load_record& r, mechanics::muscle& to, std::string_view whom) {
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
    const phrase* given = r.terms;
    for (const part& each : parts) {
      const sentence of({"the ", each.called, " of "});
      if (given->kind == shape::nothing)
        reading_.fail({whom, " has no ", each.called, "; set it in muscle_parameters{...}"});
      else
        each.value = phrases_.scalar_of(*given, {of.view(), whom}, whom);
      ++given;
    }
  }
};

} // namespace kanexpr::derivation
