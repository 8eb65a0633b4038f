#include "demo/parts.hpp"
#include "lean_and_steer_modes.hpp"
#include "models/bicycle.hpp"

#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/values.hpp>
#include <kanexpr/symbolic.hpp>

#include <cmath>
#include <cstdio>

/// The eigenvalues of the bicycle as functions of its speed.
namespace demo {

using namespace kanexpr;

namespace {

/// The bicycle, linearized while the program runs; its equations are evaluated upright and straight ahead.
class linearized_bicycle {
public:
  linearized_bicycle()
      : model_(derive<bicycle::BoundSystem>()), A_(model_.function(model_.linearize().explicit_form().A)) {}

  bicycle::modes modes_at(double speed) {
    constexpr double rear_radius = 0.3;
    state<model> x(model_);
    x["u3"] = speed / rear_radius;
    kanexpr::assemble(model_, x);
    const Eigen::MatrixXd A = A_(x);
    const std::array places{1, 2, 3, 5}; // among q1, q2, q5, u2, u3, u5
    return bicycle::modes_of(A(places, places));
  }

private:
  model model_;
  runtime::interpreted<double> A_;
};

void write_row(std::FILE* out, double v, const bicycle::modes& m) {
  std::fprintf(out, "%6.2f %9.4f %8.4f %9.4f %8.4f %10.4f %10.4f\n", v, m.weave[0].real(), m.weave[0].imag(),
               m.weave[1].real(), m.weave[1].imag(), m.capsize, m.castering);
}

} // namespace

bool show_eigenvalues(const std::string& folder, std::vector<exhibit>& all) {
  linearized_bicycle upright;
  std::printf("\nThe eigenvalues of the upright bicycle in 1/s, from equations linearized in this program\n\n"
              "   m/s            weave 1            weave 2    capsize  castering\n");
  for (int v = 0; v <= 10; v += 2) write_row(stdout, v, upright.modes_at(v));
  const double weave = bicycle::critical_speed([&](double v) { return upright.modes_at(v).weave[0].real(); });
  const double capsize = bicycle::critical_speed([&](double v) { return upright.modes_at(v).capsize; });
  std::printf("\n  stable between %.3f and %.3f m/s; the benchmark's: 4.292 and 6.024\n", weave, capsize);

  std::FILE* data = std::fopen((folder + "/eigenvalues.dat").c_str(), "w");
  if (data == nullptr) return false;
  for (int i = 0; i <= 500; ++i) write_row(data, 0.02 * i, upright.modes_at(0.02 * i));
  std::fprintf(data, "\n\n%.4f %.4f\n", weave, capsize);
  std::fclose(data);
  all.push_back({"Eigenvalues of the bicycle",
                 "Between two speeds, it stays upright by itself.",
                 "eigenvalues.svg",
                 {}});
  return std::abs(weave - 4.292) < 1e-3 && std::abs(capsize - 6.024) < 1e-3;
}

} // namespace demo
