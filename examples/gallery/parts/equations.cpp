#include "equations.hpp"

#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace gallery {

using kanexpr::model;
using kanexpr::symbolic::expression;
using kanexpr::symbolic::latex;
using kanexpr::symbolic::latex_each;
using kanexpr::symbolic::matrix;
using kanexpr::symbolic::symbol_kind;

namespace {

constexpr int most_operations = 700;           // of equations that are worth simplifying
constexpr int most_operations_to_divide = 160; // of equations that are divided by common factors
constexpr std::size_t most_terms = 1500;       // of the forms among which the simplest is chosen
constexpr std::size_t longest_line = 1100;     // letters of LaTeX
constexpr std::size_t longest_entry = 160;     // of an entry that stands for the others
constexpr std::size_t longest_open = 2600;     // letters of LaTeX that a page shows unfolded
constexpr std::size_t longest_matrix = 100000; // letters of LaTeX that are simplified

int operations_of(const matrix& m) {
  if (m.entries.size() == 0) return 0;
  kanexpr::symbolic::graph& g = m(0, 0).owner();
  kanexpr::base::sequence<int> nodes;
  for (const expression& each : m.entries) nodes.push(each.node());
  const kanexpr::symbolic::cost c = kanexpr::symbolic::cost_of(g, nodes);
  return c.multiplications + c.additions + c.divisions + 4 * (c.trigonometric + c.other);
}

/// Whether the entries of a matrix can be written without names for their common parts.
bool is_written_out(const matrix& m) { return latex_each(m.entries, longest_matrix).parts.empty(); }

std::string symbol_text(model& m, symbol_kind kind, const kanexpr::base::name& called) {
  return latex(expression(m.graph(), m.graph().variable({kind, called})));
}

/// The shorter of two forms on a page: simplified as one fraction, or with each term of a sum in lowest
/// terms.
expression shorter_on_a_page(expression e) {
  const expression whole = simplify(e, most_terms), terms = expand(whole, most_terms);
  return latex(terms).size() < latex(whole).size() ? terms : whole;
}
matrix shorter_on_a_page(matrix m) {
  for (expression& each : m.entries) each = shorter_on_a_page(each);
  return m;
}

class printed {
public:
  explicit printed(model& m) : m_(m), survey_(m.known()), known_(*survey_) {}

  std::vector<equation_group> all() {
    kinematic();
    constraints();
    dynamic();
    return std::move(groups_);
  }

private:
  std::string coordinate_rate(int i) {
    return symbol_text(m_, symbol_kind::coordinate_rate, known_.names[i]);
  }
  const kanexpr::base::name& speed_name(int i) const { return known_.names[known_.coordinates + i]; }
  std::string speed_rate(int i) { return symbol_text(m_, symbol_kind::speed_rate, speed_name(i)); }

  void add(equation_group group) {
    std::size_t length = 0;
    for (const std::string& each : group.lines) {
      length += each.size();
      group.is_folded = group.is_folded || each.size() > longest_line / 2;
    }
    group.is_folded = group.is_folded || length > longest_open;
    if (!group.lines.empty() || !group.note.empty()) groups_.push_back(std::move(group));
  }

  void kinematic() {
    if (known_.takes_rates_as_speeds) return;
    equation_group group{.heading = "Kinematic differential equations"};
    const matrix rates = shorter_on_a_page(m_.qdot());
    std::string line; // short equations share a line
    for (int i = 0; i < rates.rows; ++i) {
      const std::string equation = coordinate_rate(i) + " = " + latex(rates(i, 0));
      if (!line.empty() && line.size() + equation.size() > 90) group.lines.push_back(std::exchange(line, ""));
      line += (line.empty() ? "" : ",\\qquad ") + equation;
    }
    if (!line.empty()) group.lines.push_back(line);
    add(std::move(group));
  }

  void constraints() {
    if (known_.constraints == 0) return;
    if (known_.configuration_constraints > 0)
      equal_to_zero("Configuration constraints", m_.configuration_residual(),
                    known_.configuration_constraints);
    if (known_.constraints > known_.configuration_constraints)
      equal_to_zero("Velocity constraints", m_.velocity_residual(),
                    known_.constraints - known_.configuration_constraints);
  }

  void equal_to_zero(const std::string& heading, const matrix& residual, int count) {
    equation_group group{.heading = heading};
    int omitted = 0;
    for (int i = 0; i < count; ++i) {
      const expression e = residual(i, 0);
      const std::string line = latex(shorter_on_a_page(e)) + " = 0";
      if (line.size() > longest_line)
        ++omitted;
      else
        group.lines.push_back(line);
    }
    if (omitted > 0)
      group.note = (group.lines.empty() ? "The " : "A further ") + std::to_string(omitted) +
                   (omitted == 1 ? " equation is" : " equations are") + " too long for a page.";
    add(std::move(group));
  }

  void dynamic() {
    matrix mass = m_.mass_matrix(), forcing = m_.forcing();
    const int before = operations_of(mass) + operations_of(forcing);
    if (before > most_operations || !is_written_out(mass) || !is_written_out(forcing))
      return long_equations(before);
    mass = shorter_on_a_page(mass), forcing = shorter_on_a_page(forcing);
    const bool is_constrained = known_.constraints > 0;
    matrix explicit_form;
    if (!is_constrained && operations_of(m_.udot()) <= most_operations && is_written_out(m_.udot()))
      explicit_form = shorter_on_a_page(m_.udot());
    const bool is_shorter = explicit_form.rows > 0 && total(explicit_form) <= total(mass) + total(forcing);
    equation_group group{.heading = "Equations of motion"};
    if (is_shorter)
      for (int i = 0; i < explicit_form.rows; ++i)
        group.lines.push_back(speed_rate(i) + " = " + latex(explicit_form(i, 0)));
    else
      for (int i = 0; i < mass.rows; ++i) {
        if (before <= most_operations_to_divide) divide_row(mass, forcing, i);
        group.lines.push_back(row(mass, forcing, i));
      }
    const auto longest = std::max_element(group.lines.begin(), group.lines.end(),
                                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (longest != group.lines.end() && longest->size() > 4 * longest_line) return long_equations(before);
    if (is_constrained) group.note = note_on_dependent_speeds();
    add(std::move(group));
  }

  std::string note_on_dependent_speeds() {
    const std::string names = m_.names_of_dependent_speeds();
    const bool is_one = names.find(" and ") == std::string::npos;
    return (is_one ? "The dependent speed " : "The dependent speeds ") + names +
           (is_one ? " follows" : " follow") + " from the constraints.";
  }

  /// Divides an equation by the parameters that make it shorter, such as a mass that all of its terms
  /// contain.
  void divide_row(matrix& mass, matrix& forcing, int i) {
    for (int k = 0; k < known_.parameters; ++k) {
      const kanexpr::base::name& called = known_.names[known_.first_of(symbol_kind::parameter) + k];
      const expression by(m_.graph(), m_.graph().variable({symbol_kind::parameter, called}));
      matrix of_mass(m_.graph(), 1, mass.columns), of_forcing(m_.graph(), 1, 1);
      for (int j = 0; j < mass.columns; ++j) of_mass(0, j) = shorter_on_a_page(mass(i, j) / by);
      of_forcing(0, 0) = shorter_on_a_page(forcing(i, 0) / by);
      std::size_t letters = latex(forcing(i, 0)).size();
      for (int j = 0; j < mass.columns; ++j) letters += latex(mass(i, j)).size();
      if (total(of_mass) + total(of_forcing) >= letters) continue;
      for (int j = 0; j < mass.columns; ++j) mass(i, j) = of_mass(0, j);
      forcing(i, 0) = of_forcing(0, 0);
      --k; // it may divide by the same parameter again
    }
  }

  /// The letters of all entries, a measure of their length on a page.
  static std::size_t total(const matrix& m) {
    std::size_t letters = 0;
    for (const expression& each : m.entries) letters += latex(each).size();
    return letters;
  }

  /// The rates of the independent speeds, in the order of the columns of M.
  std::vector<int> independent() const {
    std::vector<int> all;
    for (int i = 0; i < known_.speeds; ++i)
      if (!known_.dependent[known_.coordinates + i]) all.push_back(i);
    return all;
  }

  std::string row(const matrix& mass, const matrix& forcing, int i) {
    const std::vector<int> columns = independent();
    std::string text;
    for (int j = 0; j < mass.columns; ++j) {
      if (mass(i, j).is_zero()) continue;
      const auto which = static_cast<std::size_t>(j);
      const expression rate(m_.graph(),
                            m_.graph().variable({symbol_kind::speed_rate, speed_name(columns[which])}));
      const std::string term = latex(mass(i, j) * rate);
      text += text.empty() ? term : term.starts_with('-') ? " - " + term.substr(1) : " + " + term;
    }
    return text + " = " + latex(forcing(i, 0));
  }

  /// The equations with names for their common parts, or the shortest entries if there are too many.
  void long_equations(int operations) {
    const matrix mass = m_.mass_matrix(), forcing = m_.forcing();
    equation_group group{.heading = "Equations of motion", .is_folded = true};
    group.lines.push_back("M(q)\\,\\dot{u} = f(q, u, r)");
    if (operations <= most_operations)
      with_parts(group, is_written_out(mass) ? shorter_on_a_page(mass) : mass, forcing);
    else
      shortest_entries(group, mass, forcing, operations);
    add(std::move(group));
  }

  /// The entries of the symmetric M and of f that are not zero, and their parts.
  void with_parts(equation_group& group, const matrix& mass, const matrix& forcing) {
    kanexpr::base::sequence<expression> entries;
    std::vector<std::string> names;
    const auto take = [&](const std::string& name, expression e) {
      if (e.is_zero()) return;
      names.push_back(name);
      entries.push(e);
    };
    for (int i = 0; i < mass.rows; ++i)
      for (int j = i; j < mass.columns; ++j) take("M_{" + index(i) + index(j) + "}", mass(i, j));
    for (int i = 0; i < forcing.rows; ++i) take("f_{" + index(i) + "}", forcing(i, 0));
    const kanexpr::symbolic::text_with_parts written = latex_each(entries);
    for (std::size_t i = 0; i < names.size(); ++i)
      group.lines.push_back(names[i] + " = " + written.expressions[i]);
    for (const auto& each : written.parts) group.lines.push_back(each.name + " = " + each.text);
    group.note = "M is symmetric; its other entries are zero.";
    if (known_.constraints > 0) group.note += " " + note_on_dependent_speeds();
    if (!written.parts.empty())
      group.note += " Each z with an index is a part that occurs more than once or is long.";
  }

  void shortest_entries(equation_group& group, const matrix& mass, const matrix& forcing, int operations) {
    for (int i = mass.rows - 1; i >= 0; --i)
      for (int j = mass.columns - 1; j >= i; --j)
        shortest(group, "M_{" + index(i) + index(j) + "}", mass(i, j));
    for (int i = forcing.rows - 1; i >= 0; --i) shortest(group, "f_{" + index(i) + "}", forcing(i, 0));
    group.note = "M has " + std::to_string(mass.rows) + " × " + std::to_string(mass.columns) +
                 " entries. Together, M and f take " + std::to_string(operations) +
                 " operations, too many for a page" +
                 (group.lines.size() > 1 ? "; these are their shortest entries." : ".");
  }
  static std::string index(int i) { return (i > 8 ? "," : "") + std::to_string(i + 1); }
  static void shortest(equation_group& group, const std::string& name, expression e) {
    if (group.lines.size() > 8 || e.is_zero()) return;
    const kanexpr::symbolic::text_with_parts written = latex_each({e}, longest_entry);
    if (written.parts.empty() && written.expressions[0].size() <= longest_entry)
      group.lines.push_back(name + " = " + written.expressions[0]);
  }

  model& m_;
  std::shared_ptr<const kanexpr::derivation::survey> survey_;
  const kanexpr::derivation::survey& known_;
  std::vector<equation_group> groups_;
};

} // namespace

std::vector<equation_group> equations_of(model& m) { return printed(m).all(); }

std::string latex_of(model& m, symbol_kind kind, int place) {
  return symbol_text(m, kind, m.known()->names[m.known()->first_of(kind) + place]);
}

} // namespace gallery
