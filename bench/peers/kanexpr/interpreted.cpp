// The functions of compiled.hpp, interpreted.
#include <models/bicycle.hpp>
#include <models/iiwa.hpp>
#include <models/pendulum6.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>

#include <kanexpr/symbolic.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace {

using kanexpr::mechanics::quantity;

struct subject {
  explicit subject(kanexpr::model derived)
      : known(*derived.known()), udot(derived.function(derived.udot())),
        mass_matrix_and_forcing(derived.function(both(derived))),
        udot_derivatives(derived.function(derivatives(derived))) {}

  /// M and f, and of a system with constraints the bias of the dependent rates, one below the other.
  static kanexpr::symbolic::matrix both(kanexpr::model& derived) {
    kanexpr::symbolic::matrix all = derived.mass_matrix();
    for (const auto& e : derived.forcing().entries) all.entries.push(e);
    for (const auto& e : derived.acceleration_bias().entries) all.entries.push(e);
    all.rows = all.entries.size(), all.columns = 1;
    return all;
  }

  /// The rows of u̇ of A and B, column by column.
  kanexpr::symbolic::matrix derivatives(kanexpr::model& derived) const {
    const auto A = derived.get(quantity::state_matrix);
    const auto B = derived.get(quantity::input_matrix);
    kanexpr::symbolic::matrix all;
    for (const auto& m : {A, B})
      for (int j = 0; j < m.columns; ++j)
        for (int i = m.rows - (known.speeds - known.constraints); i < m.rows; ++i) all.entries.push(m(i, j));
    all.rows = all.entries.size(), all.columns = 1;
    return all;
  }

  void call(kanexpr::runtime::interpreted<double>& function, const double* x, double* result) const {
    const int states = known.coordinates + known.speeds;
    const auto& found = function(Eigen::Map<const Eigen::VectorXd>(x, states), Eigen::VectorXd(),
                                 Eigen::Map<const Eigen::VectorXd>(x + states, known.inputs));
    std::copy_n(found.data(), found.size(), result);
  }

  kanexpr::derivation::survey known;
  kanexpr::runtime::interpreted<double> udot, mass_matrix_and_forcing, udot_derivatives;
};

std::unique_ptr<subject> now;

kanexpr::model derive(const std::string& name) {
  if (name == "pendulum6") return kanexpr::derive<pendulum6::System>();
  if (name == "puma") return kanexpr::derive<puma::System>();
  if (name == "iiwa") return kanexpr::derive<iiwa::System>();
  if (name == "quadruped") return kanexpr::derive<quadruped::System>();
  if (name == "bicycle") return kanexpr::derive<bicycle::BoundSystem>();
  std::abort();
}

} // namespace

extern "C" {

/// `path` ends with the model's name, before its extension.
void load(const char* path) { now = std::make_unique<subject>(derive(std::filesystem::path(path).stem())); }

void mass_matrix_and_forcing(const double* x, double* result) {
  now->call(now->mass_matrix_and_forcing, x, result);
}
void udot(const double* x, double* result) { now->call(now->udot, x, result); }
void udot_derivatives(const double* x, double* result) { now->call(now->udot_derivatives, x, result); }
}
