#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/unit_quaternion.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/numeric/constrained_motion.hpp>
#include <kanexpr/numeric/factorized.hpp>
#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/constraints/unit_norms.hpp>
#include <kanexpr/simulations/system_interface.hpp>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace kanexpr::simulations {

/// The manifold of the constraints and quaternions of a system. A projection applies the smallest correction,
/// first to the coordinates by Newton's method, then to the speeds (Eich 1993). One step suffices for
/// constraints that are linear in the speeds.
///
/// This is a template, like everything that depends on it, so that systems without constraints do not compile
/// it.
template <class System>
class constraint_manifold final : public manifold {
public:
  using matrix = Eigen::MatrixXd;

  explicit constraint_manifold(const System& of)
      : of_(of), norms_(of.known), n_(of.known.coordinates), o_(of.known.speeds),
        units_(vector::Zero(of.states())), correction_(vector::Zero(of.states())),
        by_q_(of.known.configuration_constraints + norms_.count(), n_), by_u_(of.known.constraints, o_) {
    for (int i = 0; i < of.states(); ++i)
      if (of.known.dependent[i]) dependent_.push_back(i);
  }

  assembly assemble(double t, vector& x, const vector& r) override {
    if (!norms_.are_bound())
      if (const status s = norms_.normalize(x, {0.99, 1.01}); !s) {
        assembly failed;
        failed.failure = base::sentence({s.view()});
        return failed;
      }
    constraints at(*this, t, r);
    return numeric::assemble(at, x, {});
  }
  vector configuration_residual(double t, const vector& x, const vector& r) override {
    return constraints(*this, t, r).configuration_residual(x);
  }
  base::sentence redundant_violation(double t, const vector& x, const vector& r, double tolerance) override {
    const constraints here(*this, t, r);
    const vector left = here.redundant_residual(x);
    vector terms = here.redundant_terms(x), nearby = x;
    if ((left.cwiseAbs().array() <= tolerance * terms.array()).all()) return {};
    for (int point = 1; point <= 3; ++point) { // terms that vanish here may be larger nearby
      for (int i = 0; i < n_; ++i) nearby(i) = x(i) + std::sin(point + 2.4 * i) * sizes_(i);
      terms = terms.cwiseMax(here.redundant_terms(nearby)).eval();
    }
    for (Eigen::Index i = 0; i < left.size(); ++i)
      if (!(std::abs(left(i)) <= tolerance * terms(i)))
        return numeric::with_number(
            base::sentence({"redundant constraint ", base::counted(static_cast<int>(i) + 1).view(),
                            " has a residual of "})
                .view(),
            left(i));
    return {};
  }

  void set_sizes(double t, const vector& x, const vector& r, const vector& sizes) override {
    sizes_ = sizes;
    unreduced_.reset();
    is_near_ = false;
    motion_at(t, x, r);
  }
  void update_singularity(double t, const vector& x, const vector& r, double least) override {
    const double distinctness = motion_at(t, x, r).distinctness(x);
    if (!is_near_) clear_ = 2 * least; // to avoid switching at every step
    is_near_ = distinctness < (is_near_ ? clear_ : least);
  }
  bool is_near_singular() const override { return is_near_; }
  status rates(double t, const vector& x, const vector& r, double* xdot) override {
    const status s = motion_at(t, x, r).find(x, found_);
    if (s) std::copy_n(found_.rates.data(), x.size(), xdot);
    return s;
  }

  status multipliers(double t, const vector& x, const vector& r, double* lambda) override {
    vector udot(o_), found(by_u_.rows());
    const auto all = [](const matrix& rows) { return rows.rows(); };
    const status s = motion_at(t, x, r).find_at(x, all, udot, found);
    if (s) std::copy_n(found.data(), found.size(), lambda);
    return s;
  }

  bool project(double t, const vector& x, const vector& r, const vector& weights) override {
    units_ = weights.cwiseAbs2().cwiseInverse();
    correction_.setZero();
    is_by_rows_ = !is_near_ && project_coordinates(t, x, r, weights) && project_speeds(t, x, r, weights);
    if (is_by_rows_) return true;
    if (by_u_.rows() == 0 || !motion_at(t, x, r).find(x, found_)) return false;
    correction_ = found_.x - x;
    return true;
  }
  const vector& correction() const override { return correction_; }
  /// Near a singular position the whole error is kept, since the rows of J do not determine its normal
  /// component.
  void project_error(double* error) const override {
    if (!is_by_rows_) return;
    Eigen::Map<vector> of_q(error, n_), of_u(error + n_, o_);
    if (by_q_.rows() != 0) of_q += minimum_norm_solution(by_q_, 0, -by_q_.lazyProduct(of_q));
    if (by_u_.rows() != 0) of_u += minimum_norm_solution(by_u_, n_, -by_u_.lazyProduct(of_u));
  }

private:
  /// Returns D Jᵀ (J D Jᵀ)⁻¹ b, the smallest vector that J maps to b, for the entries of the state from
  /// `first` on.
  vector minimum_norm_solution(const matrix& j, int first, vector b) const {
    matrix spread = j.transpose();
    for (Eigen::Index k = 0; k < spread.rows(); ++k) spread.row(k) *= units_(first + k);
    const numeric::factorized<vector> factors(matrix(j.lazyProduct(spread)));
    factors.solve(b);
    return spread.lazyProduct(b);
  }

  /// The constraints at a fixed time, with the inputs at that time, in the form that `numeric::assemble`
  /// requires. If a constraint is solved for a coordinate of a quaternion, all constraints are evaluated with
  /// unit quaternions.
  class constraints {
  public:
    using coordinate_vector = vector;
    using speed_vector = vector;
    static constexpr bool only_linear = false;

    constraints(constraint_manifold& of, double t, const vector& r)
        : on_(of), known_(of.of_.known), t_(t), r_(r), left_(coordinates()),
          by_all_(coordinates(), known_.coordinates) {}

    int all_coordinates() const { return known_.coordinates; }
    int coordinates() const { return known_.configuration_constraints; }
    int place_of_coordinate(int i) const { return on_.dependent_[static_cast<std::size_t>(i)]; }

    const vector& configuration_residual(const vector& x) {
      if (coordinates() != 0) evaluate(x);
      return left_;
    }
    matrix configuration_jacobian_by_all(const vector& x) {
      evaluate(x);
      matrix by_dependent(coordinates(), coordinates());
      for (int i = 0; i < coordinates(); ++i) by_dependent.col(i) = by_all_.col(place_of_coordinate(i));
      return by_dependent;
    }
    bool velocities_are_linear() const { return known_.nonlinear_constraints == 0; }
    int dependent_speeds() const { return known_.constraints; }
    int place_of_speed(int i) const { return place_of_coordinate(coordinates() + i); }

    vector velocity_residual(const vector& x) const {
      vector left(known_.constraints);
      matrix by_speeds(left.size(), known_.speeds);
      on_.of_.evaluate(results::velocities, at(x), {left.data(), by_speeds.data()});
      return left;
    }
    matrix velocity_jacobian_by_dependent(const vector& x) const {
      vector left(known_.constraints);
      matrix by_speeds(left.size(), known_.speeds), by_dependent(left.size(), left.size());
      on_.of_.evaluate(results::velocities, at(x), {left.data(), by_speeds.data()});
      for (int i = 0; i < dependent_speeds(); ++i)
        by_dependent.col(i) = by_speeds.col(place_of_speed(i) - known_.coordinates);
      return by_dependent;
    }
    vector redundant_residual(const vector& x) const { return redundant(x).col(0); }
    vector redundant_terms(const vector& x) const { return redundant(x).col(1); }
    vector redundant_rate(const vector& x) const { return redundant(x).col(2); }
    vector redundant_rate_terms(const vector& x) const { return redundant(x).col(3); }
    bool configuration_holds(const vector& x) const {
      return on_.motion_at(t_, x, r_).configuration_holds(x);
    }
    bool velocities_hold(const vector& x) const { return on_.motion_at(t_, x, r_).velocities_hold(x); }
    status normalize_quaternions(vector& x) const { return on_.norms_.normalize(x, lower::norm_range{}); }

    /// Sets the dependent speeds of the state, if they can be solved for.
    status solve_speeds(vector& x) const {
      vector u(known_.constraints);
      const status s = on_.of_.evaluate(results::dependent_speeds, at(x), {u.data()});
      if (s)
        for (int i = 0; i < u.size(); ++i) x(place_of_speed(i)) = u(i);
      return s;
    }

  private:
    instant<double> at(const vector& x) const { return {t_, x.data(), r_.data()}; }

    matrix redundant(const vector& x) const {
      const Eigen::Index rows = known_.redundant_constraints;
      matrix all(rows, 4);
      on_.of_.evaluate(results::redundant, at(x),
                       {all.data(), all.data() + rows, all.data() + 2 * rows, all.data() + 3 * rows});
      return all;
    }
    void evaluate(const vector& x) {
      vector normalized = x;
      if (on_.norms_.are_bound()) normalize_quaternions(normalized);
      on_.of_.evaluate(results::configuration, at(normalized), {left_.data(), by_all_.data()});
      if (on_.norms_.are_bound()) on_.norms_.leave_out(by_all_, normalized);
    }

    constraint_manifold& on_;
    const derivation::survey& known_;
    double t_;
    const vector& r_;
    vector left_;
    matrix by_all_;
  };

  /// The system in the form that `constrained_motion` requires, at a fixed time and with the inputs at that
  /// time.
  struct all_speeds {
    using number = double;
    static constexpr int fixed_coordinates = -1, fixed_speeds = -1, fixed_rows_of_coordinates = -1,
                         fixed_rows_of_speeds = -1;
    static constexpr bool only_linear = false;
    constraint_manifold& of;
    double t = 0;
    vector r{};

    int coordinates() const { return of.n_; }
    int speeds() const { return of.o_; }
    Eigen::Index rows_of_coordinates() const { return of.by_q_.rows(); }
    Eigen::Index rows_of_speeds() const { return of.by_u_.rows(); }
    bool velocities_are_linear() const { return of.of_.known.nonlinear_constraints == 0; }
    void configuration(const vector& x, vector& left, matrix& by_coordinates) const {
      left = of.configuration_residual_with_norms(t, x, r);
      by_coordinates = of.by_q_;
    }
    void velocities(const vector& x, vector& left, matrix& by_speeds) const {
      of.of_.evaluate(results::velocities, {t, x.data(), r.data()}, {left.data(), by_speeds.data()});
    }
    status motion(const vector& x, vector& qdot, matrix& mass, vector& force, vector& bias) const {
      return of.of_.evaluate(results::unreduced, {t, x.data(), r.data()},
                             {qdot.data(), mass.data(), force.data(), bias.data()});
    }
  };
  using unreduced_motion = numeric::constrained_motion<all_speeds>;

  /// Returns the motion from the equations for all speeds, at a given time and with the inputs at that time.
  unreduced_motion& motion_at(double t, const vector& x, const vector& r) {
    equations_.t = t, equations_.r = r;
    if (!unreduced_) unreduced_.emplace(equations_, sizes_, x);
    return *unreduced_;
  }

  /// Returns the residuals of the configuration constraints followed by those of the quaternion norms, and
  /// evaluates their derivatives with respect to all coordinates.
  vector configuration_residual_with_norms(double t, const vector& x, const vector& r) {
    const int norms_from = of_.known.configuration_constraints;
    vector left(by_q_.rows());
    by_q_.setZero();
    if (norms_from != 0) {
      matrix by_coordinates(norms_from, n_);
      of_.evaluate(results::configuration, {t, x.data(), r.data()}, {left.data(), by_coordinates.data()});
      by_q_.topRows(norms_from) = by_coordinates;
    }
    for (int k = 0; k < norms_.count(); ++k) {
      left(norms_from + k) = norms_.residual(k, x.data());
      for (const int place : norms_.places_of(k)) by_q_(norms_from + k, place) = x(place);
    }
    return left;
  }

  bool project_coordinates(double t, const vector& y, const vector& r, const vector& weights) {
    return by_q_.rows() == 0 || project_by_steps(0, n_, weights, [&](vector& step) {
             const vector left = configuration_residual_with_norms(t, y + correction_, r);
             step = minimum_norm_solution(by_q_, 0, -left);
           });
  }

  bool project_speeds(double t, const vector& y, const vector& r, const vector& weights) {
    if (by_u_.rows() == 0) return numeric::all_finite(correction_);
    const auto next = [&](vector& step) {
      const vector x = y + correction_;
      vector left(by_u_.rows());
      of_.evaluate(results::velocities, {t, x.data(), r.data()}, {left.data(), by_u_.data()});
      step = minimum_norm_solution(by_u_, n_, -left);
    };
    if (of_.known.nonlinear_constraints != 0) return project_by_steps(n_, o_, weights, next);
    vector step;
    next(step);
    correction_.tail(o_) = step;
    return numeric::all_finite(correction_);
  }

  /// Adds Newton steps to `count` entries of the correction, until a step is negligible or the rounding level
  /// is reached.
  template <class Next>
  bool project_by_steps(int first, int count, const vector& weights, const Next& next) {
    double last = std::numeric_limits<double>::infinity();
    vector step;
    for (int steps = 0; steps < most_steps; ++steps) {
      next(step);
      if (!numeric::all_finite(step)) return false;
      correction_.segment(first, count) += step;
      const double size = step.cwiseProduct(weights.segment(first, count)).cwiseAbs().maxCoeff();
      if (size <= close_enough || (size <= 1 && size > last / 4)) return true;
      last = size;
    }
    return false;
  }

  /// A Newton step this small relative to the tolerances leaves an error of the order of its square, which is
  /// negligible.
  static constexpr double close_enough = 1e-2;
  static constexpr int most_steps = 10;

  const System& of_;
  unit_norms norms_;
  int n_, o_;                    ///< coordinates, speeds
  std::vector<int> dependent_{}; ///< the indices of the dependent entries of the state
  vector units_, correction_;
  matrix by_q_, by_u_;
  vector sizes_ = vector::Ones(n_ + o_);
  double clear_ = 0; ///< the distinctness above which a position is no longer near a singular one
  bool is_near_ = false, is_by_rows_ = false; ///< by rows: the last projection used the rows of J
  all_speeds equations_{*this};
  std::optional<unreduced_motion> unreduced_{};
  typename unreduced_motion::motion found_{};
};

template <class System>
std::unique_ptr<manifold> manifold_of(const System& of) {
  return std::make_unique<constraint_manifold<System>>(of);
}

} // namespace kanexpr::simulations
