#pragma once

#include <kanexpr/mechanics/linearize/linearizer.hpp>
#include <kanexpr/mechanics/linearize/second_order.hpp>
#include <kanexpr/mechanics/linearize/system_form.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

#include <optional>

namespace kanexpr::mechanics {

/// The equations of one system, linearized in each of the ways that results ask for, all with the symbols u̇.
/// No way is gone before it is asked for, and none twice.
class linearized_equations {
public:
  /// What the equations are formed of, which may come to be known later.
  constexpr linearized_equations(const skeleton& s, const loads& acting, const constraints& c,
                                 const symbolic::matrix& by_q, const partition& coordinates,
                                 const partition& speeds, dynamics& d)
      : s_(s), m_(*s.model), loads_(acting), constraints_(c), by_q_(by_q), coordinates_(coordinates),
        speeds_(speeds), dynamics_(d) {}
  linearized_equations(const linearized_equations&) = delete;
  linearized_equations& operator=(const linearized_equations&) = delete;

  /// What was formed, but for what is formed again at little cost.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.reduced_);
  }

  /// The equations of the independent speeds.
  constexpr linearizer& reduced() {
    if (!reduced_.has_value()) reduced_.emplace(*m_.g, form().reduced());
    return *reduced_;
  }

  /// The same, but by Lagrange's method the equations of all speeds with their multipliers.
  constexpr linearizer& in_full() {
    if (m_.derived_by == method::kane || constraints_.size() == 0) return reduced();
    if (!in_full_.has_value()) in_full_.emplace(*m_.g, form().with_multipliers());
    return *in_full_;
  }

  /// The rates of all coordinates and speeds as functions of the whole state, whether it satisfies the
  /// constraints or not.
  constexpr linearizer& freely() {
    if (freely_) return *freely_;
    return freely_.emplace(*m_.g, form().reduced(), directions::free);
  }

  constexpr second_order& to_second_order() {
    return second_order_ ? *second_order_ : second_order_.emplace(*m_.g, freely());
  }

  /// A result of the linearized equations, or to the second order.
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

  /// λ of a system by Lagrange's method with constraints.
  constexpr symbolic::matrix multipliers() {
    const general_form& full = in_full().form();
    const sequence<expression> force = summed(full.f_2, full.f_3);
    sequence<expression> of_dependent;
    for (int d : speeds_.dependent) of_dependent.push(-force[d]);
    return mechanics::multipliers(*m_.g, constraints_, speeds_, of_dependent).x;
  }

  /// What the dependent coordinates were solved for in its directions.
  constexpr sequence<symbolic::solved_block> coordinate_blocks() const {
    const std::optional<linearizer>& any = in_full_ ? in_full_ : reduced_;
    if (!any) return {};
    return any->variations().coordinate_blocks();
  }

  /// What the mass matrix was divided by.
  constexpr sequence<symbolic::pivot> pivots() const {
    sequence<symbolic::pivot> all;
    for (const auto* any : {&reduced_, &freely_})
      if (*any)
        for (const symbolic::pivot& p : (*any)->pivots()) all.push(p);
    return all;
  }

private:
  constexpr system_form form() { return {s_, loads_, constraints_, by_q_, coordinates_, speeds_, dynamics_}; }

  /// A matrix with the multipliers that go with the rates q̇ and u̇ in it.
  constexpr symbolic::matrix imposed_forces(symbolic::matrix m) {
    const general_form& full = in_full().form();
    if (full.lambda.empty()) return m;
    const symbolic::matrix lambda = multipliers();
    symbolic::substitution imposed(*m_.g);
    for (int i = 0; i < lambda.rows; ++i) imposed.replace(full.lambda[i], lambda(i, 0));
    for (expression& e : m.entries) e = imposed.in(e);
    return m;
  }

  const skeleton& s_;
  const mechanism& m_;
  const loads& loads_;
  const constraints& constraints_;
  const symbolic::matrix& by_q_;
  const partition &coordinates_, &speeds_;
  dynamics& dynamics_;
  std::optional<linearizer> reduced_{}, in_full_{}, freely_{};
  std::optional<second_order> second_order_{};
};

} // namespace kanexpr::mechanics
