// The same mechanism in different units of length, mass and time.
#pragma once

#include "random_constraints.hpp"
#include "recipe.hpp"

#include <cmath>
#include <stdexcept>

namespace recipe {

// The number of new units in an old one.
struct units {
  double length = 1, mass = 1, time = 1;

  double velocity() const { return length / time; }
  double force() const { return mass * length / (time * time); }
  double energy() const { return force() * length; }
  double power() const { return energy() / time; }
  double inertia() const { return mass * length * length; }
};

// Which coordinates are lengths; all others are angles or parts of quaternions.
inline std::vector<char> lengths_among(const mechanism& m) {
  std::vector<char> is_length(m.q.size(), 0);
  for (const point& p : m.points)
    for (const part& along : p.offset)
      for (const formula& f : along.value)
        for (const term& one : f.terms)
          if (one.what == kind::coordinate) is_length[static_cast<std::size_t>(one.index)] = 1;
  for (const rates& k : m.kinematics)
    if (k.how == law::base_velocity)
      for (int q : k.coordinates) is_length[static_cast<std::size_t>(q)] = 1;
  return is_length;
}

// Calls `change` for every formula of a mechanism, with its unit.
template <class Change>
void for_each_formula(mechanism& m, const units& in, const std::vector<double>& speeds,
                      const std::vector<double>& rates_of_coordinates, Change change) {
  const auto all = [&](sum& v, double unit) {
    for (part& p : v)
      for (formula& f : p.value) change(f, unit);
  };
  for (frame& f : m.frames) {
    for (formula& a : f.angle) change(a, 1.0);
    all(f.angular_velocity, 1 / in.time);
  }
  for (point& p : m.points) {
    all(p.offset, in.length);
    all(p.velocity, in.velocity());
  }
  for (load& f : m.forces) all(f.value, in.force());
  for (load& t : m.torques) all(t.value, in.energy());
  for (twist& s : m.twists) change(s.angle, 1.0);
  for (rates& k : m.kinematics) {
    const std::size_t n = k.offset.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double unit = speeds[static_cast<std::size_t>(k.speeds[i])];
      change(k.offset[i], unit);
      for (std::size_t j = 0; j < n; ++j)
        change(k.matrix[i * n + j], unit / rates_of_coordinates[static_cast<std::size_t>(k.coordinates[j])]);
    }
  }
}

namespace detail {

inline void without_sines(formula& f, const std::vector<char>& lengths) {
  for (term& one : f.terms) {
    const bool is_sine = one.what == kind::sine, is_rate = one.what == kind::cosine_times_rate;
    if ((is_sine || is_rate) && lengths[static_cast<std::size_t>(one.index)] != 0)
      one.what = is_sine ? kind::coordinate : kind::rate;
  }
}

} // namespace detail

// The sine of a length has no meaning in arbitrary units: it is replaced by the length itself.
inline void without_sines_of_lengths(mechanism& m) {
  const std::vector<char> lengths = lengths_among(m);
  const std::vector<double> plain(m.q.size() + m.u.size(), 1);
  for_each_formula(m, {}, plain, plain, [&](formula& f, double) { detail::without_sines(f, lengths); });
}
inline void without_sines_of_lengths(const mechanism& m, constraint& c) {
  const std::vector<char> lengths = lengths_among(m);
  for (part& p : c.direction)
    for (formula& f : p.value) detail::without_sines(f, lengths);
  for (formula& f : c.on_speeds) detail::without_sines(f, lengths);
  for (formula& f : c.on_rates) detail::without_sines(f, lengths);
  for (formula& f : c.product) detail::without_sines(f, lengths);
  detail::without_sines(c.rest, lengths);
}

// How the constants of a mechanism are given in its new units: if some lengths are numbers such as 1e-9 and
// others are symbols, nothing indicates the magnitude of the symbols.
enum class constants {
  numbers,
  symbols, // those that have a unit
};

class in_units {
public:
  in_units(const mechanism& from, const units& in, constants how)
      : in_(in), how_(how), given_(from.parameters.size(), 0), to_(from) {
    for (char is_length : lengths_among(from)) q_.push_back(is_length != 0 ? in.length : 1);
    for (double q : q_) qdot_.push_back(q / in.time);
    u_.resize(from.u.size(), 1 / in.time);
    for (const rates& k : from.kinematics)
      for (std::size_t i = 0; i < k.speeds.size(); ++i) {
        double& unit = u_[static_cast<std::size_t>(k.speeds[i])];
        if (k.how == law::linear) unit = qdot_[static_cast<std::size_t>(k.coordinates[i])];
        if (k.how == law::base_velocity) unit = in.velocity();
      }
    for (std::size_t i = 0; i < q_.size(); ++i) to_.q[i] *= q_[i];
    for (std::size_t i = 0; i < u_.size(); ++i) to_.u[i] *= u_[i];
    to_.t *= in_.time;
    for_each_formula(to_, in_, u_, qdot_, [&](formula& f, double unit) { convert(f, unit); });
    for (frame& f : to_.frames) {
      for (constant& c : f.direction) convert(c, 1);
      f.turns_apart = how == constants::symbols; // numbers match kinematic equations, symbols need not
    }
    for (body& b : to_.bodies) {
      convert(b.mass, in_.mass);
      for (inertia& i : b.dyadic)
        for (constant& c : i.scalars) convert(c, in_.inertia());
    }
    for (spring& s : to_.springs) {
      convert(s.stiffness, in_.force() / in_.length);
      convert(s.length, in_.length);
      convert(s.damping, in_.force() / in_.velocity());
    }
    for (damper& c : to_.dampers) convert(c.damping, in_.energy() * in_.time);
    for (twist& s : to_.twists) {
      convert(s.stiffness, in_.energy());
      convert(s.rest, 1);
    }
    for (constant& c : to_.gravity) convert(c, in_.velocity() / in_.time);
  }

  const mechanism& result() const { return to_; }

  // The unit of a constraint, whose row may be multiplied by anything if it is written out.
  constraint converted(constraint c, double row) {
    for (part& p : c.direction)
      for (formula& f : p.value) convert(f, 1);
    for (std::size_t i = 0; i < c.on_speeds.size(); ++i) convert(c.on_speeds[i], row / u_[i]);
    for (std::size_t i = 0; i < c.on_rates.size(); ++i) convert(c.on_rates[i], row / qdot_[i]);
    convert(c.product[0], std::sqrt(row));
    convert(c.product[1], std::sqrt(row));
    convert(c.rest, row);
    return c;
  }
  // The unit of a velocity constraint that is written in this way.
  double of_row(const constraint& c, double row) const {
    switch (c.what) {
    case bound::point:
    case bound::points: return in_.velocity();
    case bound::turning: return 1 / in_.time;
    case bound::speeds: return row;
    case bound::configuration: break;
    }
    return row / in_.time;
  }

  const std::vector<double>& coordinates() const { return q_; }
  const std::vector<double>& rates_of_coordinates() const { return qdot_; }
  const std::vector<double>& speeds() const { return u_; }
  const std::vector<double>& parameters() const { return given_; } // 0: it does not occur

private:
  void convert(formula& f, double unit) {
    convert(f.base, unit);
    for (term& one : f.terms) convert(one.factor, unit / unit_of(one));
  }
  double unit_of(const term& one) const {
    const auto i = static_cast<std::size_t>(one.index);
    switch (one.what) {
    case kind::coordinate: return q_[i];
    case kind::sine:
    case kind::input: return 1;
    case kind::cosine_times_rate: return 1 / in_.time;
    case kind::rate: return qdot_[i];
    case kind::speed: return u_[i];
    case kind::time: break;
    }
    return in_.time;
  }
  // One unit for equal numbers with the same unit: numbers that match an orientation, or a symmetry, still
  // match.
  int symbol_for(const constant& c, double unit) {
    const auto equal = [](double x, double y) { return std::abs(x / y - 1) < 1e-12; };
    for (const symbol& s : symbols_)
      if (equal(s.value, c.value) && equal(s.unit, unit)) return s.parameter;
    symbols_.push_back({c.value, unit, static_cast<int>(to_.parameters.size())});
    to_.parameters.push_back(0), given_.push_back(0);
    return symbols_.back().parameter;
  }

  // A parameter that occurs in several places has the same unit in all of them.
  void convert(constant& c, double unit) {
    c.value *= unit;
    if (how_ == constants::numbers) c.parameter = -1;
    if (how_ == constants::symbols && unit != 1 && c.value != 0 && c.parameter < 0)
      c.parameter = symbol_for(c, unit);
    if (c.parameter < 0) return;
    const auto i = static_cast<std::size_t>(c.parameter);
    if (given_[i] != 0 && std::abs(given_[i] / unit - 1) > 1e-12)
      throw std::logic_error("a parameter with two units");
    given_[i] = unit;
    to_.parameters[i] = c.value;
  }

  units in_;
  constants how_;
  std::vector<double> q_, qdot_, u_;
  struct symbol {
    double value, unit;
    int parameter;
  };
  std::vector<symbol> symbols_; // that represent numbers
  std::vector<double> given_;   // units of parameters
  mechanism to_;
};

} // namespace recipe
