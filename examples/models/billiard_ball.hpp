#pragma once

#include <kanexpr/contact.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

/// A billiard ball on its table, with Coulomb friction between them.
namespace billiard_ball {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"m", kilogram> m;
constexpr parameter<"r", meter> r;
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr parameter<"mu", dimensionless> mu;           // friction
constexpr parameter<"s", meter / second> s;            // slip speed over which sticking is smoothed
constexpr parameter<"k", newton / pow<3, 2>(meter)> k; // stiffness
constexpr parameter<"d", meter> d;                     // the distance over which the contact closes

constexpr auto I = 0.4 * m * r * r;
struct Table : inertial_ground<Table> {}; // z points up
struct Ball : floating<Ball, Table, body<m, 0.0 * own::x, inertia<own, I, I, I>>> {};

using Cloth = contact<sphere_on_plane<Ball, r, Table, Table::z>, elastic<k, 1.5>, smoothed_over<d>,
                      coulomb_friction<mu, s>>;

struct System : kane_system<inertial<Table>, joints<Ball>, parameters<m, r, g, mu, s, k, d>,
                            loads<gravity<-g * Table::z>, Cloth>> {};

/// The velocity of the point of the ball that touches the table.
constexpr auto slip = velocity_of<Ball> - cross(angular_velocity_of<Ball>, r* Table::z);

} // namespace billiard_ball
