// The dynamics of a recipe by the Newton-Euler equations, with plain numbers and without the library:
// positions and rotation matrices along a motion as Taylor series, and partial velocities by setting one
// speed after another to one.
#pragma once

#include "mechanics/jet.hpp"
#include "recipe.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace newton_euler {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using limits::jet;
using limits::jet3;
using limits::jet3x3;
using jets = recipe::values<jet>;

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }
inline int letter(char c) { return c - 'x'; }

inline jet3x3 rotation(int axis, const jet& angle) {
  return limits::rotation(jet3(Vector3d::Unit(axis)), angle);
}

inline jet3x3 rotation(const recipe::frame& f, const jets& now) {
  using recipe::turn;
  const auto about = [&](int i) { return rotation(letter(f.letters[at(i)]), now(f.angle[at(i)])); };
  switch (f.how) {
  case turn::ground: break;
  case turn::about_basis: {
    const double way = f.backwards ? -1 : 1;
    return limits::rotation(jet3(way * Vector3d::Unit(f.axis)), now(f.angle[0]));
  }
  case turn::about_axis: {
    Vector3d axis;
    for (int i = 0; i < 3; ++i) axis(i) = f.direction[at(i)].value;
    return limits::rotation(jet3(axis.normalized()), now(f.angle[0]));
  }
  case turn::body_fixed:
  case turn::cosines: return about(0) * about(1) * about(2);
  case turn::space_fixed: return about(2) * about(1) * about(0);
  case turn::quaternion: {
    const std::size_t k = at(f.quaternion);
    return limits::rotation_by_quaternion(now.q[k], {now.q[k + 1], now.q[k + 2], now.q[k + 3]});
  }
  }
  return {};
}

// The positions and orientations, in the ground's axes.
struct placement {
  std::vector<jet3x3> frames;
  std::vector<jet3> points, velocities;

  jet3 in_ground(const recipe::sum& v, const jets& now) const {
    jet3 total;
    for (const recipe::part& p : v) {
      const jet3 value(now(p.value[0]), now(p.value[1]), now(p.value[2]));
      total = total + frames[at(p.frame)] * value;
    }
    return total;
  }
};

// From the frame's basis vectors: ω = ½ Σ e × ė.
inline jet3 angular_velocity(const jet3x3& frame) {
  jet3 twice;
  for (const jet3& e : frame.column) twice = twice + cross(e, e.rate());
  return jet(0.5) * twice;
}

inline placement place(const recipe::mechanism& m, const jets& now) {
  placement here;
  for (const recipe::frame& f : m.frames) {
    const jet3x3 own = rotation(f, now);
    here.frames.push_back(f.parent < 0 ? own : here.frames[at(f.parent)] * own);
  }
  for (const recipe::point& p : m.points) {
    const jet3 offset = here.in_ground(p.offset, now);
    jet3 rate = offset.rate();
    if (p.reference == 0) rate = here.in_ground(p.velocity, now);
    const int in = p.moves_apart ? p.reference : p.fixed_in;
    if (in > 0) rate = cross(angular_velocity(here.frames[at(in)]), offset) + here.in_ground(p.velocity, now);
    const bool moves_on = p.parent >= 0 && p.reference != 0;
    here.points.push_back(p.parent < 0 ? offset : here.points[at(p.parent)] + offset);
    here.velocities.push_back(moves_on ? here.velocities[at(p.parent)] + rate : rate);
  }
  return here;
}

// Gaussian elimination; the matrices of recipes need no pivoting.
inline std::vector<jet> solve(std::vector<std::vector<jet>> a, std::vector<jet> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const jet factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t k = 0; k < n; ++k) b[k] = b[k] / a[k][k];
  return b;
}

// q̇ from q, u and t.
inline std::vector<jet> coordinate_rates(const recipe::mechanism& m, const jets& now) {
  using recipe::law;
  std::vector<jet> qdot(now.q.size());
  const placement here = place(m, now);
  for (const recipe::rates& k : m.kinematics) {
    std::vector<jet> u, found;
    for (int i : k.speeds) u.push_back(now.u[at(i)]);
    const std::size_t n = u.size();
    const jet3x3 own = rotation(m.frames[at(k.frame)], now);
    switch (k.how) {
    case law::linear: {
      std::vector<std::vector<jet>> a(n, std::vector<jet>(n));
      for (std::size_t i = 0; i < n; ++i) {
        u[i] -= now(k.offset[i]);
        for (std::size_t j = 0; j < n; ++j) a[i][j] = now(k.matrix[i * n + j]);
      }
      found = solve(a, u);
      break;
    }
    case law::body_rates: { // Σ axis_i q̇_i = ω, where axis_i is the axis of rotation i, in the axes of the
                            // frame's parent
      const recipe::frame& f = m.frames[at(k.frame)];
      jet3x3 axes, done;
      for (int i = 0; i < 3; ++i) {
        const int axis = letter(f.letters[at(i)]);
        axes.column[at(i)] = done.column[at(axis)];
        done = done * rotation(axis, now.q[at(k.coordinates[at(i)])]);
      }
      const jet3 omega = own * jet3(u[0], u[1], u[2]);
      const auto& [first, second, third] = axes.column;
      const jet below = dot(first, cross(second, third));
      found = {dot(omega, cross(second, third)) / below, dot(omega, cross(third, first)) / below,
               dot(omega, cross(first, second)) / below};
      break;
    }
    case law::quaternion:
    case law::implicit_quaternion: { // ė = ½ e ω, a product of quaternions
      const std::size_t e = at(k.coordinates[0]);
      const jet3 v(now.q[e + 1], now.q[e + 2], now.q[e + 3]), omega(u[0], u[1], u[2]);
      const jet3 rate = now.q[e] * omega + cross(v, omega);
      const jet half = 0.5;
      found = {-half * dot(v, omega), half * rate[0], half * rate[1], half * rate[2]};
      break;
    }
    case law::base_velocity: {
      const jet3 v = here.frames[at(k.frame)] * jet3(u[0], u[1], u[2]);
      found = {v[0], v[1], v[2]};
      break;
    }
    }
    for (std::size_t i = 0; i < found.size(); ++i) qdot[at(k.coordinates[i])] = found[i];
  }
  return qdot;
}

// Positions, velocities and, with u̇ = 0, accelerations of all points and frames in the ground's axes.
struct motion {
  VectorXd qdot;
  std::vector<Matrix3d> axes;
  std::vector<Vector3d> x, v, a, omega, alpha;
  placement here;
  jets now;
};

inline Vector3d unskewed(const Matrix3d& s) {
  return Vector3d(s(2, 1) - s(1, 2), s(0, 2) - s(2, 0), s(1, 0) - s(0, 1)) / 2;
}

inline motion move(const recipe::mechanism& m, const std::vector<double>& u) {
  motion k;
  jets& now = k.now;
  now.number = [](double c) { return jet(c); };
  for (double v : m.parameters) now.parameters.emplace_back(v);
  for (double v : m.q) now.q.emplace_back(v);
  for (double v : u) now.u.emplace_back(v);
  for (double v : m.r) now.r.emplace_back(v);
  now.t = {m.t, 1, 0};
  now.qdot.resize(now.q.size());
  for (int order = 1; order <= 2; ++order) { // each pass of q̇(q, u, t) gives one more coefficient of q
    now.qdot = coordinate_rates(m, now);
    for (std::size_t i = 0; i < now.q.size(); ++i)
      now.q[i] = {now.q[i].c0, now.qdot[i].c0, order == 1 ? 0 : now.qdot[i].c1 / 2};
  }
  now.qdot = coordinate_rates(m, now);
  k.qdot.resize(static_cast<Eigen::Index>(now.q.size()));
  for (std::size_t i = 0; i < now.q.size(); ++i) k.qdot(static_cast<Eigen::Index>(i)) = now.qdot[i].c0;

  k.here = place(m, now);
  for (const jet3& p : k.here.points) k.x.push_back(p.value());
  for (const jet3& v : k.here.velocities) {
    k.v.push_back(v.value());
    k.a.push_back(v.rate().value());
  }
  for (const jet3x3& r : k.here.frames) {
    const Matrix3d back = r.value().transpose();
    k.axes.push_back(r.value());
    k.omega.push_back(unskewed(r.rate().value() * back));
    k.alpha.push_back(unskewed(r.rate().rate().value() * back)); // Ṙ Ṙᵀ is symmetric
  }
  return k;
}

} // namespace newton_euler
