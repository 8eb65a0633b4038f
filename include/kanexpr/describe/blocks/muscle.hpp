#pragma once

#include <kanexpr/describe/blocks/activation.hpp>
#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/muscle_record.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/mechanics/loads/muscle_parameters.hpp>

#include <cstddef>

namespace kanexpr {

namespace describe {

template <class Record>
inline constexpr bool is_muscle_parameters = false;
template <class... Values>
inline constexpr bool is_muscle_parameters<muscle_parameters<Values...>> = true;

/// The phrase of a parameter, or one of the kind `nothing` if it was not given.
template <auto value>
constexpr phrase phrase_if_given() {
  if constexpr (requires { value == mechanics::parameter_not_given{}; })
    return phrase{};
  else
    return phrase_of<value>;
}

/// The phrases, the state variables and the dynamics of a muscle.
template <class Self, auto excitation, auto parameters>
struct muscle_law {
  static constexpr state_variable_of<"a", Self> activation{};
  static constexpr state_variable_of<"F", Self> tendon_force{};
  static constexpr state_variable_of<"l", Self> fiber_length{};

  static constexpr auto rise = whole_argument(parameters.activation_time);
  static constexpr auto fall = whole_argument(parameters.deactivation_time);
  static constexpr auto dynamics = dot(activation) == activation_rate(activation, excitation, rise, fall);

  static constexpr phrase terms[]{phrase_if_given<parameters.peak_isometric_force>(),
                                  phrase_if_given<parameters.optimal_fiber_length>(),
                                  phrase_if_given<parameters.tendon_slack_length>(),
                                  phrase_if_given<parameters.maximal_fiber_velocity>(),
                                  phrase_if_given<parameters.pennation>(),
                                  phrase_if_given<parameters.fiber_damping>(),
                                  phrase_if_given<parameters.tendon_strain>(),
                                  phrase_if_given<parameters.passive_strain>()};

  static constexpr muscle_record record{
      .formulation = parameters.formulation,
      .tendon_state = parameters.formulation == muscle_formulation::rigid_tendon   ? phrase{}
                      : parameters.formulation == muscle_formulation::tendon_force ? phrase_of<tendon_force>
                                                                                   : phrase_of<fiber_length>};

  static constexpr void add_to(load_record& r) {
    r.muscle = &record;
    r.terms = terms;
    r.terms_given = static_cast<int>(sizeof(terms) / sizeof(phrase));
    constexpr bool is_delayed = parameters.has_activation_dynamics;
    r.value = is_delayed ? phrase_of<activation> : phrase_of<excitation>;
    if (is_delayed) {
      r.dynamics = list_of<phrase, &phrase_of<dynamics>>::all;
      r.positive = list_of<positive_argument, &positive_of<"the time of activation of ", rise>,
                           &positive_of<"the time of deactivation of ", fall>>::all;
    }
    r.states = states<is_delayed>();
  }

private:
  template <bool is_delayed>
  static constexpr listing<phrase> states() {
    constexpr muscle_formulation by = parameters.formulation;
    if constexpr (by == muscle_formulation::tendon_force)
      return states_with<is_delayed, &phrase_of<tendon_force>>();
    else if constexpr (by == muscle_formulation::fiber_length)
      return states_with<is_delayed, &phrase_of<fiber_length>>();
    else
      return states_with<is_delayed>();
  }
  template <bool is_delayed, const phrase*... of_tendon>
  static constexpr listing<phrase> states_with() {
    if constexpr (is_delayed)
      return list_of<phrase, &phrase_of<activation>, of_tendon...>::all;
    else
      return list_of<phrase, of_tendon...>::all;
  }
};

template <class Self, class Path, auto... excitation_and_parameters>
constexpr load_record record_muscle() {
  load_record r;
  r.what = load_word::muscle;
  r.word = "the muscle";
  r.called = type_name<Self>();
  r.fits = arguments_of("muscle<Self, Path, excitation, muscle_parameters{...}>",
                        sizeof...(excitation_and_parameters), 2);
  r.path = &path_of<Path>;
  r.muscle = &no_muscle;
  if constexpr (sizeof...(excitation_and_parameters) == 2) {
    constexpr auto excitation = argument_or_zero<0, excitation_and_parameters...>();
    constexpr auto parameters = one_of<1, excitation_and_parameters...>();
    if constexpr (is_muscle_parameters<std::remove_const_t<decltype(parameters)>>)
      muscle_law<Self, excitation, parameters>::add_to(r);
  }
  return r;
}

} // namespace describe

/// A muscle with its tendon along a pathway, after De Groote et al. (2016):
/// `struct Biceps : muscle<Biceps, straight<P, Q>, e, muscle_parameters{…}> {}` with the excitation e between
/// 0 and 1. The tension that it exerts is
///
///     F_max (a f_a(l) f_v(v) + f_p(l) + β v) cos α
///
/// where l and v are the length and the velocity of the fibers relative to the optimal length and the maximal
/// velocity, and α is their pennation angle. It brings its activation a, the state variable a_Biceps, whose
/// rate is that of `muscle_activation`, and with an elastic tendon one more: F_Biceps, the force of the
/// tendon relative to the peak isometric force, or l_Biceps, which is l. `muscle_equilibrium` gives
/// consistent initial values.
template <class Self, class Path, auto... excitation_and_parameters>
struct muscle : describe::load_words {
  static constexpr describe::state_variable_of<"a", Self> activation{};
  static constexpr describe::state_variable_of<"F", Self> tendon_force{};
  static constexpr describe::state_variable_of<"l", Self> fiber_length{};

  static constexpr describe::load_record load =
      describe::record_muscle<Self, Path, excitation_and_parameters...>();
};

} // namespace kanexpr
