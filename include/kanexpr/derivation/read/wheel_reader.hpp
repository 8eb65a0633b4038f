#pragma once

#include <kanexpr/derivation/read/direction_reader.hpp>
#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/describe/wheel_record.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads wheels and the ground below them.
class wheel_reader : load_parts {
public:
  constexpr explicit wheel_reader(const load_parts& by) : load_parts(by) {}

  constexpr mechanics::wheel_on_ground read(const describe::wheel_record& r) {
    mechanics::wheel_on_ground w;
    if (!r.mistake.empty()) {
      reading_.fail({whom, " ", r.mistake});
      return w;
    }
    w.rim = r.rim, w.ground = r.ground, w.steps = r.steps;
    w.point = entities_.point(r.center, whom);
    w.against = entities_.point(r.place, whom);
    w.frame = entities_.frame(r.frame, whom);
    w.axis = read_direction(*this, r.axis, "the axis of ", w.axis_frame);
    w.radius = given(r.radius, "the radius of ");
    w.tube = given(r.tube, "the radius of the tube of ");
    w.conicity = given(r.conicity, "the conicity of ");
    w.head = given(r.head, "the radius of the head of the rail of ");
    read_ground(w, r);
    return w;
  }

private:
  constexpr expression given(const phrase& p, std::string_view what) {
    return p.tokens == nullptr ? expression{} : scalar(p, what);
  }

  constexpr void read_ground(mechanics::wheel_on_ground& w, const describe::wheel_record& r) {
    using enum mechanics::ground_shape;
    if (r.ground == uneven) {
      w.other = entities_.frame(r.ground_frame, whom);
      reading_.is_on_surface = true;
      w.height = given(r.height, "the height of the ground of ");
      reading_.is_on_surface = false;
      return;
    }
    w.normal = read_direction(*this, r.normal, r.ground == rail ? "the direction up of " : "the normal of ",
                              w.other);
    if (r.ground != rail) return;
    int frame = none;
    w.along = read_direction(*this, r.along, "the direction of the rail of ", frame);
    if (frame != w.other)
      reading_.fail({"the rail of ", whom,
                     " has directions in the axes of two frames; write both in the axes "
                     "of one"});
  }
};

} // namespace kanexpr::derivation
