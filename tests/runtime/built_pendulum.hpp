#pragma once

#include <kanexpr/runtime/builder.hpp>

/// A bob on a rod that rotates about a fixed point; x points down. A motor may drive the rod.
struct built_pendulum : kanexpr::runtime::builder {
  using expression = kanexpr::symbolic::expression;
  expression q = coordinate("q"), u = speed("u"), m = parameter("m"), l = parameter("l"), g = parameter("g"),
             motor = input("T");
  kanexpr::runtime::frame_id n = inertial_frame(), rod{};

  built_pendulum() : builder("N") {
    kinematic_equation(dot(q) - u);
    rod = rotated("A", n, q, along(n, 0, 0, 1));
    const auto o = origin("O");
    particle("Bob", offset("P", o, along(rod, l, 0, 0)), m);
    gravity(along(n, g, 0, 0));
  }
};
