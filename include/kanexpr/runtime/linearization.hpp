#pragma once

#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/consistent_point.hpp>
#include <kanexpr/runtime/solve_numbers.hpp>
#include <kanexpr/symbolic/cost.hpp>

namespace kanexpr::runtime {

/// M δ[q̇; u̇; λ] = A δ[q_i; u_i] + B δr.
struct implicit_matrices {
  symbolic::matrix M, A, B;
};

/// δ[q̇_i; u̇_i] = A δ[q_i; u_i] + B δr.
struct explicit_matrices {
  symbolic::matrix A, B;
};

/// δy = C δ[q_i; u_i] + D δr of outputs y.
struct output_matrices {
  symbolic::matrix C, D;
};

/// A system linearized about an operating point while the program runs, as matrices of expressions. What the
/// point does not name stays a symbol. Every result is formed when it is asked for.
class linearization {
public:
  linearization(mechanics::equations& equations, const std::vector<symbolic::replacement>& point,
                std::vector<std::string> problems)
      : equations_(equations), point_(equations, point), problems_(std::move(problems)) {
    for (const std::string& problem : point_.problems()) problems_.push_back(problem);
  }

  /// Whether the point satisfies all equations, and all that was asked for so far has a value there.
  explicit operator bool() const { return problems_.empty(); }

  /// What is wrong with the point, and which entries have no value there, as sentences.
  const std::vector<std::string>& problems() const { return problems_; }

  const implicit_matrices& implicit_form() {
    if (implicit_.M.rows != 0) return implicit_;
    const mechanics::implicit_linearization& l = equations_.linearized_in_full().implicit_form();
    implicit_ = {at_point(l.mass, "M"), at_point(l.state, "A"), at_point(l.input, "B")};
    return implicit_;
  }

  const explicit_matrices& explicit_form() {
    if (explicit_.A.rows != 0) return explicit_;
    if (point_.is_empty()) return explicit_ = from_derivation();
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
    const mechanics::explicit_linearization l = equations_.linearized().outputs(y.entries);
    return {at_point(l.state, "C"), at_point(l.input, "D")};
  }

  /// P in [q; u; λ] = P [q_i; u_i; q_d; u_d; λ].
  symbolic::matrix permutation() {
    return mechanics::permutation_of(graph(), equations_.linearized_in_full().form());
  }

  /// The names of the states and of the inputs, in the order of the matrices.
  std::vector<std::string> states() {
    std::vector<std::string> names;
    const mechanics::general_form& form = equations_.linearized().form();
    for (int i : form.coordinates.independent) names.push_back(symbolic::print(form.q[i]));
    for (int i : form.speeds.independent) names.push_back(symbolic::print(form.u[i]));
    return names;
  }
  std::vector<std::string> inputs() {
    std::vector<std::string> names;
    for (const symbolic::expression& r : equations_.linearized().form().r)
      names.push_back(symbolic::print(r));
    return names;
  }

private:
  symbolic::graph& graph() { return *equations_.skeleton_used().model->g; }

  symbolic::matrix at_point(const symbolic::matrix& m, const std::string& called) {
    const symbolic::point_values found = point_.values(m);
    for (const symbolic::singularity& s : found.singular)
      problems_.push_back("entry (" + std::to_string(s.row + 1) + ", " + std::to_string(s.column + 1) +
                          ") of " + called + " has no value at the operating point: " + s.condition);
    return found.values;
  }

  explicit_matrices from_derivation() {
    const mechanics::explicit_linearization& l = equations_.linearized().explicit_form();
    return {at_point(l.state, "A"), at_point(l.input, "B")};
  }

  /// Solved after the values are in their places: as numbers where all are numbers.
  explicit_matrices from_implicit() {
    const implicit_matrices& given = implicit_form();
    const mechanics::linearizer& full = equations_.linearized_in_full();
    const symbolic::matrix rates = rates_of({given.M, given.A, given.B});
    const mechanics::explicit_linearization rows = mechanics::rows_of_states(graph(), full.form(), rates);
    return {rows.state, rows.input};
  }

  symbolic::matrix rates_of(const mechanics::implicit_linearization& given) {
    for (const symbolic::matrix* m : {&given.mass, &given.state, &given.input})
      if (!solve_numbers::are_numbers(*m)) return mechanics::solve_for_rates(graph(), given).x;
    const solve_numbers solved(graph(), given);
    if (!solved) problems_.push_back("the rates cannot be solved for at the operating point: M is singular");
    return solved.rates();
  }

  int operations(const explicit_matrices& form) {
    symbolic::sequence<int> outputs = symbolic::nodes_of(form.A.entries);
    for (const symbolic::expression& e : form.B.entries) outputs.push(e.node());
    const symbolic::cost c = symbolic::cost_of(graph(), outputs);
    return c.multiplications + c.additions + c.divisions;
  }

  mechanics::equations& equations_;
  consistent_point point_;
  std::vector<std::string> problems_;
  implicit_matrices implicit_;
  explicit_matrices explicit_;
};

} // namespace kanexpr::runtime
