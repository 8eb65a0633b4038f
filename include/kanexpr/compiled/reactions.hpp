#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/callable.hpp>
#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/describe/extended.hpp>
#include <kanexpr/describe/joints/reactions.hpp>

#include <Eigen/Core>

namespace kanexpr {

/// The load that a joint transmits: the force on the child at the joint and the torque on the child, from the
/// parent, in the axes of the child. A joint transmits nothing along its free directions; motors and friction
/// are modeled as loads.
template <class Scalar>
struct joint_reactions {
  Eigen::Matrix<Scalar, 3, 1> force{};
  Eigen::Matrix<Scalar, 3, 1> torque{};
  kanexpr::status status{};
};

namespace compiled {

/// A system extended by the auxiliary speeds of one joint, which come last.
template <class System, class Joint>
struct with_reaction_speeds : extended<System, reactions<Joint>> {};

template <class System, class Joint>
struct reactions_function : callable<reactions_function<System, Joint>> {
  /// Called like the other results of the system, with the time first if the reactions depend on it.
  template <class... Arguments>
  static auto called(const Arguments&... arguments) noexcept {
    const auto all =
        equations_of_motion<with_reaction_speeds<System, Joint>>::noncontributing_forces(plain(arguments)...);
    using results = decltype(all);
    joint_reactions<typename results::Scalar> found;
    if constexpr (results::RowsAtCompileTime >= 6) { // otherwise the system has a mistake
      found.force = all.template tail<6>().template head<3>();
      found.torque = all.template tail<3>();
      found.status = status_of(all);
    }
    return found;
  }

private:
  /// Converts an argument to a plain Eigen vector, which does not belong to a system.
  template <class Argument>
  static decltype(auto) plain(const Argument& argument) noexcept {
    if constexpr (requires { argument.RowsAtCompileTime; })
      return argument.template head<Argument::RowsAtCompileTime>();
    else
      return (argument);
  }
};

} // namespace compiled

/// Returns the force and the torque that a joint of a system transmits: `reactions_of<System, Link2>(x, p,
/// r)`.
template <class System, class Joint>
inline constexpr compiled::reactions_function<System, Joint> reactions_of{};

} // namespace kanexpr
