#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/causes.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/scalar_math.hpp>

/// Finds the parameter, the input or the entry of the state that makes a result not finite.
namespace kanexpr::compiled {

/// Returns a message that names the first entry of the parameters or inputs that is not finite; empty if all
/// are finite.
template <class System, symbols_of which, class Vector>
base::sentence gap_among(const Vector& values) {
  if constexpr (requires { Vector::SizeAtCompileTime; })
    return first_gap(values, survey_of<System>, range_of(which, survey_of<System>), type_name<System>());
  else
    return {};
}
template <class System, class Parameters, class Inputs>
base::sentence gap_among(const Parameters& p, const Inputs& r) {
  const base::sentence found = gap_among<System, symbols_of::parameters>(p);
  return found ? found : gap_among<System, symbols_of::inputs>(r);
}

/// The failure if all arguments are finite.
inline constexpr status results_not_finite("the results are not finite at this state");

/// Returns a message such as "m has no finite value" for every symbol of a system.
template <class System>
constexpr auto causes_of_gaps() {
  constexpr const derivation::survey& known = survey_of<System>;
  derivation::cause_list<derivation::cause_sizes{known.symbols(), known.symbols() * base::sentence::capacity}>
      all{};
  for (int i = 0; i < known.symbols(); ++i)
    all.push(base::sentence({known.names[i].view(), " has no finite value"}));
  return all;
}

/// Stores these causes permanently, because statuses do not own their messages.
template <class System>
struct not_finite {
  static constexpr auto causes =
      derivation::trimmed<causes_of_gaps<System>().sizes>(causes_of_gaps<System>());

  /// Returns the cause of a failure: an argument that is not finite, or, if there is none, the given failure.
  template <class State, class Parameters, class Inputs>
  [[gnu::cold, gnu::noinline, gnu::pure]] static status
  cause_of(status failure, const State& x, const Parameters& p, const Inputs& r) noexcept {
    int place = place_in<symbols_of::parameters>(p);
    if (place < 0) place = place_in<symbols_of::state>(x);
    if (place < 0) place = place_in<symbols_of::inputs>(r);
    return place < 0 ? failure : status(causes[place]);
  }

private:
  /// Returns the index, among all symbols, of the first value that is not finite; negative if all are finite.
  template <symbols_of which, class Vector>
  static int place_in(const Vector& values) {
    constexpr symbol_range range = range_of(which, survey_of<System>);
    if constexpr (requires { Vector::SizeAtCompileTime; })
      for (int i = 0; i < range.size; ++i)
        if (!lower::scalar_math<typename Vector::Scalar>::is_finite(values[i])) return range.first + i;
    return -1;
  }
};

} // namespace kanexpr::compiled
