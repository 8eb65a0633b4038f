// Random joints.
#pragma once

#include "random_parts.hpp"

namespace recipe {

class random_joints : protected random_parts {
protected:
  using random_parts::random_parts;

  int revolute(int parent, turn how) {
    frame f;
    f.parent = parent;
    f.how = how;
    f.axis = parallel_ || d_.chance(0.5) ? 2 : d_.whole(0, 2);
    f.backwards = d_.chance(0.2);
    for (constant& c : f.direction) {
      const double way = d_.pick({1.0, -1.0});
      c = number(way * d_.between(0.3, 1));
    }
    if (d_.chance(0.3)) f.direction[at(d_.whole(0, 2))] = {};
    const int q = coordinate(-3, 3);
    f.angle[0] = motion_of(q);
    if (q > 0 && d_.chance(0.1))
      f.angle[0].terms.push_back({some(), kind::coordinate, d_.whole(0, q - 1)}); // a gear
    if (d_.chance(0.1)) f.angle[0].terms.push_back({some(), kind::time, 0});
    if (d_.chance(0.1)) f.angle[0].terms.push_back({number(0.3), kind::sine, q});
    const int own = push(f);
    if (d_.chance(0.3)) declare(own, any_frame());
    return own;
  }

  int welded(int parent) {
    frame f;
    f.parent = parent;
    f.how = parallel_ ? turn::about_basis : d_.pick({turn::about_basis, turn::about_axis, turn::cosines});
    f.axis = parallel_ ? 2 : d_.whole(0, 2);
    for (constant& c : f.direction) c = number(d_.between(0.3, 1));
    f.letters = "zxy";
    for (formula& a : f.angle) a = plain(number(d_.pick({0.0, d_.between(-3, 3)})));
    if (d_.chance(0.1)) f.angle[0].terms.push_back({number(0.7), kind::time, 0}); // driven
    return push(f);
  }

  int sequence(int parent) {
    frame f;
    f.parent = parent;
    f.how = d_.pick({turn::body_fixed, turn::body_fixed, turn::space_fixed, turn::cosines});
    f.letters = d_.pick(
        {std::string("xyz"), std::string("zxz"), std::string("zyx"), std::string("yxz"), std::string("xyx")});
    const bool proper = f.letters[0] == f.letters[2];
    std::vector<int> used;
    const bool two = d_.chance(0.3); // a universal joint
    for (int i = 0; i < 3; ++i) {
      if (two && i == 0)
        f.angle[0] = plain(some());
      else
        used.push_back(i == 1 ? coordinate(proper ? 0.6 : -0.9, proper ? 2.4 : 0.9) : coordinate(-3, 3));
      if (!two || i > 0) f.angle[at(i)] = {{}, {{{1, -1}, kind::coordinate, used.back()}}};
    }
    const int own = push(f);
    if (f.how == turn::body_fixed && !two && d_.chance(0.6)) {
      m_.kinematics.push_back(law_for(law::body_rates, used, own));
      if (d_.chance(0.4)) declare_own_rates(own, m_.kinematics.back());
    }
    return own;
  }

  int spherical(int parent) {
    frame f;
    f.parent = parent;
    f.how = turn::quaternion;
    f.quaternion = static_cast<int>(m_.q.size());
    std::vector<int> e;
    double square = 0;
    for (int i = 0; i < 4; ++i) e.push_back(coordinate(-1, 1));
    for (int i : e) square += m_.q[at(i)] * m_.q[at(i)];
    for (int i : e) m_.q[at(i)] /= std::sqrt(square);
    const int own = push(f);
    m_.kinematics.push_back(law_for(d_.chance(0.5) ? law::quaternion : law::implicit_quaternion, e, own));
    if (d_.chance(0.5)) declare_own_rates(own, m_.kinematics.back());
    return own;
  }

  // A floating base: its velocity in its own axes as speeds.
  int base(int frame) {
    std::vector<int> x{coordinate(-1, 1), coordinate(-1, 1), coordinate(-1, 1)};
    point p{0, {{0, {}}}, -1, -1, {}};
    for (int i = 0; i < 3; ++i) p.offset[0].value[at(i)].terms = {{{1, -1}, kind::coordinate, x[at(i)]}};
    m_.kinematics.push_back(law_for(law::base_velocity, x, frame));
    if (d_.chance(0.6)) p.reference = 0, p.velocity = {own_speeds(frame, m_.kinematics.back())};
    sliding_.push_back(static_cast<int>(m_.points.size()));
    return push(p);
  }

  part own_speeds(int frame, const rates& k) {
    part p{frame, {}};
    for (std::size_t i = 0; i < 3; ++i) p.value[i].terms = {{{1, -1}, kind::speed, k.speeds[i]}};
    return p;
  }
  void declare_own_rates(int frame, const rates& k) {
    recipe::frame& f = m_.frames[at(frame)];
    f.reference = f.parent;
    f.angular_velocity = {own_speeds(frame, k)};
  }

  // ω of a frame relative to any other one, as the sum of the contributions of all frames between them.
  void declare(int frame, int reference) {
    if (frame == reference) return;
    sum omega;
    if (!add_turning(frame, 1, omega) || !add_turning(reference, -1, omega)) return;
    m_.frames[at(frame)].reference = reference;
    m_.frames[at(frame)].angular_velocity = omega;
  }
  bool add_turning(int frame, double sign, sum& omega) {
    for (int i = frame; i != 0; i = m_.frames[at(i)].parent) {
      const recipe::frame& f = m_.frames[at(i)];
      if (f.how != turn::about_basis) return false;
      formula rate;
      for (term one : f.angle[0].terms) {
        if (one.what == kind::time) rate.base = one.factor;
        if (one.what == kind::coordinate) rate.terms.push_back({one.factor, kind::rate, one.index});
        if (one.what == kind::sine) rate.terms.push_back({one.factor, kind::cosine_times_rate, one.index});
      }
      const double way = sign * (f.backwards ? -1 : 1);
      if (way < 0) { // only numbers can change their sign in a recipe
        if (rate.base.parameter >= 0) return false;
        rate.base.value *= -1;
        for (term& one : rate.terms) {
          if (one.factor.parameter >= 0) return false;
          one.factor.value *= -1;
        }
      }
      part p{d_.chance(0.5) ? f.parent : i, {}}; // the axis is fixed in both
      p.value[at(f.axis)] = rate;
      omega.push_back(p);
    }
    return true;
  }
};

} // namespace recipe
