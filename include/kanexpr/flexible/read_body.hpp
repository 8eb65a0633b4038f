#pragma once

#include <kanexpr/base/file_text.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <optional>
#include <string>
#include <vector>

namespace kanexpr::flexible {

/// The numbers of a flexible body, or the reason why they could not be read: "line 12 of panel.SID_FEM: the
/// mass: expected a finite number, got …".
struct [[nodiscard]] read_body : outcome {
  using outcome::outcome;

  mechanics::flexible_data data{};
  /// Sentences about contents that were ignored or completed.
  std::vector<std::string> notes{};
};

/// Reads a file with a function that takes its text and its name.
template <class Read>
read_body read_file(const std::string& path, const Read& read) {
  const std::optional<std::string> text = base::text_of(path);
  if (!text) return read_body(path + " cannot be read");
  return read(*text, path.substr(path.rfind('/') + 1));
}

} // namespace kanexpr::flexible
