#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>

namespace kanexpr::mechanics {

/// The inputs for which given forces vanish, or an error message if there are no such inputs. The forces
/// must be linear in the inputs.
struct required_inputs {
  sentence mistake{};
  symbolic::linear_solution solved{};
};

/// The inputs for which F_r + F_r* for the independent speeds, with the symbols u̇, vanishes.
constexpr required_inputs inputs_for(const mechanism& m, const sequence<expression>& forces) {
  const int speeds = forces.size(), inputs = m.inputs.size();
  if (speeds != inputs)
    return {sentence(
        {"required inputs are defined only if there are as many inputs as independent speeds; there ",
         inputs == 1 ? "is " : "are ", base::counted(inputs).view(), inputs == 1 ? " input" : " inputs",
         " for ", base::counted(speeds).view()})};
  const symbolic::matrix on_inputs = symbolic::jacobian(*m.g, forces, m.inputs);
  symbolic::matrix others(*m.g, speeds, 1);
  symbolic::substitution without_inputs(*m.g);
  for (const expression& r : m.inputs) without_inputs.replace(r, m.zero());
  for (int i = 0; i < speeds; ++i) others(i, 0) = -without_inputs.in(forces[i]);
  const base::zeros<char> live = symbolic::live_nodes(*m.g, symbolic::nodes_of(on_inputs.entries));
  for (const expression& r : m.inputs)
    if (live[r.node()] != 0)
      return {sentence(
          {"required inputs are defined only for forces linear in the inputs; they are not linear in ",
           m.g->symbol_at(r.node()).called.view()})};
  required_inputs found{{}, symbolic::solve_linear(*m.g, on_inputs, others)};
  if (!found.solved.structurally_regular)
    found.mistake = sentence(
        {"required inputs are defined only if the inputs act on all independent speeds; these do not"});
  return found;
}

} // namespace kanexpr::mechanics
