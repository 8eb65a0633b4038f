#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/linearize/general_form.hpp>
#include <kanexpr/symbolic/derivatives/dependence.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>

namespace kanexpr::mechanics {

/// Whether the dependent coordinates and speeds follow the independent ones or are varied independently.
enum class directions { along_constraints, free };

/// The directions in which a system can leave an operating point: one for each independent coordinate, then
/// each independent speed, then each input; the dependent coordinates and speeds follow so that f_c and f_v
/// remain zero. Free directions vary each coordinate, each speed and each input independently; they violate
/// the constraints, and the point need not satisfy them.
class variations {
public:
  constexpr variations(graph& g, const general_form& form, directions which)
      : g_(g), form_(form), of_q_(followed(form.coordinates, which)), of_u_(followed(form.speeds, which)) {
    for (int i : of_q_.independent) symbols_.push(form.q[i]);
    for (int i : of_u_.independent) symbols_.push(form.u[i]);
    for (const expression& input : form.r) symbols_.push(input);
    coordinates_ = symbolic::matrix(g, of_q_.dependent.size(), size());
    speeds_ = symbolic::matrix(g, of_u_.dependent.size(), size());
    if (coordinates_.rows != 0) coordinates_ = follow(form.f_c, form.q, of_q_, form.known.on_q);
    if (speeds_.rows != 0) speeds_ = follow(form.f_v, form.u, of_u_, form.known.on_u);
  }

  /// Creates an empty object to be restored from stored members.
  constexpr variations(graph& g, const general_form& form) : g_(g), form_(form) {}

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.of_q_, self.of_u_, self.symbols_, self.coordinates_, self.speeds_, self.blocks_);
  }

  constexpr int size() const { return symbols_.size(); }
  /// The number of directions that belong to coordinates and speeds; these come first.
  constexpr int states() const { return size() - form_.inputs(); }

  /// The variations of the dependent coordinates and speeds, a column for each direction.
  constexpr const symbolic::matrix& of_coordinates() const { return coordinates_; }
  constexpr const symbolic::matrix& of_speeds() const { return speeds_; }

  /// The coupled equations that were solved for the dependent coordinates.
  constexpr const sequence<symbolic::solved_block>& coordinate_blocks() const { return blocks_; }

  /// The symbol that direction `j` varies independently.
  constexpr expression symbol(int j) const { return symbols_[j]; }

  /// The derivatives of expressions along direction `j`.
  constexpr symbolic::differentiation along(int j) const {
    symbolic::differentiation d(g_);
    d.set_rate(symbol(j), {g_, graph::one});
    for (int i = 0; i < coordinates_.rows; ++i) d.set_rate(form_.q[of_q_.dependent[i]], coordinates_(i, j));
    for (int i = 0; i < speeds_.rows; ++i) d.set_rate(form_.u[of_u_.dependent[i]], speeds_(i, j));
    return d;
  }

  /// Finds the directions along which nodes change.
  constexpr symbolic::dependence dependence_of(const sequence<expression>& of) const {
    symbolic::dependence found(g_, symbolic::nodes_of(of), size());
    for (int j = 0; j < size(); ++j) {
      found.mark(symbol(j).node(), j);
      for (int i = 0; i < coordinates_.rows; ++i)
        if (!coordinates_(i, j).is_zero()) found.mark(form_.q[of_q_.dependent[i]].node(), j);
      for (int i = 0; i < speeds_.rows; ++i)
        if (!speeds_(i, j).is_zero()) found.mark(form_.u[of_u_.dependent[i]].node(), j);
    }
    found.spread();
    return found;
  }

  /// The derivative along direction `j`, from the derivatives with respect to all symbols, `by(symbol)`.
  template <class By>
  constexpr expression contracted(int j, const By& by) const {
    expression sum = by(symbol(j));
    for (int i = 0; i < coordinates_.rows; ++i) sum += coordinates_(i, j) * by(form_.q[of_q_.dependent[i]]);
    for (int i = 0; i < speeds_.rows; ++i) sum += speeds_(i, j) * by(form_.u[of_u_.dependent[i]]);
    return sum;
  }

private:
  /// The partition into dependent and independent unknowns; in free directions, no unknown is dependent.
  static constexpr partition followed(const partition& split, directions which) {
    if (which == directions::along_constraints) return split;
    return partition_by(sequence<char>(split.dependent.size() + split.independent.size(), 0));
  }

  /// The variations of the dependent unknowns that keep the expressions `zero` at zero.
  constexpr symbolic::matrix follow(const sequence<expression>& zero, const sequence<expression>& unknowns,
                                    const partition& split, const symbolic::matrix& known) {
    const int rows = zero.size();
    symbolic::matrix by_dependent(g_, rows, rows), right(g_, rows, size());
    for (int j = 0; j < rows; ++j) {
      const int column = split.dependent[j];
      symbolic::differentiation d(g_);
      if (known.rows == 0) d.set_rate(unknowns[column], {g_, graph::one});
      for (int i = 0; i < rows; ++i) by_dependent(i, j) = known.rows == 0 ? d.of(zero[i]) : known(i, column);
    }
    for (int j = 0; j < size(); ++j) {
      const int place = independent_place(unknowns, split, j);
      symbolic::differentiation d = along(j);
      for (int i = 0; i < rows; ++i)
        right(i, j) = place >= 0 && known.rows != 0 ? -known(i, place) : -d.of(zero[i]);
    }
    const symbolic::linear_solution solved = symbolic::solve_linear(
        g_, by_dependent, right, known.rows == 0 ? by_dependent : known, symbolic::nodes_of(zero));
    if (&zero == &form_.f_c) blocks_ = solved.blocks;
    return solved.x;
  }

  /// The index of the symbol of direction `j` among `unknowns`, or none.
  constexpr int independent_place(const sequence<expression>& unknowns, const partition& split, int j) const {
    for (int i : split.independent)
      if (unknowns[i] == symbol(j)) return i;
    return none;
  }

  graph& g_;
  const general_form& form_;
  partition of_q_{}, of_u_{}; ///< the dependent and independent unknowns
  sequence<expression> symbols_{};
  symbolic::matrix coordinates_{}, speeds_{};
  sequence<symbolic::solved_block> blocks_{};
};

} // namespace kanexpr::mechanics
