#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/sizes/term_sizes.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace kanexpr::runtime {

/// An operating point, completed by the rates and multipliers of the motion at this point and checked against
/// the equations of the system.
class consistent_point {
public:
  consistent_point(mechanics::equations& e, const std::vector<symbolic::replacement>& given)
      : form_(e.linearized().in_full().form()), g_(*e.skeleton_used().model->g), is_empty_(given.empty()),
        all_(given) {
    const bool knows_rates = names_any(form_.qdot),
               knows_accelerations = names_any(form_.udot) || names_any(form_.lambda);
    must_vanish(form_.f_c, "configuration constraint ");
    must_vanish(form_.f_v, "velocity constraint ");
    complete(form_.qdot, form_.known.qdot);
    if (!names_all(form_.udot)) complete(form_.udot, e.get(mechanics::quantity::udot).entries);
    if (!form_.lambda.empty()) complete(form_.lambda, e.linearized().multipliers().entries);
    if (knows_rates) must_vanish(mechanics::summed(form_.f_0, form_.f_1), "kinematic differential equation ");
    if (!knows_accelerations) return;
    must_vanish(form_.f_a, "the rate of velocity constraint ");
    must_vanish(mechanics::summed(mechanics::summed(form_.f_2, form_.f_3), form_.f_4),
                "dynamic differential equation ");
  }

  /// Whether the point specifies no values.
  bool is_empty() const { return is_empty_; }

  symbolic::point_values values(const symbolic::matrix& m) { return symbolic::limits_at(g_, m, all_); }

  /// The equations that the point does not satisfy, as sentences.
  const std::vector<std::string>& failures() const { return failures_; }

private:
  using symbols = base::sequence<symbolic::expression>;
  static constexpr double tolerance = 1e-9;

  bool names(symbolic::expression symbol) const {
    for (const symbolic::replacement& r : all_)
      if (r.symbol == symbol) return true;
    return false;
  }
  bool names_any(const symbols& wanted) const {
    for (const symbolic::expression& e : wanted)
      if (names(e)) return true;
    return false;
  }
  bool names_all(const symbols& wanted) const {
    for (const symbolic::expression& e : wanted)
      if (!names(e)) return false;
    return true;
  }

  /// For each symbol in `wanted` that the point does not specify, assigns the value of the corresponding
  /// expression at the point.
  void complete(const symbols& wanted, const symbols& expressions) {
    symbolic::matrix column(g_, wanted.size(), 1);
    column.entries = expressions;
    const symbolic::point_values found = values(column);
    for (const symbolic::singularity& s : found.singular)
      if (!names(wanted[s.row]))
        failures_.push_back(symbolic::print(wanted[s.row]) +
                            " has no value at the operating point: " + s.condition);
    std::vector<symbolic::replacement> added;
    for (int i = 0; i < wanted.size(); ++i)
      if (!names(wanted[i])) added.push_back({wanted[i], found.values.entries[i]});
    all_.insert(all_.end(), added.begin(), added.end());
  }

  /// Checks that equations vanish. Those that still contain a coordinate, a speed or a rate may be satisfied
  /// by unspecified values.
  void must_vanish(const symbols& zero, const std::string& what) {
    using kind = symbolic::symbol_kind;
    symbolic::matrix column(g_, zero.size(), 1);
    column.entries = zero;
    const symbols left = values(column).values.entries;
    symbolic::term_sizes sizes(g_);
    for (symbolic::expression& e : column.entries) e = sizes.of(e);
    const symbols terms = values(column).values.entries;
    const mechanics::contents held(g_);
    for (int i = 0; i < left.size(); ++i) {
      if (held.holds_any(left[i], {kind::coordinate, kind::speed, kind::coordinate_rate, kind::speed_rate,
                                   kind::multiplier}))
        continue;
      if (vanishes(left[i], terms[i])) continue;
      failures_.push_back("the operating point does not satisfy " + what + std::to_string(i + 1) +
                          ": the residual is " + symbolic::print(left[i]));
    }
  }

  /// Whether a sum is negligible compared with its terms, at two generic values of its symbols.
  bool vanishes(symbolic::expression e, symbolic::expression terms) const {
    for (const double first : {0.7312, 1.2931}) {
      const auto any = [&](int id) { return 0.4 + std::fmod(first * (id + 1), 1.0); };
      const base::sequence<double> value = symbolic::values_at(g_, {e.node(), terms.node()}, any);
      if (!(std::abs(value[0]) <= tolerance * value[1])) return false;
    }
    return true;
  }

  const mechanics::general_form& form_;
  symbolic::graph& g_;
  bool is_empty_;
  std::vector<symbolic::replacement> all_; ///< the specified values, then those that follow from them
  std::vector<std::string> failures_{};
};

} // namespace kanexpr::runtime
