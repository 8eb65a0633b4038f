// Springs, dampers and other loads between parts of a random mechanism.
#pragma once

#include "dice.hpp"
#include "newton_euler.hpp"

namespace recipe {

class random_springs {
public:
  random_springs(mechanism& m, unsigned seed) : d_(seed), m_(m) {}

  void hang() {
    const std::vector<Eigen::Vector3d> x = newton_euler::move(m_, m_.u).x;
    for (int i = d_.whole(0, 3); i > 0; --i) {
      const spring s{any(m_.points), any(m_.points), stiffness(), length(), damping()};
      if ((x[newton_euler::at(s.point)] - x[newton_euler::at(s.other)]).norm() > 0.1) m_.springs.push_back(s);
    }
    if (!m_.q.empty())
      for (int i = d_.whole(0, 2); i > 0; --i) m_.twists.push_back({angle(), stiffness(), length()});
    for (int i = d_.whole(0, 2); i > 0; --i) {
      const damper one{any(m_.frames), any(m_.frames), number(d_.between(0.2, 1))};
      if (one.frame != one.against) m_.dampers.push_back(one);
    }
    for (int i = d_.whole(0, 1); i > 0; --i) push_between(m_.forces, any(m_.points), any(m_.points));
    for (int i = d_.whole(0, 2); i > 0; --i) push_between(m_.torques, any(m_.frames), any(m_.frames));
  }

private:
  template <class Entity>
  int any(const std::vector<Entity>& from) {
    return d_.whole(0, static_cast<int>(from.size()) - 1);
  }

  constant number(double value) {
    if (d_.chance(0.5)) return {value, -1};
    m_.parameters.push_back(value);
    return {value, static_cast<int>(m_.parameters.size()) - 1};
  }
  constant stiffness() { return d_.chance(0.2) ? constant{} : number(d_.between(0.5, 2)); }
  constant length() { return d_.chance(0.4) ? constant{} : number(d_.between(0.2, 1)); }
  constant damping() { return d_.chance(0.4) ? constant{} : number(d_.between(0.2, 1)); }

  formula angle() {
    formula a{number(d_.between(-1, 1)), {}};
    for (int i = d_.whole(1, 2); i > 0; --i)
      a.terms.push_back({number(d_.between(-1, 1)), d_.pick({kind::coordinate, kind::sine}), any(m_.q)});
    if (d_.chance(0.3)) a.terms.push_back({number(0.7), kind::time, 0});
    if (d_.chance(0.3)) a.terms.push_back({number(0.7), kind::input, 1});
    return a;
  }

  void push_between(std::vector<load>& loads, int on, int against) {
    if (on == against) return;
    triple value;
    for (formula& f : value) f.base = number(d_.between(-1, 1));
    value[0].terms.push_back({number(1), kind::input, 0});
    loads.push_back({on, {{any(m_.frames), value}}, against});
  }

  dice d_;
  mechanism& m_;
};

} // namespace recipe
