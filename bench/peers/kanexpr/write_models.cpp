// Writes what the peers build their models from, the numbers of the examples, and random states:
// write_models DIRECTORY leaves <model>.model, <model>.states and <model>.operations there.
#include "model_numbers.hpp"

#include <models/bicycle.hpp>
#include <models/iiwa.hpp>
#include <models/pendulum6.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>

#include <kanexpr/assemble.hpp>
#include <kanexpr/derivation/cost.hpp>

#include <cmath>
#include <fstream>
#include <random>
#include <string>

namespace {

constexpr int states = 64;

std::ofstream opened(const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  return file;
}

/// Values between -1 and 1, the same in each run.
class source {
public:
  double next() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  template <class Vector>
  void fill(Vector& v) {
    for (double& entry : v) entry = next();
  }

private:
  std::mt19937_64 random_{13};
};

/// Whether the state is one; it is completed.
template <class System>
bool complete(kanexpr::state<System>&, const kanexpr::input_values<System>&) {
  return true;
}
template <>
bool complete<quadruped::System>(kanexpr::state<quadruped::System>& x,
                                 const kanexpr::input_values<quadruped::System>&) {
  x.segment<4>(3).normalize();
  return true;
}
/// Leaning by up to half a radian, on both wheels.
template <>
bool complete<bicycle::BoundSystem>(kanexpr::state<bicycle::BoundSystem>& x,
                                    const kanexpr::input_values<bicycle::BoundSystem>& r) {
  x[bicycle::q2] /= 2, x[bicycle::q5] /= 2, x[bicycle::q4] = 0;
  x[bicycle::u3] = 15 + 5 * x[bicycle::u3];
  return bool(
      kanexpr::assemble<bicycle::BoundSystem>(x, kanexpr::parameter_values<bicycle::BoundSystem>(), r));
}

template <class System>
bool write_states(const std::string& path) {
  std::ofstream file = opened(path);
  source random;
  for (int i = 0; i < states; ++i) {
    kanexpr::state<System> x;
    kanexpr::input_values<System> r;
    random.fill(x), random.fill(r);
    if (!complete<System>(x, r)) return false;
    for (const double entry : x) file << entry << ' ';
    for (const double entry : r) file << entry << ' ';
    file << '\n';
  }
  return bool(file);
}

/// What the compiled functions count.
template <class System>
bool write_operations(const std::string& path) {
  std::ofstream out = opened(path);
  using kanexpr::mechanics::quantity;
  const auto write = [&](const char* result, std::initializer_list<quantity> wanted) {
    const kanexpr::symbolic::cost cost = kanexpr::derivation::cost_of<System>(wanted);
    out << result << ' ' << cost.multiplications + cost.additions << '\n';
  };
  if (kanexpr::compiled::survey_of<System>.constraints != 0)
    write("mass_matrix_and_forcing", {quantity::mass_matrix, quantity::forcing, quantity::acceleration_bias});
  else
    write("mass_matrix_and_forcing", {quantity::mass_matrix, quantity::forcing});
  write("udot", {quantity::udot});
  write("udot_derivatives", {quantity::state_matrix, quantity::input_matrix});
  return bool(out);
}

template <class System>
bool write_rest(const std::string& name) {
  return write_operations<System>(name + ".operations") && write_states<System>(name + ".states");
}

template <class System>
bool write_tree(const std::string& name) {
  std::ofstream file = opened(name + ".model");
  return peers::write_tree(file, System::record) && file && write_rest<System>(name);
}

bool write_bicycle(const std::string& name) {
  std::ofstream file = opened(name + ".model");
  peers::write_values(file, bicycle::BoundSystem::record);
  return file && write_rest<bicycle::BoundSystem>(name);
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1] + std::string("/");
  const bool written =
      write_tree<pendulum6::System>(folder + "pendulum6") && write_tree<puma::System>(folder + "puma") &&
      write_tree<iiwa::System>(folder + "iiwa") && write_tree<quadruped::System>(folder + "quadruped") &&
      write_bicycle(folder + "bicycle");
  return written ? 0 : 1;
}
