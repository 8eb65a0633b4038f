#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensemble/lock_beside.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>

namespace kanexpr::ensembles {

/// The files that a study writes, each with what stands beside it for a while. No two of them are one.
class taken_names {
public:
  /// `as` is what stands there: "the checkpoint of the study".
  outcome take(const std::string& path, const std::string& as) {
    if (path.empty()) return {}; // whoever writes it says so
    std::error_code none;
    const std::string end = std::filesystem::weakly_canonical(end_of_links(path), none).string();
    for (const char* beside : {"", ".new", ".lock"})
      if (const auto [other, is_free] = taken_.emplace(end + beside, as); !is_free) {
        std::string mistake = path;
        mistake.append(" cannot be ")
            .append(as)
            .append(": ")
            .append(other->second)
            .append(" takes that name");
        return outcome(std::move(mistake));
      }
    return {};
  }

private:
  std::map<std::string, std::string> taken_{};
};

} // namespace kanexpr::ensembles
