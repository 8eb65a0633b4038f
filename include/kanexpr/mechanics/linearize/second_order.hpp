#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/minimal.hpp>
#include <kanexpr/mechanics/linearize/linearizer.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/factoring.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// Second-order derivatives of a weighted sum of the rates, λᵀ[q̇; u̇], with respect to z = [q; u; r],
/// without constraints on the state.
///
/// The rates satisfy the inverse dynamics ρ(z, u̇) = 0, including the constraints f_a = 0; both are linear in
/// u̇. With the adjoint μ of the weights, (∂ρ/∂u̇)ᵀ μ = λ_u, the sum ψ = λ_qᵀ q̇ − μᵀρ has the gradient ψ_z
/// at constant μ and u̇, and with the derivatives u̇_z
///
///     ∂²(λᵀẋ)/∂z² = ψ_zz + ψ_zu̇ u̇_z + (ψ_zu̇ u̇_z)ᵀ
///
/// No inverse is differentiated, and u̇_z is that of the linearization. ρ belongs to the independent speeds;
/// multipliers would be additional unknowns, whose derivatives along every direction are not needed
/// otherwise. Griewank & Walther, Evaluating Derivatives (2008), section 15.2.
class second_order {
public:
  /// `first` linearizes in free directions.
  constexpr second_order(graph& g, linearizer& first)
      : g_(g), first_(first), form_(first.form()), mass_(g, form_.known.mass),
        force_(negative(summed(form_.f_2, form_.f_3))) {
    for (int i = 0; i < form_.q.size() + form_.u.size(); ++i)
      weights_.push(symbol(symbolic::symbol_kind::weight, "weight", i));
    for (int j = 0; j < z().size(); ++j)
      direction_.push(symbol(symbolic::symbol_kind::direction, "direction", j));
    for (int i = 0; i < force_.size() + form_.f_a.size(); ++i)
      held_.push(symbol(symbolic::symbol_kind::multiplier, "adjoint", i));
  }
  second_order(const second_order&) = delete;
  second_order& operator=(const second_order&) = delete;

  constexpr symbolic::matrix get(quantity wanted) {
    if (wanted == quantity::weighted_gradient) return gradient();
    if (wanted == quantity::directional_derivative) return directional_derivative();
    if (wanted == quantity::weighted_hessian) return hessian();
    return product();
  }

  /// ∂(λᵀẋ)/∂z.
  constexpr symbolic::matrix gradient() {
    const sequence<expression>& found = slopes();
    symbolic::matrix column(g_, z().size(), 1);
    for (int j = 0; j < column.rows; ++j) column.entries[j] = found[j];
    return with_adjoint(column);
  }

  /// (∂ẋ/∂z) v.
  constexpr symbolic::matrix directional_derivative() {
    symbolic::differentiation d(g_);
    for (int j = 0; j < z().size(); ++j) d.set_rate(z().symbol(j), direction_[j]);
    return rates_along(d);
  }

  /// u̇_z is not formed; instead its cofactor is multiplied by the inverse mass matrix, because fewer
  /// directions of z change the cofactor. Of two equal entries, the cheaper one is formed: along a coordinate
  /// rather than a speed, along the last of two coordinates, which moves the fewest bodies, and along the
  /// first of two speeds. The inverse is multiplied by each cofactor on its own: to solve for all of them
  /// together saves at most 3 % of the time, and compilers need more memory.
  constexpr symbolic::matrix hessian() {
    const int size = z().size(), n = form_.q.size();
    const sequence<expression>& slope = slopes();
    symbolic::matrix all(g_, size, size), through(g_, size, size);
    for (int j = 0; j < size; ++j) {
      symbolic::differentiation d(g_);
      d.set_rate(z().symbol(j), {g_, graph::one});
      for (int i = j < n ? 0 : j; i < size; ++i)
        if (i <= j || i >= n) all(i, j) = all(j, i) = d.of(slope[i]);
      sequence<expression> unbalanced;
      for (int k = 0; k < form_.u.size(); ++k) unbalanced.push(d.of(slope[size + k]));
      add_through_rates(through, j, unbalanced);
    }
    for (int i = 0; i < size; ++i)
      for (int j = i; j < size; ++j) all(i, j) = all(j, i) = all(i, j) + (through(i, j) + through(j, i));
    constexpr int most_operations = 10'000, most_passes = 4;
    return symbolic::factored(g_, with_adjoint(all), form_.known.mass, most_operations, most_passes);
  }

  /// ∂²(λᵀẋ)/∂z² v: the derivative of the gradient along v, with the corresponding changes of u̇ and μ.
  /// Because λ is constant, ψ_u̇ = −λ_u is constant, too.
  constexpr symbolic::matrix product() {
    const int size = z().size(), n = form_.q.size();
    const sequence<expression>& slope = slopes();
    const symbolic::matrix rates = directional_derivative();
    symbolic::differentiation held(g_), d(g_);
    for (symbolic::differentiation* each : {&held, &d})
      for (int j = 0; j < size; ++j) each->set_rate(z().symbol(j), direction_[j]);
    sequence<expression> unbalanced;
    for (int k = 0; k < form_.u.size(); ++k) unbalanced.push(held.of(slope[size + k]));
    const sequence<expression> adjoint = adjoint_of(unbalanced);
    for (int k = 0; k < form_.u.size(); ++k) d.set_rate(form_.udot[k], rates(n + k, 0));
    for (int k = 0; k < held_.size(); ++k) d.set_rate(held_[k], adjoint[k]);
    symbolic::matrix column(g_, size, 1);
    for (int i = 0; i < size; ++i) column.entries[i] = d.of(slope[i]);
    return with_adjoint(column);
  }

  /// ∂ẋ/∂p, a column for each symbol. They are solved for on their own, because the columns of mass, mass
  /// center and inertia of a body share many operations.
  constexpr symbolic::matrix rates_by(const sequence<expression>& symbols) {
    symbolic::matrix all(g_, form_.q.size() + form_.u.size(), symbols.size());
    for (int j = 0; j < symbols.size(); ++j) {
      symbolic::differentiation d(g_);
      d.set_rate(symbols[j], {g_, graph::one});
      const symbolic::matrix column = rates_along(d);
      for (int i = 0; i < all.rows; ++i) all(i, j) = column(i, 0);
    }
    return all;
  }

  /// The derivatives of the rates [q̇; u̇] with respect to the symbols that have a rate in `d`.
  constexpr symbolic::matrix rates_along(symbolic::differentiation& d) {
    const int n = form_.q.size();
    const sequence<int>&free = form_.speeds.independent, &bound = form_.speeds.dependent;
    symbolic::matrix change(g_, bound.size(), 1), all(g_, n + form_.u.size(), 1);
    for (int i = 0; i < bound.size(); ++i) change(i, 0) = -d.of(form_.f_a[i]);
    const symbolic::matrix bias = symbolic::solve_linear(g_, first_.on_dependent(), change).x;
    sequence<expression> right;
    for (int i = 0; i < force_.size(); ++i) {
      right.push(d.of(force_[i]));
      for (int k = 0; k < bound.size(); ++k) right[i] -= form_.known.coupling(k, i) * bias(k, 0);
    }
    const sequence<expression> moved = solved(right);
    for (int i = 0; i < n; ++i) all(i, 0) = d.of(form_.known.qdot[i]);
    for (int i = 0; i < free.size(); ++i) all(n + free[i], 0) = moved[i];
    const sequence<expression> dependent = solved_for_dependent(form_.known.dependency, moved, bias.entries);
    for (int k = 0; k < bound.size(); ++k) all(n + bound[k], 0) = dependent[k];
    return all;
  }

private:
  constexpr const variations& z() const { return first_.variations(); }

  constexpr expression symbol(symbolic::symbol_kind kind, std::string_view what, int place) const {
    name called(what);
    called.append(place + 1);
    return symbolic::variable(g_, {kind, called, place});
  }

  /// ψ_z, followed by ψ_u̇, with symbols in place of μ, which must not be differentiated.
  constexpr const sequence<expression>& slopes() {
    if (!slopes_.empty()) return slopes_;
    sequence<expression> all = force_;
    all.append(form_.f_a), all.append(form_.known.qdot);
    symbolic::accumulation back(g_, all);
    for (int i = 0; i < held_.size(); ++i) back.seed(all[i], held_[i]);
    for (int i = 0; i < form_.q.size(); ++i) back.seed(form_.known.qdot[i], weights_[i]);
    back.run();
    for (int j = 0; j < z().size(); ++j) slopes_.push(back.by(z().symbol(j)));
    for (const expression& rate : form_.udot) slopes_.push(back.by(rate));
    return slopes_;
  }

  /// The adjoint of weights of u̇: the part for the equations for the independent speeds, followed by the
  /// part for f_a with the opposite sign.
  constexpr sequence<expression> adjoint_of(const sequence<expression>& of) {
    const sequence<int>&free = form_.speeds.independent, &bound = form_.speeds.dependent;
    sequence<expression> adjoint = solved(reduced(of));
    symbolic::matrix left(g_, bound.size(), 1);
    for (int k = 0; k < bound.size(); ++k) {
      left(k, 0) = -of[bound[k]];
      for (int i = 0; i < free.size(); ++i) left(k, 0) += form_.known.coupling(k, i) * adjoint[i];
    }
    adjoint.append(symbolic::solve_linear(g_, transposed(g_, first_.on_dependent()), left).x.entries);
    return adjoint;
  }

  /// A row of ψ_zu̇ u̇_z from one of ψ_zu̇. The rates follow from M δu̇_i = δf and δu̇_d = A δu̇_i + δb.
  constexpr void add_through_rates(symbolic::matrix& through, int row, const sequence<expression>& of) {
    bool is_zero = true;
    for (const expression& e : of) is_zero = is_zero && e.is_zero();
    if (is_zero) return;
    const symbolic::matrix &force = first_.changes_of_force_by_forward(), &direct = first_.direct_changes(),
                           &bias = first_.changes_of_bias();
    const sequence<expression> taken = solved(reduced(of));
    for (int j = 0; j < through.columns; ++j) {
      for (int i = 0; i < force.rows; ++i) through(row, j) += taken[i] * force(i, j);
      for (int i = 0; i < direct.rows; ++i) through(row, j) += of[i] * direct(i, j);
      for (int k = 0; k < bias.rows; ++k) through(row, j) += of[form_.speeds.dependent[k]] * bias(k, j);
    }
  }

  /// Multiplies a vector for all speeds by Tᵀ, which yields one for the independent speeds.
  constexpr sequence<expression> reduced(const sequence<expression>& of) const {
    return mechanics::reduced(of, form_.speeds, form_.known.dependency);
  }

  constexpr symbolic::matrix with_adjoint(symbolic::matrix m) {
    sequence<expression> of_speeds;
    for (int k = 0; k < form_.u.size(); ++k) of_speeds.push(weights_[form_.q.size() + k]);
    const sequence<expression> adjoint = adjoint_of(of_speeds);
    symbolic::substitution known(g_);
    for (int i = 0; i < held_.size(); ++i) known.replace(held_[i], adjoint[i]);
    for (expression& e : m.entries) e = known.in(e);
    return m;
  }

  constexpr sequence<expression> solved(const sequence<expression>& right) {
    const symbolic::symmetric_solution found = mass_.solve(right);
    first_.add_pivots(found.pivots);
    return found.x;
  }

  graph& g_;
  linearizer& first_;
  const general_form& form_;
  symbolic::symmetric_factorization mass_;
  sequence<expression> force_; ///< −(f_2 + f_3)
  sequence<expression> weights_{}, direction_{};
  sequence<expression> held_{}; ///< symbols of the adjoint
  sequence<expression> slopes_{};
};

} // namespace kanexpr::mechanics
