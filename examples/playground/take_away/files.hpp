#pragma once

#include <string>
#include <vector>

namespace playground {

/// Files to take away, or the reason why there are none.
struct files {
  struct file {
    std::string path{}, text{};
  };
  std::vector<file> all{};
  std::string mistake{};
};

} // namespace playground
