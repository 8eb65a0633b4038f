#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/numeric/central_interpolation.hpp>
#include <kanexpr/numeric/constrained_minimum.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kanexpr::numeric {

/// The motion of a constrained system from the equations for all speeds, M u̇ = f + Jᵀ λ with J u̇ + γ = 0,
/// at the nearest state that satisfies the constraints. The speeds need not be divided into independent and
/// dependent ones, and the rows of J may be linearly dependent.
///
/// At a position where rows of J become dependent, the constraints do not determine how the mechanism
/// continues to move; on both sides of the position, they do. The motion near such a position is therefore
/// interpolated from states at some distance before and after it in the direction of its speeds: the required
/// quantities are smooth along this path.
///
/// `Equations` provides the sizes of its vectors as constants, −1 for sizes known only at run time, and
///
///     coordinates(), speeds(), rows_of_coordinates(), rows_of_speeds()
///     configuration(x, left, by_coordinates)   the residual and its derivatives
///     velocities(x, left, by_speeds)
///     motion(x, qdot, mass, force, bias)       a status
///
/// and, for `find`, whether the velocity constraints are linear in the speeds: `velocities_are_linear()`, and
/// the constant `only_linear` if this is so for all systems of the type.
template <class Equations>
class constrained_motion {
public:
  using number = typename Equations::number;
  static constexpr int n = Equations::fixed_coordinates, p = Equations::fixed_speeds,
                       l = Equations::fixed_rows_of_coordinates, m = Equations::fixed_rows_of_speeds;
  template <int rows, int columns = 1>
  using matrix = Eigen::Matrix<number, rows, columns>;
  using state = matrix < n<0 ? -1 : n + p>;
  using rows_of_speeds = matrix<m>;

  using speeds = matrix<p>;

  /// The state on the constraints nearest to a given state, and its rates.
  struct motion {
    state x{}, rates{};
  };

  /// `sizes` are the typical sizes of the entries of a state; `nearby` is any state close to the motion.
  constrained_motion(const Equations& of, const state& sizes, const state& nearby)
      : of_(of), sizes_(sizes), by_q_(by_coordinates::Zero(of.rows_of_coordinates(), of.coordinates())),
        by_u_(by_speeds::Zero(of.rows_of_speeds(), of.speeds())),
        mass_(masses::Zero(of.speeds(), of.speeds())), qdot_(coordinates::Zero(of.coordinates())),
        force_(speeds::Zero(of.speeds())), bias_(rows_of_speeds::Zero(of.rows_of_speeds())),
        row_sizes_q_(rows_of_coordinates::Zero(by_q_.rows())),
        row_sizes_u_(rows_of_speeds::Zero(by_u_.rows())) {
    estimate_scales(nearby);
  }

  /// Returns how far the velocity constraints are from linear dependence at a state, relative to the largest
  /// distance found: about 1 far from all positions where constraints become dependent, and 0 if some are
  /// always dependent.
  number distinctness(const state& x) {
    if (usual_rank_ < most_rank()) return 0;
    velocities(x);
    return distinctness_of(singular_values<by_speeds>(scaled_by_u()));
  }

  /// Whether the configuration constraints hold up to rounding.
  bool configuration_holds(const state& x) {
    return by_q_.rows() == 0 || configuration(x).norm() <= rounding;
  }
  bool velocities_hold(const state& x) {
    number size = 0;
    for (int i = of_.coordinates(); i < x.size(); ++i) size = (std::max)(size, std::abs(x(i)) / sizes_(i));
    return velocities(x).norm() <= rounding * size;
  }

  /// Finds the motion at a state or, if the state does not satisfy the constraints, near it.
  status find(const state& given, motion& found) {
    status s = find_at_nearest(given, found);
    if (!s || distinct_ >= min_distinctness) return s;
    const Eigen::Index rank = usual_rank_, here = rank_;
    if (const status passing = interpolate(found); passing) return passing;
    if constexpr (!Equations::only_linear) // the speeds, not the position, make rows of J vanish
      if (!of_.velocities_are_linear() && here < rank) return inconsistent();
    return usual_rank_ == rank ? s : find_at_nearest(given, found);
  }

  /// Finds u̇ and the multipliers from the constraints at a state, without changing the state. Among all
  /// multipliers that give the same forces, these have the least sum of squares. `rank_of` returns the rank
  /// of J with its rows scaled to their typical lengths.
  template <class Rank>
  status find_at(const state& x, const Rank& rank_of, speeds& udot, rows_of_speeds& multipliers) {
    if (const status s = of_.motion(x, qdot_, mass_, force_, bias_); !s) return s;
    velocities(x);
    const by_speeds rows = scaled_by_u();
    const Eigen::Index rank = rank_of(rows);
    const singular_values<by_speeds> j(rows);
    const masses mass = scaled_mass();
    const constrained_minimum<masses, by_speeds> bound(mass, j, rank);
    if (!bound.is_regular()) return no_kinetic_energy();
    const speeds force = scaled_by_sizes(force_);
    const rows_of_speeds bias = bias_.cwiseQuotient(row_sizes_u_);
    const speeds found = bound.solve(force, -bias);
    if (!check_consistent(j, found, bias))
      return status("the constraints that are redundant at this state contradict the others");
    udot = scaled_by_sizes(found);
    multipliers = least_of(bound.multipliers(force, found).cwiseQuotient(row_sizes_u_), j, rank);
    return {};
  }

  /// Moves x to the nearest configuration that satisfies the constraints.
  status place(state& x) {
    if constexpr (l == 0) // singular values require rows
      return {};
    else
      return by_q_.rows() == 0 ? status() : place_by_steps(x);
  }

private:
  using coordinates = matrix<n>;
  using rows_of_coordinates = matrix<l>;
  using by_coordinates = matrix<l, n>;
  using by_speeds = matrix<m, p>;
  using masses = matrix<p, p>;

  static constexpr bool is_single = sizeof(number) < sizeof(double);
  static constexpr number rounding = 1024 * std::numeric_limits<number>::epsilon();
  static constexpr number rank_tolerance =
      is_single ? number(4e-5) : number(2e-9); ///< relative to the largest singular value
  static constexpr number residual_tolerance =
      is_single ? number(1e-4) : number(1e-8); ///< the permitted residual of the constraints
  static constexpr number nonzero_tolerance =
      is_single ? number(1e-3) : number(1e-6); ///< a singular value above this bound is not identically zero
  static constexpr number min_distinctness =
      number(1e-2); ///< below this distinctness, the motion loses accuracy
  static constexpr number close_enough =
      is_single ? number(1e-4) : number(1e-9); ///< a step whose square is negligible
  static constexpr number max_move =
      number(0.5); ///< the greatest distance a state may be moved, relative to its size
  static constexpr number spacing =
      number(2e-2); ///< the distance between interpolated states, relative to their size
  static constexpr int most_steps = 20, samples = 3;

  static status inconsistent() {
    return status("the constraints are dependent or inconsistent near this state");
  }
  static status no_kinetic_energy() {
    return status("a motion that the constraints permit has no kinetic energy");
  }
  Eigen::Index most_rank() const { return (std::min)(by_u_.rows(), by_u_.cols()); }

  /// Determines the typical sizes of the rows and their distinctness, at states that need not satisfy the
  /// constraints.
  void estimate_scales(const state& nearby) {
    state tried[samples];
    number way = 0;
    for (state& x : tried) {
      x = nearby;
      for (int i = 0; i < of_.coordinates(); ++i) {
        way = std::fmod(way + number(0.618034), number(1)); // any number that does not divide a full turn
        x(i) += (way - number(0.5)) * sizes_(i);
      }
      if (by_q_.rows() != 0) configuration(x);
      for (Eigen::Index i = 0; i < by_q_.rows(); ++i)
        row_sizes_q_(i) = (std::max)(row_sizes_q_(i), norm_of(by_q_, i, 0));
      velocities(x);
      for (Eigen::Index i = 0; i < by_u_.rows(); ++i)
        row_sizes_u_(i) = (std::max)(row_sizes_u_(i), norm_of(by_u_, i, of_.coordinates()));
    }
    for (number& size : row_sizes_q_) size = size > 0 ? size : 1;
    for (number& size : row_sizes_u_) size = size > 0 ? size : 1;
    usual_rank_ = most_rank();
    for (const state& x : tried) {
      velocities(x);
      const singular_values<by_speeds> found(scaled_by_u());
      if (usual_rank_ != 0) usual_ = (std::max)(usual_, found[usual_rank_ - 1]);
    }
    if (!(usual_ > 0)) usual_ = 1;
  }
  template <class Rows>
  number norm_of(const Rows& j, Eigen::Index row, int first) const {
    number square = 0;
    for (Eigen::Index k = 0; k < j.cols(); ++k) {
      const number entry = j(row, k) * sizes_(first + k);
      square += entry * entry;
    }
    return std::sqrt(square);
  }

  rows_of_coordinates configuration(const state& x) {
    rows_of_coordinates left = rows_of_coordinates::Zero(by_q_.rows());
    of_.configuration(x, left, by_q_);
    return left.cwiseQuotient(row_sizes_q_);
  }
  rows_of_speeds velocities(const state& x) {
    rows_of_speeds left = rows_of_speeds::Zero(by_u_.rows());
    of_.velocities(x, left, by_u_);
    return left.cwiseQuotient(row_sizes_u_);
  }
  template <class Rows>
  Rows scaled(const Rows& j, const matrix<Rows::RowsAtCompileTime>& rows, int first) const {
    Rows out = j;
    for (Eigen::Index i = 0; i < j.rows(); ++i)
      for (Eigen::Index k = 0; k < j.cols(); ++k) out(i, k) *= sizes_(first + k) / rows(i);
    return out;
  }
  by_coordinates scaled_by_q() const { return scaled(by_q_, row_sizes_q_, 0); }
  by_speeds scaled_by_u() const { return scaled(by_u_, row_sizes_u_, static_cast<int>(of_.coordinates())); }

  number distinctness_of(const singular_values<by_speeds>& j) const {
    return usual_rank_ == 0 ? number(1) : j[usual_rank_ - 1] / usual_;
  }

  /// Returns the minimum-norm Newton step. A singular value counts only if it exceeds the amount by which the
  /// step itself may change it.
  static coordinates step_of(const singular_values<by_coordinates>& j, const rows_of_coordinates& left) {
    coordinates step = coordinates::Zero(j.right_vector(0).size());
    for (Eigen::Index i = 0; i < j.count(); ++i) {
      if (!(j[i] > rank_tolerance * j[0] && j[i] > 10 * step.norm())) break;
      step -= (j.left_vector(i).dot(left) / j[i]) * j.right_vector(i);
    }
    return step;
  }

  status place_by_steps(state& x) {
    number last = std::numeric_limits<number>::infinity();
    for (int steps = 0; steps < most_steps; ++steps) {
      const rows_of_coordinates left = configuration(x);
      const coordinates step = step_of(singular_values<by_coordinates>(scaled_by_q()), left);
      const number size = step.norm();
      if (!(size < max_move)) break;
      for (int i = 0; i < of_.coordinates(); ++i) x(i) += step(i) * sizes_(i);
      if (size <= close_enough || (size <= 1e-4 && size > last / 4)) {
        const rows_of_coordinates rest = configuration(x);
        return rest.norm() <= residual_tolerance ? status() : inconsistent();
      }
      last = size;
    }
    return inconsistent();
  }

  /// Finds the motion at the nearest state that satisfies the constraints, from the constraints at that state
  /// only.
  status find_at_nearest(const state& given, motion& found) {
    const int first = of_.coordinates();
    found.x = given;
    if (const status s = place(found.x); !s) return s;
    if (const status s = of_.motion(found.x, qdot_, mass_, force_, bias_); !s) return s;
    if constexpr (!Equations::only_linear)
      if (!of_.velocities_are_linear())
        if (const status s = move(found.x); !s) return s;
    const rows_of_speeds left = velocities(found.x); // J u + c
    const singular_values<by_speeds> j(scaled_by_u());
    distinct_ = distinctness_of(j);
    const masses mass = scaled_mass();
    rank_ = j.rank(rank_tolerance * j[0]);
    const constrained_minimum<masses, by_speeds> bound(mass, j, rank_);
    if (!bound.is_regular()) return no_kinetic_energy();
    const speeds change = bound.solve(speeds::Zero(of_.speeds()), -left);
    for (int i = 0; i < of_.speeds(); ++i) found.x(first + i) += change(i) * sizes_(first + i);
    if (const status s = check_consistent(j, change, left); !s) return s;

    if (const status s = of_.motion(found.x, qdot_, mass_, force_, bias_); !s) return s;
    const rows_of_speeds bias = bias_.cwiseQuotient(row_sizes_u_);
    const speeds udot = bound.solve(scaled_by_sizes(force_), -bias);
    if (const status s = check_consistent(j, udot, bias); !s) return s;
    found.rates = state::Zero(found.x.size());
    for (int i = 0; i < first; ++i) found.rates(i) = qdot_(i);
    for (int i = 0; i < of_.speeds(); ++i) found.rates(first + i) = udot(i) * sizes_(first + i);
    return {};
  }

  /// Moves the speeds of x to those that satisfy constraints that are not linear in them, by Newton steps of
  /// least kinetic energy. `motion` was evaluated at the coordinates of x.
  status move(state& x) {
    const int first = of_.coordinates();
    const masses mass = scaled_mass();
    number last = std::numeric_limits<number>::infinity();
    for (int steps = 0; steps < most_steps; ++steps) {
      const rows_of_speeds left = velocities(x);
      const singular_values<by_speeds> j(scaled_by_u());
      const constrained_minimum<masses, by_speeds> bound(mass, j, j.rank(rank_tolerance * j[0]));
      if (!bound.is_regular()) return no_kinetic_energy();
      const speeds change = bound.solve(speeds::Zero(of_.speeds()), -left);
      const number size = change.norm();
      if (!(size < max_move)) break;
      for (int i = 0; i < of_.speeds(); ++i) x(first + i) += change(i) * sizes_(first + i);
      if (size <= close_enough || (size <= 1e-4 && size > last / 4)) return {};
      last = size;
    }
    return inconsistent();
  }

  masses scaled_mass() const {
    const masses sizes = sizes_of_speeds() * sizes_of_speeds().transpose();
    return mass_.cwiseProduct(sizes);
  }
  speeds scaled_by_sizes(const speeds& of) const { return of.cwiseProduct(sizes_of_speeds()); }
  speeds sizes_of_speeds() const { return sizes_.tail(of_.speeds()); }

  /// Removes from the multipliers the components that produce no force. The rows of J are not scaled here.
  rows_of_speeds least_of(rows_of_speeds multipliers, const singular_values<by_speeds>& j,
                          Eigen::Index rank) const {
    matrix<m, m> none = matrix<m, m>::Zero(by_u_.rows(), by_u_.rows()); // directions that produce no force
    for (Eigen::Index i = rank; i < none.cols(); ++i) {
      rows_of_speeds next = j.left_vector(i).cwiseQuotient(row_sizes_u_);
      next /= next.norm();
      for (int twice = 0; twice < 2; ++twice)
        for (Eigen::Index k = rank; k < i; ++k) next -= none.col(k).dot(next) * none.col(k);
      none.col(i) = next / next.norm();
    }
    for (Eigen::Index i = rank; i < none.cols(); ++i)
      multipliers -= none.col(i).dot(multipliers) * none.col(i);
    return multipliers;
  }

  /// Reports whether J x + b vanishes, including the components outside the range of J.
  static status check_consistent(const singular_values<by_speeds>& j, const speeds& x,
                                 const rows_of_speeds& b) {
    rows_of_speeds left = b;
    for (Eigen::Index i = 0; i < j.count(); ++i) left += (j[i] * j.right_vector(i).dot(x)) * j.left_vector(i);
    return left.norm() <= residual_tolerance * (1 + b.norm() + j[0] * x.norm()) ? status() : inconsistent();
  }

  /// Interpolates the motion at a singular position from the motions before and after it. If the constraints
  /// are no farther from linear dependence at those states, some of them are always dependent.
  status interpolate(motion& found) {
    number length = 0;
    for (int i = 0; i < of_.coordinates(); ++i) {
      const number rate = found.rates(i) / sizes_(i);
      length += rate * rate;
    }
    if (!(length > 0)) return inconsistent();
    number step = spacing / std::sqrt(length);
    const motion from = found;
    const auto find_ahead = [&](number ahead, motion& one) {
      state there = from.x;
      for (int i = 0; i < of_.coordinates(); ++i) there(i) += ahead * from.rates(i);
      return find_at_nearest(there, one);
    };
    constexpr number farthest_stride = central_interpolation::strides[3];
    for (int tries = 0; tries < 4; ++tries) { // the magnitudes of angles may span many revolutions
      motion one;
      if (!find_ahead(farthest_stride * step, one) || !(distinct_ > 2 * farthest_stride * spacing)) break;
      step *= farthest_stride * spacing / distinct_;
    }
    motion sum{state::Zero(from.x.size()), state::Zero(from.x.size())};
    Eigen::Index rank = 0;
    number usual = 0;
    for (const int reach : central_interpolation::strides)
      for (const int side : {-1, 1}) {
        const number ahead = static_cast<number>(side * reach) * step;
        motion one;
        if (const status s = find_ahead(ahead, one); !s) return s;
        const singular_values<by_speeds> j(scaled_by_u());
        rank = (std::max)(rank, j.rank(nonzero_tolerance * usual_));
        if (rank != 0) usual = (std::max)(usual, j[rank - 1]);
        if (rank == usual_rank_ && distinct_ < 2 * min_distinctness) return inconsistent();
        const number weight = central_interpolation::weight_of<number>(reach);
        for (int i = 0; i < of_.coordinates(); ++i) one.x(i) -= ahead * from.rates(i);
        sum.x += weight * one.x;
        sum.rates += weight * one.rates;
      }
    if (rank < usual_rank_) {
      usual_rank_ = rank, usual_ = usual;
      return inconsistent();
    }
    found = sum;
    return {};
  }

  const Equations& of_;
  state sizes_;
  by_coordinates by_q_;
  by_speeds by_u_;
  masses mass_;
  coordinates qdot_;
  speeds force_;
  rows_of_speeds bias_;
  rows_of_coordinates row_sizes_q_;
  rows_of_speeds row_sizes_u_;
  number usual_ = 0; ///< the largest value found for the smallest singular value that is not identically zero
  Eigen::Index usual_rank_ = 0; ///< the usual rank of J
  Eigen::Index rank_ = 0;       ///< the rank of J at the last state evaluated
  number distinct_ = 0;         ///< the distinctness there
};

} // namespace kanexpr::numeric
