// The table of all force elements. A new element is one more row.
#pragma once

#include "arm.hpp"
#include "element.hpp"

#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>

#include <cmath>

namespace elements {

namespace mechanics = kanexpr::mechanics;
using kanexpr::derive;
using kanexpr::runtime::builder;
using kanexpr::runtime::contact_data;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::pathway;
using kanexpr::runtime::point_id;
using mechanics::components;
using mechanics::friction_law;

// ---- laws, written out in numbers

inline double one_sided(double x, double width) {
  const double t = x / width;
  return t <= 0 ? 0 : t < 1 ? width * t * t * t * (1 - t / 2) : x - width / 2;
}
inline double hunt_and_crossley(double c, double rate) { return one_sided(1.25 + c * rate, 0.5); }
inline double coulomb(double v) { return 0.4 * v / std::sqrt(v * v + 0.01); }
inline double stribeck(double v) {
  const double r = v / 0.1, width = r * r / 4 + 0.75;
  return 0.4 * std::tanh(4 * r) + 0.2 * r / (width * width) + 0.02 * v;
}
inline double viscous(double v) { return 0.3 * v; }

inline double lugre(double v, double z) {
  const double mu = 0.4 + 0.2 * std::exp(-v * v / 0.25), size = v * v / std::sqrt(v * v + 0.01) / mu;
  return 3 * z + 0.5 / (1 + 0.5 * size / 4) * (v - 3 * size * z) + 0.02 * v;
}

inline friction_law coulomb_in(builder& b) { return friction_law::coulomb(b.number(0.4), b.number(0.1)); }
inline friction_law stribeck_in(builder& b) {
  return friction_law::stribeck(b.number(0.6), b.number(0.4), b.number(0.1), b.number(0.02));
}
inline friction_law viscous_in(builder& b) { return friction_law::of_viscosity(b.number(0.3)); }

/// LuGre's law with the stiffness 3 of the bristles.
inline friction_law lugre_in(builder& b, const kanexpr::base::sequence<expression>& deflections) {
  friction_law law = friction_law::lugre(b.number(0.6), b.number(0.4), b.number(0.5), b.number(3),
                                         b.number(0.5), b.number(0.02), deflections);
  law.slip_speed = b.number(0.1);
  return law;
}

// ---- along a pathway: the power is −T dl/dt, where T follows from the length l and its rate

struct law_along {
  std::string name;
  nature is{};
  std::function<void(builder&, const pathway&)> add;
  std::function<double(double l, double rate)> tension;
};

inline const std::vector<law_along>& laws_along() {
  using n = nature;
  static const std::vector<law_along> all{
      {"force", n::driven, [](builder& b, const pathway& p) { b.force_along(p, b.number(2.5)); },
       [](double, double) { return 2.5; }},
      {"linear spring", n::conservative,
       [](builder& b, const pathway& p) { b.linear_spring(p, b.number(3), b.number(0.4)); },
       [](double l, double) { return 3 * (l - 0.4); }},
      {"cubic spring", n::conservative,
       [](builder& b, const pathway& p) { b.cubic_spring(p, b.number(1.5), b.number(0.7), b.number(0.3)); },
       [](double l, double) { return 1.5 * (l - 0.3) + 0.7 * std::pow(l - 0.3, 3); }},
      {"linear damper", n::dissipative,
       [](builder& b, const pathway& p) { b.linear_damper(p, b.number(0.4)); },
       [](double, double rate) { return 0.4 * rate; }},
      {"elastic stop", n::conservative,
       [](builder& b, const pathway& p) {
         b.stop(p, b.number(0.6), b.number(0.9), b.number(50), b.number(0.0), b.number(0.4));
       },
       [](double l, double) { return 50 * (one_sided(l - 0.9, 0.4) - one_sided(0.6 - l, 0.4)); }},
      {"stop", n::dissipative,
       [](builder& b, const pathway& p) {
         b.stop(p, b.number(0.6), b.number(0.9), b.number(50), b.number(0.7), b.number(0.4));
       },
       [](double l, double rate) {
         return 50 * (one_sided(l - 0.9, 0.4) * hunt_and_crossley(0.7, rate) -
                      one_sided(0.6 - l, 0.4) * hunt_and_crossley(0.7, -rate));
       }},
      {"Coulomb friction", n::dissipative,
       [](builder& b, const pathway& p) { b.friction_along(p, b.number(6), coulomb_in(b)); },
       [](double, double rate) { return 6 * coulomb(rate); }},
      {"Stribeck friction", n::dissipative,
       [](builder& b, const pathway& p) { b.friction_along(p, b.number(6), stribeck_in(b)); },
       [](double, double rate) { return 6 * stribeck(rate); }},
      {"viscous friction", n::dissipative,
       [](builder& b, const pathway& p) { b.friction_along(p, b.number(6), viscous_in(b)); },
       [](double, double rate) { return 6 * viscous(rate); }}};
  return all;
}

/// Friction of bristles along a pathway, which stores the energy N σ₀ z²/2 of their deflection z.
inline element bristles_along(std::size_t path) {
  element e{"LuGre's friction along a pathway: " + mechanisms::arm().pathways()[path].first,
            nature::dissipative,
            {},
            {}};
  e.build = [path] {
    mechanisms::arm b;
    const pathway along = b.pathways()[path].second;
    const expression z = b.state_variable("z");
    b.friction_along(along, b.number(6), lugre_in(b, {z}));
    mechanics::known_motion known(b.mechanism());
    return mechanism_with_element{derive(b), {known.moving().rate(b.length_of(along)), z}, 6 * 3 * z * z / 2};
  };
  e.power = [](const VectorXd& m) { return -6 * lugre(m[0], m[1]) * m[0]; };
  return e;
}

/// Every law along every kind of pathway.
inline std::vector<element> along_pathways() {
  std::vector<element> all;
  const std::size_t paths = mechanisms::arm().pathways().size();
  for (std::size_t i = 0; i < paths; ++i) all.push_back(bristles_along(i));
  for (std::size_t i = 0; i < paths; ++i)
    for (const law_along& law : laws_along()) {
      element e{law.name + " along a pathway: " + mechanisms::arm().pathways()[i].first, law.is, {}, {}};
      e.build = [i, law] {
        mechanisms::arm b;
        const pathway path = b.pathways()[i].second;
        law.add(b, path);
        mechanics::known_motion known(b.mechanism());
        const expression length = b.length_of(path);
        return mechanism_with_element{derive(b), {length, known.moving().rate(length)}};
      };
      e.power = [law](const VectorXd& m) { return -law.tension(m[0], m[1]) * m[1]; };
      all.push_back(e);
    }
  return all;
}

// ---- between two bodies in six directions

inline std::vector<expression> numbers(builder& b, std::initializer_list<double> all) {
  std::vector<expression> result;
  for (const double each : all) result.push_back(b.number(each));
  return result;
}

inline components in_inertial_axes(const builder& b, const kanexpr::runtime::vector& v) {
  return express(b.mechanism(), v, mechanics::mechanism::inertial);
}

inline element bushing(nature is) {
  element e{is == nature::dissipative ? "bushing" : "elastic bushing", is, {}, {}};
  e.build = [is] {
    mechanisms::arm b;
    const bool is_damped = is == nature::dissipative;
    b.bushing(b.b, b.hand, b.a, b.eye, numbers(b, {4, 5, 6, 3, 4, 5}),
              is_damped ? numbers(b, {0.4, 0.5, 0.6, 0.3, 0.4, 0.5}) : std::vector<expression>{});
    mechanics::known_motion known(b.mechanism());
    mechanics::motion& k = known.moving();
    const int first = static_cast<int>(b.b), second = static_cast<int>(b.a);
    const components d = express(b.mechanism(), b.position_of(b.hand, b.eye), second);
    const components w = express(
        b.mechanism(), angular_velocity_of_frame(k, first) - angular_velocity_of_frame(k, second), second);
    const double turning[]{3, 4, 5};
    expression energy = (4 * d.x * d.x + 5 * d.y * d.y + 6 * d.z * d.z) / 2;
    for (int i = 0; i < 3; ++i) {
      const double kappa = (turning[(i + 1) % 3] + turning[(i + 2) % 3] - turning[i]) / 2;
      const components axis = express(b.mechanism(), mechanics::unit(b.graph(), i), first, second);
      energy += b.number(kappa) * (1 - axis[i]);
    }
    return mechanism_with_element{derive(b),
                                  {k.rate(energy), k.rate(d.x), k.rate(d.y), k.rate(d.z), w.x, w.y, w.z}};
  };
  e.power = [is](const VectorXd& m) {
    if (is == nature::conservative) return -m[0];
    VectorXd c(6);
    c << 0.4, 0.5, 0.6, 0.3, 0.4, 0.5;
    return -m[0] - c.dot(m.tail(6).cwiseAbs2());
  };
  return e;
}

inline std::vector<element> between_bodies() {
  std::vector<element> all{bushing(nature::conservative), bushing(nature::dissipative)};
  all.push_back({"spring between points", nature::conservative,
                 [] {
                   mechanisms::arm b;
                   b.spring(b.hand, b.wall, b.number(3), b.number(0.4));
                   const expression l = b.length_of(b.straight(b.hand, b.wall));
                   mechanics::known_motion known(b.mechanism());
                   return mechanism_with_element{derive(b), {l, known.moving().rate(l)}};
                 },
                 [](const VectorXd& m) { return -3 * (m[0] - 0.4) * m[1]; }});
  all.push_back({"damper between points", nature::dissipative,
                 [] {
                   mechanisms::arm b;
                   b.damper(b.hand, b.wall, b.number(3));
                   mechanics::known_motion known(b.mechanism());
                   return mechanism_with_element{
                       derive(b), {known.moving().rate(b.length_of(b.straight(b.hand, b.wall)))}};
                 },
                 [](const VectorXd& m) { return -3 * m[0] * m[0]; }});
  all.push_back({"torsional spring", nature::conservative,
                 [] {
                   mechanisms::arm b;
                   b.torsional_spring(b.q[2], b.number(2), b.number(0.3));
                   return mechanism_with_element{derive(b), {b.q[2], b.u[2]}};
                 },
                 [](const VectorXd& m) { return -2 * (m[0] - 0.3) * m[1]; }});
  all.push_back({"torsional damper", nature::dissipative,
                 [] {
                   mechanisms::arm b;
                   b.torsional_damper(b.b, b.inertial_frame(), b.number(2));
                   mechanics::known_motion known(b.mechanism());
                   const components w =
                       in_inertial_axes(b, angular_velocity_of_frame(known.moving(), static_cast<int>(b.b)));
                   return mechanism_with_element{derive(b), {dot(w, w)}};
                 },
                 [](const VectorXd& m) { return -2 * m[0]; }});
  return all;
}

// ---- contacts: the power is −N dδ/dt − N μ(v) v − b N ω²/√(ω² + ωₛ²), where the normal force N follows from
// the penetration δ and its rate, v is the slip speed and ω the part of the angular velocity in the tangent
// plane

struct shapes_in_contact {
  std::string name;
  frame_id first, second; ///< the frames of the two bodies
  point_id point, other;
  bool has_frame = true; ///< false if the first body is a point
  expression penetration;
  components normal,
      arm; ///< in inertial axes; from the second body to the first, and from the point to the contact
  std::function<void(const contact_data&)> add;
};

inline components scaled_to_one(const components& v) { return (1 / sqrt(dot(v, v))) * v; }

inline std::vector<shapes_in_contact> all_shapes(mechanisms::arm& b) {
  std::vector<shapes_in_contact> all;
  const auto between = [&](point_id from, point_id to) {
    return in_inertial_axes(b, b.position_of(to, from));
  };
  const auto of_plane = [&](const std::string& name, const auto& normal, frame_id fixed, point_id place,
                            auto fill) {
    const components n = scaled_to_one(in_inertial_axes(b, normal));
    shapes_in_contact s{name, b.b, fixed, b.hand, place, true, {}, n, components(b.graph()), {}};
    fill(s, dot(n, between(place, b.hand)), n);
    all.push_back(s);
  };
  const auto in_space = b.along(b.n, 0.2, -0.1, 1.0), on_body = b.along(b.a, 0.3, 1.0, 0.2);
  of_plane("point on plane", in_space, b.n, b.wall,
           [&](shapes_in_contact& s, expression height, const components&) {
             s.has_frame = false, s.penetration = -height;
             s.add = [&b, in_space](const contact_data& d) { b.point_on_plane(b.hand, b.wall, in_space, d); };
           });
  of_plane("sphere on moving plane", on_body, b.a, b.eye,
           [&](shapes_in_contact& s, expression height, const components& n) {
             s.penetration = 0.4 - height, s.arm = b.number(-0.4) * n;
             s.add = [&b, on_body](const contact_data& d) {
               b.sphere_on_plane(b.hand, b.b, 0.4, b.eye, on_body, d);
             };
           });
  const auto axis = b.along(b.b, 0.0, 1.0, 0.1);
  of_plane("torus on plane", in_space, b.n, b.wall,
           [&](shapes_in_contact& s, expression height, const components& n) {
             const components e = scaled_to_one(in_inertial_axes(b, axis)), across = cross(n, e);
             const expression cosine = dot(n, e), sine = sqrt(dot(across, across));
             s.penetration = 0.1 + 0.5 * sine - height;
             s.arm = (0.5 / sine) * (cosine * e - n) + b.number(-0.1) * n;
             s.add = [&b, axis, in_space](const contact_data& d) {
               b.torus_on_plane(b.hand, b.b, axis, 0.5, 0.1, b.wall, in_space, d);
             };
           });
  const components line = between(b.eye, b.hand), along = scaled_to_one(line);
  all.push_back({"sphere on sphere", b.b, b.a, b.hand, b.eye, true, 1.1 - sqrt(dot(line, line)), along,
                 b.number(-0.6) * along,
                 [&b](const contact_data& d) { b.sphere_on_sphere(b.hand, b.b, 0.6, b.eye, b.a, 0.5, d); }});
  const components p = express(b.mechanism(), b.position_of(b.hand, b.eye), static_cast<int>(b.a));
  const components slope(-0.6 * cos(2 * p.x), 0.8 * p.y, b.number(2));
  const expression level = 2 * p.z - 0.3 * sin(2 * p.x) + 0.4 * p.y * p.y;
  all.push_back(
      {"point on moving surface", b.b, b.a, b.hand, b.eye, false, -level / sqrt(dot(slope, slope)),
       scaled_to_one(express(b.mechanism(), slope, static_cast<int>(b.a), mechanics::mechanism::inertial)),
       components(b.graph()), [&b](const contact_data& d) {
         b.point_on_surface(
             b.hand, b.eye, b.a,
             [](expression x, expression y, expression z) { return 2 * z - 0.3 * sin(2 * x) + 0.4 * y * y; },
             d);
       }});
  return all;
}

/// The motion of the first body relative to the second at the contact: the slip and the angular velocity
/// without their parts along the normal, and this part of the angular velocity.
struct sliding {
  components slip, spin;
  expression about_normal;
};

inline sliding sliding_in(const mechanisms::arm& b, mechanics::motion& k, const shapes_in_contact& s) {
  const auto w = [&](frame_id f) {
    return in_inertial_axes(b, angular_velocity_of_frame(k, static_cast<int>(f)));
  };
  const auto v = [&](point_id p) { return in_inertial_axes(b, velocity_of_point(k, static_cast<int>(p))); };
  const components line = express(
      b.mechanism(), position_from(b.mechanism(), static_cast<int>(s.other), static_cast<int>(s.point)), 0);
  components first = v(s.point);
  if (s.has_frame) first += cross(w(s.first), s.arm);
  sliding found{first - (v(s.other) + cross(w(s.second), line + s.arm)), w(s.first) - w(s.second), {}};
  found.about_normal = dot(found.spin, s.normal);
  for (components* each : {&found.slip, &found.spin}) *each -= dot(*each, s.normal) * s.normal;
  return found;
}

/// The penetration, its rate, and the squares of the slip speed and of the angular velocity in the tangent
/// plane and about the normal.
inline std::vector<expression> measured_in(mechanisms::arm& b, const shapes_in_contact& s) {
  mechanics::known_motion known(b.mechanism());
  const sliding m = sliding_in(b, known.moving(), s);
  return {s.penetration, known.moving().rate(s.penetration), dot(m.slip, m.slip), dot(m.spin, m.spin),
          m.about_normal * m.about_normal};
}

/// Friction of bristles in a contact, which stores the energy σ₀ y²/2; the forces are those that the builder
/// returns.
inline element bristles_in_contact(std::size_t shapes, const std::string& name) {
  element e{"contact with LuGre's friction, " + name, nature::dissipative, {}, {}};
  e.build = [shapes] {
    mechanisms::arm b;
    const shapes_in_contact s = all_shapes(b)[shapes];
    contact_data data{.stiffness = 30, .exponent = 1.5, .width = 0.3};
    data.damping = 0.6;
    kanexpr::base::sequence<expression> y;
    expression stored = b.number(0.0);
    for (const char* called : {"y1", "y2", "y3"}) {
      if (y.size() == 2 && s.name.find("plane") != std::string::npos) break;
      y.push(b.state_variable(called));
      stored += 3 * y.back() * y.back() / 2;
    }
    data.friction = lugre_in(b, y);
    s.add(data);
    mechanics::known_motion known(b.mechanism());
    const components rubbing = in_inertial_axes(b, b.friction_force_of(1, known));
    return mechanism_with_element{derive(b),
                                  {b.normal_force_of(1, known), known.moving().rate(s.penetration),
                                   dot(rubbing, sliding_in(b, known.moving(), s).slip)},
                                  stored};
  };
  e.power = [](const VectorXd& m) { return -m[0] * m[1] + m[2]; };
  return e;
}

struct contact_law {
  std::string name;
  nature is{};
  double exponent = 1, damping = 0, lever = 0;
  friction_law (*friction)(builder&) = nullptr;
  double (*coefficient)(double) = nullptr;
  double spinning_lever = 0;
};

inline double normal_force(const contact_law& law, double penetration, double rate) {
  const double width = 0.3, t = std::fmin(std::fmax((penetration + width) / (2 * width), 0), 1);
  return 30 * std::pow(one_sided(penetration + width, 2 * width), law.exponent) * t * t * (3 - 2 * t) *
         hunt_and_crossley(law.damping, rate);
}

inline std::vector<element> in_contacts() {
  using n = nature;
  const contact_law laws[]{
      {"elastic contact", n::conservative, 1.5},
      {"linear contact", n::conservative},
      {"damped contact", n::dissipative, 1.5, 0.6},
      {"contact with Coulomb friction", n::dissipative, 1.5, 0.6, 0, coulomb_in, coulomb},
      {"contact with Stribeck friction", n::dissipative, 1, 0, 0, stribeck_in, stribeck},
      {"contact with viscous friction", n::dissipative, 1, 0.6, 0, viscous_in, viscous},
      {"contact with rolling resistance", n::dissipative, 1.5, 0.6, 0.2},
      {"contact with spinning resistance", n::dissipative, 1.5, 0.6, 0, nullptr, nullptr, 0.3}};
  mechanisms::arm counted;
  std::vector<element> all;
  for (std::size_t i = 0; i < all_shapes(counted).size(); ++i)
    all.push_back(bristles_in_contact(i, all_shapes(counted)[i].name));
  for (std::size_t i = 0; i < all_shapes(counted).size(); ++i)
    for (const contact_law& law : laws) {
      const shapes_in_contact shapes = all_shapes(counted)[i];
      if (law.lever + law.spinning_lever > 0 && !shapes.has_frame) continue;
      element e{law.name + ", " + shapes.name, law.is, {}, {}};
      e.build = [i, law] {
        mechanisms::arm b;
        const shapes_in_contact s = all_shapes(b)[i];
        contact_data data{.stiffness = 30, .exponent = law.exponent, .width = 0.3};
        if (law.damping > 0) data.damping = law.damping;
        if (law.friction != nullptr) data.friction = law.friction(b);
        if (law.lever > 0) data.rolling = {b.number(law.lever), b.number(0.1)};
        if (law.spinning_lever > 0) data.spinning = {b.number(law.spinning_lever), b.number(0.2)};
        s.add(data);
        const std::vector<expression> measured = measured_in(b, s);
        return mechanism_with_element{derive(b), measured};
      };
      e.power = [law](const VectorXd& m) {
        const double v = std::sqrt(m[2]), pressing = normal_force(law, m[0], m[1]);
        const double sliding = law.coefficient == nullptr ? 0 : law.coefficient(v) * v;
        const double rolling = law.lever * m[3] / std::sqrt(m[3] + 0.01),
                     spinning = law.spinning_lever * m[4] / std::sqrt(m[4] + 0.04);
        return -pressing * (m[1] + sliding + rolling + spinning);
      };
      all.push_back(e);
    }
  return all;
}

} // namespace elements
