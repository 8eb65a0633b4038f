// A bicycle that nobody steers falls over at some speeds and stays up by itself at others. The compiler
// derives its nonlinear equations by Kane's method and linearizes them; the program looks at the eigenvalues.
#include "print.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/bicycle.hpp>

#include <Eigen/Eigenvalues>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <tuple>

namespace {

using bicycle::BoundSystem;

// Upright and straight ahead at v m/s; the pitch and the front wheel's spin follow from the constraints.
kanexpr::state<BoundSystem> straight_ahead(double v) {
  constexpr double rear_radius = 0.3;
  kanexpr::state<BoundSystem> x;
  x[bicycle::u3] = v / rear_radius;
  kanexpr::assemble<BoundSystem>(x);
  return x;
}

// A in ẋ = A x near that motion, of lean, steer and their rates. Nothing depends on the yaw, and the wheels
// keep their spin.
Eigen::Matrix4d lean_and_steer(double v) {
  const auto [A, B] = kanexpr::linearization<BoundSystem>::explicit_form(straight_ahead(v));
  const std::array places{1, 2, 3, 5}; // among q1, q2, q5, u2, u3, u5
  return A(places, places);
}

// The eigenvalues, in 1/s. In the weave the bicycle swings from side to side; below 0.7 m/s it only falls, in
// two ways. The capsize is a slow fall to one side, and castering turns the front wheel into its track.
struct modes {
  std::complex<double> weave[2];
  double capsize, castering;
};

// What oscillates comes first, then what grows faster.
modes modes_at(double v) {
  const Eigen::Vector4cd found = lean_and_steer(v).eigenvalues();
  std::array s{found(0), found(1), found(2), found(3)};
  const auto rank = [](std::complex<double> one) {
    return std::tuple(one.imag() != 0, one.real(), one.imag());
  };
  std::ranges::sort(s, std::greater{}, rank);
  return {{s[0], s[1]}, s[2].real(), s[3].real()};
}

// The speed up to 10 m/s at which a mode neither grows nor decays.
template <class Growth>
double critical_speed(const Growth& growth) {
  using namespace boost::math::tools;
  std::uintmax_t most_steps = 100;
  const auto [below, above] = toms748_solve(growth, 0.0, 10.0, eps_tolerance<double>(), most_steps);
  return (below + above) / 2;
}

// A row for each speed: both of the weave with their real and imaginary parts, capsize, castering.
void tabulate(std::FILE* out, int rows) {
  std::fprintf(out, "#  m/s            weave 1            weave 2    capsize  castering\n");
  for (int i = 0; i <= rows; ++i) {
    const double v = 10.0 * i / rows;
    const auto [weave, capsize, castering] = modes_at(v);
    std::fprintf(out, "%6.2f %9.4f %8.4f %9.4f %8.4f %10.4f %10.4f\n", v, weave[0].real(), weave[0].imag(),
                 weave[1].real(), weave[1].imag(), capsize, castering);
  }
}

} // namespace

// Writes what bicycle_stability.gp draws to a file, if one is named.
int main(int count, char** names) {
  tabulate(stdout, 10);
  const double weave_speed = critical_speed([](double v) { return modes_at(v).weave[0].real(); });
  const double capsize_speed = critical_speed([](double v) { return modes_at(v).capsize; });
  const auto [weave, capsize, castering] = modes_at(5);
  print("weave, capsize, castering at 5 m/s",
        Eigen::Vector4d{weave[0].real(), weave[0].imag(), capsize, castering});
  print("stable from", weave_speed);
  print("stable up to", capsize_speed);

  if (count > 1) {
    std::FILE* data = std::fopen(names[1], "w");
    if (data == nullptr) return 1;
    tabulate(data, 500);
    std::fprintf(data, "\n\n%.4f %.4f\n", weave_speed, capsize_speed);
    std::fclose(data);
  }
}
