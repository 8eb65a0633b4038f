#pragma once

#include <kanexpr/derivation/causes.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/fixed_tape.hpp>

namespace kanexpr::derivation {

using mechanics::quantity;

/// Rows and columns of a result; a scalar is not a matrix, though a matrix may be 1×1.
struct extent {
  int rows = 1;
  int columns = 1;
  bool scalar = false;
};

/// Something that can be asked of a system: a quantity of its own, or an expression of the model. This is
/// neither.
template <auto wanted>
struct request {
  static constexpr extent of(const survey&) { return {1, 1, true}; }
  static constexpr void visit(reader& r) {
    r.refuse("what a function is asked for is not an expression of a model");
  }
  static constexpr symbolic::matrix form(reader&, mechanics::equations&) { return {}; }
  static constexpr symbolic::matrix with_rates(reader&, mechanics::equations&) { return {}; }
};

template <quantity wanted>
struct request<wanted> {
  static constexpr extent of(const survey& s) {
    const int n = s.coordinates, p = s.speeds, m = s.constraints, l = s.configuration_constraints;
    switch (wanted) {
    case quantity::mass_matrix: return {p - m, p - m};
    case quantity::mass_matrix_full:
    case quantity::state_jacobian: return {n + p, n + p};
    case quantity::forcing_full:
    case quantity::rhs: return {n + p, 1};
    case quantity::qdot: return {n, 1};
    case quantity::udot:
    case quantity::unreduced_forces: return {p, 1};
    case quantity::forcing:
    case quantity::active_forces:
    case quantity::inertia_forces: return {p - m, 1};
    case quantity::linear_momentum:
    case quantity::angular_momentum:
    case quantity::center_of_mass: return {3, 1};
    case quantity::configuration_residual:
    case quantity::configuration_step:
    case quantity::configuration_terms: return {l, 1};
    case quantity::configuration_jacobian: return {l, l};
    case quantity::configuration_jacobian_full: return {l, n};
    case quantity::constraint_residual: return {l + m, 1};
    case quantity::constraint_jacobian: return {m, p};
    case quantity::dependency: return {m, p - m};
    case quantity::velocity_residual:
    case quantity::velocity_terms:
    case quantity::dependent_speeds:
    case quantity::acceleration_bias:
    case quantity::multipliers: return {m, 1};
    case quantity::auxiliary_forces: return {s.auxiliary_speeds, 1};
    case quantity::state_matrix: return {s.states(), s.states()};
    case quantity::input_matrix: return {s.states(), s.inputs};
    case quantity::input_jacobian: return {n + p, s.inputs};
    case quantity::implicit_mass_matrix: return {s.unknowns(), s.unknowns()};
    case quantity::implicit_state_matrix: return {s.unknowns(), s.states()};
    case quantity::implicit_input_matrix: return {s.unknowns(), s.inputs};
    default: return {1, 1, true};
    }
  }
  static constexpr void visit(reader&) {}
  static constexpr symbolic::matrix form(reader&, mechanics::equations& e) { return e.get(wanted); }
};

/// An expression of the model: a scalar, or a vector by its components in inertial axes or those it was put
/// in.
template <auto wanted>
  requires requires { describe::shape_of(wanted); }
struct request<wanted> {
  static constexpr phrase words = describe::phrase_of<wanted>;
  static constexpr extent of(const survey&) {
    return {words.kind == shape::vector ? 3 : 1, 1, words.kind != shape::vector};
  }
  static constexpr void visit(reader& r) { r.visit(words.tokens, words.size); }
  static constexpr symbolic::matrix form(reader& r, mechanics::equations& e) {
    return e.in_motion(with_rates(r, e));
  }
  /// The same with the symbols q̇ and u̇.
  static constexpr symbolic::matrix with_rates(reader& r, mechanics::equations& e) {
    const mechanism& m = *e.skeleton_used().model;
    const value v = r.evaluate(words, "an expression");
    const bool own_axes =
        words.tokens[words.size - 1].what == describe::word::in_axes && v.vector.parts.size() == 1;
    symbolic::matrix result(*m.g, of({}).rows, 1);
    if (v.kind != shape::vector) {
      result.entries[0] = v.scalar;
      return result;
    }
    components c = own_axes ? v.vector.parts[0].value : mechanics::express(m, v.vector, mechanism::inertial);
    for (int i = 0; i < 3; ++i) result.entries[i] = c[i];
    return result;
  }
};

template <int size, int columns, jacobian_matrix<size, columns> wanted>
struct request<wanted> {
  static constexpr extent of(const survey&) { return {wanted.of_vector ? 3 : 1, columns}; }
  static constexpr void visit(reader& r) { r.visit(wanted.tokens, size); }
  static constexpr symbolic::matrix form(reader& r, mechanics::equations& e) {
    const mechanism& m = *e.skeleton_used().model;
    const value v =
        r.evaluate({wanted.of_vector ? shape::vector : shape::scalar, wanted.tokens, size}, "a jacobian");
    symbolic::matrix result(*m.g, wanted.of_vector ? 3 : 1, columns);
    components c(*m.g);
    if (wanted.of_vector) c = mechanics::express(m, v.vector, mechanism::inertial);
    for (int j = 0; j < columns; ++j) {
      const expression by = r.symbol(*wanted.by[j].symbol, "a jacobian");
      if (!wanted.of_vector) result(0, j) = e.in_motion(symbolic::differentiate(v.scalar, by));
      for (int i = 0; wanted.of_vector && i < 3; ++i)
        result(i, j) = e.in_motion(symbolic::differentiate(c[i], by));
    }
    return result;
  }
};

/// The measures and scales of what may be singular are behind all other results of the tape, a pair for each
/// cause. It has room for any model, so a program must not hold it.
struct outcome {
  problem mistake;
  roomy_causes causes;
  lower::roomy_tape tape;
  bool follows_from_unparsed = false; ///< the mistake, from something that did not parse
  bool tells_finiteness = false;      ///< the last pair
};

constexpr outcome none_for(const problem& mistake) { return {mistake, {}, lower::roomy_tape{}}; }

/// What no room is left for.
constexpr problem check_room(std::string_view system, const lower::tape_sizes& sizes) {
  if (lower::has_room_for(sizes)) return {};
  return sentence({"what is asked of ", system, " at once takes ", mechanics::counted(sizes.steps).view(),
                   " operations and has ", mechanics::counted(sizes.results).view(),
                   " entries; there is room for ", mechanics::counted(lower::most_steps).view(),
                   " of each; ask for it in parts"});
}

/// One derivation from the types of a model to straight-line code for everything that is wanted.
template <class System, auto... wanted>
constexpr outcome derived() {
  derived_system system(System::record);
  (request<wanted>::visit(system.reader()), ...);
  system.derive();
  if (system.mistake())
    return {system.mistake(), {}, lower::roomy_tape{}, system.reader().follows_from_unparsed()};
  sequence<int> outputs;
  (
      [&] {
        const symbolic::matrix result = request<wanted>::form(system.reader(), system.equations());
        for (const expression& entry : result.entries) outputs.push(entry.node());
      }(),
      ...);
  if (system.mistake()) return none_for(system.mistake());
  roomy_causes causes;
  bool tells_finiteness = false;
  for (const mechanics::guard& g : system.equations().guards_of(outputs)) {
    if (!causes.has_room_for(g.cause))
      return none_for(
          sentence({"what is asked of ", type_name<System>(),
                    " at once may be singular in more ways than there is room for; ask for it in parts"}));
    causes.push(g.cause);
    tells_finiteness = g.of_finiteness;
    outputs.push(g.measure.node());
    outputs.push(g.scale.node());
  }
  const lower::tape tape = lower::tape_of(system.graph(), outputs);
  if (const problem lacking = check_room(type_name<System>(), lower::sizes_of(tape)))
    return none_for(lacking);
  return {{}, causes, lower::fixed(tape), false, tells_finiteness};
}

} // namespace kanexpr::derivation
