// A random mechanism with random loads along pathways, in contacts and with state variables, and with random
// constraints on its speeds: the balance of energy, the constraints, Lagrange's method, and derivatives.
#pragma once

#include "errors.hpp"
#include "mechanics/random/dice.hpp"
#include "random_units.hpp"

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <complex>
#include <string>
#include <vector>

namespace soak {

// A tree of bodies, built in the same way for the same seed.
class loaded_mechanism : public kanexpr::runtime::builder {
  using expression = kanexpr::symbolic::expression;
  using friction_law = kanexpr::mechanics::friction_law;
  using vector = kanexpr::runtime::vector;

public:
  explicit loaded_mechanism(unsigned seed, bool by_lagrange = false)
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
    const int loads = d_.whole(1, 4);
    for (int i = 0; i < loads; ++i) add_load();
    constrains = d_.chance(0.3);
    if (constrains && !by_lagrange) constrain();
  }

  bool mixes_speeds = false, constrains = false; ///< whether q̇ differs from u
  bool gives = false;                            ///< whether a load may give energy
  bool takes = false;                            ///< whether a load may take energy
  expression held{};                             ///< the constrained quantity; the parameter c is its value

private:
  static std::size_t place(int i) { return static_cast<std::size_t>(i); }
  expression number() { return builder::number(d_.between(-1, 1)); }
  expression positive() { return builder::number(d_.between(0.3, 2)); }
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

  void add_load() {
    const int what = d_.whole(0, 10);
    takes = takes || what == 3 || what == 4 || what == 5 || what == 6 || what >= 8;
    switch (what) {
    case 0: return gives = true, force_along(some_path(), number());
    case 1: return linear_spring(some_path(), positive(), positive());
    case 2: return cubic_spring(some_path(), positive(), positive(), positive());
    case 3: return linear_damper(some_path(), positive());
    case 4:
      return stop(some_path(), builder::number(0.7), builder::number(1.4), positive() * 10, positive(),
                  builder::number(0.2));
    case 5: return friction_along(some_path(), positive(), some_law());
    case 6: return add_bushing();
    case 7: return add_memory();
    default: return add_contact();
    }
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

  void add_contact() {
    const auto [a, b] = some_pair();
    kanexpr::runtime::contact_data data{.stiffness = d_.between(2, 20),
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
    switch (shapes) {
    case 0: return point_on_plane(p, q, some_vector(g), data);
    case 1:
      return point_on_surface(
          p, q, g,
          [](expression x, expression y, expression z) { return z - 0.2 * sin(2 * x) + 0.1 * y * y; }, data);
    case 2: return sphere_on_plane(p, f, positive(), q, some_vector(g), data);
    case 3: return torus_on_plane(p, f, some_vector(f), positive(), positive(), q, some_vector(g), data);
    default: return sphere_on_sphere(p, f, positive(), q, g, positive(), data);
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
  dice d_;
  std::vector<kanexpr::runtime::frame_id> frames_;
  std::vector<kanexpr::runtime::point_id> points_;
  std::vector<where> places_; ///< of each point
  std::vector<expression> q_, u_;
};

class loaded {
public:
  explicit loaded(unsigned seed) : d_(seed + 77), seed_(seed), b_(seed), m_(kanexpr::derive(b_)) {
    const Eigen::Index size = m_.mechanism().coordinates.size() + m_.mechanism().speeds.size();
    if (!m_.mistake().empty()) return;
    rates_ = m_.rhs();
    auto rhs = m_.function(rates_);
    for (int tried = 0; tried < 20 && !regular_; ++tried) {
      x_ = Eigen::VectorXd::NullaryExpr(size, [&] { return d_.between(-1.2, 1.2); });
      bind();
      regular_ = Eigen::VectorXd(rhs(x_, p_)).norm() < 1e4 && rhs.status();
    }
  }

  // There is none where a pathway has no length or a constraint is singular. A random end of a pathway may
  // also be inside the surface around which it wraps.
  bool is_regular() const {
    const std::string mistake = m_.mistake();
    return mistake.empty() ? regular_ : mistake.find("is inside the surface") == std::string::npos;
  }

  void run(errors& found, const wanted& w) {
    found.expect(m_.mistake().empty(), m_.mistake());
    if (!found.reason().empty()) return;
    balance(found);
    differentiate(found);
    compare_roads(found);
    if (w.hostile_states) visit_hostile(found);
  }

  long hostile_visited = 0, hostile_refused = 0;

private:
  using complex = std::complex<double>;
  using expression = kanexpr::symbolic::expression;
  using quantity = kanexpr::mechanics::quantity;
  using matrix = kanexpr::symbolic::matrix;

  // The constraint holds at the state.
  void bind() {
    p_ = Eigen::VectorXd(m_.mechanism().parameters.size());
    if (!b_.held.is_given()) return;
    matrix one(m_.graph(), 1, 1);
    one.entries[0] = b_.held;
    p_[0] = 0;
    p_[0] = m_.function(one)(x_, p_)(0);
  }

  expression rate_of(expression value) {
    expression sum = m_.mechanism().zero();
    int row = 0;
    for (const auto* list : {&m_.mechanism().coordinates, &m_.mechanism().speeds})
      for (const expression& e : *list)
        sum += kanexpr::symbolic::differentiate(value, e) * rates_.entries[row++];
    return sum;
  }

  void balance(errors& found) {
    const expression stored = m_.get(quantity::potential_energy).entries[0],
                     moving = m_.get(quantity::kinetic_energy).entries[0];
    matrix all(m_.graph(), 3, 1);
    all.entries[0] = rate_of(moving), all.entries[1] = rate_of(stored);
    all.entries[2] = b_.held.is_given() ? rate_of(b_.held) : m_.mechanism().zero();
    const Eigen::VectorXd at = m_.function(all)(x_, p_);
    const double scale =
        1 + std::abs(at[0]) + std::abs(at[1]) + Eigen::VectorXd(m_.function(rates_)(x_, p_)).norm();
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(1, 1);
    if (b_.held.is_given()) found.compare("rate of a constraint", at.tail(1), zero, 10 * scale);
    if (b_.held.is_given() || b_.gives) return;
    const Eigen::MatrixXd gain = Eigen::MatrixXd::Constant(1, 1, at[0] + at[1]);
    if (b_.takes)
      found.compare("gain of energy", gain.cwiseMax(0), zero, scale);
    else
      found.compare("energy", gain, zero, scale);
  }

  void differentiate(errors& found) {
    auto rhs = m_.function<complex>(rates_),
         jacobian = m_.function<complex>(m_.get(quantity::state_jacobian));
    auto hessian = m_.function(m_.get(quantity::weighted_hessian));
    const Eigen::Index n = x_.size();
    const Eigen::VectorXd weights = Eigen::VectorXd::NullaryExpr(n, [&] { return d_.between(-1, 1); });
    const Eigen::VectorXcd p = p_;
    const Eigen::MatrixXd first = Eigen::MatrixXcd(jacobian(Eigen::VectorXcd(x_), p)).real(),
                          second = hessian(0, x_, p_, Eigen::VectorXd(), weights);
    Eigen::MatrixXd by_steps(n, n), bent(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      Eigen::VectorXcd aside = x_;
      aside[j] += complex(0, 1e-30);
      by_steps.col(j) = Eigen::VectorXcd(rhs(aside, p)).imag() / 1e-30;
      bent.col(j) = (Eigen::MatrixXcd(jacobian(aside, p)).imag() / 1e-30).transpose() * weights;
    }
    // Rounding changes the Jacobian as much as if the state were rounded.
    found.compare("state Jacobian", first, by_steps, 1 + first.norm() + second.norm());
    found.compare("weighted Hessian", second, bent, 10 * (1 + second.norm()));
  }

  void compare_roads(errors& found) {
    const Eigen::VectorXd rates = m_.function(rates_)(x_, p_);
    kanexpr::model copied = kanexpr::runtime::derive_in_own_graph(b_);
    found.compare("rates in a graph of their own", copied.function(copied.rhs())(x_, p_), rates,
                  1 + rates.norm());
    if (b_.mixes_speeds || b_.constrains) return;
    kanexpr::model lagrange = kanexpr::derive(loaded_mechanism(seed_, true));
    found.expect(lagrange.mistake().empty(), lagrange.mistake());
    if (!found.reason().empty()) return;
    found.compare("rates by Lagrange's method", lagrange.function(lagrange.rhs())(x_, p_), rates,
                  100 * (1 + rates.norm()));
  }

  void visit_hostile(errors& found) {
    auto rhs = m_.function(rates_);
    const auto visit = [&](const std::string& what, auto value) {
      Eigen::VectorXd x = x_;
      for (double& each : x) each = value(each);
      const Eigen::VectorXd rates = rhs(x, p_);
      const kanexpr::status told = rhs.status();
      found.expect(!told || rates.allFinite(), what + ": the rates are not finite, and no status says so");
      found.expect(static_cast<bool>(told) || !told.cause().empty(), what + ": refused without a cause");
      ++hostile_visited, hostile_refused += !told;
    };
    visit("zeros", [](double) { return 0.0; });
    visit("tiny values", [&](double) { return d_.pick({5e-324, -1e-300, 1e-100, 1e-17}); });
    visit("huge values", [&](double) { return d_.pick({-1.0, 1.0, 0.1}) * 1e12; });
    visit("a mixture", [&](double x) { return d_.pick({0.0, x, 1e-30, 1e8, -x, 1.0}); });
  }

  dice d_;
  unsigned seed_;
  loaded_mechanism b_;
  kanexpr::model m_;
  matrix rates_{};
  Eigen::VectorXd x_, p_;
  bool regular_ = false;
};

} // namespace soak
