#pragma once

#include "flexible/lumped_body.hpp"

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/building/beam_data.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace lumped {

/// A cantilever as particles at Gauss points, whose data are the exact integrals of a beam with polynomial
/// shapes, and a massless particle at the tip. It bends by the powers `first` along y and `second` along z.
struct beam_of_particles {
  double length = 1.3, mass_per_length = 1.5;
  std::vector<int> first{}, second{};

  lumped::body with_stiffness(double stiffness) const {
    using rule = boost::math::quadrature::gauss<double, 9>;
    lumped::body b;
    b.amplitudes = static_cast<int>(first.size() + second.size());
    for (std::size_t i = 0; i < rule::abscissa().size(); ++i)
      for (const double sign : {-1.0, 1.0}) {
        if (i == 0 && sign > 0) continue;
        const double x = length / 2 * (1 + sign * rule::abscissa()[i]);
        b.particles.push_back(particle_at(x, rule::weights()[i] * length / 2 * mass_per_length));
      }
    b.particles.push_back(particle_at(length, 0));
    add_turns(b);
    b.stiffness.setZero(b.amplitudes, b.amplitudes), b.damping = b.stiffness;
    for (int k = 0; k < b.amplitudes; ++k)
      for (int l = 0; l < b.amplitudes; ++l) {
        const int powers = power(k) + power(l) - 3;
        if (is_first(k) == is_first(l))
          b.stiffness(k, l) = stiffness * power(k) * (power(k) - 1) * power(l) * (power(l) - 1) *
                              std::pow(length, powers) / powers;
      }
    return b;
  }

private:
  bool is_first(int k) const { return k < static_cast<int>(first.size()); }
  int power(int k) const {
    const auto place = static_cast<std::size_t>(k);
    return is_first(k) ? first[place] : second[place - first.size()];
  }
  double slope(int k) const { return power(k) * std::pow(length, power(k) - 1); }

  particle particle_at(double x, double mass) const {
    particle p{.mass = mass, .place = {x, 0, 0}};
    const int n = static_cast<int>(first.size() + second.size());
    for (int k = 0; k < n; ++k)
      p.shape.push_back((is_first(k) ? Vector3d::UnitY() : Vector3d::UnitZ()) * std::pow(x, power(k)));
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < n; ++l) {
        const int powers = power(k) + power(l) - 1;
        const double shortening = power(k) * power(l) * std::pow(x, powers) / powers;
        p.bend.emplace_back(is_first(k) == is_first(l) ? -shortening : 0, 0, 0);
      }
    return p;
  }
  /// The rotation of the tip: the slopes v' about z and −w' about y, their product, and −∫ v'' w' dx about x.
  void add_turns(lumped::body& b) const {
    for (int k = 0; k < b.amplitudes; ++k)
      b.turns.push_back(is_first(k) ? Vector3d(0, 0, slope(k)) : Vector3d(0, -slope(k), 0));
    for (int k = 0; k < b.amplitudes; ++k)
      for (int l = 0; l < b.amplitudes; ++l) {
        const int v = is_first(k) ? k : l, w = is_first(k) ? l : k, powers = power(v) + power(w) - 2;
        const double twist = power(v) * (power(v) - 1) * power(w) * std::pow(length, powers) / powers;
        b.turn_bends.emplace_back(is_first(k) == is_first(l) ? 0 : slope(v) * slope(w) / 2 - twist, 0, 0);
      }
  }
};

inline kanexpr::runtime::beam_data beam_data_of(kanexpr::runtime::builder& b, const beam_of_particles& by,
                                                kanexpr::runtime::frame_id in, double stiffness) {
  const auto shapes = [](const std::vector<int>& powers, double length) {
    std::vector<kanexpr::numeric::beams::shape> all;
    for (const int power : powers) {
      kanexpr::base::sequence<double> coefficients(power + 1, 0.0);
      coefficients[power] = std::pow(length, power);
      all.push_back(kanexpr::numeric::beams::shape::polynomial(coefficients));
    }
    return all;
  };
  kanexpr::runtime::beam_data data{
      .axis = b.along(in, 1, 0, 0), .length = by.length, .mass_per_length = by.mass_per_length};
  data.bending = {{b.along(in, 0, 1, 0), {.stiffness = stiffness, .shapes = shapes(by.first, by.length)}}};
  if (!by.second.empty())
    data.bending.push_back(
        {b.along(in, 0, 0, 1), {.stiffness = stiffness, .shapes = shapes(by.second, by.length)}});
  return data;
}

} // namespace lumped
