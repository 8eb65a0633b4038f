#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/recorded_poses.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::animate {

/// The shapes of a default picture, each with its placement at every sample of a motion.
class placed_shapes {
public:
  explicit placed_shapes(const recorded_poses& poses) : poses_(poses) {}

  static constexpr std::string_view grey = "#8f979e", dark = "#565e66", of_springs = "#5d8a66";

  const std::vector<animation::shape>& all() const { return all_; }
  std::vector<animation::shape> take() { return std::move(all_); }

  /// Adds a shape that has its placements.
  void add(animation::shape s) { all_.push_back(std::move(s)); }
  void add(animation::shape s, const auto& placement_at) {
    for (std::size_t k = 0; k < poses_.samples(); ++k) s.placements.push_back(placement_at(k));
    add(std::move(s));
  }
  void add_between(std::string name, std::string kind, std::string colour, std::vector<double> sizes,
                   int from, int to) {
    add({.name = std::move(name),
         .kind = std::move(kind),
         .colour = std::move(colour),
         .sizes = std::move(sizes),
         .placed_by = placement_kind::ends},
        [&](std::size_t k) {
          return placement{.position = poses_.place(from, k), .end = poses_.place(to, k)};
        });
  }
  void add_sphere(std::string name, std::string colour, double radius, int at) {
    add({.name = std::move(name), .kind = "sphere", .colour = std::move(colour), .sizes = {radius}},
        [&](std::size_t k) { return placement{.position = poses_.place(at, k)}; });
  }
  /// Adds a solid whose axes are constant in a frame.
  void add_solid(std::string name, std::string kind, std::string colour, std::vector<double> sizes, int at,
                 int frame, const Eigen::Matrix3d& axes) {
    add({.name = std::move(name),
         .kind = std::move(kind),
         .colour = std::move(colour),
         .sizes = std::move(sizes),
         .placed_by = placement_kind::pose},
        [&](std::size_t k) {
          return placement{.position = poses_.place(at, k), .orientation = poses_.frame(frame, k) * axes};
        });
  }

private:
  const recorded_poses& poses_;
  std::vector<animation::shape> all_{};
};

} // namespace kanexpr::animate
