#pragma once

#include <kanexpr/export/wanted.hpp>

#include <string>
#include <vector>

namespace kanexpr::exporting {

/// One of the vectors that a function of CasADi is given: the state x, the inputs r, the parameters p, the
/// time t.
struct casadi_argument {
  std::string name{};
  symbols are{};
  int size = 0;
};

/// What CasADi may ask for beside the rates of the state, as functions of C: derivatives by the state and the
/// inputs, and by all arguments, which cost more. A group is a set of arguments.
class casadi_kernels {
public:
  explicit casadi_kernels(const std::vector<casadi_argument>& by_all) : by_all_(by_all) {}

  static constexpr std::size_t basic = 2; ///< the first arguments: the state and the inputs

  std::vector<wanted_function> all() const {
    std::vector<wanted_function> wanted{rates()};
    add(wanted, basic, "");
    for (std::size_t i = basic; i < by_all_.size(); ++i)
      if (by_all_[i].size > 0) {
        add(wanted, by_all_.size(), "_by_all");
        break;
      }
    return wanted;
  }

  static wanted_function rates() {
    wanted_function f = results("rhs");
    f.name = "rates";
    f.results[0].name = "rate";
    return f;
  }

private:
  using kind = wanted_derivative::kind;

  void add(std::vector<wanted_function>& wanted, std::size_t count, const std::string& end) const {
    wanted_function jacobian{.name = "jacobian" + end}, directional{.name = "directional" + end},
        directional_jacobian{.name = "directional_jacobian" + end}, gradient{.name = "gradient" + end},
        hessian{.name = "hessian" + end};
    wanted_result along = derived("rate", {.is = kind::along});
    along.is_sparse = false;
    for (std::size_t i = 0; i < count; ++i) along.derivative.along.push_back(by_all_[i].are);
    directional.results.push_back(along);
    for (std::size_t i = 0; i < count; ++i) {
      const symbols by = by_all_[i].are;
      const std::string called = "by_" + by_all_[i].name;
      jacobian.results.push_back(jacobian_by(by_all_[i]));
      directional_jacobian.results.push_back(
          derived(called, {.is = kind::along_jacobian, .along = along.derivative.along, .by = by}));
      gradient.results.push_back(derived(called, {.is = kind::weighted, .by = by}));
      gradient.results.back().is_sparse = false;
      for (std::size_t k = 0; k < count; ++k)
        hessian.results.push_back(
            derived(called + '_' + by_all_[k].name,
                    {.is = kind::weighted_jacobian, .by = by, .and_by = by_all_[k].are}));
    }
    for (const wanted_function& each : {jacobian, directional, directional_jacobian, gradient, hessian})
      wanted.push_back(each);
  }

  /// That of the linearized equations, where these have it: it costs less than the chain rule.
  static wanted_result jacobian_by(const casadi_argument& by) {
    using mechanics::quantity;
    wanted_result found = derived("by_" + by.name, {.is = kind::jacobian, .by = by.are});
    if (by.are != symbols::state && by.are != symbols::inputs) return found;
    found.request.wanted = by.are == symbols::state ? quantity::state_jacobian : quantity::input_jacobian;
    found.derivative = {};
    return found;
  }

  static wanted_result derived(std::string name, wanted_derivative by) {
    return {.name = std::move(name),
            .request = {.what = deriving::request::kind::result, .wanted = mechanics::quantity::rhs},
            .derivative = std::move(by),
            .is_sparse = true};
  }

  const std::vector<casadi_argument>& by_all_;
};

} // namespace kanexpr::exporting
