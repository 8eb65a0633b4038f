#pragma once

#include <kanexpr/compiled/state.hpp>
#include <kanexpr/derivation/causes.hpp>
#include <kanexpr/mechanics/status.hpp>

/// Why a result is not finite: a parameter or an input that has no value.
namespace kanexpr::compiled {

/// The first entry of parameters or inputs that is no finite number, as a sentence; empty: there is none.
template <class System, symbols_of which, class Vector>
mechanics::problem gap_among(const Vector& values) {
  if constexpr (requires { Vector::SizeAtCompileTime; })
    return first_gap(values, survey_of<System>, range_of(which, survey_of<System>), type_name<System>());
  else
    return {};
}
template <class System, class P, class R>
mechanics::problem gap_among(const P& p, const R& r) {
  const mechanics::problem found = gap_among<System, symbols_of::parameters>(p);
  return found ? found : gap_among<System, symbols_of::inputs>(r);
}

/// "parameter m has no value" for every parameter and input, with room for any sentence.
template <class System>
constexpr auto causes_of_gaps() {
  constexpr const derivation::survey& known = survey_of<System>;
  constexpr int count = known.parameters + known.inputs;
  derivation::cause_list<derivation::cause_sizes{count, count * mechanics::problem::capacity}> all{};
  for (int i = 0; i < count; ++i)
    all.push(told_of(gap::never_set, known, known.first_of(symbolic::symbol_kind::parameter) + i,
                     type_name<System>()));
  return all;
}

/// The same for statuses, which keep no sentences.
template <class System>
struct never_set {
  static constexpr int parameters = survey_of<System>.parameters, inputs = survey_of<System>.inputs;
  static constexpr auto causes =
      derivation::trimmed<causes_of_gaps<System>().sizes>(causes_of_gaps<System>());

  /// The same status; of a failure the cause is what was never set, if something was.
  template <class P, class R>
  static status blamed_for(const status& found, const P& p, const R& r) {
    return found ? found : cause_of(found, p, r);
  }

private:
  template <class P, class R>
  [[gnu::cold, gnu::noinline]] static status cause_of(const status& failure, const P& p, const R& r) {
    if (const int i = first_in(p, parameters); i < parameters) return status(causes[i]);
    if (const int i = first_in(r, inputs); i < inputs) return status(causes[parameters + i]);
    return failure;
  }

  template <class Vector>
  static int first_in(const Vector& values, int size) {
    if constexpr (requires { Vector::SizeAtCompileTime; })
      for (int i = 0; i < size; ++i)
        if (was_never_set(values[i])) return i;
    return size;
  }
};

} // namespace kanexpr::compiled
