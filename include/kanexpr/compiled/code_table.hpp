#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/function.hpp>
#include <kanexpr/lower/fixed_tape.hpp>

#include <string_view>

namespace kanexpr::compiled {

/// The code of a function as a table for interpreters. It adds no compile time and needs a tenth of the
/// memory of compiled code.
struct code_table {
  lower::tape_view tape;
  int causes; ///< the number of possible causes of an invalid result
  std::string_view (*cause)(int);
  bool checks_finiteness; ///< whether the last cause is a result that is not finite
};

template <class System, auto... wanted>
inline constexpr code_table table_of{
    lower::tape_view(code<System, wanted...>::tape), code<System, wanted...>::causes.sizes.count,
    [](int i) -> std::string_view { return code<System, wanted...>::causes[i]; },
    code<System, wanted...>::checks_finiteness};

/// Returns the table for arguments of the given types, which are checked like those of a call.
template <class System, class Time, class State, class Parameters, class Inputs, auto... wanted>
const code_table& table_for() {
  using code = compiled::code<System, wanted...>;
  static_assert(sizeof(call<System, code, Time, State, Parameters, Inputs, omitted, wanted...>) != 0);
  static_cast<void>(can_call_externals<code, typename State::Scalar, true, wanted...>());
  derivation::report_in_code<surveyed<System>>();
  derivation::report_in_code<code>();
  enforce_unique_system_name<System>();
  return table_of<System, wanted...>;
}

} // namespace kanexpr::compiled
