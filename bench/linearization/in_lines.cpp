// What with_sympy.py compares, for the system that is named: milliseconds from the start to A and B (the
// median of 21 runs), the operating point, and the rows of A and B. Words are separated by tabs.
#include "systems.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <variant>

namespace {

template <class Case>
double milliseconds(const kanexpr::linearization_point& at) {
  std::vector<double> times(21);
  for (double& time : times) {
    const auto start = std::chrono::steady_clock::now();
    linearized::from_the_start<Case>(at);
    time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  std::ranges::nth_element(times, times.begin() + 10);
  return times[10];
}

void print(const char* name, const Eigen::MatrixXd& m) {
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    std::printf("%s", name);
    for (Eigen::Index j = 0; j < m.cols(); ++j) std::printf("\t%.17g", m(i, j));
    std::printf("\n");
  }
}

template <class Case>
int report() {
  const kanexpr::linearization_point at = Case::point();
  std::printf("milliseconds\t%.2f\n", milliseconds<Case>(at));
  for (const auto& e : at.entries())
    std::printf("point\t%s\t%.17g\n", e.what.name().c_str(),
                std::get<kanexpr::symbolic::number>(e.value.held()).value());
  const linearized::result found = linearized::from_the_start<Case>(at);
  print("A", found.A);
  print("B", found.B);
  for (const std::string& failure : found.failures) std::fprintf(stderr, "%s\n", failure.c_str());
  return found.failures.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  const std::string_view wanted = argc == 2 ? argv[1] : "";
  if (wanted == linearized::bicycle::name) return report<linearized::bicycle>();
  if (wanted == linearized::cart::name) return report<linearized::cart>();
  if (wanted == linearized::arm::name) return report<linearized::arm>();
  std::fprintf(stderr, "usage: %s bicycle|cart|arm\n", argv[0]);
  return 2;
}
