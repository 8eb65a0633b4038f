#pragma once

#include <algorithm>
#include <string>

namespace demo {

/// Breaks an equation into lines of at most 100 columns, before a sum's terms where possible.
inline std::string wrapped(std::string text, std::size_t indent) {
  constexpr std::size_t columns = 100;
  std::string lines;
  while (text.size() > columns) {
    std::size_t at = std::max(text.rfind(" + ", columns - 1), text.rfind(" - ", columns - 1));
    if (at == std::string::npos || at <= indent) at = text.rfind('*', columns - 1);
    if (at == std::string::npos || at <= indent) break;
    lines += text.substr(0, at) + '\n';
    text = std::string(indent, ' ') + text.substr(text[at] == ' ' ? at + 1 : at);
  }
  return lines + text + '\n';
}

} // namespace demo
