#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr::symbolic {

/// The number of characters up to which a text repeats a part of an expression wherever it occurs. In a
/// longer text, such parts have names: `z1 + u*z1, where z1 = ...`.
inline constexpr std::size_t longest_text = 10000;

/// The texts of several expressions, and of the parts to which they refer by name.
struct text_with_parts {
  struct part {
    std::string name, text;
  };
  std::vector<std::string> expressions{};
  std::vector<part> parts{}; ///< each follows those to which it refers; empty if the texts are short
};

} // namespace kanexpr::symbolic
