#pragma once

#include <kanexpr/base/sequence.hpp>

namespace kanexpr::derivation {

/// Records which symbols of a list were mentioned, by position.
class symbol_uses {
public:
  constexpr int size() const { return mentioned_.size(); }
  constexpr bool operator[](int place) const { return mentioned_[place] != 0; }
  /// Registers a listed symbol, which may follow unlisted ones.
  constexpr void expect(int place) {
    while (mentioned_.size() < place) mentioned_.push(1);
    mentioned_.push(0);
  }
  constexpr void mark(int place) {
    if (place < mentioned_.size()) mentioned_[place] = 1;
  }

private:
  base::sequence<char> mentioned_{};
};

} // namespace kanexpr::derivation
