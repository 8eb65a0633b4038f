// Mechanisms by dice: trees of bodies on all kinds of joints, and points chained through frames of other
// trees.
#pragma once

#include "dice.hpp"
#include "recipe.hpp"

#include <algorithm>

namespace recipe {

class generator {
public:
  // Links without mass may leave the mass matrix singular, where axes coincide.
  generator(unsigned seed, bool massless_links)
      : d_(seed), symbolic_(d_.pick({0.0, 0.3, 1.0})), parallel_(d_.chance(0.15)),
        massless_links_(massless_links) {}

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
  enum class style { tree, chain, star, scattered };

  // a link: its frame, the point that its joint is at, and the point where its mass is
  struct link {
    int frame = 0, joint = 0, center = 0;
    bool loaded = false;
  };

  // ---- numbers

  constant number(double value) {
    const bool plain = value == 0 || value == 1 || value == -1;
    if (plain || !d_.chance(symbolic_)) return {value, -1};
    m_.parameters.push_back(value);
    return {value, static_cast<int>(m_.parameters.size()) - 1};
  }
  constant some() {
    return number(d_.chance(0.4) ? d_.pick({0.0, 0.0, 1.0, -1.0, 0.5, 2.0}) : d_.between(-1, 1));
  }
  static formula plain(constant c) { return {c, {}}; }
  formula motion_of(int q) {
    return {d_.chance(0.2) ? some() : constant{}, {{number(1), kind::coordinate, q}}};
  }
  triple constant_vector() {
    triple v;
    const int only = d_.chance(0.4) ? d_.whole(0, 2) : -1; // as on a machine, along one axis
    for (int i = 0; i < 3; ++i)
      if (only < 0 || i == only) v[at(i)] = plain(some());
    return v;
  }

  int coordinate(double from, double to) {
    m_.q.push_back(d_.between(from, to));
    free_.push_back(static_cast<int>(m_.q.size()) - 1);
    return free_.back();
  }
  // three speeds with a law of their own for coordinates that are taken off the common heap
  rates law_for(law how, std::vector<int> coordinates, int frame) {
    for (int c : coordinates) std::erase(free_, c);
    rates k{how, std::move(coordinates), {}, {}, {}, frame};
    for (int i = 0; i < 3; ++i) k.speeds.push_back(static_cast<int>(speeds_++));
    return k;
  }

  // ---- joints

  int any_frame() { return d_.whole(0, static_cast<int>(m_.frames.size()) - 1); }
  int any_point() { return d_.whole(0, static_cast<int>(m_.points.size()) - 1); }

  int push(const frame& f) {
    m_.frames.push_back(f);
    return static_cast<int>(m_.frames.size()) - 1;
  }
  int push(const point& p) {
    m_.points.push_back(p);
    return static_cast<int>(m_.points.size()) - 1;
  }

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

  // A velocity in the ground is one in all; in a frame that turns it is on top of the frame's.
  bool turns(int frame) const {
    for (int i = frame; i != 0; i = m_.frames[at(i)].parent) {
      if (m_.frames[at(i)].how == turn::quaternion) return true;
      for (const formula& a : m_.frames[at(i)].angle)
        if (!a.terms.empty()) return true;
    }
    return false;
  }

  int fixed_point(int from, int in) {
    point p{from, {{in, constant_vector()}}, -1, -1, {}};
    if (d_.chance(0.03)) {
      p.reference = 0; // a velocity that no position has
      p.velocity = {{any_frame(), {rolling(), rolling(), rolling()}},
                    {any_frame(), {rolling(), rolling(), rolling()}}};
    } else if (d_.chance(0.2))
      p.fixed_in = in;
    else if (turns(in) && d_.chance(0.1))
      p.reference = in;
    if (p.reference == in && d_.chance(0.5)) p.velocity = {{in, {}}};
    if (style_ == style::scattered && d_.chance(0.3))
      p = {from, {{in, constant_vector()}, {any_frame(), constant_vector()}}, -1, -1, {}};
    return push(p);
  }

  formula rolling() {
    formula v;
    if (d_.chance(0.2)) v.base = some();
    if (!m_.q.empty() && d_.chance(0.6)) v.terms.push_back({some(), kind::rate, any_coordinate()});
    if (speeds_ > 0 && d_.chance(0.6)) v.terms.push_back({some(), kind::speed, any_speed()});
    return v;
  }

  int sliding_point(int from, int in) {
    const int q = coordinate(-1, 1);
    triple offset = d_.chance(0.5) ? constant_vector() : triple{}, rate;
    const int first = d_.whole(0, 2);
    for (int way = 0; way < 3; ++way) {
      if (way != first && !d_.chance(0.2)) continue;
      const constant scale = number(d_.pick({1.0, 1.0, -1.0, 0.7}));
      const bool wavy = d_.chance(0.15);
      offset[at(way)].terms.push_back({scale, wavy ? kind::sine : kind::coordinate, q});
      rate[at(way)].terms.push_back({scale, wavy ? kind::cosine_times_rate : kind::rate, q});
      if (d_.chance(0.1)) {
        const constant drift = some();
        offset[at(way)].terms.push_back({drift, kind::time, 0});
        rate[at(way)].base = drift;
      }
    }
    point p{from, {{in, offset}}, -1, -1, {}};
    if (turns(in) && d_.chance(0.3)) p.reference = in, p.velocity = {{in, rate}};
    sliding_.push_back(static_cast<int>(m_.points.size()));
    return push(p);
  }

  int revolute(int parent, turn how) {
    frame f;
    f.parent = parent;
    f.how = how;
    f.axis = parallel_ || d_.chance(0.5) ? 2 : d_.whole(0, 2);
    f.backwards = d_.chance(0.2);
    for (constant& c : f.direction) c = number(d_.between(0.3, 1) * d_.pick({1.0, -1.0}));
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

  // A free base: its velocity in its own axes as speeds.
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

  // ω of a frame in any other one, as the sum of what all the frames on the way turn by.
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
  void particle(int where) { m_.bodies.push_back({where, -1, number(d_.between(0.3, 2)), {}, -1}); }

  void rigid(int center, int frame) {
    body b{center, frame, number(d_.between(0.3, 2)), {inertia_in(frame)}, -1};
    const recipe::frame& f = m_.frames[at(frame)];
    if (f.how == turn::about_basis && d_.chance(0.3)) { // as round as a wheel: the axes below serve as well
      const double across = d_.between(0.3, 1), along = d_.between(0.3, 1);
      inertia i{d_.chance(0.7) ? f.parent : frame, {}};
      const constant c = number(across);
      for (int k = 0; k < 3; ++k) i.scalars[at(k)] = k == f.axis ? number(along) : c;
      b.dyadic = {i};
    } else if (d_.chance(0.3)) {
      b.dyadic.push_back(inertia_in(d_.chance(0.5) ? welded(frame) : frame));
    } else if (d_.chance(0.05)) {
      b.dyadic = {inertia_in(any_frame())}; // no physics, but the equations have to hold
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

  // positive definite by its diagonal
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

  // What is left of the coordinates gets speeds in groups: u = A q̇ + b.
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
  int any_speed() { return d_.whole(0, static_cast<int>(speeds_) - 1); }
  int any_coordinate() { return d_.whole(0, static_cast<int>(m_.q.size()) - 1); }
  void free_moving_particle(int q) {
    triple offset;
    offset[0].terms = {{{1, -1}, kind::coordinate, q}};
    particle(push(point{0, {{0, offset}}, -1, -1, {}}));
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  dice d_;
  double symbolic_; // the share of numbers that are symbolic parameters
  bool parallel_;   // all axes
  bool massless_links_;
  style style_ = style::tree;
  mechanism m_;
  std::vector<link> links_;
  std::vector<int> sliding_; // points that need a mass of their own
  std::vector<int> free_;    // coordinates whose rates are not said yet
  std::size_t speeds_ = 0;
};

} // namespace recipe
