#include "demo/parts.hpp"
#include "demo/time_of.hpp"
#include "models/bicycle.hpp"
#include "models/iiwa.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/symbolic.hpp>

#include <cstdio>
#include <fstream>

/// Systems from their types to numbers: what the compiler derived, what it costs, and the same derivation
/// while the program runs.
namespace demo {

using namespace kanexpr;

namespace {

bool print_numbers(const compiled& c, double tolerance) {
  const double error = (c.udot - c.reference).cwiseAbs().maxCoeff() / c.reference.cwiseAbs().maxCoeff();
  std::printf("\n  %-6s %20s %20s\n", "", "u', compiled", "u', reference");
  for (Eigen::Index i = 0; i < c.udot.size(); ++i)
    std::printf("  %-6ld %20.12g %20.12g\n", static_cast<long>(i + 1), c.udot(i), c.reference(i));
  std::printf("  largest relative error %.1e\n\n", error);
  return error <= tolerance;
}

void print_cost(const char* what, const symbolic::cost& c) {
  std::printf("  %-26s %3d multiplications, %3d additions, %d divisions, %d sincos\n", what,
              c.multiplications, c.additions, c.divisions, c.trigonometric);
}

/// The compiler's seconds for one file of this program, as the build noted them.
void print_compile_time(const char* file) {
  std::ifstream noted(std::string(KANEXPR_COMPILE_TIMES) + "/" + file + ".seconds");
  std::string seconds;
  if (noted >> seconds)
    std::printf("  the compiler took %s s for %s, of which the headers are about one\n", seconds.c_str(),
                file);
}

template <class System>
void print_times(const compiled& c, const char* file) {
  for (const auto& [what, cost] : c.costs) print_cost(what, cost);
  const auto start = std::chrono::steady_clock::now();
  auto derived = derive<System>();
  const symbolic::matrix rates = derived.udot();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  auto interpreted = derived.function(rates);
  const state<System> x = state<System>::Constant(0.3);
  const double time = time_of(x, [&](const state<System>& at) -> decltype(auto) {
    return interpreted(at, parameter_values<System>::Ones(), input_values<System>::Ones());
  });
  std::printf("  one evaluation             %.0f ns compiled; derived at run time in %.2f ms and interpreted "
              "%.0f ns: %.1f times\n",
              c.nanoseconds, taken.count(), time, time / c.nanoseconds);
  print_compile_time(file);
}

} // namespace

bool show_rolling_disc() {
  std::printf("A disc that rolls without slipping: three speeds; symbols r, m, g\n");
  auto derived = derive<rolling_disc::System>();
  std::printf("\nvelocity of the mass centre: %s\n",
              derived.print(derived.vector<velocity_of<rolling_disc::Dmc>>()).c_str());
  std::printf("\nmass matrix\n%s\n", symbolic::print(derived.mass_matrix()).c_str());
  std::printf("\nforcing\n%s\n", symbolic::print(derived.forcing()).c_str());
  const compiled c = compiled_rolling_disc();
  const bool right = print_numbers(c, 1e-12);
  print_times<rolling_disc::System>(c, "rolling_disc.cpp");
  return right;
}

bool show_iiwa() {
  std::printf("\nKUKA LBR iiwa 14: seven joints; numbers bound in the type\n");
  auto derived = derive<iiwa::System>();
  const symbolic::matrix mass = derived.mass_matrix();
  std::printf("\nlast entries of the mass matrix\n");
  for (int i = 4; i < 7; ++i) std::printf("  M(%d,7) = %s\n", i + 1, symbolic::print(mass(i, 6)).c_str());
  const compiled c = compiled_iiwa();
  const bool right = print_numbers(c, 1e-11);
  print_times<iiwa::System>(c, "iiwa.cpp");
  return right;
}

bool show_bicycle() {
  std::printf(
      "\nA bicycle that nobody steers: two wheels that roll and a loop through the ground, so that three "
      "of six speeds\nfollow from the others; numbers bound in the type\n");
  const compiled c = compiled_bicycle();
  const bool right = print_numbers(c, 1e-11);
  print_times<bicycle::BoundSystem>(c, "bicycle.cpp");
  return right;
}

} // namespace demo
