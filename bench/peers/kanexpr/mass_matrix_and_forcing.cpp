#include "compiled.hpp"

/// M and f; of a system with constraints those of the independent speeds, with the bias of the dependent
/// rates.
extern "C" void mass_matrix_and_forcing(const double* x, double* result) {
  using namespace peers;
  const auto put = [&](const auto& m) {
    Eigen::Map<typename std::remove_cvref_t<decltype(m)>::PlainObject>{result} = m;
    result += m.size();
  };
  if constexpr (kanexpr::compiled::survey_of<model>.constraints != 0) {
    const auto [M, f, b] = at(eom::together(eom::mass_matrix, eom::forcing, eom::acceleration_bias), x);
    put(M), put(f), put(b);
  } else {
    const auto [M, f] = at(eom::together(eom::mass_matrix, eom::forcing), x);
    put(M), put(f);
  }
}
