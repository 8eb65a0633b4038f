#pragma once

#include <kanexpr/blocks.hpp>
#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

/// An arm with two links, on which most kinds of loads act: a motor with a current, bristles, stops, cables
/// around a cylinder and through an eye, a bushing and a contact.
namespace loaded_arm {

using namespace kanexpr;

constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr parameter<"mu"> mu;
constexpr input<"V"> V;

struct Ground : inertial_ground<Ground> {};
struct Upper : pin<Upper, Ground, axis<Ground::z>, stops<-0.8, 0.9, 40, 0.3, 0.2>, rotor<0.01, 5>,
                   body<1.2, 0.4 * own::x, inertia<own, 0.1, 0.2, 0.3>>> {};
struct Fore : pin<Fore, Upper, axis<Upper::z>, at<0.8 * Upper::x>,
                  body<0.7, 0.3 * own::x, inertia<own, 0.1, 0.1, 0.15>>> {};
struct Tip : offset<Tip, Fore, 0.6 * Fore::x> {};
struct Corner : offset<Corner, Ground, -0.9 * Ground::x + 1.1 * Ground::y> {};
struct Pulley : offset<Pulley, Ground, 0.3 * Ground::y> {};

using Cable = around_cylinder<Ground, Pulley, Ground::z, 0.1, Corner, Tip, wrapping::clockwise>;
using Rope = through<Corner, Fore, Tip>;
using Floor =
    contact<sphere_on_plane<Tip, 0.1, Ground, Ground::y, Fore>, elastic<300, 1.5>, smoothed_over<0.05>,
            restitution<0.6, 1>, stribeck_friction<0.6, mu, 0.1, 0.01>, rolling_resistance<0.01, 0.1>>;

struct System
    : kane_system<inertial<Ground>, joints<Upper, Fore>, parameters<k, c, mu>, inputs<V>,
                  loads<gravity<-9.81 * Ground::y>, dc_motor<Upper, V, 2, 0.3, 0.2, 5, 0.01>,
                        friction<Fore, 2, lugre_friction<0.6, 0.4, 0.5, 3, 0.5, 0.02, 0.1>>,
                        linear_spring<Cable, k, 0.9>, linear_damper<Rope, c>, cubic_spring<Fore, k, 2, 0.1>,
                        stop<straight<Tip, Corner>, 0.9, 1.8, 50, 0.4>,
                        friction<straight<Tip, Corner>, 3, coulomb_friction<mu, 0.2>>,
                        bushing<Fore, Ground, 1, 2, 3, 1, 2, 3, 0.1, 0.2, 0.3, 0.1, 0.2, 0.3>, Floor>> {};

} // namespace loaded_arm
