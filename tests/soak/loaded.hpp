// A random mechanism with random loads: the balance of energy, the constraints, Lagrange's method, and
// derivatives.
#pragma once

#include "errors.hpp"
#include "loaded_mechanism.hpp"
#include "mechanics/random/dice.hpp"
#include "random_units.hpp"

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <string>

namespace soak {

class loaded {
public:
  explicit loaded(unsigned seed) : d_(seed + 77), seed_(seed), b_(seed), m_(kanexpr::derive(b_)) {
    const Eigen::Index size = m_.mechanism().coordinates.size() + m_.mechanism().speeds.size();
    if (!m_.mistake().empty()) return;
    rates_ = m_.rhs();
    auto rhs = m_.function(rates_);
    for (int tried = 0; tried < 20 && !regular_; ++tried) {
      x_ = Eigen::VectorXd::NullaryExpr(size, [&] { return d_.between(-1.2, 1.2); });
      bind();
      regular_ = Eigen::VectorXd(rhs(x_, p_)).norm() < 1e4 && rhs.status();
    }
  }

  // There is none where a pathway has no length or a constraint is singular. A random end of a pathway may
  // also be inside the surface around which it wraps.
  bool is_regular() const {
    const std::string mistake = m_.mistake();
    return mistake.empty() ? regular_ : mistake.find("is inside the surface") == std::string::npos;
  }

  void run(errors& found, const wanted& w) {
    found.expect(m_.mistake().empty(), m_.mistake());
    if (!found.reason().empty()) return;
    if (w.planted > 0) return expect_found(found, w.planted);
    balance(found);
    differentiate(found);
    compare_roads(found);
    if (w.hostile_states) visit_hostile(found);
  }

  long hostile_visited = 0, hostile_refused = 0;

private:
  using real = long double;
  static constexpr double finer = 500; ///< a quarter of the ratio of rounding errors in double and in `real`
  using complex = std::complex<real>;
  using expression = kanexpr::symbolic::expression;
  using quantity = kanexpr::mechanics::quantity;
  using matrix = kanexpr::symbolic::matrix;

  // The constraint holds at the state.
  void bind() {
    p_ = Eigen::VectorXd(m_.mechanism().parameters.size());
    if (!b_.held.is_given()) return;
    matrix one(m_.graph(), 1, 1);
    one.entries[0] = b_.held;
    p_[0] = 0;
    p_[0] = m_.function(one)(x_, p_)(0);
  }

  expression rate_of(expression value) {
    expression sum = m_.mechanism().zero();
    int row = 0;
    for (const auto* list : {&m_.mechanism().coordinates, &m_.mechanism().speeds})
      for (const expression& e : *list)
        sum += kanexpr::symbolic::differentiate(value, e) * rates_.entries[row++];
    return sum;
  }

  void balance(errors& found) {
    const expression stored = m_.get(quantity::potential_energy).entries[0] + b_.stored,
                     moving = m_.get(quantity::kinetic_energy).entries[0];
    matrix all(m_.graph(), 3, 1);
    all.entries[0] = rate_of(moving), all.entries[1] = rate_of(stored);
    all.entries[2] = b_.held.is_given() ? rate_of(b_.held) : m_.mechanism().zero();
    const Eigen::VectorXd at = m_.function(all)(x_, p_);
    const double scale =
        1 + std::abs(at[0]) + std::abs(at[1]) + Eigen::VectorXd(m_.function(rates_)(x_, p_)).norm();
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(1, 1);
    if (b_.held.is_given()) found.compare("rate of a constraint", at.tail(1), zero, 10 * scale);
    if (b_.held.is_given() || b_.gives) return;
    const Eigen::MatrixXd gain = Eigen::MatrixXd::Constant(1, 1, at[0] + at[1]);
    if (b_.takes)
      found.compare("gain of energy", gain.cwiseMax(0), zero, scale);
    else
      found.compare("energy", gain, zero, scale);
  }

  // The derivatives against complex steps in long double. Near singular states, the rates themselves lose
  // digits: in double, derivatives may differ as much as complex steps in double do, and in long double by as
  // many times less as it is finer.
  void differentiate(errors& found) {
    const Eigen::Index n = x_.size();
    const Eigen::VectorXd weights = Eigen::VectorXd::NullaryExpr(n, [&] { return d_.between(-1, 1); });
    const matrix slopes = m_.get(quantity::state_jacobian), bends = m_.get(quantity::weighted_hessian);
    const auto evaluated = [&]<class T>(const matrix& what, T) {
      const auto in = [](const Eigen::VectorXd& v) { return Eigen::VectorX<T>(v.cast<T>()); };
      auto f = m_.function<T>(what);
      return Eigen::MatrixXd(
          f(T(0), in(x_), in(p_), Eigen::VectorX<T>(), in(weights)).template cast<double>());
    };
    const Eigen::MatrixXd first = evaluated(slopes, real()), second = evaluated(bends, real());
    const Eigen::MatrixXd by_steps = stepped<real>(rates_);
    Eigen::MatrixXd bent(n, n);
    {
      auto jacobian = m_.function<complex>(slopes);
      for (Eigen::Index j = 0; j < n; ++j) bent.col(j) = derivative_of(jacobian, j).transpose() * weights;
    }
    const double noise = (stepped<double>(rates_) - by_steps).norm() / errors::tolerance;
    found.compare("state Jacobian", first, by_steps, 1 + first.norm() + noise / finer);
    found.compare("weighted Hessian", second, bent, 10 * (1 + second.norm() + noise / finer));
    found.compare("state Jacobian in double", evaluated(slopes, double()), by_steps,
                  1 + first.norm() + 10 * noise);
  }

  // The imaginary part of a function of the state with a step along one of its entries.
  template <class T>
  Eigen::MatrixXd derivative_of(kanexpr::runtime::interpreted<std::complex<T>>& f, Eigen::Index along) {
    Eigen::VectorX<std::complex<T>> aside = x_.cast<std::complex<T>>();
    const Eigen::VectorX<std::complex<T>> p = p_.cast<std::complex<T>>();
    aside[along] += std::complex<T>(0, T(1e-30));
    return (Eigen::MatrixX<std::complex<T>>(f(aside, p)).imag() / T(1e-30)).template cast<double>();
  }
  template <class T>
  Eigen::MatrixXd stepped(const matrix& what) {
    auto f = m_.function<std::complex<T>>(what);
    Eigen::MatrixXd all(x_.size(), x_.size());
    for (Eigen::Index j = 0; j < x_.size(); ++j) all.col(j) = derivative_of(f, j);
    return all;
  }

  // The Jacobian of a mechanism with a slightly larger load must not pass for that of this one.
  void expect_found(errors& found, double planted) {
    kanexpr::model other = kanexpr::derive(loaded_mechanism(seed_, false, planted));
    if (!other.mistake().empty()) return;
    const Eigen::VectorX<real> x = x_.cast<real>(), p = p_.cast<real>();
    const Eigen::MatrixXd wrong =
        Eigen::MatrixX<real>(other.function<real>(other.get(quantity::state_jacobian))(x, p)).cast<double>();
    found.compare("planted error", wrong, stepped<real>(rates_), 1 + wrong.norm());
  }

  void compare_roads(errors& found) {
    const Eigen::VectorXd rates = m_.function(rates_)(x_, p_);
    kanexpr::model copied = kanexpr::runtime::derive_in_own_graph(b_);
    found.compare("rates in a graph of their own", copied.function(copied.rhs())(x_, p_), rates,
                  1 + rates.norm());
    if (b_.mixes_speeds || b_.constrains) return;
    kanexpr::model lagrange = kanexpr::derive(loaded_mechanism(seed_, true));
    found.expect(lagrange.mistake().empty(), lagrange.mistake());
    if (!found.reason().empty()) return;
    found.compare("rates by Lagrange's method", lagrange.function(lagrange.rhs())(x_, p_), rates,
                  100 * (1 + rates.norm()));
  }

  void visit_hostile(errors& found) {
    auto rhs = m_.function(rates_);
    const auto visit = [&](const std::string& what, auto value) {
      Eigen::VectorXd x = x_;
      for (double& each : x) each = value(each);
      const Eigen::VectorXd rates = rhs(x, p_);
      const kanexpr::status told = rhs.status();
      found.expect(!told || rates.allFinite(), what + ": the rates are not finite, and no status says so");
      found.expect(static_cast<bool>(told) || !told.cause().empty(), what + ": refused without a cause");
      ++hostile_visited, hostile_refused += !told;
    };
    visit("zeros", [](double) { return 0.0; });
    visit("tiny values", [&](double) { return d_.pick({5e-324, -1e-300, 1e-100, 1e-17}); });
    visit("huge values", [&](double) { return d_.pick({-1.0, 1.0, 0.1}) * 1e12; });
    visit("a mixture", [&](double x) { return d_.pick({0.0, x, 1e-30, 1e8, -x, 1.0}); });
  }

  dice d_;
  unsigned seed_;
  loaded_mechanism b_;
  kanexpr::model m_;
  matrix rates_{};
  Eigen::VectorXd x_, p_;
  bool regular_ = false;
};

} // namespace soak
