#pragma once

#include <string>
#include <vector>

/// The parts of the demo. Each prints what it did and returns whether it is as expected.
namespace demo {

/// Something that the demo wrote to its folder, for the index.
struct exhibit {
  std::string title{}, text{};
  std::string figure{}; ///< a file
  struct link {
    std::string words{}, file{};
  };
  std::vector<link> links{};
};

bool show_double_pendulum();
bool show_rolling_disc();
bool show_iiwa();
bool show_bicycle();

/// These write files to a folder and add them to the index.
bool draw_systems(const std::string& folder, std::vector<exhibit>& all);
bool show_eigenvalues(const std::string& folder, std::vector<exhibit>& all);
bool show_rides(const std::string& folder, std::vector<exhibit>& all);

bool write_index(const std::string& folder, const std::vector<exhibit>& all);

} // namespace demo
