#pragma once

#include "flexible/sid_writer.hpp"
#include "numbers_of.hpp"

#include <kanexpr/flexible/read_sid.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

/// Free bodies with the numbers of files, or with their particles, that carry a rigid body.
namespace vehicles {

namespace mechanics = kanexpr::mechanics;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using lumped::Vector3d;
using mechanics::quantity;

inline constexpr int rigid = 7; // a free frame, and a rigid body on a hinge at the node
inline constexpr int amplitudes = 2;
inline constexpr int all = rigid + amplitudes;

inline mechanics::flexible_data data_of(const lumped::body& b) {
  const auto read = kanexpr::flexible::read_sid_text(lumped::sid_text(b, lumped::fembs));
  EXPECT_TRUE(read) << read.cause();
  return read.data;
}

enum class kind { of_data, of_particles };

/// A frame that moves freely, with coordinates for a hinge and for the amplitudes of a body.
struct vehicle_base : builder {
  std::vector<expression> q, u;
  VectorXd q_now, u_now, udot_now;
  frame_id axes{};
  point_id at{};

  vehicle_base() : builder("N") {
    for (int i = 0; i < all; ++i) {
      q.push_back(coordinate("q" + std::to_string(i)));
      u.push_back(speed("u" + std::to_string(i)));
      kinematic_equation(dot(q.back()) - u.back());
    }
    const frame_id n = inertial_frame();
    axes = body_fixed("B", n, "xyz", q[3], q[4], q[5]);
    at = offset("A", origin("O"), along(n, q[0], q[1], q[2]));
    const frame_id wheel = rotated("W", n, q[6], along(n, 1, 0, 0));
    rigid_body("Wheel", origin("O2"), wheel, number(0.1), inertia(wheel, 0.1, 0.2, 0.3));
  }
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  const expression& amplitude(int k) const { return q[index(rigid + k)]; }

  void draw(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-1, 1);
    for (VectorXd* v : {&q_now, &u_now, &udot_now})
      *v = VectorXd::NullaryExpr(all, [&] { return between(random); });
  }

  void draw_undeformed(unsigned seed) {
    draw(seed);
    for (VectorXd* v : {&q_now, &u_now, &udot_now}) v->tail(amplitudes).setZero();
  }

  MatrixXd numbers(const kanexpr::symbolic::matrix& wanted) {
    const auto value_of = [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      if (l.from == symbol_kind::coordinate) return q_now[l.position];
      if (l.from == symbol_kind::speed) return u_now[l.position];
      if (l.from == symbol_kind::speed_rate) return udot_now[l.position];
      return std::numeric_limits<double>::quiet_NaN();
    };
    return numbers_of(wanted, value_of);
  }
};

/// A free body that carries a rigid body on a hinge at its node.
struct vehicle : vehicle_base {
  explicit vehicle(const mechanics::flexible_data& data) {
    carry(node("Node", flexible_body("Panel", at, axes, {amplitude(0), amplitude(1)}, data), "12"));
  }
  vehicle(const lumped::body& b, kind how) {
    if (how == kind::of_particles)
      carry(b.rotates() ? add_rigid_bodies(b) : add_particles(b));
    else
      carry(node("Node", flexible_body("Panel", at, axes, {amplitude(0), amplitude(1)}, data_of(b)), "12"));
  }

private:
  void carry(const kanexpr::runtime::section_ids& on) {
    const frame_id load = rotated("L", on.frame, q[6], along(on.frame, 0.6, 0, 0.8));
    rigid_body("Load", offset("C", on.point, along(load, 0.3, 0.1, -0.2)), load, number(0.8),
               inertia(load, 0.3, 0.4, 0.5, 0.02, 0, 0));
    gravity(along(inertial_frame(), 0.3, -9.81, 1));
  }

  kanexpr::runtime::section_ids add_particles(const lumped::body& b) {
    point_id last{};
    for (std::size_t i = 0; i < b.particles.size(); ++i) {
      last = offset("P" + std::to_string(i), at, position_from_reference(b.particles[i]));
      particle("P" + std::to_string(i), last, number(b.particles[i].mass));
    }
    add_energy(b);
    const frame_id turned = turned_by("Turned", b.turns, {});
    mechanics::matrix3 cosines;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) cosines(i, j) = number(b.axes(i, j));
    return {direction_cosines("Node", turned, cosines), last};
  }
  void add_energy(const lumped::body& b) {
    expression energy = number(0.0);
    for (int k = 0; k < amplitudes; ++k)
      for (int l = 0; l < amplitudes; ++l)
        energy += number(b.stiffness(k, l) / 2) * (amplitude(k) * amplitude(l));
    potential_energy(energy);
  }
  /// A frame that is rotated by the vector Σ turn_k q_k + ½ Σ bend_kl q_k q_l.
  frame_id turned_by(const std::string& called, const std::vector<Vector3d>& turns,
                     const std::vector<Vector3d>& bends) {
    expression s[3]{number(0.0), number(0.0), number(0.0)};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < amplitudes; ++k) {
        s[i] += number(turns[index(k)][i] / 4) * amplitude(k);
        for (int l = 0; l < amplitudes && !bends.empty(); ++l)
          s[i] += number(bends[index(k * amplitudes + l)][i] / 8) * (amplitude(k) * amplitude(l));
      }
    return modified_rodrigues(called, axes, s[0], s[1], s[2]);
  }
  kanexpr::runtime::section_ids add_rigid_bodies(const lumped::body& b) {
    kanexpr::runtime::section_ids last{};
    for (const lumped::particle& p : b.particles) {
      const std::string called = "R" + std::to_string(&p - b.particles.data());
      last.point = offset(called, at, position_from_reference(p));
      last.frame = turned_by(called, p.turn, p.turn_bend);
      const Eigen::Matrix3d& i = p.inertia;
      rigid_body(called, last.point, last.frame, number(p.mass),
                 inertia(last.frame, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(1, 2), i(2, 0)));
    }
    add_energy(b);
    return last;
  }

  mechanics::vector position_from_reference(const lumped::particle& p) {
    expression r[3]{number(0.0), number(0.0), number(0.0)};
    for (int i = 0; i < 3; ++i) {
      r[i] += number(p.place[i]);
      for (int k = 0; k < amplitudes; ++k) {
        r[i] += number(p.shape_of(k)[i]) * amplitude(k);
        for (int l = 0; l < amplitudes; ++l)
          r[i] += number(p.bend_of(k, l)[i] / 2) * (amplitude(k) * amplitude(l));
      }
    }
    return along(axes, r[0], r[1], r[2]);
  }
};

inline void expect_equal(const MatrixXd& found, const MatrixXd& expected, const std::string& what) {
  ASSERT_EQ(found.rows(), expected.rows());
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-12 * (1 + expected.cwiseAbs().maxCoeff()))
      << what << "\nfound\n"
      << found << "\nexpected\n"
      << expected;
}

/// The derivatives of the equations with respect to the amplitudes and their rates.
inline kanexpr::symbolic::matrix derivatives(vehicle_base& of) {
  mechanics::equations equations(of.system());
  const kanexpr::symbolic::matrix residual = equations.get(quantity::inverse_dynamics);
  kanexpr::symbolic::matrix by(of.graph(), all, 2 * amplitudes);
  for (int i = 0; i < all; ++i)
    for (int k = 0; k < amplitudes; ++k) {
      const std::size_t symbol = static_cast<std::size_t>(rigid + k);
      by(i, k) = kanexpr::symbolic::differentiate(residual.entries[i], of.q[symbol]);
      by(i, amplitudes + k) = kanexpr::symbolic::differentiate(residual.entries[i], of.u[symbol]);
    }
  return by;
}

} // namespace vehicles
