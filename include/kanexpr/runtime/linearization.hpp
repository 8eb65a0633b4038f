#pragma once

#include <kanexpr/derive/derived_system.hpp>
#include <kanexpr/runtime/consistent_point.hpp>
#include <kanexpr/runtime/solve_numbers.hpp>
#include <kanexpr/symbolic/cost.hpp>

#include <cmath>
#include <memory>
#include <optional>

namespace kanexpr::runtime {

/// M δ[q̇; u̇; λ] = A δ[q_i; u_i] + B δr.
struct implicit_matrices {
  symbolic::matrix M, A, B{};
};

/// δ[q̇_i; u̇_i] = A δ[q_i; u_i] + B δr.
struct explicit_matrices {
  symbolic::matrix A, B{};
};

/// δy = C δ[q_i; u_i] + D δr of outputs y.
struct output_matrices {
  symbolic::matrix C, D;
};

/// A system linearized about an operating point while the program runs, as matrices of expressions. What the
/// point does not name stays a symbol. Every result is formed when it is asked for.
class linearization {
public:
  /// Of a system with a mistake there are no results, and the mistake is the problem.
  linearization(std::shared_ptr<derivation::derived_system> system,
                const std::vector<symbolic::replacement>& point, std::vector<std::string> problems)
      : system_(std::move(system)), problems_(std::move(problems)) {
    if (system_->mistake()) {
      problems_.assign(1, std::string(system_->mistake().view()));
      return;
    }
    point_.emplace(system_->equations(), point);
    problems_.insert(problems_.end(), point_->problems().begin(), point_->problems().end());
  }

  /// Whether the point satisfies all equations, and all that was asked for so far has a value there.
  explicit operator bool() const { return problems_.empty(); }

  /// What is wrong with the point, and which entries have no value there, as sentences.
  const std::vector<std::string>& problems() const { return problems_; }

  const implicit_matrices& implicit_form() {
    if (implicit_.M.rows != 0 || !point_) return implicit_;
    const mechanics::implicit_linearization& l = equations().linearized_in_full().implicit_form();
    implicit_ = {at_point(l.mass, "M"), at_point(l.state, "A"), at_point(l.input, "B")};
    return implicit_;
  }

  const explicit_matrices& explicit_form() {
    if (explicit_.A.rows != 0 || !point_) return explicit_;
    if (point_->is_empty()) return explicit_ = from_derivation();
    explicit_ = from_implicit();
    if (solve_numbers::are_numbers(explicit_.A) && solve_numbers::are_numbers(explicit_.B)) return explicit_;
    const std::size_t known_problems = problems_.size();
    const explicit_matrices derived = from_derivation();
    if (problems_.size() == known_problems && operations(derived) < operations(explicit_))
      explicit_ = derived;
    problems_.resize(known_problems);
    return explicit_;
  }

  /// Of outputs that hold q, u, r and their rates.
  output_matrices outputs(const symbolic::matrix& y) {
    if (!point_) return {};
    const mechanics::explicit_linearization l = equations().linearized().outputs(y.entries);
    return {at_point(l.state, "C"), at_point(l.input, "D")};
  }

  /// P in [q; u; λ] = P [q_i; u_i; q_d; u_d; λ].
  symbolic::matrix permutation() {
    if (!point_) return {};
    return mechanics::permutation_of(graph(), equations().linearized_in_full().form());
  }

  /// The names of the states and of the inputs, in the order of the matrices.
  std::vector<std::string> states() {
    std::vector<std::string> names;
    if (!point_) return names;
    const mechanics::general_form& form = equations().linearized().form();
    for (int i : form.coordinates.independent) names.push_back(symbolic::print(form.q[i]));
    for (int i : form.speeds.independent) names.push_back(symbolic::print(form.u[i]));
    return names;
  }
  std::vector<std::string> inputs() {
    std::vector<std::string> names;
    if (!point_) return names;
    for (const symbolic::expression& r : equations().linearized().form().r)
      names.push_back(symbolic::print(r));
    return names;
  }

private:
  mechanics::equations& equations() { return system_->equations(); }
  symbolic::graph& graph() { return system_->graph(); }

  symbolic::matrix at_point(const symbolic::matrix& m, const std::string& called) {
    const symbolic::point_values found = point_->values(m);
    for (const symbolic::singularity& s : found.singular)
      problems_.push_back("entry (" + std::to_string(s.row + 1) + ", " + std::to_string(s.column + 1) +
                          ") of " + called + " has no value at the operating point: " + s.condition);
    return found.values;
  }

  explicit_matrices from_derivation() {
    const mechanics::explicit_linearization& l = equations().linearized().explicit_form();
    return {at_point(l.state, "A"), at_point(l.input, "B")};
  }

  /// Solved after the values are in their places: as numbers where all are numbers.
  explicit_matrices from_implicit() {
    const implicit_matrices& given = implicit_form();
    const mechanics::linearizer& full = equations().linearized_in_full();
    const symbolic::matrix rates = rates_of({given.M, given.A, given.B});
    const mechanics::explicit_linearization rows = mechanics::rows_of_states(graph(), full.form(), rates);
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
      problems_.push_back("the rates cannot be solved for at the operating point: M is singular");
  }

  /// Whether all entries are numbers at generic values of the symbols that they hold.
  bool has_values(const symbolic::matrix& m) {
    const auto any = [](int id) { return 0.4 + std::fmod(0.7312 * (id + 1), 1.0); };
    for (const double value : symbolic::values_at(graph(), symbolic::nodes_of(m.entries), any))
      if (!std::isfinite(value)) return false;
    return true;
  }

  int operations(const explicit_matrices& form) {
    symbolic::sequence<int> outputs = symbolic::nodes_of(form.A.entries);
    for (const symbolic::expression& e : form.B.entries) outputs.push(e.node());
    const symbolic::cost c = symbolic::cost_of(graph(), outputs);
    return c.multiplications + c.additions + c.divisions;
  }

  std::shared_ptr<derivation::derived_system> system_;
  std::optional<consistent_point> point_{}; ///< of a system without a mistake
  std::vector<std::string> problems_;
  implicit_matrices implicit_{};
  explicit_matrices explicit_{};
};

} // namespace kanexpr::runtime
