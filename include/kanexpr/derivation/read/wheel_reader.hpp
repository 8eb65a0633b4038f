#pragma once

#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/describe/wheel_record.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads wheels and the ground below them.
class wheel_reader : part_reader {
public:
  using part_reader::part_reader;

  /// `whom` names the load, as in "the tyre between Front and O".
  constexpr mechanics::wheel_on_ground read(const describe::wheel_record& r, std::string_view whom) {
    mechanics::wheel_on_ground w;
    if (!r.mistake.empty()) {
      reading_.fail({whom, " ", r.mistake});
      return w;
    }
    w.rim = r.rim, w.ground = r.ground, w.steps = r.steps;
    w.point = entities_.point(r.center, whom);
    w.against = entities_.point(r.place, whom);
    w.frame = entities_.frame(r.frame, whom);
    w.axis = direction(r.axis, "the axis of ", whom, w.axis_frame);
    w.radius = scalar(r.radius, "the radius of ", whom);
    w.tube = scalar(r.tube, "the radius of the tube of ", whom);
    w.conicity = scalar(r.conicity, "the conicity of ", whom);
    w.head = scalar(r.head, "the radius of the head of the rail of ", whom);
    read_ground(w, r, whom);
    return w;
  }

private:
  constexpr expression scalar(const phrase& p, std::string_view what, std::string_view whom) {
    return p.tokens == nullptr ? expression{} : phrases_.scalar_of(p, {what, whom}, whom);
  }

  constexpr void read_ground(mechanics::wheel_on_ground& w, const describe::wheel_record& r,
                             std::string_view whom) {
    using enum mechanics::ground_shape;
    if (r.ground == uneven) {
      w.other = entities_.frame(r.ground_frame, whom);
      reading_.is_on_surface = true;
      w.height = scalar(r.height, "the height of the ground of ", whom);
      reading_.is_on_surface = false;
      return;
    }
    w.normal =
        direction(r.normal, r.ground == rail ? "the direction up of " : "the normal of ", whom, w.other);
    if (r.ground != rail) return;
    int frame = none;
    w.along = direction(r.along, "the direction of the rail of ", whom, frame);
    if (frame != w.other)
      reading_.fail({"the rail of ", whom,
                     " has directions in the axes of two frames; write both in the axes "
                     "of one"});
  }

  /// Reads a vector in the axes of one frame, and its unit vector.
  constexpr mechanics::components direction(const phrase& p, std::string_view what, std::string_view whom,
                                            int& frame) {
    const mechanics::vector v = phrases_.vector_of(p, {what, whom}, whom);
    if (reading_.mistake) return mechanics::components(*m_.g);
    const mechanics::contact_direction d = mechanics::contact_direction_of(m_, v);
    if (!d.mistake.empty()) reading_.fail({what, whom, d.mistake});
    frame = d.frame;
    return d.unit;
  }
};

} // namespace kanexpr::derivation
