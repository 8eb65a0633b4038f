#pragma once

#include <kanexpr/runtime/builder.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace mechanisms {

using kanexpr::wrapping;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::pathway;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;

// Two bodies in a chain, with a mast that is fixed to the first one and a ring that moves on the mast.
struct arm : builder {
  std::vector<expression> q, u;
  frame_id n = inertial_frame(), a, b;
  point_id o, mast, hand, eye, wall, on_mast, ring;

  explicit arm(bool by_lagrange = false) : builder("N") {
    for (int i = 0; i < 4; ++i) q.push_back(coordinate("q" + std::to_string(i)));
    if (by_lagrange) rates_as_speeds();
    for (int i = 0; i < 4 && !by_lagrange; ++i) u.push_back(speed("u" + std::to_string(i)));
    if (!by_lagrange) {
      kinematic_equation(dot(q[0]) - u[0]);
      kinematic_equation(dot(q[1]) - (u[1] - 0.5 * u[0]));
      kinematic_equation(dot(q[2]) - u[2]);
      kinematic_equation(dot(q[3]) - u[3]);
    }
    o = origin("O");
    wall = offset("W", o, along(n, 1.3, 0.4, 0.2));
    a = body_fixed("A", n, "zyx", q[0], q[1], number(0.2));
    mast = offset("M", o, along(a, 0.1, 0.3, 0.2));
    eye = offset("E", mast, along(a, 0.4, -0.3, 0.5));
    on_mast = offset("S", mast, along(a, 0.25 * std::cos(0.6), 0.25 * std::sin(0.6), 0.15));
    ring = offset("R", mast, along(a, 0.25 * cos(q[2]), 0.25 * sin(q[2]), 0.4 + q[3]));
    b = rotated("B", a, q[2], along(a, 1, 2, 2));
    hand = offset("H", mast, along(a, -0.9, 0.2, 0.1) + along(b, q[3], -0.5, 0.2));
    rigid_body("first", eye, a, number(1.2), inertia(a, 0.2, 0.3, 0.4));
    rigid_body("second", hand, b, number(0.7), inertia(b, 0.1, 0.2, 0.15));
  }

  std::vector<std::pair<std::string, pathway>> pathways() {
    const auto axis = along(a, 0.0, 0.0, 1.0);
    const expression r = number(0.25);
    return {{"straight", straight(hand, wall)},
            {"through", through({hand, eye, mast, wall})},
            {"given", given_length(0.3 * q[0] - 0.2 * q[2] * q[3])},
            {"cylinder ccw", around_cylinder(a, mast, axis, r, hand, wall, wrapping::counterclockwise)},
            {"cylinder cw", around_cylinder(a, mast, along(a, 1, 2, 3), r, hand, wall, wrapping::clockwise)},
            {"cylinder from its surface",
             around_cylinder(a, mast, axis, r, on_surface(on_mast), wall, wrapping::clockwise)},
            {"cylinder on its surface", around_cylinder(a, mast, axis, r, on_surface(on_mast),
                                                        on_surface(ring), wrapping::counterclockwise)},
            {"sphere", around_sphere(mast, r, hand, wall)},
            {"sphere at the end", around_sphere(mast, r, hand, eye)},
            {"cone ccw", around_cone(a, mast, along(a, 0.5, 0.2, -1.0), number(0.35), hand, wall,
                                     wrapping::counterclockwise)},
            {"cone cw",
             around_cone(a, mast, along(a, -1.0, 0.3, 0.2), number(0.4), hand, wall, wrapping::clockwise)}};
  }
};

} // namespace mechanisms
