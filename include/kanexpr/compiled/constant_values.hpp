#pragma once

#include <kanexpr/compiled/gap.hpp>
#include <kanexpr/compiled/place.hpp>
#include <kanexpr/compiled/survey_of.hpp>

#include <array>
#include <initializer_list>

namespace kanexpr {

namespace compiled {

/// Returns a vector of a system from values given by name, for constant expressions. Dependent symbols may be
/// omitted and are zero. Other entries without a value, or with two values, are NaN; if a name does not
/// belong to the system, all entries are NaN. clang++ rejects any further use of NaN entries.
template <class System, symbols_of which>
constexpr auto constant_values(std::initializer_list<entry<System, which, double>> named) {
  constexpr symbol_range range = range_of(which, survey_of<System>);
  std::array<double, static_cast<std::size_t>(range.size)> values{};
  std::array<bool, static_cast<std::size_t>(range.size) + 1> set{};
  bool all_names_known = true;
  for (const auto& given : named) {
    all_names_known = all_names_known && given.place >= 0;
    if (given.place < 0) continue;
    const auto place = static_cast<std::size_t>(given.place);
    values[place] = set[place] ? number_for(gap::set_twice) : given.value;
    set[place] = true;
  }
  for (int i = 0; i < range.size; ++i) {
    const auto place = static_cast<std::size_t>(i);
    if (!all_names_known || (!set[place] && !survey_of<System>.may_be_omitted(range.first + i)))
      values[place] = number_for(all_names_known ? gap::never_set : gap::unknown_name_in_list);
  }
  return values;
}

} // namespace compiled

/// Returns the state of a system from values given by name, for constant expressions:
/// `eom::udot.constant(constant_state<System>({{q1, 0.1}, {u1, 0}}), constant_parameters<System>({{m, 2}}))`.
template <class System>
constexpr auto
constant_state(std::initializer_list<compiled::entry<System, compiled::symbols_of::state, double>> named) {
  return compiled::constant_values<System, compiled::symbols_of::state>(named);
}
/// Returns the parameters of a system from values given by name, for constant expressions:
/// `constant_parameters<System>({{m, 2}})`.
template <class System>
constexpr auto constant_parameters(
    std::initializer_list<compiled::entry<System, compiled::symbols_of::parameters, double>> named) {
  return compiled::constant_values<System, compiled::symbols_of::parameters>(named);
}
/// Returns the inputs of a system from values given by name, for constant expressions:
/// `constant_inputs<System>({{T, 0.5}})`.
template <class System>
constexpr auto
constant_inputs(std::initializer_list<compiled::entry<System, compiled::symbols_of::inputs, double>> named) {
  return compiled::constant_values<System, compiled::symbols_of::inputs>(named);
}

} // namespace kanexpr
