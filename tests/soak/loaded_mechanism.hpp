// A random mechanism with random loads along pathways, in contacts, of tyres, muscles and motors, and with
// random constraints on its speeds.
#pragma once

#include "mechanics/random/dice.hpp"

#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/building/block_data.hpp>
#include <kanexpr/runtime/building/contact_data.hpp>
#include <kanexpr/runtime/building/tyre_data.hpp>
#include <kanexpr/runtime/building/wheel_data.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace soak {

// A tree of bodies, built in the same way for the same seed.
class loaded_mechanism : public kanexpr::runtime::builder {
  using expression = kanexpr::symbolic::expression;
  using friction_law = kanexpr::mechanics::friction_law;
  using vector = kanexpr::runtime::vector;

public:
  /// The numbers of the first load are larger by the given share.
  explicit loaded_mechanism(unsigned seed, bool by_lagrange = false, double planted = 0)
      : builder("N"), by_lagrange_(by_lagrange), d_(seed), frames_{inertial_frame()} {
    points_.push_back(origin("O"));
    places_.push_back({0, 0});
    const int bodies = d_.whole(1, 3);
    for (int i = 0; i < 2 * bodies; ++i) q_.push_back(coordinate("q" + std::to_string(i)));
    mixes_speeds = d_.chance(0.5);
    if (by_lagrange) rates_as_speeds();
    for (int i = 0; i < 2 * bodies && !by_lagrange; ++i) {
      const expression u = speed("u" + std::to_string(i));
      const bool mixes = mixes_speeds && i > 0;
      kinematic_equation(mixes ? dot(q_[place(i)]) - u + 0.4 * u_.back() : dot(q_[place(i)]) - u);
      u_.push_back(u);
    }
    for (int i = 0; i < bodies; ++i) add_body(i);
    if (d_.chance(0.5)) gravity(along(frames_[0], number(), number(), number()));
    stored = builder::number(0.0);
    const int loads = d_.whole(1, 4);
    for (int i = 0; i < loads; ++i) {
      factor_ = i == 0 ? 1 + planted : 1;
      add_load(i);
    }
    constrains = d_.chance(0.3);
    if (constrains && !by_lagrange) constrain();
  }

  bool mixes_speeds = false, constrains = false; ///< whether q̇ differs from u
  bool gives = false;                            ///< whether a load may give energy
  bool takes = false;                            ///< whether a load may take energy
  expression held{};                             ///< the constrained quantity; the parameter c is its value
  expression stored{};                           ///< the energy of bristles, tyres and coils

private:
  static std::size_t place(int i) { return static_cast<std::size_t>(i); }
  expression number() { return builder::number(factor_ * d_.between(-1, 1)); }
  double positive_value() { return factor_ * d_.between(0.3, 2); }
  expression positive() { return builder::number(positive_value()); }
  vector some_vector(kanexpr::runtime::frame_id f) { return along(f, number(), number(), number()); }
  int some_place() { return d_.whole(0, static_cast<int>(points_.size()) - 1); }
  kanexpr::runtime::frame_id frame_at(int p) const { return frames_[place(places_[place(p)].frame)]; }

  // A body that turns about an axis of its parent and slides along another, and a second point on it.
  void add_body(int i) {
    const std::string n = std::to_string(i);
    const int on = some_place();
    const auto parent = frame_at(on);
    const auto frame = rotated("F" + n, parent, q_[place(2 * i)], some_vector(parent));
    frames_.push_back(frame);
    const auto center =
        offset("P" + n, points_[place(on)],
               some_vector(parent) + q_[place(2 * i + 1)] * along(parent, 1, 0, 0) + some_vector(frame));
    rigid_body("B" + n, center, frame, positive(), inertia(frame, 1.1, 1.2, 1.3, 0.1, 0.2, -0.1));
    const auto other = offset("Q" + n, center, some_vector(frame));
    for (const auto p : {center, other}) points_.push_back(p), places_.push_back({i + 1, i + 1});
  }

  // Two points on different bodies.
  std::pair<int, int> some_pair() {
    for (;;) {
      const int a = some_place(), b = some_place();
      if (places_[place(a)].body != places_[place(b)].body) return {a, b};
    }
  }

  kanexpr::runtime::pathway some_path() {
    const auto [a, b] = some_pair();
    const auto p = points_[place(a)], q = points_[place(b)], c = points_[place(some_place())];
    const auto sense = d_.pick({kanexpr::wrapping::clockwise, kanexpr::wrapping::counterclockwise});
    const auto frame = frame_at(some_place());
    switch (d_.whole(0, 5)) {
    case 0: return c == p || c == q ? straight(p, q) : through({p, c, q});
    case 1: return given_length(number() * q_[0] + number() * q_.back() * q_[0]);
    case 2:
      if (c == p || c == q) return straight(p, q);
      return around_cylinder(frame, c, some_vector(frame), builder::number(0.2), p, q, sense);
    case 3:
      if (c == p || c == q) return straight(p, q);
      return around_sphere(c, builder::number(0.2), p, q);
    case 4:
      if (c == p || c == q) return straight(p, q);
      return around_cone(frame, c, some_vector(frame), builder::number(0.3), p, q, sense);
    default: return straight(p, q);
    }
  }

  friction_law some_law() {
    switch (d_.whole(0, 2)) {
    case 0: return friction_law::coulomb(positive(), positive());
    case 1: return friction_law::stribeck(builder::number(0.9), builder::number(0.5), positive(), positive());
    default: return friction_law::of_viscosity(positive());
    }
  }

  void add_load(int place) {
    const std::string n = std::to_string(place);
    const int what = d_.whole(0, 14);
    takes = takes || (what >= 3 && what != 7);
    switch (what) {
    case 0: gives = true, force_along(some_path(), number()); break;
    case 1: linear_spring(some_path(), positive(), positive()); break;
    case 2: cubic_spring(some_path(), positive(), positive(), positive()); break;
    case 3: linear_damper(some_path(), positive()); break;
    case 4:
      stop(some_path(), builder::number(0.7), builder::number(1.4), positive() * 10, positive(),
           builder::number(0.2));
      break;
    case 5: friction_along(some_path(), positive(), some_law()); break;
    case 6: add_bushing(); break;
    case 7: add_memory(); break;
    case 8: add_bristles("bristle" + n); break;
    case 9: add_muscle("M" + n); break;
    case 10: add_motor("D" + n); break;
    case 11:
    case 12: add_tyre(n); break;
    default: add_contact("y" + n); break;
    }
  }

  /// The law of LuGre, or that of Dahl, whose bristles have no damping.
  friction_law law_of_bristles(double stiffness, const kanexpr::base::sequence<expression>& deflections) {
    const bool is_dahl = d_.chance(0.3);
    const double sliding = d_.between(0.3, 0.6);
    return friction_law::lugre(builder::number(is_dahl ? sliding : sliding + 0.2), builder::number(sliding),
                               positive(), builder::number(stiffness),
                               builder::number(is_dahl ? 0.0 : positive_value()),
                               builder::number(is_dahl ? 0.0 : positive_value()), deflections);
  }

  void add_bristles(const std::string& called) {
    const auto path = some_path();
    const double normal = positive_value(), stiffness = positive_value();
    const expression z = state_variable(called);
    friction_along(path, builder::number(normal), law_of_bristles(stiffness, {z}));
    stored += normal * stiffness / 2 * (z * z);
  }

  void add_muscle(const std::string& called) {
    gives = true;
    const auto path = some_path();
    using enum kanexpr::muscle_formulation;
    muscle(called, path, builder::number(d_.between(0, 1)),
           {.peak_isometric_force = positive_value(),
            .optimal_fiber_length = d_.between(0.7, 1.2),
            .tendon_slack_length = d_.between(0.3, 0.6),
            .maximal_fiber_velocity = d_.between(2, 5),
            .pennation = d_.chance(0.5) ? 0.0 : d_.between(0.1, 0.4),
            .fiber_damping = d_.between(0.1, 0.5),
            .tendon_strain = 0.6,
            .passive_strain = 3.0,
            .has_activation_dynamics = d_.chance(0.5),
            .formulation = d_.pick({rigid_tendon, tendon_force, fiber_length})});
  }

  /// A motor at a coordinate, and perhaps its rotor.
  void add_motor(const std::string& called) {
    const std::size_t at = place(d_.whole(0, static_cast<int>(q_.size()) - 1));
    expression rate = dot(q_[at]);
    if (!by_lagrange_) rate = mixes_speeds && at > 0 ? u_[at] - 0.4 * u_[at - 1] : u_[at];
    const bool is_driven = d_.chance(0.5);
    const double inductance = positive_value();
    kanexpr::runtime::dc_motor_data data{.voltage = is_driven ? positive_value() : 0.0,
                                         .resistance = positive_value(),
                                         .inductance = inductance,
                                         .torque_constant = positive_value(),
                                         .gear_ratio = d_.between(1, 4),
                                         .friction = d_.chance(0.5) ? positive_value() : 0.0};
    if (d_.chance(0.3)) data.winding = {0.004, positive_value(), positive_value()};
    const auto motor = dc_motor(called, rate, data);
    force_along(given_length(q_[at]), -motor.torque);
    stored += inductance / 2 * (motor.current * motor.current);
    gives = gives || is_driven;
    if (d_.chance(0.5)) rotor(called + "Rotor", q_[at], builder::number(0.05), builder::number(3.0));
  }

  void add_tyre(const std::string& n) {
    const auto [a, b] = some_pair();
    const auto hub = points_[place(a)], ground = points_[place(b)];
    const auto f = frame_at(a), g = frame_at(b);
    const auto axis = some_vector(f);
    const int below = d_.whole(0, 2);
    const double tube = below < 2 && d_.chance(0.5) ? 0.1 : 0.0, conicity = below == 2 ? 0.1 : 0.0;
    const kanexpr::runtime::wheel_data wheel{hub, f, axis, positive_value(), tube, conicity};
    kanexpr::runtime::wheel_on_ground on;
    if (below == 0) on = wheel_on_plane(wheel, ground, some_vector(g));
    if (below == 1)
      on = wheel_on_surface(
          wheel, ground, g, [](expression x, expression y) { return 0.1 * sin(x) - 0.05 * y * y; }, 1);
    if (below == 2) {
      const expression z = builder::number(0.0), one = builder::number(1);
      on = wheel_on_rail(wheel, {ground, along(g, one, number(), z), along(g, z, z, one), 0.3});
    }
    tyre(on, some_tyre(n));
    gives = gives || below == 1; // the energy of its spring is not known there
  }

  kanexpr::runtime::tyre_data some_tyre(const std::string& n) {
    using kanexpr::runtime::tyre_data;
    const double slip = positive_value(), cornering = positive_value();
    const int law = d_.whole(0, 5);
    tyre_data t = law < 2   ? tyre_data::linear(slip, cornering)
                  : law < 5 ? tyre_data::brush(positive_value(), slip, cornering)
                            : tyre_data::of_formula(some_formula());
    t.standstill = positive_value();
    if (d_.chance(0.6))
      t.radial = {positive_value() * 5, d_.between(0, 1), 0.1};
    else if (law >= 2)
      t.load = positive_value();
    if (d_.chance(0.3)) t.effective_radius = positive_value();
    if (law < 5 && d_.chance(0.3)) t.camber_stiffness = positive_value(), t.trail = 0.1;
    const bool lags = d_.chance(0.4);
    if (lags) {
      const double along = positive_value(), across = positive_value();
      const expression x = state_variable("dx" + n), y = state_variable("dy" + n);
      t.relaxation = {along, across, x, y};
      stored += slip / along / 2 * (x * x) + cornering / across / 2 * (y * y); // if it is linear
    }
    gives = gives || law == 5 || (lags && law >= 2) || t.effective_radius || t.camber_stiffness;
    return t;
  }

  kanexpr::runtime::tyre_data::coefficients some_formula() {
    return {.Fz0 = 2.0,
            .R0 = 0.3,
            .pCx1 = 1.6,
            .pDx1 = positive_value(),
            .pKx1 = 20,
            .rBx1 = 10,
            .rCx1 = 1,
            .pCy1 = 1.3,
            .pDy1 = positive_value(),
            .pKy1 = -15,
            .pKy2 = 1.5,
            .pKy4 = 2,
            .rBy1 = 8,
            .rCy1 = 1.1,
            .qBz1 = 9,
            .qBz9 = 10,
            .qCz1 = 1.2,
            .qDz1 = 0.1};
  }

  void add_bushing() {
    const auto [a, b] = some_pair();
    std::vector<expression> k, c;
    for (int i = 0; i < 6; ++i) k.push_back(positive()), c.push_back(positive());
    bushing(frame_at(a), points_[place(a)], frame_at(b), points_[place(b)], k, c);
  }

  // A force that lags behind the length of a pathway.
  void add_memory() {
    gives = true;
    const auto path = some_path();
    const expression z = state_variable("z" + std::to_string(mechanism().state_variables));
    const expression deviation = length_of(path) - z;
    dynamics(z, deviation / positive());
    force_along(path, positive() * z);
  }

  void add_contact(const std::string& called) {
    const auto [a, b] = some_pair();
    kanexpr::runtime::contact_data data{.stiffness = factor_ * d_.between(2, 20),
                                        .exponent = d_.pick({1.0, 1.5, 2.0, 1.7}),
                                        .width = d_.between(0.05, 0.4)};
    if (d_.chance(0.3))
      data.restitution = {d_.between(0.1, 1), d_.between(0.5, 2)};
    else if (d_.chance(0.5))
      data.damping = d_.between(0, 2);
    if (d_.chance(0.7)) data.friction = some_law();
    const auto p = points_[place(a)], q = points_[place(b)];
    const auto f = frame_at(a), g = frame_at(b);
    const int shapes = d_.whole(0, 4);
    if (d_.chance(0.3) && shapes > 1) data.rolling = {positive(), positive()};
    if (d_.chance(0.2)) { // with a deflection along each axis of the plane or of space
      const double stiffness = positive_value();
      kanexpr::base::sequence<expression> deflections;
      for (const char* axis : {"1", "2", "3"}) {
        if (deflections.size() == 2 && (shapes == 0 || shapes == 2 || shapes == 3)) break;
        deflections.push(state_variable(called + axis));
        stored += stiffness / 2 * (deflections.back() * deflections.back());
      }
      data.friction = law_of_bristles(stiffness, deflections);
    }
    switch (shapes) {
    case 0: point_on_plane(p, q, some_vector(g), data); break;
    case 1:
      point_on_surface(
          p, q, g,
          [](expression x, expression y, expression z) { return z - 0.2 * sin(2 * x) + 0.1 * y * y; }, data);
      break;
    case 2: sphere_on_plane(p, f, positive(), q, some_vector(g), data); break;
    case 3: torus_on_plane(p, f, some_vector(f), positive(), positive(), q, some_vector(g), data); break;
    default: sphere_on_sphere(p, f, positive(), q, g, positive(), data); break;
    }
  }

  // The speed of a point, or a component of its velocity.
  void constrain() {
    const int on = d_.whole(1, static_cast<int>(points_.size()) - 1);
    kanexpr::mechanics::known_motion known(mechanism());
    const vector v = velocity_of_point(known.moving(), static_cast<int>(points_[place(on)]));
    held = d_.chance(0.6) ? dot(v, v) : dot(v, some_vector(frames_.back()));
    velocity_constraint(held - parameter("c"));
  }

  struct where {
    int frame = 0, body = 0;
  };

  bool by_lagrange_;
  double factor_ = 1; ///< of the numbers of the present load
  dice d_;
  std::vector<kanexpr::runtime::frame_id> frames_;
  std::vector<kanexpr::runtime::point_id> points_;
  std::vector<where> places_; ///< of each point
  std::vector<expression> q_, u_;
};

} // namespace soak
