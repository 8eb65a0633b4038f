#pragma once

#include <kanexpr/derivation/read/contact_reader.hpp>
#include <kanexpr/derivation/read/friction_reader.hpp>
#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/derivation/read/muscle_reader.hpp>
#include <kanexpr/derivation/read/path_loads.hpp>
#include <kanexpr/derivation/read/phrase_units.hpp>
#include <kanexpr/derivation/read/simple_loads.hpp>
#include <kanexpr/derivation/read/tyre_reader.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <iterator>

namespace kanexpr::derivation {

using describe::load_word;

/// How the loads of one word are read, and which of their forces expressions may contain.
struct load_row {
  load_word word{};
  void (*read)(load_parts&) = nullptr;
  /// States the units of its phrases; null if its law has units that only the load itself knows.
  void (*expect_units)(const load_record&, phrase_units&) = nullptr;
  /// Whether its value has a potential energy, so that it depends only on coordinates.
  bool is_conservative = false;
  /// The tension of the only load in a list; null if it does not act along a pathway.
  expression (*tension)(const mechanics::loads&, mechanics::observed_motion&) = nullptr;
  /// Another quantity of the only load in a list; null if it is neither a contact nor a tyre.
  value (*observe)(describe::load_quantity, const mechanics::loads&, mechanics::observed_motion&) = nullptr;
};

/// The loads, in the order of their words.
inline constexpr load_row load_table[]{
    {.word = load_word::force, .read = read_force, .expect_units = expect_force},
    {.word = load_word::torque, .read = read_torque, .expect_units = expect_torque},
    {.word = load_word::gravity, .read = read_gravity, .expect_units = expect_gravity},
    {.word = load_word::potential_energy,
     .read = read_potential_energy,
     .expect_units = expect_energy,
     .is_conservative = true},
    {.word = load_word::spring,
     .read = read_spring,
     .expect_units = expect_spring,
     .is_conservative = true,
     .tension = tension_along_path},
    {.word = load_word::damper,
     .read = read_damper,
     .expect_units = expect_damper,
     .tension = tension_along_path},
    {.word = load_word::torsional_spring,
     .read = read_torsional_spring,
     .expect_units = expect_torsional_spring,
     .is_conservative = true},
    {.word = load_word::torsional_damper,
     .read = read_torsional_damper,
     .expect_units = expect_torsional_damper},
    {.word = load_word::path_force, .read = read_path_force, .tension = tension_along_path},
    {.word = load_word::path_spring, .read = read_path_spring, .tension = tension_along_path},
    {.word = load_word::path_cubic_spring, .read = read_path_cubic_spring, .tension = tension_along_path},
    {.word = load_word::path_damper, .read = read_path_damper, .tension = tension_along_path},
    {.word = load_word::path_stop, .read = read_path_stop, .tension = tension_along_path},
    {.word = load_word::bushing, .read = read_bushing},
    {.word = load_word::friction, .read = read_friction, .tension = tension_along_path},
    {.word = load_word::contact, .read = read_contact, .observe = observe_contact},
    {.word = load_word::muscle, .read = read_muscle, .tension = tension_of_muscle},
    {.word = load_word::tyre, .read = read_tyre, .observe = observe_tyre},
};

constexpr bool is_in_order(const load_row* rows, int size) {
  for (int i = 0; i < size; ++i)
    if (static_cast<int>(rows[i].word) != i) return false;
  return size == static_cast<int>(load_word::none);
}
static_assert(is_in_order(load_table, static_cast<int>(std::size(load_table))));

/// The row of a load; `r` must be a load.
constexpr const load_row& row_of(const load_record& r) { return load_table[static_cast<int>(r.what)]; }

} // namespace kanexpr::derivation
