#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/exporting/casadi/casadi_function.hpp>
#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

inline std::size_t count_of_basic(const std::vector<casadi_argument>& arguments) {
  std::size_t count = 0;
  while (count < arguments.size() && arguments[count].is_basic()) ++count;
  return count;
}

/// The C functions that CasADi may need for a column (the rates of the state or the residual of the implicit
/// form): the column itself, its derivatives with respect to the basic arguments, and its derivatives with
/// respect to all arguments, which cost more.
class casadi_kernels {
public:
  casadi_kernels(bool of_residual, const std::vector<casadi_argument>& by_all)
      : of_residual_(of_residual), by_all_(by_all) {}

  std::vector<requested_function> all() const {
    std::vector<requested_function> wanted{column()};
    const std::size_t basic = count_of_basic(by_all_);
    add(wanted, basic, "");
    for (std::size_t i = basic; i < by_all_.size(); ++i)
      if (by_all_[i].size > 0) {
        add(wanted, by_all_.size(), "_by_all");
        break;
      }
    return wanted;
  }

  /// The rates, or the residual.
  requested_function column() const {
    requested_function f{.name = name_of_column(of_residual_)};
    f.results.push_back(derived(of_residual_ ? "residual" : "rate", {}));
    f.results[0].is_sparse = false;
    return f;
  }

  static std::string name_of_column(bool of_residual) { return of_residual ? "residual" : "rates"; }
  static std::string begin_of_names(bool of_residual) { return of_residual ? "residual_" : ""; }

private:
  using kind = requested_derivative::kind;
  using quantity = mechanics::quantity;

  void add(std::vector<requested_function>& wanted, std::size_t count, const std::string& end) const {
    const auto called = [&](const char* what) {
      return requested_function{.name = begin_of_names(of_residual_) + what + end};
    };
    requested_function jacobian = called("jacobian"), directional = called("directional"),
                       directional_jacobian = called("directional_jacobian"), gradient = called("gradient"),
                       hessian = called("hessian");
    std::vector<symbols> all;
    all.reserve(count);
    for (std::size_t i = 0; i < count; ++i) all.push_back(by_all_[i].are);
    // If there are derivatives with respect to the parameters, those taken from the graph share more
    // operations.
    const bool is_by_parameters = !by_all_[count - 1].is_basic();
    const auto to_second_order = [&](requested_result found, quantity by, std::vector<symbols> part) {
      if (of_residual_ || is_by_parameters) return found;
      found.request.wanted = by;
      found.derivative = {};
      found.part = std::move(part);
      return found;
    };
    directional.results.push_back(to_second_order(derived("rate", {.type = kind::directional, .along = all}),
                                                  quantity::directional_derivative, {symbols::state}));
    directional.results.back().is_sparse = false;
    for (std::size_t i = 0; i < count; ++i) {
      const symbols by = by_all_[i].are;
      const std::string begin = "by_" + by_all_[i].name;
      jacobian.results.push_back(jacobian_by(by_all_[i]));
      directional_jacobian.results.push_back(
          derived(begin, {.type = kind::directional_jacobian, .along = all, .by = by}));
      gradient.results.push_back(to_second_order(derived(begin, {.type = kind::weighted, .by = by}),
                                                 quantity::weighted_gradient, {by}));
      gradient.results.back().is_sparse = false;
      for (std::size_t k = 0; k < count; ++k) {
        const symbols and_by = by_all_[k].are;
        hessian.results.push_back(
            to_second_order(derived(begin + '_' + by_all_[k].name,
                                    {.type = kind::weighted_jacobian, .by = by, .and_by = and_by}),
                            quantity::weighted_hessian, {by, and_by}));
      }
    }
    for (const requested_function& each : {jacobian, directional, directional_jacobian, gradient, hessian})
      wanted.push_back(each);
  }

  /// The Jacobian with respect to one argument. For the rates, it is taken from the linearized equations if
  /// they contain it, which costs less than the chain rule.
  requested_result jacobian_by(const casadi_argument& by) const {
    requested_result found = derived("by_" + by.name, {.type = kind::jacobian, .by = by.are});
    if (of_residual_ || !by.is_basic()) return found;
    found.request.wanted = by.are == symbols::state ? quantity::state_jacobian : quantity::input_jacobian;
    found.derivative = {};
    return found;
  }

  requested_result derived(std::string name, requested_derivative by) const {
    return {.name = std::move(name),
            .request = {.what = derivation::request::kind::result, .wanted = quantity::rhs},
            .is_residual = of_residual_,
            .derivative = std::move(by),
            .is_sparse = true};
  }

  bool of_residual_;
  const std::vector<casadi_argument>& by_all_;
};

/// Gives sparse results with the same name in two functions the same sparsity by adding explicit zeros: two
/// derivations of a derivative may find different entries to be zero.
class common_shapes {
public:
  static void unify(exported_function& one, exported_function& other) {
    for (const exported_result& a : one.results)
      for (const exported_result& b : other.results) {
        if (a.name != b.name || !a.is_sparse || a.places == b.places) continue;
        places all;
        std::set_union(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                       std::back_inserter(all));
        widen(one, a.name, all);
        widen(other, b.name, all);
      }
  }

private:
  using places = std::vector<std::pair<int, int>>;

  static void widen(exported_function& f, const std::string& name, const places& to) {
    lower::statements& code = f.code;
    const int zero = code.lines.push({.a = code.numbers.push(symbolic::exactly(0))});
    base::sequence<int> results;
    int next = 0; // an entry of the old results
    for (exported_result& each : f.results) {
      each.first = results.size();
      if (each.name != name) {
        for (int i = 0; i < each.entries(); ++i) results.push(code.results[next++]);
        continue;
      }
      const places from = std::exchange(each.places, to);
      for (const auto& at : to)
        results.push(std::binary_search(from.begin(), from.end(), at) ? code.results[next++] : zero);
    }
    while (next < code.results.size()) results.push(code.results[next++]); // those of the checks
    code.results = results;
  }
};

} // namespace kanexpr::exporting
