#pragma once

#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <array>
#include <cstddef>

/// The rotary inertia of a node of a finite-element model. The rotation vector of the node is
/// θ = Σ ψ_k q_k + ½ Σ ψ_kl q_k q_l, in the axes of the body, and its inertia I at rest becomes R I Rᵀ with
/// the rotation R. To the second order in the amplitudes and their rates, its kinetic energy
/// ½ (ω + Ω)·R I Rᵀ·(ω + Ω), with the angular velocity Ω = θ̇ + ½ θ × θ̇ + …, contributes to J, H_k and M_kl.
namespace kanexpr::flexible::modes {

namespace rotary_inertia {

using vector = std::array<double, 3>;
using matrix = std::array<vector, 3>; ///< rows

inline matrix skew(const vector& v) {
  return {vector{0, -v[2], v[1]}, vector{v[2], 0, -v[0]}, vector{-v[1], v[0], 0}};
}
inline matrix product(const matrix& a, const matrix& b) {
  matrix p{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) p[i][j] += a[i][k] * b[k][j];
  return p;
}
inline vector product(const matrix& a, const vector& v) {
  vector p{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) p[i] += a[i][k] * v[k];
  return p;
}
inline double dot(const vector& a, const vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// A + Aᵀ.
inline matrix with_transpose(const matrix& a) {
  matrix sum{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum[i][j] = a[i][j] + a[j][i];
  return sum;
}

} // namespace rotary_inertia

/// Adds the rotary inertia of one node to the integrals of a body. `rotation(k)` and `second_rotation(k, l)`
/// return the vectors ψ_k and ψ_kl.
template <class Rotation, class SecondRotation>
void add_rotary_inertia(mechanics::flexible_data& d, const rotary_inertia::matrix& inertia,
                        const Rotation& rotation, const SecondRotation& second_rotation) {
  using namespace rotary_inertia;
  const int n = d.amplitudes;
  const auto add_inertia = [&](const auto& entry, const matrix& m, double factor) {
    for (int e = 0; e < 6; ++e) {
      const std::size_t i = static_cast<std::size_t>(e % 3), j = e < 3 ? i : (i + 1) % 3;
      entry(e) += factor * m[i][j];
    }
  };
  add_inertia([&](int e) -> double& { return d.inertia.constant(e); }, inertia, 1);
  for (int k = 0; k < n; ++k) {
    const vector psi = rotation(k), momentum = product(inertia, psi);
    const matrix turned = product(skew(psi), inertia);
    add_inertia([&](int e) -> double& { return d.inertia.linear(k, e); }, with_transpose(turned), 1);
    for (int i = 0; i < 3; ++i) d.angular.constant(3 * k + i) += momentum[static_cast<std::size_t>(i)];
    for (int l = 0; l < n; ++l) {
      const vector other = rotation(l), second = second_rotation(k, l);
      const matrix other_turned = product(skew(other), inertia);
      const auto entry = [&](int e) -> double& { return d.inertia.quadratic(k, l, e); };
      // ½ ([ψ_k][ψ_l] + [ψ_l][ψ_k]) I − [ψ_k] I [ψ_l] + [ψ_kl] I, and the transpose
      add_inertia(entry, with_transpose(product(skew(psi), other_turned)), 0.5);
      add_inertia(entry, with_transpose(product(skew(other), turned)), 0.5);
      add_inertia(entry, with_transpose(product(turned, skew(other))), -1);
      add_inertia(entry, with_transpose(product(skew(second), inertia)), 1);
      // ψ_l × I ψ_k − ½ I (ψ_l × ψ_k) + I ψ_kl
      const vector gyration = product(other_turned, psi), shift = product(inertia, product(skew(other), psi)),
                   bend = product(inertia, second);
      for (std::size_t i = 0; i < 3; ++i)
        d.angular.linear(l, 3 * k + static_cast<int>(i)) += gyration[i] - shift[i] / 2 + bend[i];
      d.modal_mass[k * n + l] += dot(psi, product(inertia, other));
    }
  }
}

} // namespace kanexpr::flexible::modes
