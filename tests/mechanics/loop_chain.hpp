// A chain of four-bar loops, built at run time: each is attached to the rocker of the previous one.
#pragma once

#include <kanexpr/runtime/builder.hpp>

#include <string>

class loop_chain : public kanexpr::runtime::builder {
public:
  using expression = kanexpr::symbolic::expression;
  using frame_id = kanexpr::runtime::frame_id;
  using point_id = kanexpr::runtime::point_id;

  explicit loop_chain(int loops) : builder("N") {
    frame_id base = inertial_frame();
    point_id at = origin("O");
    for (int i = 0; i < loops; ++i) {
      const std::string k = std::to_string(i);
      const expression crank = angle("crank" + k), coupler = angle("coupler" + k),
                       rocker = angle("rocker" + k);
      const frame_id a = turned("A" + k, base, crank), b = turned("B" + k, a, coupler),
                     c = turned("C" + k, base, rocker);
      const expression ground = length("g" + k), la = length("a" + k), lb = length("b" + k),
                       lc = length("c" + k);
      const point_id bearing = offset("Bearing" + k, at, along(base, ground, zero(), zero()));
      const point_id joint = bar("a" + k, at, a, la);
      bar("b" + k, joint, b, lb);
      bar("c" + k, bearing, c, lc);
      // the end of the coupler coincides with that of the rocker, in the axes of the body that carries the
      // loop
      configuration_constraint(la * cos(crank) + lb * cos(crank + coupler) - ground - lc * cos(rocker));
      configuration_constraint(la * sin(crank) + lb * sin(crank + coupler) - lc * sin(rocker));
      base = c;
      at = bearing;
    }
    gravity(along(inertial_frame(), 0, -9.81, 0));
  }

private:
  expression zero() { return number(0.0); }
  expression length(const std::string& called) { return parameter("l" + called); }
  expression angle(const std::string& called) {
    const expression q = coordinate(called);
    kinematic_equation(dot(q) - speed("u" + called));
    return q;
  }
  frame_id turned(const std::string& called, frame_id parent, expression by) {
    return rotated(called, parent, by, along(parent, 0, 0, 1));
  }
  // A bar with a given mass center; returns its other end.
  point_id bar(const std::string& called, point_id from, frame_id frame, expression reach) {
    const point_id center =
        offset("G" + called, from, along(frame, parameter("x" + called), parameter("y" + called), zero()));
    rigid_body("Bar" + called, center, frame, parameter("m" + called),
               inertia(frame, zero(), zero(), parameter("I" + called)));
    return offset("P" + called, from, along(frame, reach, zero(), zero()));
  }
};
