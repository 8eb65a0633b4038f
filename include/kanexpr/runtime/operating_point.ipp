#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/derived.hpp>
#include <kanexpr/runtime/linearization_point.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/sizes/term_sizes.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// Looks up the symbols of an operating point in a derived system. A parameter that only the operating point
/// uses, such as the speed of a vehicle, is added to the parameters.
class point_reader {
public:
  explicit point_reader(derived& system) : system_(system), m_(system.system().mechanism) {}

  std::vector<symbolic::replacement> read(const linearization_point& point) {
    std::vector<symbolic::replacement> found;
    for (const symbol_name& what : point.duplicates())
      failures_.push_back("the operating point gives " + what.name() + " two values");
    for (const linearization_point::entry& e : point.entries()) {
      const std::optional<symbolic::expression> symbol = symbol_of(e.what);
      if (!symbol.has_value()) {
        failures_.push_back("the operating point refers to " + e.what.name() +
                            ", which the system does not have");
        continue;
      }
      if (const std::optional<symbolic::expression> value = value_of(e)) found.push_back({*symbol, *value});
    }
    return found;
  }

  /// The mistakes in the operating point, as error messages.
  const std::vector<std::string>& failures() const { return failures_; }

private:
  using symbols = base::sequence<symbolic::expression>;

  /// Finds a symbol by name in `named` and returns its counterpart in `partners`.
  std::optional<symbolic::expression> find(const symbols& named, std::string_view name,
                                           const symbols& partners) const {
    for (int i = 0; i < named.size(); ++i)
      if (mechanics::called(m_, named[i]) == name) return partners[i];
    return std::nullopt;
  }

  std::optional<symbolic::expression> symbol_of(const symbol_name& what) const {
    return what.symbol() != nullptr ? symbol_of(*what.symbol()) : symbol_of(std::string_view(what.name()));
  }

  std::optional<symbolic::expression> symbol_of(const describe::symbol_record& r) const {
    using symbolic::symbol_kind;
    const std::string_view name = r.called.view();
    switch (r.kind) {
    case symbol_kind::time: return m_.time;
    case symbol_kind::coordinate: return find(m_.coordinates, name, m_.coordinates);
    case symbol_kind::speed: return find(m_.speeds, name, m_.speeds);
    case symbol_kind::parameter: return find(m_.parameters, name, m_.parameters);
    case symbol_kind::input: return find(m_.inputs, name, m_.inputs);
    case symbol_kind::coordinate_rate:
      return find(m_.coordinates, name, is_by_lagrange() ? m_.speeds : m_.coordinate_rates);
    case symbol_kind::speed_rate: return find(m_.speeds, name, m_.speed_rates);
    case symbol_kind::auxiliary_speed:
    case symbol_kind::multiplier:
    case symbol_kind::weight:
    case symbol_kind::direction: break; // cannot occur in an operating point
    }
    return std::nullopt;
  }

  std::optional<symbolic::expression> symbol_of(std::string_view name) const {
    for (const symbols* list : {&m_.coordinates, &m_.speeds, &m_.parameters, &m_.inputs})
      if (const auto found = find(*list, name, *list)) return found;
    if (name == "t") return m_.time;
    if (!name.ends_with('\'')) return multiplier_called(name);
    name.remove_suffix(1);
    if (const auto found = find(m_.coordinates, name, m_.coordinate_rates)) return found;
    return find(m_.speeds, name, m_.speed_rates);
  }

  std::optional<symbolic::expression> multiplier_called(std::string_view name) const {
    const symbolic::graph& g = system_.graph();
    for (int i = 0; i < g.symbols().size(); ++i)
      if (g.symbols()[i].kind == symbolic::symbol_kind::multiplier && g.symbols()[i].called.view() == name)
        return symbolic::variable(system_.graph(), g.symbols()[i]);
    return std::nullopt;
  }

  bool is_by_lagrange() const { return m_.derived_by == mechanics::method::lagrange; }

  std::optional<symbolic::expression> value_of(const linearization_point::entry& e) {
    if (const auto* number = std::get_if<symbolic::number>(&e.value.held()))
      return symbolic::constant(system_.graph(), *number);
    if (const auto* given = std::get_if<symbolic::expression>(&e.value.held())) return *given;
    const auto& words = std::get<point_value::phrase>(e.value.held());
    for (const describe::token& t : words) {
      if (t.symbol == nullptr) continue;
      if (t.symbol->kind == symbolic::symbol_kind::parameter)
        system_.reader().add_parameter(*t.symbol);
      else if (!symbol_of(*t.symbol).has_value()) {
        failures_.push_back("the value of " + e.what.name() + " at the operating point contains " +
                            std::string(t.symbol->called.view()) + ", which the system does not have");
        return std::nullopt;
      }
    }
    const describe::phrase whole{describe::shape::scalar, words.data(), static_cast<int>(words.size())};
    return system_.reader().evaluate(whole, "the operating point").scalar;
  }

  derived& system_;
  const mechanics::mechanism& m_;
  std::vector<std::string> failures_{};
};

/// An operating point, completed by the rates and multipliers of the motion at this point and checked against
/// the equations of the system.
class consistent_point {
public:
  consistent_point(mechanics::equations& e, const std::vector<symbolic::replacement>& given)
      : form_(e.linearized().in_full().form()), g_(*e.skeleton_used().model->g), is_empty_(given.empty()),
        all_(given) {
    const bool knows_rates = names_any(form_.qdot),
               knows_accelerations = names_any(form_.udot) || names_any(form_.lambda);
    check_vanishes(form_.f_c, "configuration constraint ");
    check_vanishes(form_.f_v, "velocity constraint ");
    fill_missing(form_.qdot, form_.known.qdot);
    if (!names_all(form_.udot)) fill_missing(form_.udot, e.get(mechanics::quantity::udot).entries);
    if (!form_.lambda.empty()) fill_missing(form_.lambda, e.linearized().multipliers().entries);
    if (knows_rates)
      check_vanishes(mechanics::summed(form_.f_0, form_.f_1), "kinematic differential equation ");
    if (!knows_accelerations) return;
    check_vanishes(form_.f_a, "the rate of velocity constraint ");
    check_vanishes(mechanics::summed(mechanics::summed(form_.f_2, form_.f_3), form_.f_4),
                   "dynamic differential equation ");
  }

  /// Whether the point specifies no values.
  bool is_empty() const { return is_empty_; }

  symbolic::point_values values(const symbolic::matrix& m) { return symbolic::limits_at(g_, m, all_); }

  /// Sentences about the equations that the point does not satisfy.
  const std::vector<std::string>& failures() const { return failures_; }

private:
  using symbols = base::sequence<symbolic::expression>;
  static constexpr double tolerance = 1e-9;

  bool names(symbolic::expression symbol) const {
    return std::ranges::find(all_, symbol, &symbolic::replacement::symbol) != all_.end();
  }
  bool names_any(const symbols& wanted) const {
    return std::any_of(wanted.begin(), wanted.end(), [&](const auto& e) { return names(e); });
  }
  bool names_all(const symbols& wanted) const {
    return std::all_of(wanted.begin(), wanted.end(), [&](const auto& e) { return names(e); });
  }

  /// For each symbol in `wanted` that the point does not specify, assigns the value of the corresponding
  /// expression at the point.
  void fill_missing(const symbols& wanted, const symbols& expressions) {
    symbolic::matrix column(g_, wanted.size(), 1);
    column.entries = expressions;
    const symbolic::point_values found = values(column);
    for (const symbolic::singularity& s : found.singular)
      if (!names(wanted[s.row]))
        failures_.push_back(symbolic::print(wanted[s.row]) +
                            " has no value at the operating point: " + s.condition);
    std::vector<symbolic::replacement> added;
    for (int i = 0; i < wanted.size(); ++i)
      if (!names(wanted[i])) added.push_back({wanted[i], found.values.entries[i]});
    all_.insert(all_.end(), added.begin(), added.end());
  }

  /// Checks that residuals vanish. Those that still contain a coordinate, a speed or a rate may be satisfied
  /// by unspecified values.
  void check_vanishes(const symbols& zero, const std::string& what) {
    using kind = symbolic::symbol_kind;
    symbolic::matrix column(g_, zero.size(), 1);
    column.entries = zero;
    const symbols left = values(column).values.entries;
    symbolic::term_sizes sizes(g_);
    for (symbolic::expression& e : column.entries) e = sizes.of(e);
    const symbols terms = values(column).values.entries;
    const mechanics::contents held(g_);
    for (int i = 0; i < left.size(); ++i) {
      if (held.holds_any(left[i], {kind::coordinate, kind::speed, kind::coordinate_rate, kind::speed_rate,
                                   kind::multiplier}))
        continue;
      if (vanishes(left[i], terms[i])) continue;
      failures_.push_back("the operating point does not satisfy " + what + std::to_string(i + 1) +
                          ": the residual is " + symbolic::print_in_sentence(left[i]));
    }
  }

  /// Whether a sum is negligible compared with its terms for two sets of generic values of its symbols.
  bool vanishes(symbolic::expression e, symbolic::expression terms) const {
    for (const double first : {0.7312, 1.2931}) {
      const auto any = [&](int id) { return 0.4 + std::fmod(first * (id + 1), 1.0); };
      const base::sequence<double> value = symbolic::values_at(g_, {e.node(), terms.node()}, any);
      if (!(std::abs(value[0]) <= tolerance * value[1])) return false;
    }
    return true;
  }

  const mechanics::general_form& form_;
  symbolic::graph& g_;
  bool is_empty_;
  std::vector<symbolic::replacement> all_; ///< the specified values, then those that follow from them
  std::vector<std::string> failures_{};
};

} // namespace kanexpr::runtime
