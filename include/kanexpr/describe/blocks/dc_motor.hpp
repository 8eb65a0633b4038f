#pragma once

#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/describe/joints/motor.hpp>

namespace kanexpr {

/// The current of the DC motor of a joint, the state variable i_Link2.
template <class Joint>
inline constexpr describe::state_variable_of<"i", Joint> current_of{};

/// The temperature of the winding of the DC motor of a joint above that of its surroundings, the state
/// variable heat_Link2.
template <class Joint>
inline constexpr describe::state_variable_of<"heat", Joint> heating_of{};

namespace describe {

/// R = R_0 (1 + α θ).
template <class Resistance, class Coefficient, class Heating>
constexpr auto warm_resistance(const Resistance& cold, const Coefficient& alpha, const Heating& heating) {
  return cold * (1.0 + alpha * heating);
}
/// L di/dt = V − R i − k n u.
template <class Voltage, class Resistance, class Current, class Induced>
constexpr auto inductive_voltage(const Voltage& voltage, const Resistance& resistance, const Current& current,
                                 const Induced& induced) {
  const auto dropped = resistance * current;
  return voltage - dropped - induced;
}
/// C dθ/dt = R i² − θ/R_th.
template <class Resistance, class Current, class Heating, class Thermal>
constexpr auto heat_flow(const Resistance& resistance, const Current& current, const Heating& heating,
                         const Thermal& thermal_resistance) {
  const auto lost = resistance * current * current;
  const auto conducted = heating / thermal_resistance;
  return lost - conducted;
}

/// A permanent-magnet DC motor with the current i, whose rotor turns n times as fast as the joint:
///
///     L di/dt = V − R i − k n u,   torque n k i − n² (b u + J du/dt),
///     C dθ/dt = R i² − θ/R_th,     R = R_0 (1 + α θ)
///
/// Franklin, Powell & Emami-Naeini, Feedback Control of Dynamic Systems (2019), section 2.3; Hughes & Drury,
/// Electric Motors and Drives (2019), section 3.8.
template <class Joint, auto... given>
struct dc_motor_law {
  template <std::size_t index>
  static constexpr auto argument = argument_or_zero<index, given...>();

  static constexpr std::size_t size = sizeof...(given);
  static constexpr bool is_heated = size > 7, has_axis = effort_of_joint<Joint>() != joint_effort::none;
  static constexpr auto i = current_of<Joint>;
  static constexpr auto heat = heating_of<Joint>;

  static constexpr auto ratio() {
    if constexpr (size > 4)
      return argument<4>;
    else
      return describe::constant(1.0);
  }
  static constexpr auto resistance() {
    if constexpr (is_heated)
      return warm_resistance(argument<1>, argument<7>, heat);
    else
      return argument<1>;
  }
  static constexpr auto voltage_of_rotor() {
    if constexpr (has_axis)
      return argument<3> * (ratio() * Joint::template u<0>);
    else
      return argument<3>;
  }
  static constexpr auto torque() {
    if constexpr (size > 5 && has_axis)
      return ratio() * argument<3> * i - ratio() * ratio() * argument<5> * Joint::template u<0>;
    else
      return ratio() * argument<3> * i;
  }
  static constexpr auto electrical =
      argument<2> * dot(i) == inductive_voltage(argument<0>, resistance(), i, voltage_of_rotor());
  static constexpr auto thermal = argument<8> * dot(heat) == heat_flow(resistance(), i, heat, argument<9>);

  static constexpr auto inertia = argument<6>;
  static constexpr auto gear = ratio();

  static constexpr void add_rotor(load_record& r) {
    if constexpr (size > 6) {
      r.joint = &joint_of<Joint>;
      r.rotor = given_phrases<inertia, gear>;
    }
  }
  template <std::size_t index, text name>
  static constexpr const positive_argument* positive = &positive_of<name, argument<index>>;

  static constexpr void add_states(load_record& r) {
    if constexpr (is_heated) {
      r.states = list_of<phrase, &phrase_of<i>, &phrase_of<heat>>::all;
      r.dynamics = list_of<phrase, &phrase_of<electrical>, &phrase_of<thermal>>::all;
      r.positive =
          list_of<positive_argument, positive<1, "the resistance of ">, positive<2, "the inductance of ">,
                  positive<8, "the heat capacity of ">, positive<9, "the thermal resistance of ">>::all;
    } else {
      r.states = list_of<phrase, &phrase_of<i>>::all;
      r.dynamics = list_of<phrase, &phrase_of<electrical>>::all;
      r.positive = list_of<positive_argument, positive<1, "the resistance of ">,
                           positive<2, "the inductance of ">>::all;
    }
  }
};

} // namespace describe

/// A DC motor in a joint with one axis, between the child and the parent: `dc_motor<Link2, V, R, L, k, n, b,
/// J>` with the voltage, resistance, inductance, torque constant, the gear ratio n (turns of the rotor per
/// turn of the joint, by default 1), the viscous friction of the rotor and its inertia (by default none). Its
/// current is `current_of<Link2>`. The inertia n² J acts on the joint's coordinate, as that of `rotor<J, n>`.
/// Three further arguments, α, C and R_th, let the resistance R (1 + α θ) grow with the heating θ of the
/// winding, `heating_of<Link2>`, with the heat capacity C and the thermal resistance R_th.
template <class Joint, auto... voltage_and_constants>
struct dc_motor : describe::load_words {
  static constexpr describe::load_record load = [] {
    using law = describe::dc_motor_law<Joint, voltage_and_constants...>;
    describe::load_record r = describe::load_along_axis<dc_motor, Joint, law::torque()>("the DC motor");
    constexpr std::size_t given = sizeof...(voltage_and_constants);
    r.fits = given <= 7
                 ? describe::arguments_of("dc_motor<Joint, V, R, L, k, n, b, J>", given, 4, 7)
                 : describe::arguments_of("dc_motor<Joint, V, R, L, k, n, b, J, alpha, C, Rth>", given, 10);
    if (r.fits && law::has_axis) law::add_states(r), law::add_rotor(r);
    return r;
  }();
};

} // namespace kanexpr
