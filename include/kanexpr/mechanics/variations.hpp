#pragma once

#include <kanexpr/mechanics/general_form.hpp>
#include <kanexpr/symbolic/differentiate.hpp>
#include <kanexpr/symbolic/solve_linear.hpp>

namespace kanexpr::mechanics {

/// The directions in which a constrained system can leave an operating point: one for each independent
/// coordinate, then each independent speed, then each input, where the dependent coordinates and speeds
/// follow so that f_c and f_v stay zero.
class variations {
public:
  constexpr variations(graph& g, const general_form& form) : g_(g), form_(form) {
    const int directions = form.states() + form.inputs();
    coordinates_ = symbolic::matrix(g, form.coordinates.dependent.size(), directions);
    speeds_ = symbolic::matrix(g, form.speeds.dependent.size(), directions);
    if (coordinates_.rows != 0) coordinates_ = follow(form.f_c, form.q, form.coordinates, {});
    if (speeds_.rows != 0) speeds_ = follow(form.f_v, form.u, form.speeds, form.known.on_u);
  }

  constexpr int size() const { return form_.states() + form_.inputs(); }

  /// How the dependent coordinates and speeds follow, a column for each direction.
  constexpr const symbolic::matrix& of_coordinates() const { return coordinates_; }
  constexpr const symbolic::matrix& of_speeds() const { return speeds_; }

  /// The coupled equations that were solved for the dependent coordinates.
  constexpr const sequence<symbolic::solved_block>& coordinate_blocks() const { return blocks_; }

  /// The symbol that is varied by itself.
  constexpr expression symbol(int j) const {
    const sequence<int>&q = form_.coordinates.independent, &u = form_.speeds.independent;
    if (j < q.size()) return form_.q[q[j]];
    if (j < form_.states()) return form_.u[u[j - q.size()]];
    return form_.r[j - form_.states()];
  }

  /// The derivatives of expressions along direction `j`.
  constexpr symbolic::derivation along(int j) const {
    symbolic::derivation d(g_);
    d.set_rate(symbol(j), {g_, graph::one});
    for (int i = 0; i < coordinates_.rows; ++i)
      d.set_rate(form_.q[form_.coordinates.dependent[i]], coordinates_(i, j));
    for (int i = 0; i < speeds_.rows; ++i) d.set_rate(form_.u[form_.speeds.dependent[i]], speeds_(i, j));
    return d;
  }

  /// The same from the derivatives by all symbols, `by(symbol)`.
  template <class By>
  constexpr expression contracted(int j, const By& by) const {
    expression sum = by(symbol(j));
    for (int i = 0; i < coordinates_.rows; ++i)
      sum += coordinates_(i, j) * by(form_.q[form_.coordinates.dependent[i]]);
    for (int i = 0; i < speeds_.rows; ++i) sum += speeds_(i, j) * by(form_.u[form_.speeds.dependent[i]]);
    return sum;
  }

private:
  /// Keeps some equations zero by the dependent ones among their unknowns.
  constexpr symbolic::matrix follow(const sequence<expression>& zero, const sequence<expression>& unknowns,
                                    const partition& split, const symbolic::matrix& known) {
    const int rows = zero.size();
    symbolic::matrix by_dependent(g_, rows, rows), right(g_, rows, size());
    for (int j = 0; j < rows; ++j) {
      const int column = split.dependent[j];
      symbolic::derivation d(g_);
      if (known.rows == 0) d.set_rate(unknowns[column], {g_, graph::one});
      for (int i = 0; i < rows; ++i) by_dependent(i, j) = known.rows == 0 ? d.of(zero[i]) : known(i, column);
    }
    for (int j = 0; j < size(); ++j) {
      const int place = independent_place(unknowns, split, j);
      symbolic::derivation d = along(j);
      for (int i = 0; i < rows; ++i)
        right(i, j) = place >= 0 && known.rows != 0 ? -known(i, place) : -d.of(zero[i]);
    }
    const symbolic::linear_solution solved = symbolic::solve_linear(g_, by_dependent, right, {});
    if (known.rows == 0) blocks_ = solved.blocks;
    return solved.x;
  }

  /// Where the symbol of a direction stands among some unknowns, or none.
  constexpr int independent_place(const sequence<expression>& unknowns, const partition& split, int j) const {
    for (int i : split.independent)
      if (unknowns[i] == symbol(j)) return i;
    return none;
  }

  graph& g_;
  const general_form& form_;
  symbolic::matrix coordinates_, speeds_;
  sequence<symbolic::solved_block> blocks_;
};

} // namespace kanexpr::mechanics
