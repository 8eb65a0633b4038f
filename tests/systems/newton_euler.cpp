#include "systems/jet.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace hand_written {
namespace {

jets along(const VectorXd& q, const VectorXd& rates, const VectorXd& second) {
  jets all;
  for (int i = 0; i < q.size(); ++i) all.emplace_back(q(i), rates(i), second(i));
  return all;
}

VectorXd values(const jets& all) {
  VectorXd v(static_cast<Eigen::Index>(all.size()));
  for (Eigen::Index i = 0; const jet& a : all) v(i++) = a.value;
  return v;
}
VectorXd rates(const jets& all) {
  VectorXd v(static_cast<Eigen::Index>(all.size()));
  for (Eigen::Index i = 0; const jet& a : all) v(i++) = a.rate;
  return v;
}

// The nearest solution, with one refinement step.
VectorXd solution_of(const MatrixXd& all, const VectorXd& right) {
  const Eigen::ColPivHouseholderQR<MatrixXd> factors(all);
  const VectorXd found = factors.solve(right);
  return found + factors.solve(right - all * found);
}

// The minimum-norm solution; the rows are independent.
VectorXd shortest_solution_of(const MatrixXd& all, const VectorXd& right) {
  const MatrixXd back = all.transpose();
  const VectorXd found = back * solution_of(all * back, right);
  return found + back * solution_of(all * back, right - all * found);
}

// Rows of `no_motion`, with a column for each coordinate.
MatrixXd constraint_matrix(const system& s, const VectorXd& q) {
  const VectorXd zero = VectorXd::Zero(q.size());
  MatrixXd all(static_cast<Eigen::Index>(s.move(along(q, zero, zero)).no_motion.size()), q.size());
  for (int i = 0; i < q.size(); ++i)
    all.col(i) = values(s.move(along(q, VectorXd::Unit(q.size(), i), zero)).no_motion);
  return all;
}

} // namespace

solution solve(const system& s, const VectorXd& q, const VectorXd& qdot) {
  const Eigen::Index n = q.size();
  const VectorXd zero = VectorXd::Zero(n);
  const motion now = s.move(along(q, qdot, zero));
  const MatrixXd J = constraint_matrix(s, q);

  MatrixXd M = MatrixXd::Zero(n, n);
  VectorXd f = zero;
  solution result{zero, {}, {}, {}, 0, 0};
  std::vector<motion> by_unit;
  for (int i = 0; i < n; ++i) by_unit.push_back(s.move(along(q, VectorXd::Unit(n, i), zero)));
  for (std::size_t k = 0; k < now.bodies.size(); ++k) {
    const body& b = now.bodies[k];
    const Matrix3d turn = value(b.turn);
    const Matrix3d inertia = turn * b.inertia * turn.transpose();
    const vector velocity = rate_of(b.center), omega = angular_velocity(b.turn);
    const Vector3d v = value(velocity), w = value(omega);
    Eigen::Matrix3Xd V(3, n), W(3, n);
    for (int i = 0; i < n; ++i) {
      const body& unit = by_unit[static_cast<std::size_t>(i)].bodies[k];
      V.col(i) = value(rate_of(unit.center));
      W.col(i) = value(angular_velocity(unit.turn));
    }
    M += b.mass * V.transpose() * V + W.transpose() * inertia * W;
    f += V.transpose() * (b.force - b.mass * rate(velocity)) +
         W.transpose() * (b.torque - inertia * rate(omega) - w.cross(inertia * w));
    result.kinetic_energy += (b.mass * v.squaredNorm() + w.dot(inertia * w)) / 2;
    result.power += b.force.dot(v) + b.torque.dot(w);
  }

  const Eigen::Index m = J.rows();
  MatrixXd all = MatrixXd::Zero(n + m, n + m);
  all << M, -J.transpose(), J, MatrixXd::Zero(m, m);
  VectorXd right(n + m);
  right << f, -rates(now.no_motion);
  const VectorXd found = solution_of(all, right);
  result.acceleration = found.head(n);
  result.multipliers = found.tail(m);
  const motion then = s.move(along(q, qdot, result.acceleration));
  result.speeds = values(then.speeds);
  result.udot = rates(then.speeds);
  return result;
}

// Moves q to a configuration that satisfies the constraints, by steps of minimum norm.
bool close(const system& s, VectorXd& q) {
  const VectorXd zero = VectorXd::Zero(q.size());
  const auto gap = [&](const VectorXd& at) { return values(s.move(along(at, zero, zero)).closed); };
  const Eigen::Index m = gap(q).size();
  if (m == 0) return true;
  for (int step = 0; step < 50; ++step) {
    MatrixXd gradient(m, q.size());
    for (int i = 0; i < q.size(); ++i)
      gradient.col(i) = rates(s.move(along(q, VectorXd::Unit(q.size(), i), zero)).closed);
    const VectorXd change = shortest_solution_of(gradient, gap(q));
    q -= change;
    if (!(change.norm() < 1e3)) return false;
    if (change.norm() <= 1e-15 * (1 + q.norm())) break;
  }
  return gap(q).norm() <= 1e-13;
}

// The part of these rates that the constraints permit.
VectorXd allowed(const system& s, const VectorXd& q, const VectorXd& rates) {
  const MatrixXd J = constraint_matrix(s, q);
  const VectorXd result = rates - shortest_solution_of(J, J * rates);
  return result - shortest_solution_of(J, J * result);
}

VectorXd pick(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
              const VectorXd& values) {
  VectorXd picked = VectorXd::Zero(static_cast<Eigen::Index>(wanted.size()));
  for (std::size_t i = 0; i < wanted.size(); ++i)
    for (std::size_t j = 0; j < names.size(); ++j)
      if (wanted[i] == names[j]) picked(static_cast<Eigen::Index>(i)) = values(static_cast<Eigen::Index>(j));
  return picked;
}

VectorXd rates_for(const system& s, const VectorXd& q, const std::vector<std::string>& names,
                   const VectorXd& speeds) {
  const MatrixXd J = constraint_matrix(s, q);
  MatrixXd all(speeds.size() + J.rows(), q.size());
  for (int i = 0; i < q.size(); ++i) {
    const motion unit = s.move(along(q, VectorXd::Unit(q.size(), i), VectorXd::Zero(q.size())));
    all.col(i) << pick(names, s.u, values(unit.speeds)), J.col(i);
  }
  VectorXd right(all.rows());
  right << speeds, VectorXd::Zero(J.rows());
  return solution_of(all, right);
}

} // namespace hand_written
