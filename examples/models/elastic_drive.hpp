#pragma once

#include <kanexpr/blocks.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

/// A DC motor that turns a disk through an elastic shaft. A PI controller of the disk's speed, whose output
/// is limited, sets the voltage. Its integral part and the current of the motor are states of the system.
namespace elastic_drive {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"J1", kilogram * pow<2>(meter)> J1; // of the rotor
constexpr parameter<"J2", kilogram * pow<2>(meter)> J2; // of the disk
constexpr parameter<"k", newton * meter / radian> k;    // of the shaft
constexpr parameter<"c", newton * meter * second / radian> c;
constexpr parameter<"R", ohm> R;
constexpr parameter<"L", henry> L;
constexpr parameter<"kt", newton * meter / ampere> kt; // torque per current, and voltage per angular velocity
constexpr parameter<"kp", volt * second / radian> kp;
constexpr parameter<"ki", volt / radian> ki;
constexpr parameter<"V", volt> V; // the limit of the voltage
constexpr parameter<"Tt", second> Tt;
constexpr input<"r", radian / second> reference;
constexpr input<"T", newton * meter> T; // a torque that brakes the disk

struct Ground : inertial_ground<Ground> {};
struct Rotor : pin<Rotor, Ground, axis<Ground::x>, body<0.4, 0.0 * own::x, inertia<own, J1, J1, J1>>> {};
struct Disk : pin<Disk, Ground, axis<Ground::x>, at<0.3 * Ground::x>,
                  body<0.6, 0.0 * own::x, inertia<own, J2, J2 / 2, J2 / 2>>> {};
struct Controller : pid<Controller, reference - u_of<Disk>, kp, ki, -V, V, Tt> {};

struct System
    : kane_system<inertial<Ground>, joints<Rotor, Disk>, blocks<Controller>,
                  parameters<J1, J2, k, c, R, L, kt, kp, ki, V, Tt>, inputs<reference, T>,
                  loads<dc_motor<Rotor, Controller::output, R, L, kt>, torque<Disk, -T * Ground::x>,
                        torsional_spring<q_of<Disk> - q_of<Rotor>, k>, torsional_damper<Disk, Rotor, c>>> {};

} // namespace elastic_drive
