#pragma once

#include <string_view>

namespace kanexpr::exporting::fmi_source {

/// Creation, modes and steps of an instance.
inline constexpr std::string_view life = R"(
static void start(instance *of) {
  int i;
  for (i = 0; i < states; ++i) of->x[i] = start_of_states[i];
  for (i = 0; i < parameters; ++i) of->p[i] = start_of_parameters[i];
  for (i = 0; i < inputs; ++i) of->r[i] = start_of_inputs[i];
  of->t = 0;
  of->tolerance = 1e-8; /* default */
  of->mode = instantiated;
  of->known = 0;
  of->may_be_off = false;
}

static instance *made(const char *given_token, void *environment, log_message log, bool is_stepped) {
  instance *of;
  if (given_token == NULL || strcmp(given_token, token) != 0) {
    if (log != NULL)
      log(environment, fmi3Error, "logStatusError", "the instantiation token belongs to a different model description");
    return NULL;
  }
  of = (instance *)calloc(1, sizeof(instance));
  if (of == NULL) return NULL;
  of->environment = environment;
  of->log = log;
  of->is_stepped = is_stepped;
  start(of);
  return of;
}

EXPORTED const char *fmi3GetVersion(void) { return "3.0"; }

EXPORTED void *fmi3InstantiateModelExchange(const char *name, const char *given_token, const char *resources, bool visible,
                                            bool logging, void *environment, log_message log) {
  (void)name, (void)resources, (void)visible, (void)logging;
  return made(given_token, environment, log, false);
}

EXPORTED void *fmi3InstantiateCoSimulation(const char *name, const char *given_token, const char *resources, bool visible,
                                           bool logging, bool with_event_mode, bool early_return,
                                           const fmi3ValueReference *required, size_t required_count, void *environment,
                                           log_message log, void (*intermediate)(void)) {
  (void)name, (void)resources, (void)visible, (void)logging, (void)with_event_mode, (void)early_return;
  (void)required, (void)required_count, (void)intermediate;
  return made(given_token, environment, log, true);
}

EXPORTED void *fmi3InstantiateScheduledExecution(const char *name, const char *given_token, const char *resources,
                                                 bool visible, bool logging, void *environment, log_message log,
                                                 void (*clock)(void), void (*lock)(void), void (*unlock)(void)) {
  (void)name, (void)given_token, (void)resources, (void)visible, (void)logging, (void)clock, (void)lock, (void)unlock;
  if (log != NULL) log(environment, fmi3Error, "logStatusError", "scheduled execution is not supported");
  return NULL;
}

EXPORTED void fmi3FreeInstance(void *of) { free(of); }

EXPORTED fmi3Status fmi3SetDebugLogging(void *of, bool on, size_t count, const char *const *categories) {
  (void)of, (void)on, (void)count, (void)categories;
  return fmi3OK;
}

/* Changes the mode; reports an error if the current mode is not `from`. */
static fmi3Status go(instance *of, enum mode from, enum mode to, const char *function) {
  if (of->mode != from) return say(of, fmi3Error, function);
  of->mode = to;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3EnterInitializationMode(void *given, bool has_tolerance, double tolerance, double from, bool has_end,
                                                double end) {
  instance *const of = (instance *)given;
  const fmi3Status status =
      go(of, instantiated, initialization,
         "fmi3EnterInitializationMode requires an instance that was instantiated or reset");
  (void)has_end, (void)end;
  if (status != fmi3OK) return status;
  if (has_tolerance && tolerance > 0) of->tolerance = tolerance;
  of->t = from;
  of->known = 0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3ExitInitializationMode(void *given) {
  instance *const of = (instance *)given;
  fmi3Status status;
  if (of->mode != initialization)
    return say(of, fmi3Error, "fmi3ExitInitializationMode requires initialization mode");
  if (prepare(of) != fmi3OK || (indicators > 0 && begin_indicators(of) != fmi3OK)) return fmi3Error;
  status = go(of, initialization, of->is_stepped ? step_mode : event_mode, "");
  return status;
}

EXPORTED fmi3Status fmi3EnterEventMode(void *given) {
  return go((instance *)given, continuous_time, event_mode, "fmi3EnterEventMode requires continuous-time mode");
}

EXPORTED fmi3Status fmi3EnterContinuousTimeMode(void *given) {
  return go((instance *)given, event_mode, continuous_time, "fmi3EnterContinuousTimeMode requires event mode");
}

EXPORTED fmi3Status fmi3Terminate(void *given) {
  instance *const of = (instance *)given;
  if (of->mode < event_mode || of->mode == terminated)
    return say(of, fmi3Error, "fmi3Terminate requires an initialized instance");
  of->mode = terminated;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3Reset(void *given) {
  start((instance *)given);
  return fmi3OK;
}

EXPORTED fmi3Status fmi3UpdateDiscreteStates(void *given, bool *again, bool *ends, bool *nominals_changed,
                                             bool *states_changed, bool *has_next_event, double *next_event) {
  instance *const of = (instance *)given;
  *again = *ends = *nominals_changed = *states_changed = *has_next_event = false;
  *next_event = 0;
  if (of->mode != event_mode) return say(of, fmi3Error, "fmi3UpdateDiscreteStates requires event mode");
  if (drifts) {
    const fmi3Status status = look_for_drift(of, states_changed);
    if (status != fmi3OK) return status;
    if (*states_changed && to_constraints(of) != fmi3OK) return fmi3Discard;
  }
  return indicators > 0 ? handle_events(of, states_changed, ends) : fmi3OK;
}

EXPORTED fmi3Status fmi3EvaluateDiscreteStates(void *of) {
  (void)of;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3CompletedIntegratorStep(void *of, bool is_final, bool *enter_event_mode, bool *ends) {
  bool is_far = false, any = false;
  fmi3Status status = fmi3OK;
  (void)is_final;
  *enter_event_mode = *ends = false;
  if (((instance *)of)->mode != continuous_time)
    return say((instance *)of, fmi3Error, "fmi3CompletedIntegratorStep requires continuous-time mode");
  if (drifts) status = look_for_drift((instance *)of, &is_far);
  if (status == fmi3OK) status = follow_indicators((instance *)of, &any);
  *enter_event_mode = is_far || any;
  return status;
}

EXPORTED fmi3Status fmi3DoStep(void *given, double from, double length, bool is_final, bool *event, bool *ends, bool *early,
                               double *reached) {
  instance *const of = (instance *)given;
  const double most = 1e10; /* internal steps: years of computing time */
  double count, i;
  fmi3Status status;
  (void)is_final;
  *event = *ends = *early = false;
  *reached = of->t;
  if (of->mode != step_mode) return say(of, fmi3Error, "fmi3DoStep requires step mode");
  if (!(length > 0) || !isfinite(length)) return say(of, fmi3Error, "the length of a step must be positive and finite");
  if (!isfinite(from) || !(fabs(from - of->t) <= 1e-9 * (length + fabs(from))))
    return say(of, fmi3Error, "a step must begin at the end of the last one");
  count = fmax(1, ceil(length / internal_step - 1e-9));
  if (count > most) return say(of, fmi3Error, "a step may consist of at most 1e10 internal steps");
  if (!(from + length / count > from))
    return say(of, fmi3Error, "the internal step is below the resolution of the time");
  status = prepare(of);
  for (i = 0; i < count && status == fmi3OK && !*ends; ++i) status = step_with_events(of, length / count, ends);
  if (status == fmi3OK && !*ends) of->t = from + length;
  *reached = of->t;
  return status;
}
)";

/// Values and derivatives.
inline constexpr std::string_view values = R"(
static const char after_the_end[] = "no variable can be set after fmi3Terminate";

static bool is_among(int reference, int first, int end) { return reference >= first && reference < end; }

static fmi3Status value(instance *of, fmi3ValueReference of_variable, double *found) {
  const int i = (int)of_variable;
  fmi3Status status = fmi3OK;
  if (is_among(i, FIRST_RATE, FIRST_PARAMETER)) status = find_rates(of);
  if (is_among(i, FIRST_OUTPUT, END)) status = find_measured(of);
  if (status != fmi3OK) return status;
  if (i == 0)
    *found = of->t;
  else if (is_among(i, FIRST_STATE, FIRST_RATE))
    *found = of->x[i - FIRST_STATE];
  else if (is_among(i, FIRST_RATE, FIRST_PARAMETER))
    *found = of->rates[i - FIRST_RATE];
  else if (is_among(i, FIRST_PARAMETER, FIRST_INPUT))
    *found = of->p[i - FIRST_PARAMETER];
  else if (is_among(i, FIRST_INPUT, FIRST_OUTPUT))
    *found = of->r[i - FIRST_INPUT];
  else if (is_among(i, FIRST_OUTPUT, FIRST_OUTPUT + outputs))
    *found = of->measured[i - FIRST_OUTPUT];
  else if (is_among(i, FIRST_OUTPUT + outputs, END))
    *found = indicator(of, i - FIRST_OUTPUT - outputs);
  else
    return say(of, fmi3Error, "there is no variable of this value reference");
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetFloat64(void *given, const fmi3ValueReference *of_variables, size_t count, double *found,
                                   size_t size) {
  instance *const of = (instance *)given;
  fmi3Status status;
  size_t i;
  if (count != size) return say(of, fmi3Error, "array variables are not supported");
  if ((status = prepare(of)) != fmi3OK) return status;
  for (i = 0; i < count && status == fmi3OK; ++i) status = value(of, of_variables[i], &found[i]);
  return status;
}

/* The value of a variable that a tool may set; null if it may not. */
static double *settable(instance *of, fmi3ValueReference of_variable) {
  const int i = (int)of_variable;
  if (is_among(i, FIRST_STATE, FIRST_RATE)) return of->mode == step_mode ? NULL : &of->x[i - FIRST_STATE];
  if (is_among(i, FIRST_PARAMETER, FIRST_INPUT)) return &of->p[i - FIRST_PARAMETER];
  return is_among(i, FIRST_INPUT, FIRST_OUTPUT) ? &of->r[i - FIRST_INPUT] : NULL;
}

EXPORTED fmi3Status fmi3SetFloat64(void *given, const fmi3ValueReference *of_variables, size_t count,
                                   const double *values, size_t size) {
  instance *const of = (instance *)given;
  size_t k;
  if (count != size) return say(of, fmi3Error, "array variables are not supported");
  if (of->mode == terminated) return say(of, fmi3Error, after_the_end);
  for (k = 0; k < count; ++k)
    if (settable(of, of_variables[k]) == NULL)
      return say(of, fmi3Error, is_among((int)of_variables[k], FIRST_STATE, FIRST_RATE)
                                    ? "the state of a co-simulation changes only by steps"
                                    : "this variable cannot be set");
  for (k = 0; k < count; ++k) *settable(of, of_variables[k]) = values[k];
  of->known = 0;
  of->may_be_off = drifts && of->mode == step_mode;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetTime(void *given, double time) {
  instance *const of = (instance *)given;
  if (of->is_stepped) return say(of, fmi3Error, "the time of a co-simulation advances only by steps");
  if (of->mode == terminated) return say(of, fmi3Error, after_the_end);
  of->t = time;
  of->known = 0;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3SetContinuousStates(void *given, const double *x, size_t count) {
  instance *const of = (instance *)given;
  int i;
  if (of->is_stepped) return say(of, fmi3Error, "the state of a co-simulation changes only by steps");
  if (of->mode == terminated) return say(of, fmi3Error, after_the_end);
  if (count != states) return say(of, fmi3Error, "the number of states does not match the model");
  for (i = 0; i < states; ++i) of->x[i] = x[i];
  of->known = 0;
  return fmi3OK;
}

static fmi3Status copied(instance *of, size_t count, int present, const double *from, double *to) {
  int i;
  if (count != (size_t)present) return say(of, fmi3Error, "the number of values does not match the model");
  for (i = 0; i < present; ++i) to[i] = from[i];
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetContinuousStates(void *given, double *x, size_t count) {
  instance *const of = (instance *)given;
  const fmi3Status status = prepare(of);
  return status == fmi3OK ? copied(of, count, states, of->x, x) : status;
}

EXPORTED fmi3Status fmi3GetContinuousStateDerivatives(void *given, double *rates, size_t count) {
  instance *const of = (instance *)given;
  fmi3Status status = prepare(of);
  if (status == fmi3OK) status = find_rates(of);
  return status == fmi3OK ? copied(of, count, states, of->rates, rates) : status;
}

EXPORTED fmi3Status fmi3GetEventIndicators(void *given, double *found, size_t count) {
  instance *const of = (instance *)given;
  int i;
  fmi3Status status = prepare(of);
  if (status == fmi3OK && indicators > 0) status = find_measured(of);
  if (status == fmi3OK && count != indicators)
    status = say(of, fmi3Error, "the number of event indicators does not match the model");
  for (i = 0; status == fmi3OK && i < indicators; ++i) found[i] = indicator(of, i);
  return status;
}

EXPORTED fmi3Status fmi3GetNominalsOfContinuousStates(void *given, double *nominals, size_t count) {
  size_t i;
  if (count != states) return say((instance *)given, fmi3Error, "the number of states does not match the model");
  for (i = 0; i < count; ++i) nominals[i] = 1;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetNumberOfEventIndicators(void *of, size_t *count) {
  (void)of;
  *count = indicators;
  return fmi3OK;
}

EXPORTED fmi3Status fmi3GetNumberOfContinuousStates(void *of, size_t *count) {
  (void)of;
  *count = states;
  return fmi3OK;
}

/* ∂unknown/∂known for two variables, given by their value references. */
static fmi3Status partial(instance *of, fmi3ValueReference unknown, fmi3ValueReference known, double *found) {
  const int y = (int)unknown, z = (int)known;
  const bool is_state = is_among(z, FIRST_STATE, FIRST_RATE), is_input = is_among(z, FIRST_INPUT, FIRST_OUTPUT);
  fmi3Status status = fmi3OK;
  if (z != 0 && !is_state && !is_input)
    return say(of, fmi3Error, "derivatives are available only with respect to states, inputs and the time");
  if (is_among(y, FIRST_STATE, FIRST_RATE)) {
    *found = y == z;
  } else if (is_among(y, FIRST_RATE, FIRST_PARAMETER)) {
    const int row = y - FIRST_RATE;
    if ((status = find_jacobian(of)) == fmi3OK)
      *found = is_state   ? of->by_state[row * states + z - FIRST_STATE]
               : is_input ? of->by_inputs[row * inputs + z - FIRST_INPUT]
                          : of->by_time[row];
  } else if (is_among(y, FIRST_OUTPUT, END)) {
    const int row = y - FIRST_OUTPUT;
    if ((status = find_measured_derivatives(of)) == fmi3OK)
      *found = is_state   ? of->measured_by_state[row * states + z - FIRST_STATE]
               : is_input ? of->measured_by_inputs[row * inputs + z - FIRST_INPUT]
                          : of->measured_by_time[row];
  } else {
    return say(of, fmi3Error, "derivatives are available only of states, their rates and outputs");
  }
  return status;
}

static fmi3Status products(instance *of, const fmi3ValueReference *unknowns, size_t unknown_count,
                           const fmi3ValueReference *knowns, size_t known_count, const double *seed, double *found,
                           bool is_adjoint) {
  const size_t size = is_adjoint ? known_count : unknown_count;
  size_t i, j;
  fmi3Status status;
  if (drifts && of->mode <= initialization)
    return say(of, fmi3Error,
               "derivatives are not available before the end of initialization, because dependent states follow from others");
  status = prepare(of);
  for (i = 0; i < size; ++i) found[i] = 0;
  for (i = 0; i < unknown_count && status == fmi3OK; ++i)
    for (j = 0; j < known_count && status == fmi3OK; ++j) {
      double each = 0;
      if ((status = partial(of, unknowns[i], knowns[j], &each)) == fmi3OK)
        found[is_adjoint ? j : i] += each * seed[is_adjoint ? i : j];
    }
  return status;
}

EXPORTED fmi3Status fmi3GetDirectionalDerivative(void *given, const fmi3ValueReference *unknowns, size_t unknown_count,
                                                 const fmi3ValueReference *knowns, size_t known_count,
                                                 const double *seed, size_t seed_size, double *found, size_t size) {
  instance *const of = (instance *)given;
  if (seed_size != known_count || size != unknown_count)
    return say(of, fmi3Error, "array variables are not supported");
  return products(of, unknowns, unknown_count, knowns, known_count, seed, found, false);
}

EXPORTED fmi3Status fmi3GetAdjointDerivative(void *given, const fmi3ValueReference *unknowns, size_t unknown_count,
                                             const fmi3ValueReference *knowns, size_t known_count, const double *seed,
                                             size_t seed_size, double *found, size_t size) {
  instance *const of = (instance *)given;
  if (seed_size != unknown_count || size != known_count)
    return say(of, fmi3Error, "array variables are not supported");
  return products(of, unknowns, unknown_count, knowns, known_count, seed, found, true);
}
)";

} // namespace kanexpr::exporting::fmi_source
