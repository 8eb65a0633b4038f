// Extreme states: every result is finite there, or its status reports why not.
#pragma once

#include "errors.hpp"
#include "mechanics/random/build_recipe.hpp"
#include "mechanics/random/dice.hpp"
#include "mechanics/random/in_units.hpp"

#include <kanexpr/runtime/interpreted.hpp>

#include <limits>

namespace soak {

// A result of a mechanism, evaluated repeatedly.
class result_of {
public:
  result_of(recipe::builder& b, kanexpr::mechanics::equations& derived,
            kanexpr::mechanics::quantity wanted = kanexpr::mechanics::quantity::rhs)
      : value_(evaluated(b, derived, wanted)) {}

  Eigen::MatrixXd at(const recipe::mechanism& m) {
    Eigen::VectorXd x(static_cast<Eigen::Index>(m.q.size() + m.u.size()));
    std::copy(m.q.begin(), m.q.end(), x.begin());
    std::copy(m.u.begin(), m.u.end(), x.begin() + static_cast<std::ptrdiff_t>(m.q.size()));
    const auto vector = [](const std::vector<double>& v) {
      return Eigen::VectorXd(Eigen::VectorXd::Map(v.data(), static_cast<Eigen::Index>(v.size())));
    };
    return value_(m.t, x, vector(m.parameters), vector(m.r));
  }
  kanexpr::status status() const { return value_.status(); }

private:
  static kanexpr::runtime::interpreted<double>
  evaluated(recipe::builder& b, kanexpr::mechanics::equations& derived, kanexpr::mechanics::quantity wanted) {
    const kanexpr::symbolic::matrix result = derived.get(wanted);
    kanexpr::base::sequence<int> outputs;
    for (const auto& e : result.entries) outputs.push(e.node());
    return {b.graph(), result, b.mechanism().coordinates.size(), derived.singularity_checks_of(outputs)};
  }

  kanexpr::runtime::interpreted<double> value_;
};

class hostile_states {
public:
  hostile_states(recipe::mechanism m, const recipe::in_units& in, dice& d)
      : m_(std::move(m)), in_(in), d_(d) {}

  void visit(recipe::builder& b, kanexpr::mechanics::equations& derived, errors& found) {
    using kanexpr::mechanics::quantity;
    std::vector<result_of> results;
    for (const quantity each : {quantity::rhs, quantity::mass_matrix, quantity::forcing,
                                quantity::kinetic_energy, quantity::angular_momentum})
      results.emplace_back(b, derived, each);
    if (m_.has_gravity || !m_.springs.empty() || !m_.twists.empty())
      results.emplace_back(b, derived, quantity::potential_energy);
    if (derived.constraints_used().size() > 0) results.emplace_back(b, derived, quantity::multipliers);

    constexpr double largest = 1e20; // whose fourth power is far from overflow
    for (const bool of_state : {true, false}) {
      const auto visit_with = [&](const std::string& what, auto value) {
        look_at(results, found, what, of_state ? state_by(value) : parameters_by(value));
      };
      visit_with("zeros", [&](double) { return 0.0; });
      visit_with("quarter turns", [&](double) { return d_.whole(-2, 2) * std::acos(0.0); });
      visit_with("tiny values", [&](double) { return d_.pick({5e-324, -1e-300, 1e-100, 1e-17}); });
      visit_with("huge values", [&](double) { return d_.pick({-1.0, 1.0, 0.1}) * largest; });
      visit_with("a mixture", [&](double x) { return d_.pick({0.0, x, 1e-30, largest, -x, 1.0}); });
    }
    // with NaN, the only requirement is that the evaluation returns
    for (const double none :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      recipe::mechanism at = m_;
      std::vector<double>& x = d_.chance(0.5) ? at.q : at.u;
      if (!x.empty()) x[static_cast<std::size_t>(d_.whole(0, static_cast<int>(x.size()) - 1))] = none;
      for (result_of& each : results) each.at(at);
      ++visited;
    }
  }

  long visited = 0, refused = 0;

private:
  void look_at(std::vector<result_of>& results, errors& found, const std::string& what,
               const recipe::mechanism& at) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const Eigen::MatrixXd value = results[i].at(at);
      const kanexpr::status told = results[i].status();
      found.expect(static_cast<bool>(told) || !told.cause().empty(), what + ": refused without a cause");
      found.expect(!told || value.allFinite(),
                   what + ": result " + std::to_string(i) + " is not finite, and no status says so");
      if (i == 0) ++visited, refused += !told;
    }
  }

  template <class Value>
  recipe::mechanism state_by(Value value) const {
    recipe::mechanism at = m_;
    for (std::size_t i = 0; i < at.q.size(); ++i) {
      const double unit = in_.coordinates()[i], x = value(at.q[i] / unit);
      at.q[i] = unit * (is_of_quaternion(i) ? std::clamp(x, -10.0, 10.0) : x); // many powers are multiplied
    }
    for (std::size_t i = 0; i < at.u.size(); ++i)
      at.u[i] = in_.speeds()[i] * value(at.u[i] / in_.speeds()[i]);
    return at;
  }
  template <class Value>
  recipe::mechanism parameters_by(Value value) const {
    recipe::mechanism at = m_;
    for (std::size_t i = 0; i < at.parameters.size(); ++i)
      if (const double unit = in_.parameters()[i]; unit != 0)
        at.parameters[i] = unit * value(at.parameters[i] / unit);
    return at;
  }

  bool is_of_quaternion(std::size_t i) const {
    for (const recipe::frame& f : m_.frames)
      if (f.how == recipe::turn::quaternion && i - static_cast<std::size_t>(f.quaternion) < 4) return true;
    return false;
  }

  recipe::mechanism m_;
  const recipe::in_units& in_;
  dice& d_;
};

} // namespace soak
