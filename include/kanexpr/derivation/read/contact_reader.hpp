#pragma once

#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/mechanics/loads/contact.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/loads/contact_law.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/restitution.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads contacts and laws of friction.
class contact_reader : part_reader {
public:
  using part_reader::part_reader;

  /// `default_slip_speed` is used if the law omits it; if it is not given either, that is a mistake. The
  /// state variables are those of bristles.
  constexpr mechanics::friction_law law_of(const describe::friction_record& r,
                                           const describe::listing<phrase>& states,
                                           expression default_slip_speed, std::string_view whom) {
    const auto part = [&](const phrase& p, std::string_view what) {
      return p.tokens == nullptr ? expression{} : phrases_.scalar_of(p, {what, whom}, whom);
    };
    mechanics::friction_law law{r.kind,
                                part(r.sliding, "the coefficient of friction of "),
                                part(r.sticking, "the coefficient of static friction of "),
                                part(r.slip_speed, "the slip speed of "),
                                part(r.viscous, "the viscous coefficient of "),
                                {part(r.stiffness, "the stiffness of the bristles of "),
                                 part(r.damping, "the damping of the bristles of "),
                                 part(r.stribeck_speed, "the Stribeck speed of "),
                                 {}}};
    if (reading_.mistake) return law;
    for (const phrase& z : states) law.bristles.deflections.push(phrases_.scalar_of(z, {"", whom}, whom));
    law.take_slip_speed(default_slip_speed);
    if (law.needs_slip_speed())
      reading_.fail(
          {whom, " has ", law.has_bristles() ? "dahl" : "coulomb",
           "_friction<...> without a slip speed; only a contact with restitution<...> has a default"});
    return law;
  }

  constexpr mechanics::contact read(const describe::contact_record& r,
                                    const describe::listing<phrase>& states, std::string_view whom) {
    mechanics::contact c;
    lay_out(c.between, r, whom);
    c.law.stiffness = scalar(r.stiffness, "the stiffness of ", whom);
    c.law.exponent = exponent_of(r.exponent, whom);
    c.law.width = scalar(r.width, "the width of ", whom);
    expression slip{};
    if (r.approach_speed.tokens != nullptr) {
      const expression approach = scalar(r.approach_speed, "the approach speed of ", whom);
      if (reading_.mistake) return c;
      if (approach.is_constant() && !(approach.owner().number_at(approach.node()).value() > 0))
        reading_.fail({"the approach speed of ", whom, " is not positive"});
      if (reading_.mistake) return c;
      const double damping = mechanics::damping_of_restitution(r.restitution);
      if (r.restitution < 1) c.law.damping = approach.number(symbolic::real(damping)) / approach;
      slip = approach / 100;
    }
    if (r.damping.tokens != nullptr) c.law.damping = scalar(r.damping, "the damping of ", whom);
    if (r.friction != nullptr && !reading_.mistake) c.friction = law_of(*r.friction, states, slip, whom);
    if (r.lever.tokens != nullptr) {
      c.rolling.lever = scalar(r.lever, "the lever of the rolling resistance of ", whom);
      c.rolling.angular_velocity =
          scalar(r.rolling_rate, "the angular velocity of the rolling resistance of ", whom);
    }
    if (r.spinning_lever.tokens != nullptr) {
      c.spinning.lever = scalar(r.spinning_lever, "the lever of the spinning resistance of ", whom);
      c.spinning.angular_velocity =
          scalar(r.spinning_rate, "the angular velocity of the spinning resistance of ", whom);
    }
    if (r.direction.tokens != nullptr) {
      c.direction.unit = direction(r.direction, "the direction of the friction of ", whom, c.direction.frame);
      c.direction.ratio = scalar(r.ratio, "the ratio of the directional friction of ", whom);
    }
    if (!reading_.mistake && c.rolling && c.between.frame == none)
      reading_.fail({whom, " has rolling_resistance<...>, but a point does not roll"});
    if (!reading_.mistake && c.spinning && c.between.frame == none)
      reading_.fail({whom, " has spinning_resistance<...>, but a point does not turn"});
    return c;
  }

private:
  constexpr expression scalar(const phrase& p, std::string_view what, std::string_view whom) {
    return phrases_.scalar_of(p, {what, whom}, whom);
  }

  constexpr void lay_out(mechanics::contact_geometry& g, const describe::contact_record& r,
                         std::string_view whom) {
    g.shapes = r.shapes;
    g.point = entities_.point(r.point, whom);
    g.against = entities_.point(r.other_point, whom);
    if (r.frame != nullptr) g.frame = entities_.frame(r.frame, whom);
    if (r.other_frame != nullptr) g.other = entities_.frame(r.other_frame, whom);
    if (r.normal.tokens != nullptr) g.normal = direction(r.normal, "the normal of ", whom, g.other);
    int frame_of_axis = g.frame;
    if (r.axis.tokens != nullptr) g.axis = direction(r.axis, "the axis of ", whom, frame_of_axis);
    g.axis_frame = frame_of_axis;
    if (r.level.tokens != nullptr) {
      reading_.is_on_surface = true;
      g.level = scalar(r.level, "the surface of ", whom);
      reading_.is_on_surface = false;
    }
    g.radius = scalar(r.radius, "the radius of ", whom);
    if (r.other_radius.tokens != nullptr)
      g.other_radius = scalar(r.other_radius, "the second radius of ", whom);
  }

  /// Reads a vector in the axes of one frame, and its unit vector.
  constexpr mechanics::components direction(const phrase& p, std::string_view what, std::string_view whom,
                                            int& frame) {
    const mechanics::vector v = phrases_.vector_of(p, {what, whom}, whom);
    if (reading_.mistake) return mechanics::components(*m_.g);
    mechanics::contact_direction d = mechanics::contact_direction_of(m_, v);
    if (!d.mistake.empty()) reading_.fail({what, whom, d.mistake});
    frame = d.frame;
    return d.unit;
  }

  constexpr expression exponent_of(const phrase& p, std::string_view whom) {
    const expression n = scalar(p, "the exponent of ", whom);
    if (reading_.mistake) return n;
    const expression exact = mechanics::contact_exponent(n);
    if (!exact.is_given()) reading_.fail({"the exponent of ", whom, " is not a number from 1 to 30"});
    return exact;
  }
};

} // namespace kanexpr::derivation
