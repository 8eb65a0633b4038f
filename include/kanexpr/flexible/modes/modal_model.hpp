#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr::flexible::modes {

/// A finite-element model in terms of some of its modes, in SI units and in the axes of the body. The index
/// of a node is its place in the list of positions.
struct modal_model {
  using vectors = std::vector<double>; ///< three components for each node
  using matrix = std::vector<double>;  ///< an entry for each pair of amplitudes, row by row
  using tensor = std::array<std::array<double, 3>, 3>;

  /// An entry of the mass matrix, which is the same in all three directions.
  struct mass_entry {
    std::size_t row = 0, column = 0;
    double mass = 0;
  };
  /// A node that becomes a node of the body.
  struct attachment {
    std::string called{};
    std::size_t node = 0;
  };

  int amplitudes = 0;
  vectors positions{};
  std::vector<mass_entry> masses{};
  std::vector<vectors> shapes{};    ///< by amplitude: the displacements
  std::vector<vectors> rotations{}; ///< by amplitude: the rotation vectors; empty: the nodes do not rotate
  std::vector<vectors> bends{};     ///< by pair of amplitudes: ∂²r/∂q_k∂q_l; empty: zero
  std::vector<vectors> rotation_bends{}; ///< the second derivatives of the rotation vectors; empty: zero
  std::vector<tensor> inertias{};        ///< by node: about the node, in the axes of the body; empty: zero
  std::vector<attachment> attachments{};
  matrix modal_mass{}; ///< empty: that of the shapes
  matrix stiffness{}, damping{};
  /// The stiffness against deformation that the inertia forces of these motions cause: of a unit acceleration
  /// along each axis, of a unit angular acceleration about each axis, and of ωx², ωy², ωz², ωx ωy, ωy ωz and
  /// ωz ωx. Empty: none.
  std::vector<matrix> by_acceleration{}, by_angular_acceleration{}, by_rotation{};

  std::size_t count() const { return static_cast<std::size_t>(amplitudes); }
};

} // namespace kanexpr::flexible::modes
