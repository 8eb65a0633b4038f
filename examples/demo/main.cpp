#include "demo/parts.hpp"
#include "demo/time_of.hpp"
#include "models/iiwa.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/symbolic.hpp>

#include <cstdio>
#include <fstream>
#include <string>

/// Two systems from their types to numbers: what the compiler derived, what it costs, and the same derivation
/// while the program runs.
namespace {

using namespace kanexpr;

bool print_numbers(const demo::compiled& c, double tolerance) {
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
void print_times(const demo::compiled& c, const char* file) {
  print_cost("mass matrix and forcing", c.mass_matrix_and_forcing);
  print_cost("u'", c.udot_cost);
  const auto start = std::chrono::steady_clock::now();
  auto derived = derive<System>();
  const symbolic::matrix udot = derived.udot();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  auto interpreted = derived.function(udot);
  const state<System> x = state<System>::Constant(0.3);
  const double time = demo::time_of(x, [&](const state<System>& at) -> decltype(auto) {
    return interpreted(at, parameter_values<System>::Ones(), input_values<System>::Ones());
  });
  std::printf("  one evaluation of u'       %.0f ns compiled; derived at run time in %.2f ms and interpreted "
              "%.0f ns: "
              "%.1f times\n",
              c.nanoseconds, taken.count(), time, time / c.nanoseconds);
  print_compile_time(file);
}

bool show_rolling_disc() {
  std::printf("A disc that rolls without slipping: three speeds; symbols r, m, g\n");
  auto derived = derive<rolling_disc::System>();
  std::printf("\nvelocity of the mass centre: %s\n",
              derived.print(derived.vector<velocity_of<rolling_disc::Dmc>>()).c_str());
  std::printf("\nmass matrix\n%s\n", symbolic::print(derived.mass_matrix()).c_str());
  std::printf("\nforcing\n%s\n", symbolic::print(derived.forcing()).c_str());
  const demo::compiled c = demo::compiled_rolling_disc();
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
  const demo::compiled c = demo::compiled_iiwa();
  const bool right = print_numbers(c, 1e-11);
  print_times<iiwa::System>(c, "iiwa.cpp");
  return right;
}

} // namespace

int main() {
  const bool disc = show_rolling_disc();
  const bool arm = show_iiwa();
  return disc && arm ? 0 : 1;
}
