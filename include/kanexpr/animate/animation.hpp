#pragma once

#include <kanexpr/animate/placement.hpp>

#include <optional>
#include <string>
#include <vector>

namespace kanexpr {

/// The shapes of a picture along a trajectory, or why there are none.
struct animation {
  struct shape {
    std::string name{}, kind{}; ///< the kind is that of the word: "sphere", "trace"
    std::string colour{};       ///< "#rrggbb"; empty: the page chooses
    std::string file{};         ///< of a mesh, as the picture names it
    double opacity = 1;
    std::vector<double> sizes{};
    animate::placing placed_by = animate::placing::place;
    std::vector<animate::placement> placements{}; ///< at each time
  };
  /// A coordinate or speed at each time.
  struct column {
    std::string name;
    std::vector<double> values;
  };

  std::vector<double> times{};
  std::vector<shape> shapes{};
  std::vector<column> columns{};
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> seen_from{};
  std::optional<double> ground{};
  bool carried = false;
  std::string folder{}; ///< where files with relative names are; empty: the current one
  std::string failure{};

  explicit operator bool() const { return failure.empty(); }
  /// Why there is none, as a sentence; empty: there is.
  std::string cause() const { return failure; }

  const shape* find(std::string_view name) const {
    for (const shape& s : shapes)
      if (s.name == name) return &s;
    return nullptr;
  }
};

} // namespace kanexpr
