#pragma once

#include <kanexpr/robots/pose.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A robot as a plain value: links and the joints between them, as files describe them, in SI units.
namespace kanexpr::robots {

/// Returns text from a file for use in a message: truncated and without control characters.
inline std::string printable(std::string_view text, std::size_t most = 60) {
  std::string plain;
  for (char c : text.substr(0, most)) plain += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return text.size() > most ? plain + "..." : plain;
}

/// The symmetric inertia matrix about the mass center; xy is the matrix entry −∫ x y dm.
struct inertia_matrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  /// The largest absolute value of an entry.
  double largest() const {
    return (std::max)({std::abs(xx), std::abs(yy), std::abs(zz), std::abs(xy), std::abs(yz), std::abs(zx)});
  }
  /// The sum of the entries; finite only if all of them are.
  double sum() const { return xx + yy + zz + xy + yz + zx; }
};

struct inertial {
  double mass = 0;
  pose center{}; ///< the mass center and the axes of the inertia, in the axes of the link
  inertia_matrix inertia{};
};

enum class shape_kind : unsigned char { box, cylinder, sphere, capsule, mesh };

/// A visual or collision shape of a link.
struct shape {
  shape_kind kind = shape_kind::box;
  pose origin{};  ///< in the axes of the link
  vector3 size{}; ///< edge lengths of a box; radius and length of a cylinder or capsule along z; radius of a
                  ///< sphere; scale of a mesh
  std::string file{}; ///< name of the mesh file, as written
};

struct link {
  std::string name{};
  std::optional<robots::inertial> inertial{};
  std::vector<shape> visual{}, collision{};
  bool weightless = false; ///< gravity does not act on the link
};

enum class joint_kind : unsigned char {
  fixed,
  revolute,
  continuous, ///< revolute without limits
  prismatic,
  planar,   ///< two translations in the plane normal to the axis, and a rotation about it
  floating, ///< all six degrees of freedom
};

/// Whether the joint has exactly one coordinate.
constexpr bool has_one_coordinate(joint_kind k) {
  return k == joint_kind::revolute || k == joint_kind::continuous || k == joint_kind::prismatic;
}

/// Whether the joint has an axis about, along or normal to which it moves.
constexpr bool has_axis(joint_kind k) { return k != joint_kind::fixed && k != joint_kind::floating; }

struct joint_limits {
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity(), velocity = std::numeric_limits<double>::infinity();
};

/// The rule by which a joint mimics another: q = multiplier · q_leader + offset.
struct mimic_rule {
  int leader = -1; ///< index of the joint
  double multiplier = 1, offset = 0;
};

struct joint {
  std::string name{};
  joint_kind kind = joint_kind::fixed;
  int parent = -1, child = -1; ///< indices of links
  pose origin{};               ///< pose of the child at q = 0, in the axes of the parent
  vector3 axis{1, 0, 0};       ///< unit vector in the axes of the child
  joint_limits limits{};
  double damping = 0;  ///< the torque or force −damping·q̇
  double friction = 0; ///< the torque or force −friction·sign(q̇)
  std::optional<mimic_rule> mimic{};
  double gear_ratio = 1;    ///< turns of the rotor per turn of the joint
  double rotor_inertia = 0; ///< about the axis of the rotor

  /// The inertia n² J of the rotor, reflected to the joint.
  double reflected_inertia() const { return gear_ratio * gear_ratio * rotor_inertia; }
};

/// A robot. Its links form a tree: every link except `root` is the child of one joint.
struct robot {
  std::string name{};
  std::vector<link> links{};
  std::vector<joint> joints{};
  int root = -1;
  std::optional<vector3> gravity{}; ///< gravitational acceleration, in the axes of the root
};

} // namespace kanexpr::robots
