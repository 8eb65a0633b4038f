#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/derived.hpp>
#include <kanexpr/runtime/linearization_point.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// Looks up the symbols of an operating point in a derived system. A parameter that only the operating point
/// uses, such as the speed of a vehicle, is added to the parameters.
class point_reader {
public:
  explicit point_reader(derived& system) : system_(system), m_(system.mechanism()) {}

  std::vector<symbolic::replacement> read(const linearization_point& point) {
    std::vector<symbolic::replacement> found;
    for (const symbol_name& what : point.doubled())
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

  /// The mistakes in the operating point, as sentences.
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
        system_.reader().admit_parameter(*t.symbol);
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

} // namespace kanexpr::runtime
