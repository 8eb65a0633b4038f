// What with_scipy.py compares: milliseconds of simulating the bicycle (the fastest of 101 runs), evaluations
// of ẋ, the parameters, and the states at both ends of the time span. Words are separated by tabs.
#include "motions.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>

namespace {

using motion = motions::bicycle;
using System = motion::System;

auto run() { return kanexpr::simulate<System>(motion::start(), motion::parameters(), motion::span); }

double milliseconds() {
  double least = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 101; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    [[maybe_unused]] const auto result = run();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  return least;
}

void print_parameters() {
  const auto& values = System::record.values;
  for (int i = 0; i < values.size; ++i) {
    const kanexpr::describe::token* const equation = values[i].tokens; // parameter, number, subtract
    std::printf("parameter\t%s\t%.17g\n", std::string(equation[0].symbol->called.view()).c_str(),
                equation[1].number.value());
  }
}

void print(const char* what, const kanexpr::sample<System>& at) {
  const auto& known = kanexpr::compiled::survey_of<System>;
  for (int i = 0; i < at.x.size(); ++i)
    std::printf("%s\t%s\t%.17g\n", what, std::string(known.names[i].view()).c_str(), at.x(i));
}

} // namespace

int main() {
  const auto result = run();
  if (!result) {
    std::fprintf(stderr, "%s\n", result.cause().c_str());
    return 1;
  }
  std::printf("milliseconds\t%.3f\n", milliseconds());
  std::printf("evaluations\t%ld\n", result.statistics.rate_evaluations);
  std::printf("time\t%.17g\n", motion::span.to);
  print_parameters();
  print("start", result.trajectory.front());
  print("end", result.trajectory.back());
}
