#pragma once

#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

// Random choices that are the same with every standard library.
class dice {
public:
  explicit dice(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  bool chance(double probability) { return between(0, 1) < probability; }
  int whole(int low, int high) { return low + static_cast<int>(between(0, high - low + 1)); }
  template <class T>
  T pick(std::initializer_list<T> from) {
    return from.begin()[whole(0, static_cast<int>(from.size()) - 1)];
  }
  template <class T>
  void shuffle(std::vector<T>& all) {
    for (std::size_t i = all.size(); i > 1; --i)
      std::swap(all[i - 1], all[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
  }

private:
  std::mt19937 engine_;
};
