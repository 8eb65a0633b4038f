#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

/// Times of work that takes turns with other work, so that other programs disturb all of it.
namespace timing {

struct taken {
  double wall = 0, processor = 0; // s
};

template <class Work>
taken time_of(const Work& work) {
  const auto processor = [] {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const double before = processor();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), processor() - before};
}

/// Printed as the median and, after it, the quartiles.
struct spread {
  std::vector<double> all{};
  void print(const char* what, const char* unit = "") {
    std::ranges::sort(all);
    std::printf("%s\t%.4g%s\t(%.4g to %.4g)\n", what, all[all.size() / 2], unit, all[all.size() / 4],
                all[all.size() * 3 / 4]);
    std::fflush(stdout);
  }
};

inline void print_load() {
  if (double load[3]; getloadavg(load, 3) == 3) std::printf("load of the machine before\t%.1f\n", load[0]);
}

[[noreturn]] inline void give_up(const std::string& cause) {
  std::fprintf(stderr, "%s\n", cause.c_str());
  std::exit(1);
}

} // namespace timing
