#pragma once

#include <kanexpr/simulate/sundials/kinsol.hpp>
#include <kanexpr/simulate/trim_conditions.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace kanexpr::trim {

using complex_vector = Eigen::VectorXcd;

/// [norms of quaternions; constraints; ẋ] of a system at the time t and [x; p; r], and what could not be
/// solved there, as a sentence.
using evaluation = std::string_view (*)(double t, const complex_vector& at, complex_vector& all);

/// The equations of an operating point as functions of its unknowns. Their derivatives are exact: by complex
/// steps.
class trim_equations final : public solvers::nonlinear_equations {
public:
  trim_equations(const conditions& asked, evaluation evaluate, double t, const Eigen::VectorXd& guess)
      : asked_(asked), evaluate_(evaluate), t_(t), at_(guess), all_(asked.residuals() + asked.states()) {}

  int equations() const override { return static_cast<int>(asked_.equations().size()); }
  int stiff_unknowns() const override {
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
    unsolved_ = evaluate_(t_, at_, all_);
    f.resize(equations());
    Eigen::Index row = 0;
    for (const condition& c : asked_.equations()) f(row++) = all_(c.place).real() - c.wanted;
    return unsolved_.empty() && f.allFinite();
  }

  bool jacobian(const Eigen::VectorXd& z, Eigen::MatrixXd& slope) override {
    constexpr double step = 1e-40; // its square is nothing beside any value
    place(z);
    slope.resize(equations(), unknowns());
    Eigen::Index column = 0;
    for (const int unknown : asked_.unknowns()) {
      at_(unknown).imag(step);
      evaluate_(t_, at_, all_);
      at_(unknown).imag(0);
      Eigen::Index row = 0;
      for (const condition& c : asked_.equations()) slope(row++, column) = all_(c.place).imag() / step;
      ++column;
    }
    return slope.allFinite();
  }

  /// A state changes in one step by no more than its own magnitude, or by 1: a radian.
  Eigen::VectorXd limits(const Eigen::VectorXd& z) const override {
    Eigen::VectorXd most = Eigen::VectorXd::Constant(unknowns(), std::numeric_limits<double>::infinity());
    for (Eigen::Index i = 0; i < z.size(); ++i)
      if (is_state(i)) most(i) = (std::max)(1.0, std::abs(z(i)));
    return most;
  }

  /// States are of magnitude 1 or their own; forces and parameters, in whatever units, are as large as it
  /// takes to change an equation by 1.
  solvers::magnitudes magnitudes_at(const Eigen::VectorXd& z, const Eigen::MatrixXd& slope) const {
    solvers::magnitudes sizes{z.cwiseAbs(), Eigen::VectorXd::Ones(equations())};
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      const double effect = slope.col(i).norm();
      sizes.unknowns(i) = (std::max)(sizes.unknowns(i), is_state(i) || effect < 1e-12 ? 1.0 : 1 / effect);
      sizes.equations = sizes.equations.cwiseMax(sizes.unknowns(i) * slope.col(i).cwiseAbs());
    }
    return sizes;
  }

  /// What the last residual could not solve, as a sentence.
  std::string_view unsolved() const { return unsolved_; }
  /// [x; p; r] with the unknowns in their places.
  Eigen::VectorXd values(const Eigen::VectorXd& z) {
    place(z);
    return at_.real();
  }

private:
  void place(const Eigen::VectorXd& z) {
    Eigen::Index i = 0;
    for (const int unknown : asked_.unknowns()) at_(unknown) = z(i++);
  }
  bool is_state(Eigen::Index i) const { return i < stiff_unknowns(); }

  const conditions& asked_;
  evaluation evaluate_;
  double t_;
  complex_vector at_, all_;
  std::string_view unsolved_{};
};

} // namespace kanexpr::trim
