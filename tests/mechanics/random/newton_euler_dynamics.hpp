// Kane's equations of a recipe, projected from the Newton-Euler equations.
#pragma once

#include "newton_euler.hpp"

namespace newton_euler {

struct dynamics {
  VectorXd qdot, forcing, active_forces, inertia_bias;
  MatrixXd mass_matrix;
  double kinetic_energy = 0, potential_energy = 0;
  Vector3d linear_momentum = Vector3d::Zero(), angular_momentum = Vector3d::Zero(),
           center_of_mass = Vector3d::Zero();
  double force_scale = 0; // of the terms whose sum is the forcing
};

// Partial velocities of points and frames: velocities are affine in the speeds.
class partial_motions {
public:
  using columns = std::vector<Vector3d>;

  explicit partial_motions(const recipe::mechanism& m) : still_(move(m, std::vector<double>(m.u.size(), 0))) {
    for (std::size_t r = 0; r < m.u.size(); ++r) {
      std::vector<double> u(m.u.size(), 0);
      u[r] = 1;
      one_.push_back(move(m, u));
    }
  }
  columns velocity(std::size_t point) const { return difference(&motion::v, point); }
  columns angular(std::size_t frame) const { return difference(&motion::omega, frame); }

  // ∂V̇/∂u of a function of coordinates and time, from its rate for one speed after another.
  std::vector<double> rates(const std::function<jet(const jets&)>& energy) const {
    std::vector<double> all;
    for (const motion& k : one_) all.push_back(energy(k.now).c1 - energy(still_.now).c1);
    return all;
  }

private:
  columns difference(const std::vector<Vector3d> motion::* of, std::size_t which) const {
    columns j;
    for (const motion& k : one_) j.push_back((k.*of)[which] - (still_.*of)[which]);
    return j;
  }

  motion still_;
  std::vector<motion> one_;
};

// The contribution of the rates of the speeds to an acceleration.
inline Vector3d sum(const partial_motions::columns& j, const std::vector<double>& rates) {
  Vector3d total = Vector3d::Zero();
  for (std::size_t r = 0; r < j.size(); ++r) total += rates[r] * j[r];
  return total;
}

// M v, row by row.
inline VectorXd times(const MatrixXd& m, const VectorXd& v) {
  VectorXd product(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i) product(i) = m.row(i).transpose().cwiseProduct(v).sum();
  return product;
}

// The inertia about the mass center, in the ground's axes.
inline Matrix3d central_inertia(const recipe::body& b, const motion& k) {
  Matrix3d total = Matrix3d::Zero();
  for (const recipe::inertia& part : b.dyadic) {
    double s[6];
    for (std::size_t i = 0; i < 6; ++i) s[i] = part.scalars[i].value;
    Matrix3d own;
    own << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    const Matrix3d& axes = k.axes[at(part.axes)];
    total += axes * own * axes.transpose();
  }
  if (b.about >= 0) {
    const Vector3d r = k.x[at(b.center)] - k.x[at(b.about)];
    total -= b.mass.value * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  return total;
}

// The rate of I·ω for a constant angular velocity: ω×(I·ω), plus further terms if the inertia is not fixed in
// the body.
inline Vector3d change_of_inertia(const recipe::body& b, const motion& k, const Vector3d& omega) {
  const jet3 w(omega);
  jet3 total;
  for (const recipe::inertia& part : b.dyadic) {
    const jet3x3& axes = k.here.frames[at(part.axes)];
    jet3 own;
    for (int i = 0; i < 3; ++i) own[i] = dot(axes.column[at(i)], w);
    jet3 h;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      h[i] += jet(part.scalars[at(i)].value) * own[i];
      h[i] += jet(part.scalars[at(3 + i)].value) * own[j];
      h[j] += jet(part.scalars[at(3 + i)].value) * own[i];
    }
    total = total + axes * h;
  }
  if (b.about >= 0) {
    const jet3 r = k.here.points[at(b.center)] + jet(-1) * k.here.points[at(b.about)];
    total = total + jet(-b.mass.value) * (dot(r, r) * w + jet(-1) * (dot(r, w) * r));
  }
  return total.rate().value();
}

inline dynamics evaluate(const recipe::mechanism& m) {
  const motion k = move(m, m.u);
  const partial_motions partial(m);
  const auto size = static_cast<Eigen::Index>(m.u.size());

  dynamics d;
  d.qdot = k.qdot;
  d.mass_matrix = MatrixXd::Zero(size, size);
  d.active_forces = d.inertia_bias = VectorXd::Zero(size);
  const auto act = [&](VectorXd& on, const partial_motions::columns& j, const Vector3d& load) {
    for (Eigen::Index r = 0; r < size; ++r) {
      const double share = j[static_cast<std::size_t>(r)].dot(load);
      on(r) += share;
      d.force_scale += std::abs(share);
    }
  };
  const auto resist = [&](const partial_motions::columns& j, const Matrix3d& inertia) { // M += Jᵀ I J
    for (Eigen::Index r = 0; r < size; ++r)
      for (Eigen::Index s = 0; s < size; ++s)
        d.mass_matrix(r, s) += j[static_cast<std::size_t>(r)].dot(inertia * j[static_cast<std::size_t>(s)]);
  };
  const auto in_ground = [&](const recipe::sum& v) { return k.here.in_ground(v, k.now).value(); };

  Vector3d gravity = Vector3d::Zero();
  for (int i = 0; i < 3 && m.has_gravity; ++i) gravity(i) = m.gravity[at(i)].value;
  double total_mass = 0;
  for (const recipe::body& b : m.bodies) {
    const double mass = b.mass.value;
    const Vector3d &x = k.x[at(b.center)], &v = k.v[at(b.center)];
    const partial_motions::columns j = partial.velocity(at(b.center));
    resist(j, mass * Matrix3d::Identity());
    act(d.inertia_bias, j, -mass * k.a[at(b.center)]);
    act(d.active_forces, j, mass * gravity);
    d.kinetic_energy += mass * v.squaredNorm() / 2;
    d.potential_energy -= mass * gravity.dot(x);
    d.linear_momentum += mass * v;
    d.angular_momentum += mass * x.cross(v);
    d.center_of_mass += mass * x;
    total_mass += mass;
    if (b.frame < 0) continue;
    const Matrix3d inertia = central_inertia(b, k);
    const Vector3d &omega = k.omega[at(b.frame)], &alpha = k.alpha[at(b.frame)];
    const partial_motions::columns turning = partial.angular(at(b.frame));
    resist(turning, inertia);
    act(d.inertia_bias, turning, -inertia * alpha);
    act(d.inertia_bias, turning, -change_of_inertia(b, k, omega));
    d.kinetic_energy += omega.dot(inertia * omega) / 2;
    d.angular_momentum += inertia * omega;
  }
  d.center_of_mass /= total_mass;
  for (const recipe::load& f : m.forces) {
    act(d.active_forces, partial.velocity(at(f.on)), in_ground(f.value));
    if (f.against >= 0) act(d.active_forces, partial.velocity(at(f.against)), -in_ground(f.value));
  }
  for (const recipe::load& t : m.torques) {
    act(d.active_forces, partial.angular(at(t.on)), in_ground(t.value));
    if (t.against >= 0) act(d.active_forces, partial.angular(at(t.against)), -in_ground(t.value));
  }
  for (const recipe::spring& s : m.springs) {
    const Vector3d line = k.x[at(s.point)] - k.x[at(s.other)], along = line.normalized();
    const double longer = line.norm() - s.length.value, rate = along.dot(k.v[at(s.point)] - k.v[at(s.other)]);
    const Vector3d pull = (s.stiffness.value * longer + s.damping.value * rate) * along;
    act(d.active_forces, partial.velocity(at(s.point)), -pull);
    act(d.active_forces, partial.velocity(at(s.other)), pull);
    d.potential_energy += s.stiffness.value * longer * longer / 2;
  }
  for (const recipe::damper& c : m.dampers) {
    const Vector3d torque = -c.damping.value * (k.omega[at(c.frame)] - k.omega[at(c.against)]);
    act(d.active_forces, partial.angular(at(c.frame)), torque);
    act(d.active_forces, partial.angular(at(c.against)), -torque);
  }
  for (const recipe::twist& s : m.twists) {
    const auto energy = [&](const jets& now) {
      const jet angle = now(s.angle) - jet(s.rest.value);
      return jet(s.stiffness.value / 2) * angle * angle;
    };
    d.potential_energy += energy(k.now).c0;
    const std::vector<double> rates = partial.rates(energy);
    for (Eigen::Index r = 0; r < size; ++r) {
      d.active_forces(r) -= rates[static_cast<std::size_t>(r)];
      d.force_scale += std::abs(rates[static_cast<std::size_t>(r)]);
    }
  }
  d.forcing = d.active_forces + d.inertia_bias;
  return d;
}

} // namespace newton_euler
