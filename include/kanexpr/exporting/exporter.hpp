#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/compiled/values_reader.hpp>
#include <kanexpr/derivation/names_along.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/exporting/differentiated.hpp>
#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/exporting/exported_system.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/exporting/units_of_export.hpp>
#include <kanexpr/exporting/written_step.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/mechanics/checks/check_derivatives.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/staged_derivation.hpp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// A parameter that is replaced by a number in the exported code.
struct bound_parameter {
  std::string name{};
  double value = 0;
};

struct options {
  std::vector<requested_function> functions = default_results();
  std::vector<bound_parameter> bound{};
};

/// A system to be exported, or the reason why it cannot be.
struct exported {
  exported_system system{};
  std::string mistake{};
};

/// Forms each function in a separate model, so that its code equals that of the compiled function,
/// regardless of what else is exported.
class exporter {
public:
  exporter(std::string name, runtime::staged_derivation& derivation, options chosen)
      : derivation_(derivation), chosen_(std::move(chosen)) {
    made_.system.name = std::move(name);
  }

  exported run() {
    if (!is_identifier(made_.system.name))
      refuse("the name of an exported system must be a C identifier of letters, digits and underscores; \"" +
             made_.system.name + "\" is not one");
    else
      read_names();
    for (const requested_function& wanted : chosen_.functions)
      if (made_.mistake.empty()) add(wanted);
    return made_;
  }

private:
  static bool is_identifier(const std::string& name) {
    return name != "math" && identifiers().unique(name) == name;
  }

  void read_names() {
    const model first = derivation_.resume();
    survey_ = first.known();
    if (made_.mistake = first.mistake(); !made_.mistake.empty()) return;
    using symbolic::symbol_kind;
    exported_system& s = made_.system;
    if (survey_->states_units) units_ = units_of_export(first);
    s.states_units = units_.are_stated();
    s.units_of_states = units_of(0, survey_->coordinates + survey_->speeds);
    s.units_of_inputs = units_of(survey_->first_of(symbol_kind::input), survey_->inputs);
    s.coordinates = names_of(symbol_kind::coordinate), s.speeds = names_of(symbol_kind::speed);
    s.inputs = names_of(symbol_kind::input);
    const std::vector<std::string> parameters = names_of(symbol_kind::parameter);
    bound_values_.assign(parameters.size(), numeric::not_a_number<double>);
    for (const bound_parameter& b : chosen_.bound) {
      const auto place = std::find(parameters.begin(), parameters.end(), b.name);
      if (place == parameters.end())
        return refuse("there is no parameter " + b.name + " to bind to a number");
      if (!numeric::is_finite(b.value))
        return refuse("parameter " + b.name + " must be bound to a finite number");
      double& value = bound_values_[static_cast<std::size_t>(place - parameters.begin())];
      if (!numeric::is_nan(value)) return refuse("parameter " + b.name + " is bound twice");
      value = b.value;
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      index_of_parameter_.push_back(static_cast<int>(s.parameters.size()));
      if (is_bound(i)) continue;
      s.parameters.push_back(parameters[i]);
      if (s.states_units)
        s.units_of_parameters.push_back(
            units_.of_symbol(survey_->first_of(symbol_kind::parameter) + static_cast<int>(i)));
    }
    if (const base::sentence impossible = compiled::check_masses(*survey_, bound_values_.data()))
      refuse(std::string(impossible.view()));
  }

  bool is_bound(std::size_t parameter) const { return !numeric::is_nan(bound_values_[parameter]); }

  std::vector<std::string> names_of(symbolic::symbol_kind kind) const {
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(survey_->count_of(kind)));
    for (int i = 0; i < survey_->count_of(kind); ++i)
      names.emplace_back(survey_->names[survey_->first_of(kind) + i].view());
    return names;
  }

  std::vector<exported_unit> units_of(int first, int count) const {
    std::vector<exported_unit> all;
    for (int i = first; i < first + count && units_.are_stated(); ++i) all.push_back(units_.of_symbol(i));
    return all;
  }

  void add(const requested_function& wanted) {
    if (!wanted.mistake.empty()) return refuse(wanted.mistake);
    exported_function made{.name = wanted.name};
    if (wanted.step) {
      made = written_step(wanted.name, *survey_, *wanted.step, [&](mechanics::quantity of) {
        return form({.results = {{"", {.what = derivation::request::kind::result, .wanted = of}}}});
      });
      if (!made_.mistake.empty()) return;
      if (units_.are_stated())
        for (exported_result& each : made.results) each.units = units_.of_states();
    } else {
      for (const requested_result& each : wanted.results)
        if (each.request.is_weighted() && each.part.empty())
          return refuse(wanted.name + " takes weights or a direction, which exported functions cannot take");
      std::optional<formed_results> found = form(wanted);
      if (!found) return;
      if (found->results.empty()) return refuse(wanted.name + " of " + made_.system.name + " has no entries");
      made.cost = lower::cost_of(found->code);
      made.code = lower::statements_of(found->code, true);
      made.results = std::move(found->results), made.checks = std::move(found->checks);
      made.weights = found->weights;
      for (const requested_result& each : wanted.results) {
        made.takes_rates = made.takes_rates || contains_speed_rates(each.request);
        made.takes_all_rates = made.takes_all_rates || each.is_residual;
      }
    }
    finish(std::move(made));
  }

  /// The stage from which the first result of a function is formed.
  static mechanics::stage first_stage(const requested_function& wanted) {
    if (wanted.results.empty() || wanted.results[0].written.is_given()) return mechanics::stage::constrained;
    return derivation::stage_for(wanted.results[0].request);
  }

  /// Forms the results of one function in one model.
  std::optional<formed_results> form(const requested_function& wanted) {
    model from = derivation_.resume(first_stage(wanted));
    formed_results made;
    base::sequence<int> nodes;
    const auto take = [&](const std::string& name, const symbolic::matrix& found,
                          std::vector<std::string> row_symbols, std::vector<exported_unit> units) {
      if (found.entries.empty()) return; // without inputs there is no B
      made.results.push_back({.name = name,
                              .rows = found.rows,
                              .columns = found.columns,
                              .first = nodes.size(),
                              .row_symbols = std::move(row_symbols),
                              .units = std::move(units)});
      for (const symbolic::expression& e : found.entries) nodes.push(e.node());
    };
    const differentiable_symbols known_symbols = symbols_of(from);
    std::optional<differentiated> derivatives;
    const auto derived = [&](const base::sequence<symbolic::expression>& of, const requested_derivative& by) {
      if (!derivatives || !derivatives->differentiates(of))
        derivatives.emplace(from.graph(), of, known_symbols);
      made.weights = (std::max)(made.weights, derivatives->weights_for(by));
      symbolic::matrix found = derivatives->get(by);
      if (const base::sentence lacking = mechanics::check_derivatives(found))
        refuse(std::string(lacking.view()));
      return found;
    };
    base::sequence<symbolic::expression> all;
    for (const requested_result& each : wanted.results) {
      symbolic::matrix found = evaluate(from, each, wanted.derivatives.empty());
      if (made_.mistake.empty() && !from.mistake().empty()) refuse(from.mistake());
      if (!made_.mistake.empty()) return std::nullopt;
      if (each.derivative.type != requested_derivative::kind::none)
        found = derived(found.entries, each.derivative);
      if (!each.part.empty()) {
        made.weights = (std::max)(made.weights, weights_for(each.request));
        found = part_of(from, found, each.part);
      }
      if (each.is_sparse)
        made.results.push_back(sparse(each.name, from, found, nodes));
      else if (wanted.derivatives.empty())
        take(each.name, found, symbols_of_rows(each.request), units_.of_result(from, each, found));
      for (const symbolic::expression& e : found.entries) all.push(e);
    }
    for (const symbols each : wanted.derivatives)
      take(name_of(each), derived(all, {.type = requested_derivative::kind::jacobian, .by = each}), {}, {});
    if (!made_.mistake.empty()) return std::nullopt;
    made.checks = checks_of(wanted, from, nodes);
    made.code = lower::tape_of(from.graph(), bound(from, nodes));
    return made;
  }

  /// Appends the measures and scales of the checks to the nodes of the results. The results of linearizations
  /// are checked themselves, because their sum would take as many additions as they have entries.
  static std::vector<exported_check> checks_of(const requested_function& wanted, model& from,
                                               base::sequence<int>& nodes) {
    const bool watches = std::ranges::any_of(wanted.results, [](const requested_result& each) {
      return each.request.is_of_linearization() && !each.is_sparse; // CasADi functions check sparse results
    });
    const bool can_fail =
        std::any_of(nodes.begin(), nodes.end(), [&](int id) { return !from.graph().is_constant(id); });
    std::vector<exported_check> checks;
    std::string cause(mechanics::results_not_finite);
    for (const mechanics::singularity_check& c : from.equations().singularity_checks_of(nodes)) {
      if (watches && c.of_finiteness) {
        cause = c.cause.view();
        continue;
      }
      checks.push_back({std::string(c.cause.view()), c.of_finiteness});
      nodes.push(c.measure.node());
      nodes.push(c.scale.node());
    }
    if (watches && can_fail) checks.push_back({.cause = std::move(cause), .watches_results = true});
    return checks;
  }

  /// Adds the function to the system, or refuses it if it cannot be written to a file.
  void finish(exported_function made) {
    constexpr std::size_t most_checks = 64; // one bit of the status each
    if (const std::size_t checks = made.causes().size(); checks > most_checks)
      return refuse("function " + made.name + " has " + std::to_string(checks) +
                    " checks for singularities; a status has only 64 bits");
    if (!made.code.externals.empty())
      return refuse("function " + made.name + " calls " + std::string(made.code.externals[0]->called.view()) +
                    ", a function of the program, which cannot be exported");
    for (lower::load& l : made.code.arguments) {
      const bool is_parameter = l.from == symbolic::symbol_kind::parameter;
      if (l.position >= survey_->count_of(l.from) && (is_parameter || l.from == symbolic::symbol_kind::input))
        return refuse("function " + made.name + " uses " + (is_parameter ? "a parameter" : "an input") +
                      " that the system does not have");
      if (is_parameter) l.position = index_of_parameter_[static_cast<std::size_t>(l.position)];
    }
    made_.system.functions.push_back(std::move(made));
  }

  /// Collects the nodes of the entries that are not identically zero.
  exported_result sparse(const std::string& name, model& from, const symbolic::matrix& found,
                         base::sequence<int>& nodes) const {
    exported_result made{.name = name, .rows = found.rows, .columns = found.columns, .first = nodes.size()};
    made.is_sparse = true;
    const base::sequence<int> with_numbers = bound(from, symbolic::nodes_of(found.entries));
    for (int j = 0; j < found.columns; ++j)
      for (int i = 0; i < found.rows; ++i) {
        if (with_numbers[i * found.columns + j] == symbolic::graph::zero) continue;
        made.places.emplace_back(j, i);
        nodes.push(found(i, j).node());
      }
    return made;
  }

  differentiable_symbols symbols_of(const model& of) const {
    const mechanics::mechanism& m = of.mechanism();
    differentiable_symbols all;
    for (const symbolic::expression& q : m.coordinates) all[symbols::state].push(q);
    for (const symbolic::expression& u : m.speeds) all[symbols::state].push(u);
    all[symbols::rates] = m.coordinate_rates;
    for (const symbolic::expression& rate : m.speed_rates) all[symbols::rates].push(rate);
    all[symbols::inputs] = m.inputs;
    for (int i = 0; i < m.parameters.size(); ++i)
      if (!is_bound(static_cast<std::size_t>(i))) all[symbols::parameters].push(m.parameters[i]);
    all[symbols::time].push(m.time);
    return all;
  }

  /// `is_final` if the function contains no derivatives of the result.
  symbolic::matrix evaluate(model& from, const requested_result& each, bool is_final) {
    if (!each.written.is_given()) {
      const bool can_have_columns = is_final && !each.is_sparse && each.part.empty() &&
                                    each.derivative.type == requested_derivative::kind::none;
      const symbolic::matrix found =
          can_have_columns ? from.get_for_code(each.request) : from.get(each.request);
      return each.is_residual && from.mistake().empty() ? implicit_form(from.graph(), from.equations())
                                                        : found;
    }
    symbolic::graph& own = from.graph();
    const int symbols = own.symbols().size();
    symbolic::expression e = each.written;
    if (!e.belongs_to(own)) e = {own, symbolic::copy_nodes(e.owner(), {e.node()}, own)[e.node()]};
    if (own.symbols().size() > symbols) refuse(each.name + " is not an expression of the exported system");
    symbolic::matrix one(own, 1, 1);
    one(0, 0) = from.in_motion(e);
    return one;
  }

  int weights_for(const derivation::request& wanted) const {
    const int states = survey_->coordinates + survey_->speeds;
    return mechanics::row_of(wanted.wanted).takes_weights ? states : states + survey_->inputs;
  }

  /// Returns the block of `whole` that belongs to the symbols `which`; its entries are derivatives with
  /// respect to the state and the inputs.
  symbolic::matrix part_of(model& from, const symbolic::matrix& whole,
                           const std::vector<symbols>& which) const {
    const int states = survey_->coordinates + survey_->speeds;
    const auto begin = [&](symbols of) { return of == symbols::state ? 0 : states; };
    const auto size = [&](symbols of) { return of == symbols::state ? states : survey_->inputs; };
    const bool is_square = which.size() > 1;
    symbolic::matrix part(from.graph(), size(which[0]), is_square ? size(which[1]) : 1);
    for (int i = 0; i < part.rows; ++i)
      for (int j = 0; j < part.columns; ++j)
        part(i, j) = whole(begin(which[0]) + i, is_square ? begin(which[1]) + j : 0);
    return part;
  }

  static const char* name_of(symbols which) {
    constexpr const char* names[]{"by_state", "by_rates", "by_inputs", "by_parameters", "by_time"};
    return names[static_cast<int>(which)];
  }

  static bool contains_speed_rates(const derivation::request& r) {
    return r.what == derivation::request::kind::result && mechanics::row_of(r.wanted).holds_speed_rates;
  }

  base::sequence<int> bound(model& from, const base::sequence<int>& nodes) const {
    if (chosen_.bound.empty()) return nodes;
    symbolic::substitution numbers(from.graph());
    for (std::size_t i = 0; i < bound_values_.size(); ++i)
      if (is_bound(i))
        numbers.replace(from.mechanism().parameters[static_cast<int>(i)],
                        from.mechanism().number(bound_values_[i]));
    base::sequence<int> with_numbers;
    for (int id : nodes) with_numbers.push(numbers.in(symbolic::expression(from.graph(), id)).node());
    return with_numbers;
  }

  /// The symbols whose rates or forces the rows contain.
  std::vector<std::string> symbols_of_rows(const derivation::request& r) const {
    if (r.what != derivation::request::kind::result) return {};
    return derivation::names_along(*survey_, mechanics::row_of(r.wanted).rows);
  }

  void refuse(std::string because) { made_.mistake = std::move(because); }

  runtime::staged_derivation& derivation_;
  options chosen_;
  std::shared_ptr<const derivation::survey> survey_{};
  units_of_export units_{};
  std::vector<double> bound_values_{};    ///< NaN for parameters that are not bound
  std::vector<int> index_of_parameter_{}; ///< index of each parameter among those that are not bound
  exported made_{};
};

/// Exports a compile-time system: `exported_from<pendulum::System>("pendulum")`.
template <class System>
exported exported_from(std::string name, const options& chosen = {}) {
  runtime::staged_derivation derivation([] { return kanexpr::derive<System>(); });
  return exporter(std::move(name), derivation, chosen).run();
}

} // namespace kanexpr::exporting
