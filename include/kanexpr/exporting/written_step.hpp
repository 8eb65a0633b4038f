#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/exporting/exported_system.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/steps/methods.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// Results as code, with their singularity checks: pairs of measure and scale, stored after all entries.
struct formed_results {
  std::vector<exported_result> results{};
  std::vector<exported_check> checks{};
  lower::tape code{};
  int weights = 0; ///< number of weights, or of entries of the direction, that the derivatives take
};

/// A vector of values in generated code.
struct written_vector {
  using Scalar = lower::written_value;
  std::vector<Scalar> entries{};

  static written_vector of(const base::sequence<Scalar>& values, int count) {
    return {{values.begin(), values.begin() + count}};
  }
  int size() const { return static_cast<int>(entries.size()); }
  Scalar& operator()(int i) { return entries[static_cast<std::size_t>(i)]; }
  const Scalar& operator()(int i) const { return entries[static_cast<std::size_t>(i)]; }
};

/// The code of a step while it is being generated.
struct step_in_code {
  lower::statements code{};
  std::vector<exported_check> checks{};
  std::vector<std::pair<lower::written_value, lower::written_value>> measures{}; ///< paired with their scales
  std::map<std::pair<symbolic::symbol_kind, int>, lower::written_value> arguments{};
  std::map<mechanics::quantity, std::optional<formed_results>> known{};
};

/// Forms one result of a system; empty if it cannot be formed.
using result_former = std::function<std::optional<formed_results>(mechanics::quantity)>;

/// Equations with which the functions in steps/ generate code: every value becomes a line, and every status a
/// check.
class written_equations {
public:
  using value = lower::written_value;

  written_equations(const derivation::survey& known, const requested_step& wanted, const result_former& form,
                    step_in_code& into)
      : survey_(known), wanted_(wanted), form_(form), into_(into) {}

  template <mechanics::quantity wanted>
  written_vector get(const value& t, const written_vector& x) const {
    const auto known = into_.known.try_emplace(wanted).first;
    if (!known->second) known->second = form_(wanted);
    if (!known->second) return written_vector();
    const formed_results& result = *known->second;
    const auto values = lower::write(into_.code, result.code, [&](const lower::load& from) {
      using symbolic::symbol_kind;
      if (from.from == symbol_kind::time) return t;
      if (from.from == symbol_kind::coordinate) return x(from.position);
      if (from.from == symbol_kind::speed) return x(survey_.coordinates + from.position);
      return argument(from);
    });
    const int entries = result.results.empty() ? 0 : result.results[0].entries();
    for (std::size_t i = 0; i < result.checks.size(); ++i) {
      const int place = entries + 2 * static_cast<int>(i);
      add_check(result.checks[i], values[place], values[place + 1]);
    }
    return written_vector::of(values, entries);
  }

  const written_equations& held(const value&, const written_vector&) const { return *this; }

  status finite(const value& asked, std::string_view cause) const {
    add_check({.cause = std::string(cause), .is_finiteness_check = true}, asked, asked);
    return {};
  }

  bool has_pivots() const { return !wanted_.method.empty() && survey_.constraints != 0; }
  status same_side(const value& before, const value& after) const {
    if (before.code != nullptr)
      add_check({.cause = std::string(steps::singular_position_elsewhere), .is_order_check = true},
                steps::pivot_margin(before, after), 0.0);
    return {};
  }

  status corrected(const value& t, written_vector& x) const {
    if (wanted_.corrections == 0 || (survey_.constraints == 0 && survey_.quaternions == 0)) return {};
    return steps::correct(*this, wanted_.corrections, t, x);
  }

  status normalize(written_vector& x) const {
    const auto [least, most] = steps::near_one;
    for (int k = 0; k < survey_.quaternions; ++k) {
      std::vector<int> places;
      for (int i = 0; i < survey_.coordinates; ++i)
        if (survey_.quaternion_of[i] == k + 1) places.push_back(i);
      const value square = lower::squared_norm(x, places);
      const exported_check range{.cause = std::string(steps::far_from_norm_1(survey_, k).view()),
                                 .is_order_check = true};
      add_check(range, square, least * least);
      add_check(range, -square, -(most * most));
      lower::divide_by_norm(x, places, square);
    }
    return {};
  }

  bool quaternions_are_bound() const {
    for (int i = 0; i < survey_.coordinates; ++i)
      if (survey_.quaternion_of[i] != 0 && survey_.dependent[i]) return true;
    return false;
  }

  bool velocities_are_linear() const { return survey_.nonlinear_constraints == 0; }

  int dependent(int i) const {
    for (int at = 0; at < survey_.coordinates + survey_.speeds; ++at)
      if (survey_.dependent[at] && i-- == 0) return at;
    return 0;
  }

  value argument(const lower::load& from) const {
    const auto [place, is_new] = into_.arguments.try_emplace({from.from, from.position});
    if (is_new) place->second = lower::argument_of(into_.code, from);
    return place->second;
  }

private:
  void add_check(exported_check one, const value& measure, const value& scale) const {
    into_.checks.push_back(std::move(one));
    into_.measures.emplace_back(measure, scale);
  }

  const derivation::survey& survey_;
  const requested_step& wanted_;
  const result_former& form_;
  step_in_code& into_;
};

/// A step that leaves the state unchanged.
struct identity_step {
  template <class Equations, class Time, class State>
  static status advance(const Equations&, const Time&, const State&, const Time&, State&) {
    return {};
  }
};

/// Generates a step of the method with this name.
template <std::size_t... row>
void write_step(const written_equations& of, std::string_view name, const lower::written_value& t,
                written_vector& x, const lower::written_value& h, std::index_sequence<row...>) {
  const auto write = [&]<std::size_t i>() {
    using method = steps::method<*steps::tableaux[i]>;
    if (steps::tableaux[i]->name == name) static_cast<void>(steps::stepped<method>(of, t, x, h));
  };
  (write.template operator()<row>(), ...);
}

/// Returns a step as a function; it is meaningless if a result could not be formed.
inline exported_function written_step(std::string name, const derivation::survey& known,
                                      const requested_step& wanted, const result_former& form) {
  step_in_code into;
  const written_equations of(known, wanted, form, into);
  using symbolic::symbol_kind;
  const lower::written_value t = of.argument({symbol_kind::time, 0}), h = of.argument({symbol_kind::time, 1});
  written_vector x;
  for (int i = 0; i < known.coordinates; ++i) x.entries.push_back(of.argument({symbol_kind::coordinate, i}));
  for (int i = 0; i < known.speeds; ++i) x.entries.push_back(of.argument({symbol_kind::speed, i}));
  if (wanted.method.empty())
    static_cast<void>(steps::stepped<identity_step>(of, t, x, h));
  else
    write_step(of, wanted.method, t, x, h, std::make_index_sequence<steps::tableaux.size()>());
  base::sequence<lower::written_value> results;
  for (const lower::written_value& each : x.entries) results.push(each);
  for (const auto& [measure, scale] : into.measures) results.push(measure), results.push(scale);
  exported_function made{.name = std::move(name), .checks = std::move(into.checks)};
  made.results.push_back({"next", x.size(), 1, 0, {}});
  made.takes_step = true;
  made.code = lower::concluded(into.code, results);
  made.cost = lower::cost_of(made.code);
  return made;
}

} // namespace kanexpr::exporting
