#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::animate {

/// The placement of a shape at one time, in inertial axes.
struct placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero(); ///< second point of a shape between two points; the vector
                                                 ///< of an arrow
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity(); ///< its columns are the shape's axes
};

/// The parts of a placement that a shape uses.
enum class placement_kind : unsigned char {
  place, ///< a point
  ends,  ///< two points
  pose,  ///< a point and an orientation
};

} // namespace kanexpr::animate

namespace kanexpr {

/// The shapes of a picture along a trajectory, or the reason why there are none.
struct animation {
  struct shape {
    std::string name{}, kind{}; ///< the name and the kind of shape or element, such as "sphere" or "trace"
    std::string colour{};       ///< "#rrggbb"; if empty, the page chooses a colour
    std::string profile{};      ///< the kind of cross section of a sweep or cable, such as "circle"
    std::string file{};         ///< the mesh file, as specified in the picture
    std::string layer{};        ///< the switch of the page that shows it; if empty, it is always shown
    std::string unit{};         ///< the unit of the vector of an arrow
    double opacity = 1;
    std::vector<double> sizes{};
    animate::placement_kind placed_by = animate::placement_kind::place;
    std::size_t places = 1; ///< the number of placements at each time; a sweep or cable has several
    std::vector<std::size_t> straight_parts{};    ///< of a cable; part i is between the places i and i + 1
    std::vector<animate::placement> placements{}; ///< at the first time, then at the second, and so on
    /// The placements if no flexible body were deformed; empty if they are the same.
    std::vector<animate::placement> undeformed{};

    const animate::placement& placement_at(std::size_t time, std::size_t place = 0) const {
      return placements[time * places + place];
    }
  };
  /// The values of a coordinate, a speed, an input or another scalar at each time.
  struct column {
    std::string name{};
    std::vector<double> values{};
    std::string group{}; ///< such as "Coordinates"
    std::string unit{};  ///< as given by the picture or the model; empty if it is unknown
  };

  std::string system{}; ///< the name of the system, which is the default title of a page
  std::vector<double> times{};
  std::vector<shape> shapes{};
  std::vector<column> columns{};
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> seen_from{};
  std::optional<double> ground{};
  bool carried = false;
  std::string folder{}; ///< the folder for relative file names; if empty, the current folder
  std::string failure{};

  explicit operator bool() const { return failure.empty(); }
  /// Why there is no animation, as a sentence; empty if there is an animation.
  std::string cause() const { return failure; }

  const shape* find(std::string_view name) const {
    for (const shape& s : shapes)
      if (s.name == name) return &s;
    return nullptr;
  }
};

/// One of several runs that a page shows together: `{"pushed", animated<swing>(run.trajectory)}`.
struct named_animation {
  std::string name{};
  animation motion{};
};

} // namespace kanexpr
