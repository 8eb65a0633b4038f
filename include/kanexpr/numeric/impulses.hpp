#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

namespace kanexpr::numeric {

/// Several contacts that are struck simultaneously, in a system with the mass matrix M.
///
/// The impulses λ ≥ 0 act along the rows of `contacts`, so that the speeds u become u + M⁻¹ Jᵀ λ. The contact
/// velocity v becomes at least −e v, and exactly that where λ > 0 (J. J. Moreau, 1988, Unilateral contact and
/// dry friction in finite freedom dynamics). With the same e in [0, 1] at all contacts, the kinetic energy
/// does not increase. Impulses of `constraints` keep their velocities at zero.
class struck_contacts {
public:
  struck_contacts(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& constraints,
                  const Eigen::MatrixXd& contacts)
      : constraints_(constraints), contacts_(contacts),
        response_(mass.partialPivLu().solve(rows_of((1u << contacts.rows()) - 1).transpose())) {}

  /// The speeds after the impact. The sets of contacts that receive an impulse are tried in turn; at most 12
  /// contacts are supported.
  Eigen::VectorXd speeds_after(const Eigen::VectorXd& u, double restitution) const {
    Eigen::VectorXd best = u;
    double least = -1;
    for (unsigned struck = 0; struck < 1u << contacts_.rows(); ++struck) {
      const trial found = try_set(struck, u, restitution);
      if (least >= 0 && found.violation >= least) continue;
      least = found.violation, best = found.u;
      const double rounding = 1e-12 * (1 + (contacts_ * u).cwiseAbs().maxCoeff());
      if (least <= rounding) break;
    }
    return best;
  }

private:
  struct trial {
    Eigen::VectorXd u;
    double violation; ///< of λ ≥ 0, as the velocity that it would cause, and of v⁺ ≥ −e v
  };

  trial try_set(unsigned struck, const Eigen::VectorXd& u, double restitution) const {
    const Eigen::MatrixXd rows = rows_of(struck), response = columns_of(struck);
    Eigen::VectorXd wanted = -(rows * u);
    const Eigen::Index fixed = constraints_.rows(), hit = rows.rows() - fixed;
    wanted.tail(hit) *= 1 + restitution;
    const Eigen::MatrixXd mobility = rows * response;
    Eigen::VectorXd impulse = wanted;
    if (rows.rows() > 0) impulse = mobility.completeOrthogonalDecomposition().solve(wanted);
    trial t{u + response * impulse, 0};
    const Eigen::VectorXd bounded = contacts_ * (t.u + restitution * u);
    if (bounded.size() > 0) t.violation = (std::max)(t.violation, -bounded.minCoeff());
    if (rows.rows() > 0)
      t.violation = (std::max)(t.violation, (mobility * impulse - wanted).cwiseAbs().maxCoeff());
    for (Eigen::Index i = fixed; i < rows.rows(); ++i)
      t.violation = (std::max)(t.violation, -impulse[i] * mobility(i, i));
    return t;
  }

  /// The rows of the constraints, followed by those of the contacts in a set.
  Eigen::MatrixXd rows_of(unsigned set) const {
    Eigen::MatrixXd all(constraints_.rows() + contacts_.rows(), contacts_.cols());
    Eigen::Index next = constraints_.rows();
    all.topRows(next) = constraints_;
    for (Eigen::Index i = 0; i < contacts_.rows(); ++i)
      if ((set >> i & 1u) != 0) all.row(next++) = contacts_.row(i);
    return all.topRows(next);
  }
  /// The corresponding columns of M⁻¹ Jᵀ.
  Eigen::MatrixXd columns_of(unsigned set) const {
    Eigen::MatrixXd all(response_.rows(), response_.cols());
    Eigen::Index next = constraints_.rows();
    all.leftCols(next) = response_.leftCols(next);
    for (Eigen::Index i = 0; i < contacts_.rows(); ++i)
      if ((set >> i & 1u) != 0) all.col(next++) = response_.col(constraints_.rows() + i);
    return all.leftCols(next);
  }

  Eigen::MatrixXd constraints_, contacts_;
  Eigen::MatrixXd response_; ///< M⁻¹ Jᵀ of the constraints and of all contacts
};

} // namespace kanexpr::numeric
