#include <chrono>

/// Nanoseconds of one call, the mean over `turns` through all states, which stand one after another.
extern "C" double nanoseconds(void (*call)(const double*, double*), const double* states, int count,
                              int width, double* result, int turns) {
  const auto start = std::chrono::steady_clock::now();
  for (int turn = 0; turn < turns; ++turn)
    for (int i = 0; i < count; ++i) call(states + i * width, result);
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count() / turns / count;
}
