#pragma once

#include <kanexpr/animate/animation.hpp>

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Sweeps and cables whose volumes and extents are known in closed form. At the times 0, 1 and 2 they are
/// straight, bent to an arc of 1 radian and bent to an arc of 2.5 radians; their length is 1.
namespace tests {

inline constexpr double angles_of_arcs[]{0, 1, 2.5};

/// A place on the arc in the xz plane that begins along x; the x axis of the profile is rotated from y by
/// `twist` about the arc.
inline kanexpr::animate::placement place_on_arc(double angle, double part, double twist) {
  const double turned = angle * part;
  kanexpr::animate::placement here;
  here.position = angle > 0 ? Eigen::Vector3d(std::sin(turned), 0, 1 - std::cos(turned)) / angle
                            : Eigen::Vector3d(part, 0, 0);
  const Eigen::Vector3d tangent(std::cos(turned), 0, std::sin(turned)),
      inward(-std::sin(turned), 0, std::cos(turned));
  here.orientation.col(0) = std::cos(twist) * Eigen::Vector3d::UnitY() + std::sin(twist) * inward;
  here.orientation.col(1) = tangent.cross(here.orientation.col(0));
  here.orientation.col(2) = tangent;
  return here;
}

struct swept_shapes {
  kanexpr::animation animation{};
  nlohmann::json expected = nlohmann::json::array(); ///< by shape: its volume, and its extent at each time

  swept_shapes() {
    constexpr double of_circle = 0.01 * sides_of_circle; // area, radius 0.1
    add("cable", "circle", {0.1}, 5, 0, of_circle, true);
    add("sweep", "circle", {0.1}, 5, 0, of_circle, true);
    add("sweep", "circle", {0.1, 0.04}, 5, 0, sides_of_circle * (0.01 + 0.004 + 0.0016) / 3, false);
    add("sweep", "rectangle", {0.2, 0.05}, 9, 0, 0.01, false);
    add("sweep", "rectangle", {0.2, 0.05, 0.2, 0.05}, 9, 0.7, 0.01, false);
    expected.back()["extents"].push_back(extent_of_twisted_bar());
    expected.back()["unevenness"] = 0.012; // triangles on twisted faces
    add("sweep", "i_section", {0.2, 0.1, 0.02}, 9, 0, 2 * 0.2 * 0.02 + 0.06 * 0.02, false);
    add("sweep", "airfoil", {0.3, 0.05}, 9, 0, 0.3 * 0.05 * of_airfoil, false);
    expected.back()["unevenness"] = 0.005; // a polygon with 40 corners
    add_taut();
    animation.times = {0, 1, 2};
    animation.up = Eigen::Vector3d::UnitZ();
  }

private:
  /// The area of a polygon with 24 corners on the unit circle.
  static constexpr double sides_of_circle = 12 * 0.25881904510252074; // 12 sin 15°
  /// The area of a NACA four-digit airfoil with a closed edge, per chord and thickness.
  static constexpr double of_airfoil =
      10 * (0.2969 * 2 / 3 - 0.126 / 2 - 0.3516 / 3 + 0.2843 / 4 - 0.1036 / 5);

  void add(const std::string& kind, const std::string& profile, std::vector<double> sizes, std::size_t places,
           double twist, double volume, bool is_round) {
    kanexpr::animation::shape s;
    s.name = kind + ' ' + profile + ' ' + std::to_string(sizes.size());
    s.kind = kind, s.profile = profile, s.sizes = std::move(sizes), s.places = places;
    s.placed_by =
        kind == "cable" ? kanexpr::animate::placement_kind::place : kanexpr::animate::placement_kind::pose;
    nlohmann::json one{{"name", s.name}, {"volume", volume}, {"extents", nlohmann::json::array()}};
    for (const double angle : angles_of_arcs) {
      for (std::size_t i = 0; i < places; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(places - 1);
        s.placements.push_back(place_on_arc(angle, part, twist * part));
      }
      if (is_round) one["extents"].push_back(extent_of_arc(angle, s.sizes[0]));
    }
    animation.shapes.push_back(std::move(s));
    expected.push_back(one);
  }

  /// A cable with a corner: two straight parts, a quarter of a circle, and another straight part.
  void add_taut() {
    using Eigen::Vector3d;
    kanexpr::animation::shape s{.name = "taut cable", .kind = "cable", .profile = "circle", .sizes = {0.02}};
    std::vector<Vector3d> places{{0, 0, 1}, {0, 0, 0}, {1, 0, 0}};
    for (int i = 1; i <= 4; ++i) {
      const double turned = i * std::numbers::pi / 8;
      places.emplace_back(1 + 0.5 * std::sin(turned), 0, 0.5 * (1 - std::cos(turned)));
    }
    places.emplace_back(1.5, 0, 1.5);
    s.places = places.size(), s.straight_parts = {0, 1, 6};
    for (std::size_t k = 0; k < std::size(angles_of_arcs); ++k)
      for (const Vector3d& place : places) s.placements.push_back({.position = place});
    const double length = 3 + std::numbers::pi / 4;
    const nlohmann::json extent{{"least", {-0.02, -0.02, -0.02}}, {"most", {1.52, 0.02, 1.5}}};
    expected.push_back({{"name", s.name},
                        {"volume", 0.0004 * sides_of_circle * length},
                        {"extents", {extent, extent, extent}},
                        {"unevenness", 0.03}}); // it is thinner near the corner
    animation.shapes.push_back(std::move(s));
  }

  /// The extent of the straight bar with edges 0.2 and 0.05, twisted by 0.7.
  static nlohmann::json extent_of_twisted_bar() {
    const double widest = std::hypot(0.1, 0.025), highest = 0.1 * std::sin(0.7) + 0.025 * std::cos(0.7);
    return {{"least", {0, -widest, -highest}}, {"most", {1, widest, highest}}};
  }

  /// The extent of a bent circular cylinder, of angles from 0 to π.
  static nlohmann::json extent_of_arc(double angle, double r) {
    if (!(angle > 0)) return {{"least", {0, -r, -r}}, {"most", {1, r, r}}};
    const double inner = 1 / angle - r, outer = 1 / angle + r, cosine = std::cos(angle);
    const double reach = angle < std::numbers::pi / 2 ? std::sin(angle) : 1;
    return {{"least", {0, -r, -r}},
            {"most", {outer * reach, r, 1 / angle - (cosine > 0 ? inner : outer) * cosine}}};
  }
};

/// A turning beam of length 1 that bends by x² q1 + x³ q2, with the axes of a station near its tip.
inline kanexpr::animation bent_beam() {
  using kanexpr::animate::placement;
  kanexpr::animation made;
  made.up = Eigen::Vector3d::UnitZ();
  kanexpr::animation::shape beam{
      .name = "beam", .kind = "sweep", .profile = "rectangle", .sizes = {0.1, 0.02}, .places = 9};
  kanexpr::animation::shape axes{.name = "station", .kind = "axes", .sizes = {0.2}};
  beam.placed_by = axes.placed_by = kanexpr::animate::placement_kind::pose;
  for (int k = 0; k <= 40; ++k) {
    const double t = 0.05 * k, q1 = 0.2 * std::sin(3 * t), q2 = 0.1 * std::cos(8 * t);
    const Eigen::Matrix3d root = Eigen::AngleAxisd(0.9 * t, Eigen::Vector3d(1, 2, 2) / 3).matrix();
    made.times.push_back(t);
    for (int i = 0; i < 9; ++i) {
      const double x = i / 8.0, slope = 2 * x * q1 + 3 * x * x * q2;
      const Eigen::Vector3d place(x, x * x * (q1 + x * q2), 0), tangent(std::cos(slope), std::sin(slope), 0);
      placement here{.position = root * place + Eigen::Vector3d(t, 0, 0)};
      here.orientation.col(0) = root.col(2);
      here.orientation.col(2) = root * tangent;
      here.orientation.col(1) = here.orientation.col(2).cross(here.orientation.col(0));
      placement straight{.position = root * Eigen::Vector3d(x, 0, 0) + Eigen::Vector3d(t, 0, 0)};
      straight.orientation.col(0) = root.col(2);
      straight.orientation.col(2) = root.col(0);
      straight.orientation.col(1) = root.col(1);
      beam.placements.push_back(here), beam.undeformed.push_back(straight);
      if (i == 7) axes.placements.push_back(here), axes.undeformed.push_back(straight);
    }
  }
  made.shapes = {beam, axes};
  return made;
}

} // namespace tests
