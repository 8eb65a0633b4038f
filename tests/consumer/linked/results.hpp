#include <kanexpr/compiled/out_of_line.hpp>

#include <cinttypes>
#include <cstdio>

/// The same digits, regardless of how the functions were compiled.
namespace results {

template <class Matrix>
void print(const char* what, const Matrix& m) {
  std::printf("%s:", what);
  for (Eigen::Index i = 0; i < m.size(); ++i) std::printf(" %.17g", m(i));
  std::printf("\n");
}

template <class System>
void print_all(const kanexpr::state<System>& at, const kanexpr::input_values<System>& r) {
  using eom = kanexpr::equations_of_motion<System>;
  const typename eom::parameters p{{models::l, 0.7}};
  print("mass matrix", eom::mass_matrix(at, p, r));
  print("forcing", eom::forcing(at, p, r));
  print("rates", eom::rhs(0.5, at, p, r));
  print("multipliers", eom::multipliers(at, p, r));
  print("inertia forces", eom::inertia_forces(at, p, r, eom::udot(at, p, r)));
  const auto [mass, forcing] = eom::together(eom::mass_matrix, eom::forcing)(at, p, r);
  print("together", forcing);
  const auto [A, B] = kanexpr::linearization<System>::explicit_form(at, p, r);
  print("A", A), print("B", B);
  std::printf("energy: %.17g\n", static_cast<double>(eom::kinetic_energy(at, p)));
  using rates = kanexpr::function<System, kanexpr::mechanics::quantity::rhs>;
  std::printf("known by: %016" PRIx64 "\n", kanexpr::out_of_line<rates>::digest());
}

/// An equation that cannot be solved has its cause.
template <class System>
void print_failure() {
  using eom = kanexpr::equations_of_motion<System>;
  typename eom::state at;
  const typename eom::parameters p{{models::l, 0.7}};
  const auto rates = eom::udot(at, p);
  std::printf("%s\n", rates.status ? "solved" : rates.status.cause().c_str());
}

} // namespace results
