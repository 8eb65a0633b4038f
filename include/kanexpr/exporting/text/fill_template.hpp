#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// Returns the text of a template file, a raw string: all lines between the first, R"(, and the last.
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

/// Joins the texts of the entries, separated by `between`.
template <class Entries, class TextOf>
std::string joined(const Entries& all, std::string_view between, const TextOf& text_of) {
  std::string whole;
  std::string_view before;
  for (const auto& each : all) {
    whole.append(before).append(text_of(each));
    before = between;
  }
  return whole;
}
inline std::string joined(const std::vector<int>& all, std::string_view between) {
  return joined(all, between, [](int each) { return std::to_string(each); });
}

/// Replaces each `@name@` in a text by its value.
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
