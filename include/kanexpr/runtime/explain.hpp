#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/derivation/check_words.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// One form of the equations of motion, and what a result costs in it.
struct formulation_candidate {
  std::string called{}; ///< "axes of each body, by elimination"
  std::string cause{};  ///< why it does not apply to the system, or was not formed; empty if it applies
  symbolic::cost cost{};
  long long weighted = 0; ///< the cost by the given weights
  /// The form, for `builder::formulation`.
  mechanics::formulation form{};
  /// The word that states it in a model: "formulation<written_in<Arm, Shoulder>>". It is empty for the form
  /// that the model has already.
  std::string word{};
  bool is_left_out = false; ///< it may apply, but was not formed

  bool applies() const { return cause.empty(); }
};

/// The forms in which the equations of a system can be written. The first is that of the model.
struct explanation {
  std::string mistake{}; ///< of the system; there are no candidates then
  std::vector<formulation_candidate> candidates{};
  std::size_t cheapest = 0; ///< by the given weights; the first of several equal ones
  operation_weights weights{};
  /// How the form of the model finds u̇; `solution::cheapest` if the counted results do not depend on it.
  mechanics::solution solved_by = mechanics::solution::cheapest;

  /// The form of the model and the cheapest form. After a mistake, both are a candidate that does not apply,
  /// with a form that states nothing.
  const formulation_candidate& chosen() const { return candidate(0); }
  const formulation_candidate& best() const { return candidate(cheapest); }
  /// A table with a row for each candidate, the weights, and the word that states the cheapest one.
  KANEXPR_ENGINE std::string text() const;

private:
  KANEXPR_ENGINE const formulation_candidate& candidate(std::size_t place) const;
};

/// Options of `explain`.
struct explain_options {
  /// The results that are counted together; the operations for their status are included.
  std::vector<mechanics::quantity> results{mechanics::quantity::udot};
  /// By default, those of the model.
  std::optional<operation_weights> weights{};
  /// Whether the axes and reference points of each body are varied one after another until the cost falls no
  /// further, and other dependent speeds are tried.
  bool searches = true;
  /// Whether the axes of a frame may be used, by its name; by default, those of all frames.
  std::function<bool(std::string_view)> may_use{};
};

namespace runtime {

/// The word of a formulation that states weights: "weighted_by<operation_weights{.fused = 1}>".
KANEXPR_ENGINE std::string word_of(const symbolic::operation_weights& weights);

KANEXPR_ENGINE explanation explain_types(const derivation::checked_words& from,
                                         const explain_options& options);

} // namespace runtime

/// Forms the equations of a system in several ways at run time and counts the operations of a result: by
/// elimination and by articulated bodies, in different axes, about different points, for different internal
/// speeds and, if there are constraints, for different dependent speeds. The counts are those of the compiled
/// code.
template <class System>
explanation explain(const explain_options& options = {}) {
  return runtime::explain_types(derivation::words_of<System>, options);
}

/// The same for the system of a builder.
KANEXPR_ENGINE explanation explain(const runtime::builder& built, const explain_options& options = {});

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/explain.ipp>
#include <kanexpr/runtime/explanation.ipp>
#endif
