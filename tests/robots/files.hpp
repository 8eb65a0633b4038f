#pragma once

#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

/// The robots of the tests, in tests/robots/files.
namespace robot_files {

inline std::string path_of(const std::string& file) { return std::string(KANEXPR_ROBOT_FILES) + "/" + file; }

inline std::string text_of(const std::string& file) {
  std::ifstream in(path_of(file), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Files with changed, omitted and repeated bytes: the same number for each robot, the same in every run.
template <class Use>
void each_broken(int of_each, Use&& use) {
  std::mt19937 random(2026);
  const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
  for (const char* file : {"arm.urdf", "carts.urdf", "gripper.urdf", "walker.urdf"}) {
    const std::string whole = text_of(file);
    for (int i = 0; i < of_each; ++i) {
      std::string text = whole;
      for (std::size_t changes = 1 + any(4); changes > 0; --changes) {
        const std::size_t at = any(text.size()), length = 1 + any(40);
        switch (any(4)) {
        case 0: text[at] = static_cast<char>(any(256)); break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(any(text.size()), text.substr(at, length)); break;
        default: text[at] = "0123456789-.e,<>/\"= "[any(20)];
        }
      }
      use(text);
    }
  }
}

/// Pinocchio's results for a robot at one state, by name: bench/robots/compare_with_pinocchio.py --write.
using reference = std::map<std::string, std::vector<double>>;

inline std::vector<reference> references_of(const std::string& robot) {
  std::vector<reference> all;
  std::istringstream in(text_of(robot + ".txt"));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "state") all.emplace_back();
    std::vector<double>& numbers = all.back()[what];
    for (double x; words >> x;) numbers.push_back(x);
  }
  return all;
}

} // namespace robot_files
