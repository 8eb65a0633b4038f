#pragma once

#include <initializer_list>
#include <string_view>

namespace kanexpr::mechanics {

/// A mistake in a model, as one sentence in the words of mechanics that names the entity. Empty: no mistake.
struct problem {
  static constexpr int capacity = 255;
  char letters[capacity + 1]{};
  int length = 0;

  constexpr explicit operator bool() const { return length != 0; }
  constexpr std::string_view view() const { return {letters, static_cast<std::size_t>(length)}; }
};

/// The first mistake is the one that is told; what follows from it would only confuse.
constexpr problem sentence(std::initializer_list<std::string_view> pieces) {
  problem p;
  for (std::string_view piece : pieces)
    for (char letter : piece)
      if (p.length < problem::capacity) p.letters[p.length++] = letter;
  return p;
}

} // namespace kanexpr::mechanics
