#pragma once

#include <kanexpr/derive/survey.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/mechanics/equations.hpp>

namespace kanexpr::derive {

using mechanics::quantity;

/// Rows and columns of a result; 1×1 is a scalar.
struct extent {
  int rows = 1;
  int columns = 1;
};

/// Something that can be asked of a system: a quantity of its own, or an expression of the model.
template <auto wanted>
struct request;

template <quantity wanted>
struct request<wanted> {
  static constexpr extent of(const survey& s) {
    const int n = s.coordinates, p = s.speeds;
    switch (wanted) {
    case quantity::mass_matrix: return {p, p};
    case quantity::mass_matrix_full: return {n + p, n + p};
    case quantity::forcing_full:
    case quantity::rhs: return {n + p, 1};
    case quantity::qdot: return {n, 1};
    case quantity::forcing:
    case quantity::udot:
    case quantity::active_forces:
    case quantity::inertia_forces: return {p, 1};
    case quantity::linear_momentum:
    case quantity::angular_momentum:
    case quantity::center_of_mass: return {3, 1};
    default: return {1, 1};
    }
  }
  static constexpr symbolic::matrix form(reader&, mechanics::equations& e) { return e.get(wanted); }
};

struct outcome {
  problem mistake;
  lower::roomy_tape tape;
};

/// One derivation from the types of a model to straight-line code for everything that is wanted.
template <class System, auto... wanted>
constexpr outcome derived() {
  graph g;
  mechanism m(g);
  reader r(System::record, m);
  r.read();
  mechanics::equations e(m);
  sequence<int> outputs;
  (
      [&] {
        const symbolic::matrix result = request<wanted>::form(r, e);
        for (const expression& entry : result.entries) outputs.push(entry.node());
      }(),
      ...);
  return {e.mistake(), lower::fixed(lower::tape_of(g, outputs))};
}

} // namespace kanexpr::derive
