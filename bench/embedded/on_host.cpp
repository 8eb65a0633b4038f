// on_host SCALAR: compares what a board printed, at the input, with what this machine computes for the same
// points. The reference has more digits than SCALAR; the board may be off by at most four times what this
// machine is off with the same digits, or by eight units of the last place. An entry is judged beside its
// largest value over all points, or a thousandth of the largest of all entries. A loop has to end as its
// program says, too. Prints the error of the board and of this machine, in units of the last place.
#include "points.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <type_traits>

namespace {

template <class T>
using results = std::array<std::array<T, program::found>, embedded::point_count>;

// At the points as T has them.
template <class T, class As>
results<As> computed() {
  static constexpr auto points = embedded::points<program, T>();
  results<As> all{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::array<As, program::given.size()> given{};
    std::copy(points[k].begin(), points[k].end(), given.begin());
    program::run(given.data(), all[k].data());
  }
  return all;
}

// Of the lines of a board; each begins with instructions and bytes of stack.
template <class T>
bool read(results<T>& all) {
  using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  for (auto& line : all) {
    if (std::scanf("%*u %*u") == EOF) return false;
    for (T& entry : line) {
      unsigned long long digits = 0;
      if (std::scanf("%llx", &digits) != 1) return false;
      entry = std::bit_cast<T>(static_cast<bits>(digits));
    }
  }
  return true;
}

template <class Wide>
std::array<Wide, program::found> scales(const results<Wide>& reference) {
  std::array<Wide, program::found> found{};
  for (const auto& line : reference)
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = std::max(found[i], std::abs(line[i]));
  const Wide least = *std::max_element(found.begin(), found.end()) / 1000;
  for (Wide& scale : found) scale = std::max(scale, least);
  return found;
}

// The largest, in units of the last place of T; infinite where something is not a number.
template <class T, class Wide>
double error(const results<T>& all, const results<Wide>& reference) {
  const auto scale = scales(reference);
  double largest = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < program::found; ++i) {
      const Wide off = std::abs(static_cast<Wide>(all[k][i]) - reference[k][i]);
      if (off == 0) continue; // of what is zero everywhere, too
      if (!std::isfinite(off)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, static_cast<double>(off / scale[i] / std::numeric_limits<T>::epsilon()));
    }
  return largest;
}

// Of a program that says what it is to end with.
template <class Program, class T>
bool ends_well(const results<T>& all) {
  if constexpr (requires(const T* found) { Program::is_well(found); })
    return std::all_of(all.begin(), all.end(),
                       [](const auto& line) { return Program::is_well(line.data()); });
  return true;
}

template <class T, class Wide>
int compare() {
  results<T> board{};
  if (!read(board)) return std::fprintf(stderr, "the board did not print all results\n"), 1;
  const results<Wide> reference = computed<T, Wide>();
  const double of_board = error(board, reference), of_host = error(computed<T, T>(), reference);
  std::printf("%.1f\t%.1f\n", of_board, of_host);
  if (!ends_well<program>(board)) return std::fprintf(stderr, "the loop does not end as it should\n"), 1;
  if (std::isfinite(of_host) && of_board <= std::max(4 * of_host, 8.0)) return 0;
  return std::fprintf(stderr, "the board is off by %.1f units of the last place, the host by %.1f\n",
                      of_board, of_host),
         1;
}

} // namespace

int main(int count, char** words) {
  const bool is_float = count == 2 && std::strcmp(words[1], "float") == 0;
  return is_float ? compare<float, double>() : compare<double, long double>();
}
