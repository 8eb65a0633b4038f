// Random mechanisms: trees of bodies with all kinds of joints, and points connected through frames of other
// trees.
#pragma once

#include "random_joints.hpp"

namespace recipe {

class generator : random_joints {
public:
  // Links without mass may make the mass matrix singular if axes coincide.
  generator(unsigned seed, bool massless_links) : random_joints(seed), massless_links_(massless_links) {}

  mechanism run() {
    m_.t = d_.between(0, 1);
    for (int i = 0; i < 3; ++i) m_.r.push_back(d_.between(-2, 2));
    const int bodies = d_.chance(0.7) ? d_.whole(1, 6) : d_.whole(7, 12);
    style_ = d_.pick({style::tree, style::tree, style::chain, style::star, style::scattered});
    for (int i = 0; i < bodies; ++i) add_link();
    load_leaves();
    gravity_and_loads();
    rest_of_kinematics();
    for (std::size_t i = 0; i < speeds_; ++i) m_.u.push_back(d_.between(-2, 2));
    return m_;
  }

private:
  // its frame, the point of its joint, and its mass center
  struct link {
    int frame = 0, joint = 0, center = 0;
    bool loaded = false;
  };

  void add_link() {
    const int last = static_cast<int>(links_.size()) - 1;
    int below = style_ == style::chain ? last : d_.whole(-1, last);
    if (style_ == style::star) below = -1;
    int frame = below < 0 ? 0 : links_[at(below)].frame;
    int joint = below < 0 ? 0 : links_[at(below)].joint;
    if (style_ == style::scattered) frame = any_frame();
    if (style_ == style::star || style_ == style::scattered) joint = any_point();
    if (below >= 0 && style_ != style::star && style_ != style::scattered)
      links_[at(below)].loaded = d_.chance(0.8);

    link l;
    l.joint = d_.chance(0.2) ? joint : fixed_point(joint, style_ == style::star ? any_frame() : frame);
    switch (d_.pick(parallel_ ? std::initializer_list<int>{0, 0, 0, 4, 7, 9}
                              : std::initializer_list<int>{0, 0, 0, 3, 4, 5, 6, 7, 8, 9})) {
    case 0: l.frame = revolute(frame, turn::about_basis); break;
    case 3: l.frame = revolute(frame, turn::about_axis); break;
    case 4: l.frame = frame, l.joint = sliding_point(l.joint, frame); break;
    case 5: l.frame = sequence(frame); break;
    case 6: l.frame = spherical(frame); break;
    case 7: l.frame = welded(frame); break;
    case 8:
      l.frame = spherical(frame);
      if (frame == 0 && below < 0) l.joint = base(l.frame);
      break;
    default: l.frame = revolute(frame, turn::about_basis), l.joint = sliding_point(l.joint, l.frame); break;
    }
    l.center = d_.chance(0.15) ? l.joint : fixed_point(l.joint, l.frame);
    if (d_.chance(0.15)) l.center = fixed_point(l.center, d_.chance(0.5) ? welded(l.frame) : l.frame);
    links_.push_back(l);
  }

  // ---- masses

  void load_leaves() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const link& l = links_[i];
      if (massless_links_ && l.loaded && d_.chance(0.3)) continue;
      rigid(l.center, l.frame);
      if (d_.chance(0.2)) rigid(d_.chance(0.5) ? fixed_point(l.joint, l.frame) : l.center, l.frame);
      if (d_.chance(0.2)) particle(d_.chance(0.5) ? fixed_point(l.joint, l.frame) : l.joint);
    }
    for (int p : sliding_)
      if (style_ == style::star || style_ == style::scattered || d_.chance(0.2)) particle(p);
  }
  void particle(int where) { m_.bodies.push_back({where, -1, number(d_.between(0.3, 2)), {}, -1, false}); }

  void rigid(int center, int frame) {
    body b{center, frame, number(d_.between(0.3, 2)), {inertia_in(frame)}, -1, false};
    const recipe::frame& f = m_.frames[at(frame)];
    if (f.how == turn::about_basis && d_.chance(0.3)) { // axisymmetric, so the axes below also fit
      const double across = d_.between(0.3, 1), along = d_.between(0.3, 1);
      inertia i{d_.chance(0.7) ? f.parent : frame, {}};
      const constant c = number(across);
      for (int k = 0; k < 3; ++k) i.scalars[at(k)] = k == f.axis ? number(along) : c;
      b.dyadic = {i};
    } else if (d_.chance(0.3)) {
      b.dyadic.push_back(inertia_in(d_.chance(0.5) ? welded(frame) : frame));
      b.inertia_changes = b.dyadic.back().axes != frame && !m_.frames.back().angle[0].terms.empty(); // driven
    } else if (d_.chance(0.05)) {
      b.dyadic = {inertia_in(any_frame())}; // not physical, but the equations must hold
      b.inertia_changes = true;
    }
    if (d_.chance(0.1)) b.about = center;
    if (d_.chance(0.2)) give_about_another_point(b);
    m_.bodies.push_back(b);
  }

  void give_about_another_point(body& b) {
    const triple r = constant_vector();
    b.about = push(point{b.center, {{b.frame, r}}, -1, -1, {}});
    inertia shift{b.frame, {}};
    for (int i = 0; i < 3; ++i) {
      const double x = r[at(i)].base.value, y = r[at((i + 1) % 3)].base.value,
                   z = r[at((i + 2) % 3)].base.value;
      shift.scalars[at(i)] = number(b.mass.value * (y * y + z * z));
      shift.scalars[at(3 + i)] = number(-b.mass.value * x * y);
    }
    b.dyadic.push_back(shift);
  }

  // positive definite because of its diagonal
  inertia inertia_in(int axes) {
    inertia i{axes, {}};
    for (int k = 0; k < 3; ++k) i.scalars[at(k)] = number(d_.between(0.5, 1.5));
    if (d_.chance(0.6))
      for (std::size_t k = 3; k < 6; ++k) i.scalars[k] = number(d_.between(-0.2, 0.2));
    return i;
  }

  // ---- loads

  formula anything() {
    formula f = plain(some());
    if (d_.chance(0.3)) f.terms.push_back({some(), kind::input, d_.whole(0, 2)});
    if (d_.chance(0.2)) f.terms.push_back({some(), kind::time, 0});
    if (!m_.q.empty() && d_.chance(0.4)) {
      const kind what = d_.pick({kind::coordinate, kind::sine, kind::rate, kind::cosine_times_rate});
      f.terms.push_back({some(), what, any_coordinate()});
    }
    if (speeds_ > 0 && d_.chance(0.3)) f.terms.push_back({some(), kind::speed, any_speed()});
    return f;
  }
  sum any_vector() {
    sum v;
    for (int i = d_.whole(1, 2); i > 0; --i) v.push_back({any_frame(), {anything(), anything(), anything()}});
    return v;
  }

  void gravity_and_loads() {
    for (int i = d_.whole(0, 3); i > 0; --i) m_.forces.push_back({any_point(), any_vector()});
    for (int i = d_.whole(0, 3); i > 0; --i) m_.torques.push_back({any_frame(), any_vector()});
    m_.has_gravity = d_.chance(0.6);
    if (d_.chance(0.6))
      m_.gravity[at(d_.whole(0, 2))] = number(-9.81);
    else
      m_.gravity = {some(), number(-9.81), some()};
  }

  // ---- speeds

  // Assigns speeds to the remaining coordinates in groups: u = A q̇ + b.
  void rest_of_kinematics() {
    std::vector<int> left = free_;
    if (left.empty() && speeds_ == 0) left.push_back(coordinate(-1, 1)), free_moving_particle(left[0]);
    d_.shuffle(left);
    while (!left.empty()) {
      const std::size_t size = std::min(left.size(), static_cast<std::size_t>(d_.pick({1, 1, 1, 2, 3, 4})));
      rates k;
      for (std::size_t i = 0; i < size; ++i) {
        k.coordinates.push_back(left.back()), left.pop_back();
        k.speeds.push_back(static_cast<int>(speeds_++));
      }
      const bool absolute = d_.chance(0.2), plain_rates = d_.chance(0.3);
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) {
          formula a;
          if (absolute)
            a.base.value = j <= i ? 1 : 0;
          else if (plain_rates || size == 1)
            a.base.value = i == j ? 1 : 0;
          else
            a.base = number(i == j ? d_.between(1, 2) : d_.pick({0.0, d_.between(-0.2, 0.2)}));
          if (!absolute && !plain_rates && d_.chance(0.3))
            a.terms.push_back({number(0.2), kind::sine, any_coordinate()});
          k.matrix.push_back(a);
        }
      for (std::size_t i = 0; i < size; ++i) {
        formula b;
        if (!plain_rates && d_.chance(0.2)) b = plain(some());
        if (!plain_rates && d_.chance(0.1)) b.terms.push_back({some(), kind::sine, any_coordinate()});
        if (!plain_rates && d_.chance(0.1)) b.terms.push_back({some(), kind::time, 0});
        k.offset.push_back(b);
      }
      m_.kinematics.push_back(k);
    }
  }
  void free_moving_particle(int q) {
    triple offset;
    offset[0].terms = {{{1, -1}, kind::coordinate, q}};
    particle(push(point{0, {{0, offset}}, -1, -1, {}}));
  }

  bool massless_links_;
  std::vector<link> links_;
};

} // namespace recipe
