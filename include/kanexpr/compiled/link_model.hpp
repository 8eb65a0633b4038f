#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/finite_function.hpp>
#include <kanexpr/compiled/linked_model.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

/// The code of a linked model, for the single file that compiles it: `template struct
/// kanexpr::compiled::library_of<System>;`
namespace kanexpr::compiled {

/// Sets the status of a result that is not finite. An omitted argument is NaN, and so is every result that
/// depends on it.
template <class Number>
void flag_if_not_finite(with_status<Number>& result) {
  bool is_finite = true;
  if constexpr (requires { result.value; })
    is_finite = numeric::is_finite(result.value);
  else
    is_finite = numeric::all_finite(result);
  if (result.status && !is_finite)
    result.status = status("the result is not finite; check for an omitted argument or an unset value");
}
template <class... Number>
void flag_if_not_finite(std::tuple<Number...>& results) {
  std::apply([](auto&... each) { (flag_if_not_finite(each), ...); }, results);
}

/// Whether a function checks by itself that its results are finite.
template <class Function>
inline constexpr bool checks_finiteness = false;
template <class System, auto... wanted>
inline constexpr bool checks_finiteness<finite_function<System, wanted...>> = true;

/// The results that the library of a model returns.
template <class Number, class Function, class Results>
Results told(Results results) {
  if constexpr (std::is_same_v<Number, double> && !checks_finiteness<Function>)
    flag_if_not_finite(results); // other scalar types are used for numerical derivatives
  return results;
}

/// The reason why a valid system does not have a result; for example, a system that specifies only its
/// Lagrangian has no energies.
template <class Function>
struct unavailable {
  static constexpr base::sentence why{};
};
template <class System, mechanics::quantity... wanted>
struct unavailable<function<System, wanted...>> {
  static constexpr base::sentence why = [] {
    using stages = derivation::stages_of<System>;
    constexpr bool by_equations = ((mechanics::row_of(wanted).needs != mechanics::stage::constrained) || ...);
    if (stages::constrained.mistake) return base::sentence();
    if constexpr (by_equations)
      if (stages::equations.mistake) return base::sentence();
    return derived_code<System, wanted...>::mistake();
  }();
};

template <class Number>
void set_unavailable(with_status<Number>& result, kanexpr::status why) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if constexpr (requires { result.value; })
    result.value = nan;
  else
    result.setConstant(nan);
  result.status = why;
}
template <class... Number>
void set_unavailable(std::tuple<Number...>& results, kanexpr::status why) {
  std::apply([&](auto&... each) { (set_unavailable(each, why), ...); }, results);
}

/// Returns the results of a function or, if there are none, NaN with the reason as the status.
template <class Number, class Function, class Results, class... Given>
Results results_or_reason(const Given&... given) noexcept {
  if constexpr (static_cast<bool>(unavailable<Function>::why)) {
    Results none{};
    set_unavailable(none, kanexpr::status(unavailable<Function>::why.view()));
    return none;
  } else {
    return told<Number, Function>(results_of<Results, Function>(given...));
  }
}

template <class Number, class Function, int alignment>
typename linked_instance<Number, Function, alignment>::results
linked_instance<Number, Function, alignment>::evaluate(const Number& t, const typename vectors::state& x,
                                                       const typename vectors::parameters& p,
                                                       const typename vectors::inputs& r) noexcept {
  return results_or_reason<Number, Function, results>(t, x, p, r);
}
template <class Number, class Function, int alignment>
std::uint64_t linked_instance<Number, Function, alignment>::digest() noexcept {
  if constexpr (static_cast<bool>(unavailable<Function>::why))
    return 0;
  else
    return digest_of_function<Function>;
}
template <class Number, class Function, int alignment>
typename linked_instance_at_rates<Number, Function, alignment>::results
linked_instance_at_rates<Number, Function, alignment>::evaluate(const Number& t,
                                                                const typename vectors::state& x,
                                                                const typename vectors::parameters& p,
                                                                const typename vectors::inputs& r,
                                                                const typename vectors::rates& a) noexcept {
  return results_or_reason<Number, Function, results>(t, x, p, r, a);
}

/// Whether the survey in the generated header matches the system.
template <class System>
constexpr bool is_up_to_date() {
  const derivation::survey &written = surveyed<System>::survey,
                           &derived = derivation::stages_of<System>::constrained.known;
  bool same = written.takes_rates_as_speeds == derived.takes_rates_as_speeds &&
              written.coordinates == derived.coordinates && written.speeds == derived.speeds &&
              written.state_variables == derived.state_variables &&
              written.parameters == derived.parameters && written.inputs == derived.inputs &&
              written.auxiliary_speeds == derived.auxiliary_speeds &&
              written.constraints == derived.constraints &&
              written.configuration_constraints == derived.configuration_constraints &&
              written.redundant_constraints == derived.redundant_constraints &&
              written.quaternions == derived.quaternions;
  for (int i = 0; i < derived.symbols(); ++i)
    same = same && written.names[i] == derived.names[i] && written.dependent[i] == derived.dependent[i] &&
           written.quaternion_of[i] == derived.quaternion_of[i];
  return same;
}

template <class Number, class... Functions>
constexpr auto code_of(function_list<Functions...>) {
  return std::tuple(std::pair(&linked_instance<Number, Functions>::evaluate,
                              &linked_instance<Number, Functions>::digest)...);
}
template <class Number, class... Functions>
constexpr auto code_at_rates_of(function_list<Functions...>) {
  return std::tuple(&linked_instance_at_rates<Number, Functions>::evaluate...);
}
template <class System>
constexpr auto all_code_of() {
  return std::tuple(code_of<double>(typename linked_functions<System>::type{}),
                    code_at_rates_of<double>(typename linked_functions_at_rates<System>::type{}),
                    code_of<std::complex<double>>(typename linked_functions_of_complex<System>::type{}));
}

/// All functions of a linked model. An explicit instantiation puts them into an object file.
template <class System>
class library_of {
  static_assert(is_up_to_date<System>(),
                "the header of this model was generated for an earlier version of the model");
  using table = decltype(all_code_of<System>());

public:
  /// References every function, so that the library contains all of them.
  static const table functions;
};
template <class System>
const typename library_of<System>::table library_of<System>::functions = all_code_of<System>();

} // namespace kanexpr::compiled
