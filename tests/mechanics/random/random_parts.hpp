// Random numbers, formulas and points.
#pragma once

#include "dice.hpp"
#include "recipe.hpp"

#include <algorithm>

namespace recipe {

class random_parts {
protected:
  enum class style { tree, chain, star, scattered };

  explicit random_parts(unsigned seed)
      : d_(seed), symbolic_(d_.pick({0.0, 0.3, 1.0})), parallel_(d_.chance(0.15)) {}

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
    const int only = d_.chance(0.4) ? d_.whole(0, 2) : -1; // along a single axis, as in a machine
    for (int i = 0; i < 3; ++i)
      if (only < 0 || i == only) v[at(i)] = plain(some());
    return v;
  }

  int coordinate(double from, double to) {
    m_.q.push_back(d_.between(from, to));
    free_.push_back(static_cast<int>(m_.q.size()) - 1);
    return free_.back();
  }
  // three speeds with separate equations for coordinates that are not assigned otherwise
  rates law_for(law how, std::vector<int> coordinates, int frame) {
    for (int c : coordinates) std::erase(free_, c);
    rates k{how, std::move(coordinates), {}, {}, {}, frame};
    for (int i = 0; i < 3; ++i) k.speeds.push_back(static_cast<int>(speeds_++));
    return k;
  }

  // ---- frames and points

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

  int any_speed() { return d_.whole(0, static_cast<int>(speeds_) - 1); }
  int any_coordinate() { return d_.whole(0, static_cast<int>(m_.q.size()) - 1); }

  // A velocity in the ground is the full velocity; in a rotating frame, it is added to that of the frame.
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
      p.reference = any_frame();
      p.moves_apart = true;
      p.velocity = {{any_frame(), {rolling(), rolling(), rolling()}},
                    {any_frame(), {rolling(), rolling(), rolling()}}};
    } else if (d_.chance(0.2))
      p.fixed_in = in;
    else if (const int on = any_frame(); on > 0 && d_.chance(0.05)) // as if fixed there, but its offset moves
      p = {from, {{any_frame(), constant_vector()}, {any_frame(), constant_vector()}}, -1, on, {}, true};
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

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  dice d_;
  double symbolic_; // the fraction of numbers that are symbolic parameters
  bool parallel_;   // all axes
  style style_ = style::tree;
  mechanism m_;
  std::vector<int> sliding_; // points that require a mass
  std::vector<int> free_;    // coordinates whose rates are not yet specified
  std::size_t speeds_ = 0;
};

} // namespace recipe
