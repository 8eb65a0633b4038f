// Random constraints on a random mechanism, and their values in plain numbers.
#pragma once

#include "newton_euler.hpp"
#include "random_parts.hpp"

namespace recipe {

enum class bound {
  point,         // the velocity of a point along a direction
  points,        // that of a point minus that of another
  turning,       // the angular velocity of a frame minus that of another along a direction
  speeds,        // Σ a u + Σ b q̇ + c
  configuration, // the product of two formulas, plus a third
};

struct constraint {
  bound what{};
  int one = 0, other = 0; // points or frames
  sum direction;
  std::vector<formula> on_speeds, on_rates; // by speed, by coordinate
  formula rest;
  std::array<formula, 2> product;
};

class random_constraints {
public:
  random_constraints(const mechanism& m, unsigned seed) : m_(m), d_(seed) {}

  std::vector<constraint> run() {
    const int speeds = static_cast<int>(m_.u.size());
    std::vector<constraint> all;
    for (int left = d_.whole(1, std::min(5, speeds - 1)); left > 0; --left) all.push_back(any());
    return all;
  }

private:
  constraint any() {
    constraint c;
    c.what = d_.pick({bound::point, bound::point, bound::points, bound::turning, bound::speeds, bound::speeds,
                      bound::configuration});
    const bool is_turning = c.what == bound::turning;
    const int last = static_cast<int>(is_turning ? m_.frames.size() : m_.points.size()) - 1;
    c.one = d_.whole(0, last);
    c.other = d_.whole(0, last);
    for (int i = d_.pick({1, 1, 1, 2}); i > 0; --i)
      c.direction.push_back({d_.whole(0, static_cast<int>(m_.frames.size()) - 1), {way(), way(), way()}});
    for (std::size_t i = 0; i < m_.u.size(); ++i)
      c.on_speeds.push_back(d_.chance(0.5) ? any_of_q() : formula{});
    for (std::size_t i = 0; i < m_.q.size(); ++i)
      c.on_rates.push_back(d_.chance(0.1) ? any_of_q() : formula{});
    if (d_.chance(0.3)) c.rest = any_of_q();
    c.product = {any_of_q(), any_of_q()};
    return c;
  }
  formula way() { return d_.chance(0.8) ? formula{some(), {}} : any_of_q(); }
  constant some() { return {d_.chance(0.3) ? d_.pick({0.0, 1.0, -1.0}) : d_.between(-1, 1), -1}; }
  formula any_of_q() {
    formula f{some(), {}};
    for (int i = d_.whole(0, 2); i > 0; --i)
      f.terms.push_back(
          {some(), d_.pick({kind::coordinate, kind::sine}), d_.whole(0, static_cast<int>(m_.q.size()) - 1)});
    if (d_.chance(0.1)) f.terms.push_back({some(), kind::time, 0});
    return f;
  }

  const mechanism& m_;
  dice d_;
};

// The quantity that must vanish, along a motion: its value, and its rate for constant speeds.
inline limits::jet vanishing(const constraint& c, const newton_euler::motion& k) {
  using limits::jet;
  using newton_euler::at;
  switch (c.what) {
  case bound::point: return dot(k.here.velocities[at(c.one)], k.here.in_ground(c.direction, k.now));
  case bound::points:
    return dot(k.here.velocities[at(c.one)] + jet(-1) * k.here.velocities[at(c.other)],
               k.here.in_ground(c.direction, k.now));
  case bound::turning:
    return dot(newton_euler::angular_velocity(k.here.frames[at(c.one)]) +
                   jet(-1) * newton_euler::angular_velocity(k.here.frames[at(c.other)]),
               k.here.in_ground(c.direction, k.now));
  case bound::speeds: {
    jet total = k.now(c.rest);
    for (std::size_t i = 0; i < k.now.u.size(); ++i) total += k.now(c.on_speeds[i]) * k.now.u[i];
    for (std::size_t i = 0; i < k.now.q.size(); ++i) total += k.now(c.on_rates[i]) * k.now.qdot[i];
    return total;
  }
  case bound::configuration: break;
  }
  return (k.now(c.product[0]) * k.now(c.product[1]) + k.now(c.rest)).rate();
}

// J u + c = 0 and J u̇ + γ = 0.
struct linear_constraints {
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd remainder, bias;
};

inline linear_constraints linearized(const mechanism& m, const std::vector<constraint>& all) {
  const auto rows = static_cast<Eigen::Index>(all.size()), columns = static_cast<Eigen::Index>(m.u.size());
  linear_constraints out{Eigen::MatrixXd(rows, columns), Eigen::VectorXd(rows), Eigen::VectorXd(rows)};
  std::vector<double> u(m.u.size(), 0);
  const auto values = [&] {
    const newton_euler::motion k = newton_euler::move(m, u);
    Eigen::VectorXd found(rows);
    for (std::size_t i = 0; i < all.size(); ++i)
      found(static_cast<Eigen::Index>(i)) = vanishing(all[i], k).c0;
    return found;
  };
  out.remainder = values();
  for (std::size_t j = 0; j < u.size(); ++j) {
    u[j] = 1;
    out.jacobian.col(static_cast<Eigen::Index>(j)) = values() - out.remainder;
    u[j] = 0;
  }
  const newton_euler::motion k = newton_euler::move(m, m.u);
  for (std::size_t i = 0; i < all.size(); ++i)
    out.bias(static_cast<Eigen::Index>(i)) = vanishing(all[i], k).c1;
  return out;
}

} // namespace recipe
