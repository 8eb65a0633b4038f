#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace kanexpr::exporting {

/// The text of a template file, which is a raw string: all lines between its first, R"(, and its end.
constexpr std::string_view template_text(std::string_view file) {
  file.remove_prefix(1); // the line break after R"(
  return file;
}

/// Returns the part of a template file that follows the line `@@@ name`.
inline std::string_view template_part(std::string_view file, std::string_view name) {
  const std::string line = "@@@ " + std::string(name) + '\n';
  file.remove_prefix(file.find(line) + line.size());
  return file.substr(0, file.find("@@@ "));
}

/// Replaces each `@name@` in a text by its meaning.
inline std::string fill_template(std::string_view text,
                                 std::initializer_list<std::pair<std::string_view, std::string>> meanings) {
  std::string all;
  while (!text.empty()) {
    const std::size_t begin = text.find('@');
    all += text.substr(0, begin);
    if (begin == text.npos) break;
    const std::size_t end = text.find('@', begin + 1);
    const std::string_view name = text.substr(begin + 1, end - begin - 1);
    for (const auto& [called, meaning] : meanings)
      if (called == name) all += meaning;
    text.remove_prefix(end + 1);
  }
  return all;
}

} // namespace kanexpr::exporting
