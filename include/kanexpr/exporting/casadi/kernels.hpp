#pragma once

#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <string>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// An argument of a CasADi function: the state x, its rates, the inputs r, the parameters p, or the time t.
struct casadi_argument {
  std::string name{};
  symbols are{};
  int size = 0;

  /// False for parameters and time, which come last: derivatives by them are computed only on request.
  bool is_basic() const { return are != symbols::parameters && are != symbols::time; }
};

inline std::size_t count_of_basic(const std::vector<casadi_argument>& arguments) {
  std::size_t count = 0;
  while (count < arguments.size() && arguments[count].is_basic()) ++count;
  return count;
}

/// The C functions that CasADi may request for a column (the rates of the state or the residual of the
/// implicit form): the column itself, its derivatives by the basic arguments, and its derivatives by all
/// arguments, which cost more.
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
    // Together with derivatives by the parameters, those from the graph share more operations.
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

  /// The Jacobian by one argument. That of the rates is taken from the linearized equations if they have it,
  /// as this costs less than the chain rule.
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

} // namespace kanexpr::exporting
