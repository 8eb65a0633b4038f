#pragma once

#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/units/si.hpp>

/// A pendulum that hangs from a cart on a spring. It states the units of an angle and of a mass, from which
/// most others follow.
struct cart_with_units : kanexpr::runtime::builder {
  using expression = kanexpr::symbolic::expression;
  expression s = coordinate("s"), q = coordinate("q", kanexpr::units::si::radian), v = speed("v"),
             u = speed("u"), m = parameter("m", kanexpr::units::si::kilogram), l = parameter("l"),
             g = parameter("g"), k = parameter("k"), c = parameter("c"), w = parameter("w"),
             force_on_cart = input("F");
  kanexpr::runtime::frame_id n = inertial_frame(), rod{};
  kanexpr::runtime::point_id bob{};

  cart_with_units() : builder("N") {
    kinematic_equation(dot(s) - v);
    kinematic_equation(dot(q) - u);
    rod = rotated("A", n, q, along(n, 0, 0, 1));
    const auto cart = offset("C", origin("O"), along(n, 0, s, 0));
    particle("Cart", cart, 2 * m);
    bob = offset("P", cart, along(rod, l, 0, 0));
    particle("Bob", bob, m);
    gravity(along(n, g, 0, 0));
    kanexpr::runtime::builder::force(cart, along(n, 0, force_on_cart - k * s, 0));
    torque(rod, along(n, 0, 0, -c * u));
    used_elsewhere(w);
  }
};
