#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <vector>

/// Bodies that consist of particles or of small rigid bodies.
namespace lumped {

using Eigen::Vector3d;
using index = Eigen::Index;

/// A particle at r0 + Σ shape_k q_k + ½ Σ bend_kl q_k q_l, or a small rigid body that is rotated by the
/// vector Σ turn_k q_k + ½ Σ turn_bend_kl q_k q_l.
struct particle {
  double mass = 0;
  Vector3d place = Vector3d::Zero();
  std::vector<Vector3d> shape{}; ///< by amplitude
  std::vector<Vector3d> bend{};  ///< row by row; symmetric
  std::vector<Vector3d> turn{}, turn_bend{};
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();

  const Vector3d& bend_of(int k, int l) const {
    return bend[static_cast<std::size_t>(k) * shape.size() + static_cast<std::size_t>(l)];
  }
  const Vector3d& shape_of(int k) const { return shape[static_cast<std::size_t>(k)]; }
  const Vector3d& turn_bend_of(int k, int l) const {
    return turn_bend[static_cast<std::size_t>(k) * turn.size() + static_cast<std::size_t>(l)];
  }
};

struct body {
  int amplitudes = 0;
  std::vector<particle> particles{};
  std::vector<Vector3d> turns{};      ///< the rotation of the node at the last particle, by amplitude
  std::vector<Vector3d> turn_bends{}; ///< the second derivatives of its rotation vector; empty: zero
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< of the node, in the axes of the body
  Eigen::MatrixXd stiffness{}, damping{};
  // The derivatives of the elastic energy of first, third and fourth order, and those of the damping with
  // respect to the amplitudes, row by row; empty: zero.
  std::vector<double> preload{}, third{}, fourth{}, damping_rate{}, second_damping_rate{};

  /// An entry of a list with as many indices as given.
  template <class... Indices>
  double entry(const std::vector<double>& list, Indices... indices) const {
    std::size_t place = 0;
    ((place = place * static_cast<std::size_t>(amplitudes) + static_cast<std::size_t>(indices)), ...);
    return list.empty() ? 0 : list.at(place);
  }
  bool rotates() const { return !particles[0].turn.empty(); }
  /// The rotation of a particle, by default that of the node.
  const Vector3d& turn_of(const particle& p, int k) const {
    return (p.turn.empty() ? turns : p.turn)[static_cast<std::size_t>(k)];
  }
  Vector3d turn_bend_of(int k, int l) const {
    if (turn_bends.empty()) return Vector3d::Zero();
    return turn_bends[static_cast<std::size_t>(k * amplitudes + l)];
  }

  /// Σ m f(particle), an integral over the mass.
  template <class Value>
  Value integral(const std::function<Value(const particle&)>& f) const {
    Value sum = Value::Zero();
    for (const particle& p : particles) sum += p.mass * f(p);
    return sum;
  }
  double mass() const {
    double sum = 0;
    for (const particle& p : particles) sum += p.mass;
    return sum;
  }
};

/// Fills the list of a symmetric tensor with random numbers.
inline std::vector<double> random_tensor(int amplitudes, int order, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::map<std::vector<int>, double> known;
  std::vector<double> all;
  std::vector<int> indices(static_cast<std::size_t>(order), 0);
  for (bool more = true; more;) {
    std::vector<int> sorted = indices;
    std::sort(sorted.begin(), sorted.end());
    if (!known.contains(sorted)) known[sorted] = number(random);
    all.push_back(known[sorted]);
    auto last = indices.rbegin();
    while (last != indices.rend() && ++*last == amplitudes) *last++ = 0;
    more = last != indices.rend();
  }
  return all;
}

/// A body with random particles in space; its particles bend if `bends`.
inline body random_body(int amplitudes, int particles, bool bends, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] {
    const double x = number(random), y = number(random);
    return Vector3d(x, y, number(random));
  };
  body b;
  b.amplitudes = amplitudes;
  for (int i = 0; i < particles; ++i) {
    particle p;
    p.mass = 1.2 + number(random);
    p.place = 2 * vector();
    for (int k = 0; k < amplitudes; ++k) p.shape.push_back(vector());
    p.bend.resize(static_cast<std::size_t>(amplitudes * amplitudes), Vector3d::Zero());
    for (int k = 0; k < amplitudes && bends; ++k)
      for (int l = 0; l <= k; ++l)
        p.bend[static_cast<std::size_t>(k * amplitudes + l)] =
            p.bend[static_cast<std::size_t>(l * amplitudes + k)] = vector();
    b.particles.push_back(p);
  }
  for (int k = 0; k < amplitudes; ++k) b.turns.push_back(vector());
  b.axes = Eigen::AngleAxisd(0.7, vector().normalized()).toRotationMatrix();
  const Eigen::MatrixXd root =
      Eigen::MatrixXd::NullaryExpr(amplitudes, amplitudes, [&] { return number(random); });
  b.stiffness = 100 * (root * root.transpose() + Eigen::MatrixXd::Identity(amplitudes, amplitudes));
  b.damping = root.transpose() * root;
  return b;
}

/// The same with small rigid bodies instead of particles.
inline body random_body_of_rigid_bodies(int amplitudes, int particles, unsigned seed) {
  body b = random_body(amplitudes, particles, true, seed);
  b.axes.setIdentity();
  std::mt19937 random(seed + 1);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vector3d(Vector3d::NullaryExpr([&] { return number(random); })); };
  for (particle& p : b.particles) {
    for (int k = 0; k < amplitudes; ++k) p.turn.push_back(vector());
    p.turn_bend.resize(static_cast<std::size_t>(amplitudes * amplitudes));
    for (int k = 0; k < amplitudes; ++k)
      for (int l = 0; l <= k; ++l)
        p.turn_bend[static_cast<std::size_t>(k * amplitudes + l)] =
            p.turn_bend[static_cast<std::size_t>(l * amplitudes + k)] = vector();
    const Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return number(random); });
    p.inertia = root * root.transpose();
    p.inertia = p.inertia.trace() * Eigen::Matrix3d::Identity() - p.inertia;
  }
  b.turns = b.particles.back().turn, b.turn_bends = b.particles.back().turn_bend;
  return b;
}

inline Eigen::Matrix3d skew(const Vector3d& v) {
  Eigen::Matrix3d s;
  s << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return s;
}

/// The bilinear form whose diagonal is (a·a E − a a).
inline Eigen::Matrix3d inertia_form(const Vector3d& a, const Vector3d& b) {
  return a.dot(b) * Eigen::Matrix3d::Identity() - (a * b.transpose() + b * a.transpose()) / 2;
}

/// a·(ω × (ω × b)) as coefficients of ωx², ωy², ωz², ωx ωy, ωy ωz, ωz ωx.
using six_numbers = Eigen::Matrix<double, 6, 1>;

inline six_numbers centrifugal_form(const Vector3d& a, const Vector3d& b) {
  six_numbers c;
  c << -a.y() * b.y() - a.z() * b.z(), -a.z() * b.z() - a.x() * b.x(), -a.x() * b.x() - a.y() * b.y(),
      a.x() * b.y() + a.y() * b.x(), a.y() * b.z() + a.z() * b.y(), a.z() * b.x() + a.x() * b.z();
  return c;
}

} // namespace lumped
