#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/angle.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/sundials/kinsol.hpp>
#include <kanexpr/simulations/trim/trim_conditions.hpp>
#include <kanexpr/simulations/trim/trim_sizes.hpp>
#include <kanexpr/simulations/trim/trim_values.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string_view>

namespace kanexpr::simulations {

using complex_vector = Eigen::VectorXcd;

/// The equations of an operating point as functions of its unknowns, with exact derivatives by complex steps.
class trim_equations final : public simulations::nonlinear_equations {
public:
  trim_equations(const conditions& asked, const system_functions& system, double t,
                 const Eigen::VectorXd& guess)
      : asked_(asked), evaluate_(system), t_(t), at_(guess), all_(asked.residuals() + asked.states()) {}

  int equations() const override { return static_cast<int>(asked_.equations().size()); }
  int unknowns_kept_close() const override {
    const auto is_state = [&](int place) { return place < asked_.states(); };
    return static_cast<int>(std::count_if(asked_.unknowns().begin(), asked_.unknowns().end(), is_state));
  }
  int unknowns() const { return static_cast<int>(asked_.unknowns().size()); }

  Eigen::VectorXd start() const {
    Eigen::VectorXd z(unknowns());
    Eigen::Index i = 0;
    for (const int unknown : asked_.unknowns()) z(i++) = at_(unknown).real();
    return z;
  }

  bool residual(const Eigen::VectorXd& z, Eigen::VectorXd& f) override {
    place(z);
    unsolved_ = evaluate_(t_, at_.data(), all_.data());
    f.resize(equations());
    Eigen::Index row = 0;
    for (const condition& c : asked_.equations()) f(row++) = all_(c.place).real() - c.wanted;
    return unsolved_.empty() && numeric::all_finite(f);
  }

  bool jacobian(const Eigen::VectorXd& z, Eigen::MatrixXd& slope) override {
    place(z);
    slope.resize(equations(), unknowns());
    Eigen::Index column = 0;
    for (const int unknown : asked_.unknowns()) {
      derive_by(unknown);
      Eigen::Index row = 0;
      for (const condition& c : asked_.equations()) slope(row++, column) = derivative_of(c.place);
      ++column;
    }
    return numeric::all_finite(slope);
  }

  /// Limits the change of a state in one step to its own magnitude or its scale, which for an angle is 1.
  Eigen::VectorXd limits(const Eigen::VectorXd& z) const override {
    Eigen::VectorXd most = Eigen::VectorXd::Constant(unknowns(), std::numeric_limits<double>::infinity());
    for (Eigen::Index i = 0; i < unknowns_kept_close(); ++i) most(i) = (std::max)(sizes_(i), std::abs(z(i)));
    return most;
  }

  /// Returns the magnitudes of unknowns and equations near z.
  simulations::magnitudes magnitudes_at(const Eigen::VectorXd& z) {
    if (kinds_.unknowns.empty()) find_kinds();
    place(z);
    Eigen::MatrixXd slope(all_.size(), at_.size());
    for (int symbol = 0; symbol < at_.size(); ++symbol) {
      derive_by(symbol);
      for (int row = 0; row < all_.size(); ++row) {
        const double found = derivative_of(row);
        slope(row, symbol) = numeric::is_finite(found) ? found : 0;
      }
    }
    const sizes found(kinds_, at_.real(), slope, usual_length_);
    simulations::magnitudes of{Eigen::VectorXd(unknowns()), Eigen::VectorXd(equations())};
    Eigen::Index i = 0, row = 0;
    for (const int unknown : asked_.unknowns()) of.unknowns(i++) = found.symbols()(unknown);
    for (const condition& c : asked_.equations())
      of.equations(row++) = (std::max)(found.functions()(c.place), std::abs(c.wanted));
    sizes_ = of.unknowns;
    return of;
  }

  /// Returns a sentence that names the linear system that was singular in the last residual; empty if none
  /// was.
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
  /// Differentiates by a complex step, whose square is negligible compared with any value.
  void derive_by(int symbol) {
    at_(symbol).imag(step);
    evaluate_(t_, at_.data(), all_.data());
    at_(symbol).imag(0);
  }
  double derivative_of(int function) const { return all_(function).imag() / step; }

  /// Determines which coordinates are angles, and the magnitude of the others, at the guess.
  void find_kinds() {
    const derivation::survey& known = asked_.known();
    kinds_.coordinates = known.coordinates;
    kinds_.speeds = known.speeds;
    kinds_.residuals = asked_.residuals();
    kinds_.unknowns.assign(static_cast<std::size_t>(at_.size()), false);
    for (const int unknown : asked_.unknowns()) kinds_.unknowns[static_cast<std::size_t>(unknown)] = true;
    for (int j = 0; j < known.coordinates; ++j) {
      const double here = at_(j).real();
      const auto nearby = [&](double by) -> Eigen::VectorXd {
        at_(j) = here + by;
        evaluate_(t_, at_.data(), all_.data());
        return all_.real();
      };
      kinds_.angles.push_back(known.quaternion_of[j] != 0 || numeric::is_angle(nearby));
      at_(j) = here;
    }
    usual_length_ = sizes::longest(kinds_, at_.real());
  }

  static constexpr double step = 1e-40;

  const conditions& asked_;
  values_of_equations evaluate_;
  double t_;
  complex_vector at_, all_;
  std::string_view unsolved_{};
  layout kinds_{};
  double usual_length_ = 0;
  Eigen::VectorXd sizes_{}; ///< of the unknowns
};

} // namespace kanexpr::simulations
