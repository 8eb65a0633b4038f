#include "demo/compiled.hpp"
#include "demo/parts.hpp"
#include "demo/time_of.hpp"
#include "demo/wrapped.hpp"
#include "models/bicycle.hpp"
#include "models/double_pendulum.hpp"
#include "models/iiwa.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/algebra.hpp>
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
  std::printf("\n  %-6s %20s %20s\n", "", "u' compiled", "u' reference");
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
    std::printf("  the compiler               %s s for %s, including about 1 s for the headers\n",
                seconds.c_str(), file);
}

/// Prints `name = expression`, simplified, in lines of at most 100 columns.
void print_equation(const std::string& name, const symbolic::expression& e) {
  const std::string left = "  " + name + " = ";
  std::printf("%s", wrapped(left + symbolic::print(symbolic::simplify(e)), left.size()).c_str());
}

void print_equations(model& m, const symbolic::matrix& rates) {
  const mechanics::mechanism& of = m.mechanism();
  for (int i = 0; i < rates.rows; ++i) print_equation(symbolic::print(of.speed_rates[i]), rates(i, 0));
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
  std::printf("  one evaluation             %.0f ns compiled\n", c.nanoseconds);
  std::printf("  at run time                derived in %.2f ms; one evaluation %.0f ns interpreted\n",
              taken.count(), time);
  print_compile_time(file);
}

} // namespace

bool show_double_pendulum() {
  std::printf("A double pendulum with friction and two motors; M u' = f\n\n");
  model m = derive<double_pendulum::System>();
  const symbolic::matrix M = m.mass_matrix(), f = m.forcing();
  for (int i = 0; i < 2; ++i)
    for (int j = i; j < 2; ++j) print_equation("M" + std::to_string(i + 1) + std::to_string(j + 1), M(i, j));
  for (int i = 0; i < 2; ++i) print_equation("f" + std::to_string(i + 1), f(i, 0));
  return m.mistake().empty();
}

bool show_rolling_disc() {
  std::printf(
      "\nA disc that rolls without slipping; u1, u2, u3 are its angular velocity in the lean frame L\n\n");
  auto derived = derive<rolling_disc::System>();
  std::printf("  velocity of the mass center: %s\n",
              derived.print(derived.vector<velocity_of<rolling_disc::Dmc>>()).c_str());
  print_equations(derived, derived.udot());
  const compiled c = compiled_rolling_disc();
  const bool right = print_numbers(c, 1e-12);
  print_times<rolling_disc::System>(c, "rolling_disc.cpp");
  return right;
}

bool show_iiwa() {
  std::printf("\nKUKA LBR iiwa 14: seven joints; masses and lengths are numbers in the type\n\n");
  auto derived = derive<iiwa::System>();
  const symbolic::matrix mass = derived.mass_matrix();
  for (int i = 3; i < 7; ++i) print_equation("M" + std::to_string(i + 1) + "7", mass(i, 6));
  const compiled c = compiled_iiwa();
  const bool right = print_numbers(c, 1e-11);
  print_times<iiwa::System>(c, "iiwa.cpp");
  return right;
}

bool show_bicycle() {
  std::printf(
      "\nA bicycle without a rider: two rolling wheels and a loop through the ground, so that three of\n"
      "six speeds follow from the others; masses and lengths are numbers in the type\n");
  const compiled c = compiled_bicycle();
  const bool right = print_numbers(c, 1e-11);
  print_times<bicycle::BoundSystem>(c, "bicycle.cpp");
  return right;
}

} // namespace demo
