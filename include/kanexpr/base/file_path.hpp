#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace kanexpr {

/// The path of a file: a string or a `std::filesystem::path`, whose header is too large to include here.
class file_path {
public:
  template <std::convertible_to<std::string_view> Text>
  file_path(const Text& path) : text_(std::string_view(path)) {}
  template <class Path>
    requires requires(const Path& path) {
      { path.string() } -> std::same_as<std::string>;
    }
  file_path(const Path& path) : text_(path.string()) {}

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

} // namespace kanexpr
