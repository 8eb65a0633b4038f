// States that nobody would choose: what is evaluated there is finite, or its status says why not.
#pragma once

#include "errors.hpp"
#include "mechanics/build_recipe.hpp"
#include "mechanics/dice.hpp"
#include "mechanics/in_units.hpp"

#include <kanexpr/runtime/interpreted.hpp>

#include <limits>

namespace soak {

// ẋ of a mechanism, as often as is asked.
class rates_of {
public:
  rates_of(recipe::builder& b, kanexpr::mechanics::equations& derived) : rates_(evaluated(b, derived)) {}

  Eigen::MatrixXd at(const recipe::mechanism& m) {
    Eigen::VectorXd x(static_cast<Eigen::Index>(m.q.size() + m.u.size()));
    std::copy(m.q.begin(), m.q.end(), x.begin());
    std::copy(m.u.begin(), m.u.end(), x.begin() + static_cast<std::ptrdiff_t>(m.q.size()));
    const auto vector = [](const std::vector<double>& v) {
      return Eigen::VectorXd(Eigen::VectorXd::Map(v.data(), static_cast<Eigen::Index>(v.size())));
    };
    return rates_(m.t, x, vector(m.parameters), vector(m.r));
  }
  kanexpr::status status() const { return rates_.status(); }

private:
  static kanexpr::runtime::interpreted<double> evaluated(recipe::builder& b,
                                                         kanexpr::mechanics::equations& derived) {
    const kanexpr::symbolic::matrix rhs = derived.get(kanexpr::mechanics::quantity::rhs);
    kanexpr::symbolic::sequence<int> outputs;
    for (const auto& e : rhs.entries) outputs.push(e.node());
    return {b.graph(), rhs, b.mechanism().coordinates.size(), derived.guards_of(outputs)};
  }

  kanexpr::runtime::interpreted<double> rates_;
};

class hostile_states {
public:
  hostile_states(recipe::mechanism m, const recipe::in_units& in, dice& d)
      : m_(std::move(m)), in_(in), d_(d) {}

  void visit(rates_of& rates, errors& found) {
    constexpr double largest = 1e20; // of which the fourth power is far from overflow
    look_at(rates, found, "zeros", [&](double) { return 0.0; });
    look_at(rates, found, "quarter turns", [&](double) { return d_.whole(-2, 2) * std::acos(0.0); });
    look_at(rates, found, "tiny values", [&](double) { return d_.pick({5e-324, -1e-300, 1e-100, 1e-17}); });
    look_at(rates, found, "huge values", [&](double) { return d_.pick({-1.0, 1.0, 0.1}) * largest; });
    look_at(rates, found, "a mixture", [&](double x) { return d_.pick({0.0, x, 1e-30, largest, -x, 1.0}); });
    // of what is no number nothing is asked but to come back
    for (const double none :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      recipe::mechanism at = m_;
      std::vector<double>& x = d_.chance(0.5) ? at.q : at.u;
      if (!x.empty()) x[static_cast<std::size_t>(d_.whole(0, static_cast<int>(x.size()) - 1))] = none;
      rates.at(at);
      ++visited;
    }
  }

  long visited = 0, refused = 0;

private:
  template <class Value>
  void look_at(rates_of& rates, errors& found, const std::string& what, Value value) {
    recipe::mechanism at = m_;
    for (std::size_t i = 0; i < at.q.size(); ++i) {
      const double unit = in_.coordinates()[i], x = value(at.q[i] / unit);
      at.q[i] = unit * (is_of_quaternion(i) ? std::clamp(x, -10.0, 10.0) : x); // of many the powers multiply
    }
    for (std::size_t i = 0; i < at.u.size(); ++i)
      at.u[i] = in_.speeds()[i] * value(at.u[i] / in_.speeds()[i]);
    const Eigen::MatrixXd x = rates.at(at);
    ++visited;
    if (!rates.status()) {
      ++refused;
      found.expect(!rates.status().cause().empty(), what + ": refused without a cause");
    } else {
      found.expect(x.allFinite(), what + ": not finite, and no status says so");
    }
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
