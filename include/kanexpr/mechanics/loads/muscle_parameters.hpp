#pragma once

namespace kanexpr {

/// The state variable of a muscle's tendon.
enum class muscle_formulation : unsigned char {
  rigid_tendon, ///< none: the tendon has its slack length
  tendon_force, ///< the force of an elastic tendon, relative to the peak isometric force
  fiber_length, ///< the length of the fibers with an elastic tendon, relative to the optimal length
};

namespace mechanics {

/// A parameter that has no default and was not given.
struct parameter_not_given {
  constexpr bool operator==(const parameter_not_given&) const = default;
};

} // namespace mechanics

/// The parameters of a muscle, named by designated initializers: `muscle_parameters{.peak_isometric_force =
/// F, .optimal_fiber_length = 0.1, .tendon_slack_length = l}`. Each is a number, a parameter of the model or
/// an expression; the first three have no default.
template <class Force = mechanics::parameter_not_given, class Fiber = mechanics::parameter_not_given,
          class Slack = mechanics::parameter_not_given, class Velocity = double, class Angle = double,
          class Damping = double, class Tendon = double, class Passive = double, class Rise = double,
          class Fall = double>
struct muscle_parameters {
  Force peak_isometric_force{};          ///< in N
  Fiber optimal_fiber_length{};          ///< in m
  Slack tendon_slack_length{};           ///< in m
  Velocity maximal_fiber_velocity{10.0}; ///< in optimal fiber lengths per second, 1/s
  Angle pennation{0.0};                  ///< the angle at the optimal fiber length, in rad
  Damping fiber_damping{0.1};            ///< relative to peak force and maximal velocity
  Tendon tendon_strain{0.049};           ///< of the tendon at the peak isometric force
  Passive passive_strain{0.6};           ///< of the fiber at a passive force of the same size
  Rise activation_time{0.015};           ///< in s
  Fall deactivation_time{0.06};          ///< in s
  bool has_activation_dynamics = true;   ///< false: the activation is the excitation
  muscle_formulation formulation = muscle_formulation::rigid_tendon;
};

} // namespace kanexpr
