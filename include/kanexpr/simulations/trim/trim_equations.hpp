#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/angle.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/simulations/constraints/unit_norms.hpp>
#include <kanexpr/simulations/sundials/kinsol.hpp>
#include <kanexpr/simulations/trim/trim.hpp>
#include <kanexpr/simulations/trim/trim_conditions.hpp>
#include <kanexpr/simulations/trim/trim_sizes.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace kanexpr::simulations {

/// The equations of an operating point as functions of its unknowns, with exact derivatives by complex steps.
class trim_equations {
  using number = std::complex<double>;

public:
  trim_equations(const conditions& asked, const system_functions& system, double t,
                 const Eigen::VectorXd& guess)
      : asked_(asked), system_(system), norms_(system.known), t_(t), at_(guess),
        all_(asked.residuals() + asked.states()) {
    if (system.constraints != nullptr) constraints_.emplace(*system.constraints, system.known);
    if (system.rates != nullptr) rates_.emplace(*system.rates, system.known);
    find_angles();
    usual_length_ = sizes::longest(angles_, guess);
  }

  int equations() const { return static_cast<int>(asked_.equations().size()); }
  int unknowns() const { return static_cast<int>(asked_.unknowns().size()); }
  /// Returns the number of leading unknowns that change only if the others cannot solve the equations: the
  /// states.
  int unknowns_kept_close() const {
    return static_cast<int>(
        std::ranges::count_if(asked_.unknowns(), [&](int place) { return place < asked_.states(); }));
  }

  Eigen::VectorXd start() const { return at_(asked_.unknowns()).real(); }

  /// Evaluates the residuals at z; returns whether they are finite there.
  bool residual(const Eigen::VectorXd& z, Eigen::VectorXd& f) {
    place(z);
    unsolved_ = evaluate();
    f.resize(equations());
    Eigen::Index row = 0;
    for (const condition& c : asked_.equations()) f(row++) = all_(c.place).real() - c.wanted;
    return unsolved_.empty() && numeric::all_finite(f);
  }

  bool jacobian(const Eigen::VectorXd& z, Eigen::MatrixXd& slope) {
    place(z);
    slope.resize(equations(), unknowns());
    Eigen::Index column = 0;
    for (const int unknown : asked_.unknowns()) {
      differentiate(unknown);
      Eigen::Index row = 0;
      for (const condition& c : asked_.equations()) slope(row++, column) = derivative_of(c.place);
      ++column;
    }
    return numeric::all_finite(slope);
  }

  /// Limits the change of a state in one step to its absolute value or, if that is smaller, to its scale,
  /// which is 1 for an angle.
  Eigen::VectorXd limits(const Eigen::VectorXd& z) const {
    Eigen::VectorXd most = Eigen::VectorXd::Constant(unknowns(), std::numeric_limits<double>::infinity());
    for (Eigen::Index i = 0; i < unknowns_kept_close(); ++i) most(i) = (std::max)(sizes_(i), std::abs(z(i)));
    return most;
  }

  /// Returns the magnitudes of unknowns and equations near z.
  magnitudes magnitudes_at(const Eigen::VectorXd& z) {
    place(z);
    Eigen::MatrixXd slope(all_.size(), at_.size());
    for (int symbol = 0; symbol < at_.size(); ++symbol) {
      differentiate(symbol);
      for (int row = 0; row < all_.size(); ++row) {
        const double found = derivative_of(row);
        slope(row, symbol) = numeric::is_finite(found) ? found : 0;
      }
    }
    const sizes found(asked_, angles_, at_.real(), slope, usual_length_);
    sizes_ = found.symbols()(asked_.unknowns());
    magnitudes of{sizes_, Eigen::VectorXd(equations())};
    Eigen::Index row = 0;
    for (const condition& c : asked_.equations())
      of.equations(row++) = (std::max)(found.functions()(c.place), std::abs(c.wanted));
    return of;
  }

  /// Returns a message that names the linear system that was singular when the residual was last evaluated;
  /// empty if there was none.
  std::string_view unsolved() const { return unsolved_; }
  /// Returns [x; p; r] with the unknowns inserted.
  Eigen::VectorXd values(const Eigen::VectorXd& z) {
    place(z);
    return at_.real();
  }

private:
  void place(const Eigen::VectorXd& z) {
    Eigen::Index i = 0;
    for (const int unknown : asked_.unknowns()) at_(unknown) = z(i++);
  }

  /// Evaluates [norms of quaternions; constraints; ẋ]. Returns a message that names a
  /// singular linear system; empty if there is none.
  std::string_view evaluate() {
    number* all = all_.data();
    for (int k = 0; k < norms_.count(); ++k) *all++ = norms_.residual(k, at_.data());
    if (system_.compiled != nullptr) return system_.compiled(t_, at_.data(), all);
    const derivation::survey& known = system_.known;
    const number *x = at_.data(), *p = x + known.first_of(symbolic::symbol_kind::parameter),
                 *r = x + known.first_of(symbolic::symbol_kind::input);
    const status kept = constraints_ ? constraints_->evaluate(t_, x, p, r, all) : status();
    const status moved =
        rates_->evaluate(t_, x, p, r, all + known.configuration_constraints + known.constraints);
    return (moved ? kept : moved).view();
  }
  /// Differentiates by a complex step, the square of which is negligible compared with any value.
  void differentiate(int symbol) {
    at_(symbol).imag(step);
    evaluate();
    at_(symbol).imag(0);
  }
  double derivative_of(int function) const { return all_(function).imag() / step; }

  /// Determines, at the guess, which coordinates are angles.
  void find_angles() {
    const derivation::survey& known = asked_.known();
    for (int j = 0; j < known.coordinates; ++j) {
      const double here = at_(j).real();
      const auto nearby = [&](double by) -> Eigen::VectorXd {
        at_(j) = here + by;
        evaluate();
        return all_.real();
      };
      angles_.push_back(known.quaternion_of[j] != 0 || numeric::is_angle(nearby));
      at_(j) = here;
    }
  }

  static constexpr double step = 1e-40;

  const conditions& asked_;
  const system_functions system_;
  unit_norms norms_;
  std::optional<runtime::table_interpreter<number>> constraints_{}, rates_{};
  double t_;
  Eigen::VectorXcd at_, all_;
  std::string_view unsolved_{};
  std::vector<bool> angles_{}; ///< whether each coordinate is an angle
  double usual_length_ = 0;
  Eigen::VectorXd sizes_{}; ///< magnitudes of the unknowns
};

} // namespace kanexpr::simulations
