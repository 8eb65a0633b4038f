#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/mechanics/checks/check_derivatives.hpp>
#include <kanexpr/mechanics/linearize/linearization.hpp>
#include <kanexpr/numeric/equilibrated.hpp>
#include <kanexpr/numeric/factorized.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/linearization.hpp>
#include <kanexpr/runtime/operating_point.ipp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/symmetric_columns.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr::runtime {

/// Computes M⁻¹ [A B] of a linearization whose entries are all numbers, by elimination with row exchanges.
/// The result does not depend on the units of equations and unknowns.
class solve_numbers {
public:
  static bool are_numbers(const symbolic::matrix& m) {
    return std::all_of(m.entries.begin(), m.entries.end(), [](const auto& e) { return e.is_constant(); });
  }

  solve_numbers(symbolic::graph& g, const mechanics::implicit_linearization& given)
      : g_(g), mass_(numbers_of(given.mass)), scale_(mass_), factors_(scale_.applied_to(mass_)),
        rates_(g, given.mass.rows, given.state.columns + given.input.columns) {
    if (!*this) return;
    int done = 0;
    for (const symbolic::matrix* right : {&given.state, &given.input})
      for (int j = 0; j < right->columns; ++j) solve(numbers_of(*right).col(j), done++);
  }

  /// Whether M is regular.
  explicit operator bool() const { return factors_.singularity_measure() > base::vanishing_measure; }

  /// δ[q̇; u̇; λ], with a column for each state, followed by one for each input.
  const symbolic::matrix& rates() const { return rates_; }

private:
  Eigen::MatrixXd numbers_of(const symbolic::matrix& m) const {
    Eigen::MatrixXd numbers(m.rows, m.columns);
    for (int i = 0; i < m.rows; ++i)
      for (int j = 0; j < m.columns; ++j) numbers(i, j) = g_.number_at(m(i, j).node()).value();
    return numbers;
  }

  void solve(const Eigen::VectorXd& right, int into) {
    Eigen::VectorXd x = scale_.rows.cwiseProduct(right);
    factors_.solve(x);
    for (int i = 0; i < rates_.rows; ++i)
      rates_(i, into) = symbolic::constant(g_, symbolic::real(scale_.columns(i) * x(i)));
  }

  symbolic::graph& g_;
  Eigen::MatrixXd mass_;
  numeric::equilibration<Eigen::VectorXd> scale_;
  numeric::factorized<Eigen::VectorXd> factors_;
  symbolic::matrix rates_;
};

class linearization::at_point {
public:
  at_point(std::shared_ptr<derived> system, const linearization_point& given) : system_(std::move(system)) {
    const bool is_sound = !system_->mistake();
    point_reader reader(*system_);
    const std::vector<symbolic::replacement> point = reader.read(given);
    if (system_->mistake()) {
      failures_.assign(1, std::string(system_->mistake().view()));
      if (is_sound) system_->reader().forget_mistake(); // a mistake in the point only
      return;
    }
    failures_ = reader.failures();
    point_.emplace(equations(), point);
    failures_.insert(failures_.end(), point_->failures().begin(), point_->failures().end());
  }

  const std::vector<std::string>& failures() const { return failures_; }

  const implicit_matrices& implicit_form() {
    if (implicit_.M.rows != 0 || !point_) return implicit_;
    const mechanics::implicit_linearization& l = equations().linearized().in_full().implicit_form();
    return implicit_ = unless_mistaken<implicit_matrices>(
               {values(l.mass, "M"), values(l.state, "A"), values(l.input, "B")});
  }

  const explicit_matrices& explicit_form() {
    if (explicit_.A.rows != 0 || !point_) return explicit_;
    if (point_->is_empty()) return explicit_ = unless_mistaken(from_derivation());
    explicit_ = unless_mistaken(from_implicit());
    if (system_->mistake()) return explicit_;
    if (solve_numbers::are_numbers(explicit_.A) && solve_numbers::are_numbers(explicit_.B)) return explicit_;
    const std::size_t known_problems = failures_.size();
    const explicit_matrices derived = from_derivation();
    const int at_present = operations(explicit_);
    if (failures_.size() == known_problems && operations(derived) < at_present) explicit_ = derived;
    failures_.resize(known_problems);
    return explicit_;
  }

  output_matrices outputs(const symbolic::matrix& y) {
    if (!point_) return {};
    const mechanics::explicit_linearization l = equations().linearized().reduced().outputs(y.entries);
    return unless_mistaken<output_matrices>({values(l.state, "C"), values(l.input, "D")});
  }

  symbolic::matrix permutation() {
    if (!point_) return {};
    return mechanics::permutation_of(graph(), equations().linearized().in_full().form());
  }

  std::vector<std::string> states() {
    std::vector<std::string> names;
    if (!point_) return names;
    const mechanics::general_form& form = equations().linearized().reduced().form();
    for (int i : form.coordinates.independent) names.push_back(symbolic::print(form.q[i]));
    for (int i : form.speeds.independent) names.push_back(symbolic::print(form.u[i]));
    return names;
  }
  std::vector<std::string> inputs() {
    std::vector<std::string> names;
    if (!point_) return names;
    for (const symbolic::expression& r : equations().linearized().reduced().form().r)
      names.push_back(symbolic::print(r));
    return names;
  }

private:
  mechanics::equations& equations() { return *system_->equations(); }
  symbolic::graph& graph() { return system_->graph(); }

  /// Returns the result; empty if forming it revealed a mistake in the system.
  template <class Form>
  Form unless_mistaken(const Form& formed) {
    if (!system_->mistake()) return formed;
    failures_.assign(1, std::string(system_->mistake().view()));
    return {};
  }

  symbolic::matrix values(const symbolic::matrix& m, const std::string& called) {
    const symbolic::point_values found = point_->values(symbolic::written_out(m));
    for (const symbolic::singularity& s : found.singular)
      failures_.push_back("entry (" + std::to_string(s.row + 1) + ", " + std::to_string(s.column + 1) +
                          ") of " + called + " has no value at the operating point: " + s.condition);
    if (const base::sentence lacking = mechanics::check_derivatives(found.values))
      if (const std::string text(lacking.view()); std::ranges::find(failures_, text) == failures_.end())
        failures_.push_back(text);
    system_->note_linearization(found.values);
    return found.values;
  }

  explicit_matrices from_derivation() {
    const mechanics::explicit_linearization& l = equations().linearized().reduced().explicit_form();
    return {values(l.state, "A"), values(l.input, "B")};
  }

  /// Solves for the rates after the values have been substituted, numerically if all entries are numbers.
  explicit_matrices from_implicit() {
    const implicit_matrices& given = implicit_form();
    const mechanics::linearizer& full = equations().linearized().in_full();
    const symbolic::matrix rates = rates_of({given.M, given.A, given.B});
    const mechanics::explicit_linearization rows = mechanics::rows_of_states(graph(), full.form(), rates);
    system_->note_linearization(rows.state), system_->note_linearization(rows.input);
    return {rows.state, rows.input};
  }

  symbolic::matrix rates_of(const mechanics::implicit_linearization& given) {
    bool all_numbers = true;
    for (const symbolic::matrix* m : {&given.mass, &given.state, &given.input})
      all_numbers = all_numbers && solve_numbers::are_numbers(*m);
    if (all_numbers) {
      const solve_numbers solved(graph(), given);
      require(static_cast<bool>(solved));
      return solved.rates();
    }
    const symbolic::linear_solution solved = mechanics::solve_for_rates(graph(), given);
    require(solved.structurally_regular && has_values(solved.x));
    return solved.x;
  }

  void require(bool is_regular) {
    if (!is_regular)
      failures_.push_back("the rates cannot be solved for at the operating point: M is singular");
  }

  /// Whether all entries are finite at generic values of their symbols.
  bool has_values(const symbolic::matrix& m) {
    const auto any = [](int id) { return 0.4 + std::fmod(0.7312 * (id + 1), 1.0); };
    for (const double value : symbolic::values_at(graph(), symbolic::nodes_of(m.entries), any))
      if (!numeric::is_finite(value)) return false;
    return true;
  }

  int operations(const explicit_matrices& form) {
    base::sequence<int> outputs = symbolic::nodes_of(form.A.entries);
    for (const symbolic::expression& e : form.B.entries) outputs.push(e.node());
    const symbolic::cost c = symbolic::cost_of(graph(), outputs);
    return c.multiplications + c.additions + c.divisions;
  }

  std::shared_ptr<derived> system_;
  std::optional<consistent_point> point_{}; ///< empty if the system has a mistake
  std::vector<std::string> failures_{};
  implicit_matrices implicit_{};
  explicit_matrices explicit_{};
};

KANEXPR_ENGINE linearization::linearization(std::shared_ptr<derived> system, const linearization_point& at)
    : at_(std::make_shared<at_point>(std::move(system), at)) {}

KANEXPR_ENGINE const std::vector<std::string>& linearization::failures() const { return at_->failures(); }
KANEXPR_ENGINE const implicit_matrices& linearization::implicit_form() { return at_->implicit_form(); }
KANEXPR_ENGINE const explicit_matrices& linearization::explicit_form() { return at_->explicit_form(); }
KANEXPR_ENGINE output_matrices linearization::outputs(const symbolic::matrix& y) { return at_->outputs(y); }
KANEXPR_ENGINE symbolic::matrix linearization::permutation() { return at_->permutation(); }
KANEXPR_ENGINE std::vector<std::string> linearization::states() { return at_->states(); }
KANEXPR_ENGINE std::vector<std::string> linearization::inputs() { return at_->inputs(); }

} // namespace kanexpr::runtime

#include <kanexpr/base/letters_back.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
