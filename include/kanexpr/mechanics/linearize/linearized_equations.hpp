#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/linearize/linearizer.hpp>
#include <kanexpr/mechanics/linearize/second_order.hpp>
#include <kanexpr/mechanics/linearize/system_form.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

#include <optional>

namespace kanexpr::mechanics {

/// The linearized equations of one system, in each form that the requested results need, with the symbols u̇.
/// Each form is derived on first use and only once.
class linearized_equations {
public:
  /// Stores references to the parts of the equations, which may be completed later.
  constexpr explicit linearized_equations(const parts_of_system& of) : of_(of), m_(*of.skeleton.model) {}
  linearized_equations(const linearized_equations&) = delete;
  linearized_equations& operator=(const linearized_equations&) = delete;

  /// The stored members, except those that are cheap to form again.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.reduced_);
  }

  /// The equations for the independent speeds.
  constexpr linearizer& reduced() {
    if (!reduced_.has_value()) reduced_.emplace(*m_.g, system_form(of_).reduced());
    return *reduced_;
  }

  /// The same equations for Kane's method; for Lagrange's method, the equations for all speeds with the
  /// multipliers.
  constexpr linearizer& in_full() {
    if (m_.derived_by == method::kane || of_.constraints.size() == 0) return reduced();
    if (!in_full_.has_value()) in_full_.emplace(*m_.g, system_form(of_).with_multipliers());
    return *in_full_;
  }

  /// The rates of all coordinates and speeds as functions of the whole state, whether or not it satisfies the
  /// constraints.
  constexpr linearizer& freely() {
    if (of_.coordinates.dependent.empty() && of_.speeds.dependent.empty()) return reduced();
    if (freely_) return *freely_;
    return freely_.emplace(*m_.g, system_form(of_).reduced(), directions::free);
  }

  constexpr second_order& to_second_order() {
    return second_order_ ? *second_order_ : second_order_.emplace(*m_.g, freely());
  }

  /// A result of the linearized equations, or one of second order.
  constexpr symbolic::matrix get(quantity wanted) {
    using enum quantity;
    if (wanted == state_matrix) return reduced().explicit_form().state;
    if (wanted == input_matrix) return reduced().explicit_form().input;
    if (wanted == state_jacobian) return freely().of_all_rates().state;
    if (wanted == input_jacobian) return freely().of_all_rates().input;
    if (wanted == implicit_mass_matrix) return imposed_forces(in_full().implicit_form().mass);
    if (wanted == implicit_state_matrix) return imposed_forces(in_full().implicit_form().state);
    if (wanted == implicit_input_matrix) return imposed_forces(in_full().implicit_form().input);
    return to_second_order().get(wanted);
  }

  /// λ of a constrained system, by Lagrange's method.
  constexpr symbolic::matrix multipliers() {
    const general_form& full = in_full().form();
    const sequence<expression> force = summed(full.f_2, full.f_3);
    sequence<expression> of_dependent;
    for (int d : of_.speeds.dependent) of_dependent.push(-force[d]);
    return mechanics::multipliers(*m_.g, of_.constraints, of_.speeds, of_dependent).x;
  }

  /// The coupled equations that were solved for the directions of the dependent coordinates.
  constexpr sequence<symbolic::solved_block> coordinate_blocks() const {
    const std::optional<linearizer>& any = in_full_ ? in_full_ : reduced_;
    if (!any) return {};
    return any->variations().coordinate_blocks();
  }

  /// The pivots of the mass matrix.
  constexpr sequence<symbolic::pivot> pivots() const {
    sequence<symbolic::pivot> all;
    for (const auto* any : {&reduced_, &freely_})
      if (*any) all.append((*any)->pivots());
    return all;
  }

private:
  /// Substitutes the multipliers that belong to the rates q̇ and u̇ into a matrix.
  constexpr symbolic::matrix imposed_forces(symbolic::matrix m) {
    const general_form& full = in_full().form();
    if (full.lambda.empty()) return m;
    const symbolic::matrix lambda = multipliers();
    symbolic::substitution imposed(*m_.g);
    for (int i = 0; i < lambda.rows; ++i) imposed.replace(full.lambda[i], lambda(i, 0));
    for (expression& e : m.entries) e = imposed.in(e);
    return m;
  }

  const parts_of_system of_;
  const mechanism& m_;
  std::optional<linearizer> reduced_{}, in_full_{}, freely_{};
  std::optional<second_order> second_order_{};
};

} // namespace kanexpr::mechanics
