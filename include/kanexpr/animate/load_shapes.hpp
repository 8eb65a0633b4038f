#pragma once

#include <kanexpr/animate/about_axis.hpp>
#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/placed_shapes.hpp>
#include <kanexpr/animate/recorded_poses.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/figures/pathways.hpp>
#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/numeric/taut_line.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace kanexpr::animate {

/// Chooses the shapes of the loads of a model: springs, dampers, cables, and the surfaces around which these
/// are wrapped. All sizes are fractions of `length`.
class load_shapes {
public:
  load_shapes(const mechanics::multibody_system& system, const recorded_poses& poses,
              const figures::geometry& first, double length, placed_shapes& made)
      : system_(system), poses_(poses), first_(first), length_(length), made_(made) {}

  void add_springs();
  void add_pathways();

private:
  /// Whether no load before this one acts along the same line around a surface.
  bool is_first_on_its_line(int load) const {
    const auto line_of = [&](int i) {
      const mechanics::pathway& p = path_loads_[i].along;
      return std::tuple(p.form, p.points[0], p.points.back(), p.center, p.surface.sense);
    };
    for (int i = 0; i < load; ++i)
      if (path_loads_[i].along.is_around_surface() && line_of(i) == line_of(load)) return false;
    return true;
  }
  void add_wrapped_cable(int load);
  std::string name_of_point(int point) const {
    return std::string(system_.mechanism.points[point].called.view());
  }

  const mechanics::multibody_system& system_;
  const recorded_poses& poses_;
  const figures::geometry& first_; ///< the geometry at the first sample
  double length_;
  placed_shapes& made_;
  const base::sequence<mechanics::path_load> path_loads_ = system_.loads.all<mechanics::path_load>();
};

inline void load_shapes::add_springs() {
  for (const mechanics::spring_damper& each : system_.loads.spring_dampers) {
    const std::string ends = " from " + name_of_point(each.point) + " to " + name_of_point(each.against);
    if (!each.stiffness.is_zero())
      made_.add_between("spring" + ends, "coil", std::string(placed_shapes::of_springs), {0.06 * length_, 9},
                        each.point, each.against);
    if (!each.damping.is_zero())
      made_.add_between("damper" + ends, "rod", std::string(placed_shapes::of_springs), {0.018 * length_},
                        each.point, each.against);
  }
}

/// A cable around a surface, and the surface itself.
inline void load_shapes::add_wrapped_cable(int load) {
  const mechanics::pathway& along = path_loads_[load].along;
  numeric::wrapped_surface around = first_.surfaces[static_cast<std::size_t>(load)];
  const Eigen::Vector3d axis = poses_.frame(along.frame, 0).transpose() * around.axis; // in the frame
  const std::string ends = name_of_point(along.points[0]) + " to " + name_of_point(along.points.back());
  animation::shape cable{.name = "cable from " + ends,
                         .kind = "cable",
                         .colour = std::string(placed_shapes::of_springs),
                         .profile = "circle",
                         .sizes = {0.012 * length_}};
  double deepest = 0; // from the tip of a cone, along its axis
  for (std::size_t k = 0; k < poses_.samples(); ++k) {
    around.center = poses_.place(along.center, k), around.axis = poses_.frame(along.frame, k) * axis;
    const numeric::taut_line line =
        figures::line_along(along, around, [&](int point) { return poses_.place(point, k); });
    cable.places = line.places.size(), cable.straight_parts = line.straight_parts;
    for (const Eigen::Vector3d& place : line.places) {
      cable.placements.push_back({.position = place});
      deepest = (std::max)(deepest, around.axis.dot(place - around.center));
    }
  }
  made_.add(std::move(cable));
  const double inside = around.size * 0.97; // so that the cable can be seen
  const std::string name = " of the cable from " + ends;
  if (around.form == numeric::wrapped_solid::sphere)
    made_.add_sphere("sphere" + name, std::string(placed_shapes::grey), inside, along.center);
  else if (around.form == numeric::wrapped_solid::cylinder)
    made_.add_solid("cylinder" + name, "cylinder", std::string(placed_shapes::grey), {inside, around.size},
                    along.center, along.frame,
                    about_axis(axis, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
  else if (deepest > 0)
    made_.add_solid("cone" + name, "cone", std::string(placed_shapes::grey),
                    {1.1 * deepest * std::tan(inside), 1.1 * deepest}, along.center, along.frame,
                    about_axis(axis, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
}

/// Cables and muscles are drawn once, whatever acts along them; of muscles, only those through points.
inline void load_shapes::add_pathways() {
  std::set<std::pair<int, int>> drawn;
  const auto add_segments = [&](const mechanics::pathway& along) {
    if (along.form != mechanics::pathway_form::through_points) return;
    const auto& points = along.points;
    for (int i = 1; i < points.size(); ++i) {
      const std::pair<int, int> ends = std::minmax(points[i - 1], points[i]);
      if (!drawn.insert(ends).second) continue;
      made_.add_between("cable from " + name_of_point(points[i - 1]) + " to " + name_of_point(points[i]),
                        "rod", std::string(placed_shapes::of_springs), {0.012 * length_}, points[i - 1],
                        points[i]);
    }
  };
  for (int n = 0; n < path_loads_.size(); ++n) {
    const mechanics::pathway& along = path_loads_[n].along;
    if (along.is_around_surface() && is_first_on_its_line(n)) add_wrapped_cable(n);
    add_segments(along);
  }
  for (const mechanics::muscle& each : system_.loads.all<mechanics::muscle>()) add_segments(each.along);
}

} // namespace kanexpr::animate
