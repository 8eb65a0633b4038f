#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// The symbols of a system with respect to which its results are differentiated.
class differentiable_symbols {
public:
  using expressions = base::sequence<symbolic::expression>;

  expressions& operator[](symbols which) { return all_[static_cast<std::size_t>(which)]; }
  const expressions& of(symbols which) const { return all_[static_cast<std::size_t>(which)]; }

private:
  std::array<expressions, 5> all_{};
};

/// The derivatives of an arbitrary column of expressions, obtained by the chain rule through its graph.
/// Common subexpressions are shared.
class differentiated {
public:
  differentiated(symbolic::graph& g, const base::sequence<symbolic::expression>& y,
                 const differentiable_symbols& of)
      : graph_(g), y_(y), symbols_(of) {}

  bool differentiates(const base::sequence<symbolic::expression>& y) const {
    return std::equal(y.begin(), y.end(), y_.begin(), y_.end(),
                      [](const auto& a, const auto& b) { return a.node() == b.node(); });
  }

  symbolic::matrix get(const requested_derivative& wanted) {
    using enum requested_derivative::kind;
    switch (wanted.type) {
    case none: break;
    case jacobian: return symbolic::jacobian(graph_, y_, symbols_.of(wanted.by));
    case directional: return column(along_direction(wanted.along));
    case directional_jacobian:
      return symbolic::jacobian(graph_, along_direction(wanted.along), symbols_.of(wanted.by));
    case weighted: return column(gradient_by(wanted.by));
    case weighted_jacobian:
      // Both blocks use the same order, so that the Hessian is symmetric to the last bit.
      if (wanted.by < wanted.and_by) return transposed(second(wanted.and_by, wanted.by));
      return second(wanted.by, wanted.and_by);
    }
    return column(y_);
  }

  /// The number of weights, or of entries of the direction, that a derivative takes.
  int weights_for(const requested_derivative& wanted) const {
    using enum requested_derivative::kind;
    int count = 0;
    if (wanted.type == directional || wanted.type == directional_jacobian)
      for (symbols each : wanted.along) count += symbols_.of(each).size();
    if (wanted.type == weighted || wanted.type == weighted_jacobian) count = y_.size();
    return count;
  }

private:
  using expression = symbolic::expression;
  using expressions = base::sequence<expression>;

  /// Returns a variable with the same name as in mechanics/linearize/second_order.hpp, because the results of
  /// both may appear in the same function.
  expression seed(symbolic::symbol_kind kind, std::string_view what, int place) {
    base::name called(what);
    called.append(place + 1);
    return symbolic::variable(graph_, {kind, called, place});
  }

  expressions along_direction(const std::vector<symbols>& which) {
    symbolic::differentiation d(graph_);
    int place = 0;
    for (symbols each : which)
      for (const expression& s : symbols_.of(each)) {
        d.set_rate(s, seed(symbolic::symbol_kind::direction, "direction", place));
        ++place;
      }
    expressions rates;
    for (const expression& each : y_) rates.push(d.of(each));
    return rates;
  }

  expressions gradient_by(symbols which) {
    if (!reverse_pass_) {
      reverse_pass_.emplace(graph_, y_);
      for (int i = 0; i < y_.size(); ++i)
        reverse_pass_->seed(y_[i], seed(symbolic::symbol_kind::weight, "weight", i));
      reverse_pass_->run();
    }
    expressions slopes;
    for (const expression& s : symbols_.of(which)) slopes.push(reverse_pass_->by(s));
    return slopes;
  }

  symbolic::matrix second(symbols by, symbols and_by) {
    const expressions slopes = gradient_by(by), &columns = symbols_.of(and_by);
    symbolic::matrix all(graph_, slopes.size(), columns.size());
    symbolic::differentiation d(graph_);
    for (int j = 0; j < all.columns; ++j) {
      d.set_rate(columns[j], {graph_, symbolic::graph::one});
      for (int i = by == and_by ? j : 0; i < all.rows; ++i) all(i, j) = d.of(slopes[i]);
      d.restart();
    }
    if (by == and_by)
      for (int j = 0; j < all.columns; ++j)
        for (int i = 0; i < j; ++i) all(i, j) = all(j, i);
    return all;
  }

  symbolic::matrix transposed(const symbolic::matrix& m) const {
    symbolic::matrix exchanged(graph_, m.columns, m.rows);
    for (int i = 0; i < m.rows; ++i)
      for (int j = 0; j < m.columns; ++j) exchanged(j, i) = m(i, j);
    return exchanged;
  }

  symbolic::matrix column(const expressions& entries) const {
    symbolic::matrix m(graph_, entries.size(), 1);
    for (int i = 0; i < m.rows; ++i) m.entries[i] = entries[i];
    return m;
  }

  symbolic::graph& graph_;
  expressions y_;
  const differentiable_symbols& symbols_;
  std::optional<symbolic::accumulation> reverse_pass_{};
};

/// The residual of the equations of motion at given rates: q̇ − q̇(q, u), the residual M u̇ − f of inverse
/// dynamics in the rows of the independent speeds, and the rates of the constraints in the rows of the
/// dependent speeds. It contains no multipliers, and no system is solved for u̇.
inline symbolic::matrix implicit_form(symbolic::graph& g, mechanics::equations& of) {
  const mechanics::general_form& form = of.linearized().freely().form();
  const base::sequence<symbolic::expression> force = mechanics::summed(form.f_2, form.f_3);
  const int coordinates = form.q.size();
  symbolic::matrix residual(g, coordinates + form.u.size(), 1);
  for (int i = 0; i < coordinates; ++i) residual(i, 0) = form.qdot[i] - form.known.qdot[i];
  for (int i = 0; i < force.size(); ++i) residual(coordinates + form.speeds.independent[i], 0) = force[i];
  for (int i = 0; i < form.f_a.size(); ++i) residual(coordinates + form.speeds.dependent[i], 0) = form.f_a[i];
  return residual;
}

} // namespace kanexpr::exporting
