#pragma once

#include <string_view>

/// The parts of an FMU's C code that are the same for all models; they rely on the counts defined before
/// them. Memory is allocated only when an instance is created; instances share nothing.
namespace kanexpr::exporting::fmi_source {

/// Types of FMI 3.0 as defined by the standard, and the instance.
inline constexpr std::string_view declarations = R"(
#if defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

#define ROOM(count) ((count) > 0 ? (count) : 1)

typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef uint32_t fmi3ValueReference;
typedef void (*log_message)(void *environment, fmi3Status status, const char *category, const char *message);

enum mode { instantiated, initialization, event_mode, continuous_time, step_mode, terminated };

/* Flags for the results that are up to date with the values of an instance. */
enum { rates_are_known = 1, measured_is_known = 2, jacobian_is_known = 4, measured_jacobian_is_known = 8,
       is_on_constraints = 16 };

typedef struct {
  void *environment;
  log_message log;
  bool is_stepped; /* co-simulation */
  enum mode mode;
  unsigned known;
  double t, x[ROOM(states)], p[ROOM(parameters)], r[ROOM(inputs)];
  double rates[ROOM(states)], measured[ROOM(measured_count)], changes[ROOM(change_count)];
  double by_state[ROOM(states *states)], by_inputs[ROOM(states *inputs)], by_time[ROOM(states)];
  double measured_by_state[ROOM(measured_count *states)], measured_by_inputs[ROOM(measured_count *inputs)];
  double measured_by_time[ROOM(measured_count)];
  double next[ROOM(states)];
  double tolerance; /* of the solver */
  bool may_be_off; /* the constraints may be violated, as a value was set since the last step */
  bool is_positive[ROOM(indicators)]; /* sign of each indicator at the last check for events */
  bool is_zero[ROOM(indicators)];     /* at that check; leaving zero is not a crossing */
  double level[ROOM(indicators)];     /* treated as zero while an indicator is about to cross zero or to return */
} instance;

static fmi3Status say(const instance *of, fmi3Status status, const char *message) {
  if (of->log != NULL)
    of->log(of->environment, status, status == fmi3Discard ? "logStatusDiscard" : "logStatusError", message);
  return status;
}

static fmi3Status finite(const instance *of, const double *values, int count) {
  int i;
  for (i = 0; i < count; ++i)
    if (!isfinite(values[i])) return say(of, fmi3Discard, "the results are not finite at this state");
  return fmi3OK;
}
)";

/// Used by functions that have checks.
inline constexpr std::string_view failure = R"(
/* Reports the checks that failed. */
static fmi3Status failed(const instance *of, unsigned long long status, const char *const *causes, int count) {
  int i;
  for (i = 0; i < count; ++i)
    if (status >> i & 1) say(of, fmi3Discard, causes[i]);
  return fmi3Discard;
}
)";

/// Constraints, events and steps of fixed length, based on the functions that evaluate the model.
inline constexpr std::string_view motion = R"(
/* The largest change from this state to the next, each entry relative to its size. */
static double way_to_next(const instance *of) {
  double longest = 0;
  int i;
  for (i = 0; i < states; ++i) {
    const double each = fabs(of->next[i] - of->x[i]) / (1 + fabs(of->x[i]));
    if (!(each <= longest)) longest = each;
  }
  return longest;
}

static void go_to_next(instance *of) {
  int i;
  for (i = 0; i < states; ++i) of->x[i] = of->next[i];
  of->known = 0;
}

static const double close_to_constraints = 1e-9;

/* Newton's method, which converges quadratically. If it fails, the state is unchanged. */
static fmi3Status to_constraints(instance *of) {
  enum { most_steps = 100 };
  double way = drifts ? 2 * close_to_constraints : 0, before[ROOM(states)];
  fmi3Status status = fmi3OK;
  int done, i;
  for (i = 0; i < states; ++i) before[i] = of->x[i];
  for (done = 0; !(way <= close_to_constraints) && done < most_steps; ++done) {
    if ((status = find_correction(of)) != fmi3OK) break;
    way = way_to_next(of);
    go_to_next(of);
  }
  if (status == fmi3OK && !(way <= close_to_constraints))
    status = say(of, fmi3Discard, "Newton's method found no state that satisfies the constraints");
  if (status == fmi3OK) {
    of->known |= is_on_constraints;
  } else {
    for (i = 0; i < states; ++i) of->x[i] = before[i];
    of->known = 0;
  }
  return status;
}

/* Before the end of initialization, and after a tool has changed a parameter or an input of a co-simulation, dependent
   states are computed from independent ones. A state on the constraints is not changed, not even in the last bit. */
static fmi3Status prepare(instance *of) {
  fmi3Status status = fmi3OK;
  if (of->mode <= initialization) return (of->known & is_on_constraints) ? fmi3OK : to_constraints(of);
  if (!of->may_be_off) return fmi3OK;
  if ((status = find_correction(of)) == fmi3OK && !(way_to_next(of) <= close_to_constraints))
    status = to_constraints(of);
  of->may_be_off = status != fmi3OK;
  return status;
}

/* Checks whether a solver violates the constraints by more than its tolerance; `next` satisfies them. */
static fmi3Status look_for_drift(instance *of, bool *is_far) {
  const fmi3Status status = find_correction(of);
  *is_far = status == fmi3OK && way_to_next(of) > of->tolerance;
  return status;
}

static double indicator(const instance *of, int i) { return of->measured[outputs + i] - of->level[i]; }

/* Records on which side of zero an indicator is. */
static void look_at(instance *of, int i) {
  const double found = of->measured[outputs + i], level = of->level[i];
  if (!((level < found && found <= 0) || (0 <= found && found <= level && level > 0))) of->level[i] = 0;
  of->is_positive[i] = indicator(of, i) > 0;
  of->is_zero[i] = indicator(of, i) == 0;
}

static fmi3Status look_at_indicators(instance *of) {
  const fmi3Status status = find_measured(of);
  int i;
  if (status == fmi3OK)
    for (i = 0; i < indicators; ++i) look_at(of, i);
  return status;
}

/* The change of an indicator when the state and the time change by rounding errors. */
static double rounding_of(const instance *of, int i) {
  const int row = outputs + i;
  double sum = fabs(of->measured_by_time[row]) * (1 + fabs(of->t));
  int j;
  for (j = 0; indicators > 0 && j < states; ++j)
    sum += fabs(of->measured_by_state[row * states + j]) * (1 + fabs(of->x[j]));
  return 1e-12 * sum;
}

/* Lets an indicator that is zero up to rounding cross zero again: it counts as being on the side from which it would
   come. Requires up-to-date derivatives. */
static void wait_for(instance *of, int i, int direction_of_passing) {
  const double found = of->measured[outputs + i], rounding = rounding_of(of, i);
  if (fabs(found) <= 1000 * rounding)
    of->level[i] = direction_of_passing < 0 ? fmin(found, 0) - rounding : fmax(found, 0) + rounding;
}

/* At the start there is no previous sign: an indicator that is zero there crosses zero if it leaves zero in the
   direction of its event. */
static fmi3Status begin_indicators(instance *of) {
  fmi3Status status = find_measured(of);
  double largest = 0;
  int i;
  for (i = 0; i < states; ++i) largest = fmax(largest, fabs(of->x[i]));
  for (i = 0; status == fmi3OK && i < indicators; ++i) {
    const double found = of->measured[outputs + i];
    of->level[i] = 0;
    if (direction[i] * found < 0 || direction[i] == 0 || fabs(found) > 1e-9 * (1 + largest)) continue;
    if ((status = find_measured_derivatives(of)) == fmi3OK) wait_for(of, i, direction[i]);
  }
  return status == fmi3OK ? look_at_indicators(of) : status;
}

/* The direction in which an indicator has crossed or reached zero; 0 if it has not, or not in the event's direction. */
static int passed(const instance *of, int i) {
  const double found = indicator(of, i);
  const bool is_positive = found == 0 ? !of->is_positive[i] : found > 0;
  if (of->is_zero[i] || is_positive == of->is_positive[i] || (direction[i] != 0 && (direction[i] > 0) != is_positive)) return 0;
  return is_positive ? 1 : -1;
}

/* The rates of the indicators at constant inputs. */
static fmi3Status find_slopes(instance *of, double *slopes) {
  fmi3Status status = find_rates(of);
  int i, j;
  if (status == fmi3OK) status = find_measured_derivatives(of);
  for (i = 0; status == fmi3OK && i < indicators; ++i) {
    slopes[i] = of->measured_by_time[outputs + i];
    for (j = 0; indicators > 0 && j < states; ++j)
      slopes[i] += of->measured_by_state[(outputs + i) * states + j] * of->rates[j];
  }
  return status;
}

/* Handles all events at this instant. All new values are computed from the state before. An indicator whose rate its
   event has reversed or set to zero may cross zero again immediately. */
static fmi3Status handle_events(instance *of, bool *is_changed, bool *ends) {
  fmi3Status status = find_measured(of);
  int happened[ROOM(indicators)], has_changed[ROOM(indicators)];
  double before[ROOM(indicators)], after[ROOM(indicators)];
  bool any = false; /* changes */
  int i;
  if (status != fmi3OK) return status;
  for (i = 0; i < indicators; ++i) {
    happened[i] = passed(of, i);
    has_changed[i] = 0;
    *ends = *ends || (happened[i] != 0 && ends_motion[i]);
  }
  for (i = 0; i < change_count; ++i)
    if (happened[changed_by[i]] != 0) has_changed[changed_by[i]] = any = true;
  if (any) {
    if ((status = find_slopes(of, before)) != fmi3OK || (status = find_changes(of)) != fmi3OK) return status;
    for (i = 0; i < change_count; ++i)
      if (happened[changed_by[i]] != 0) of->x[changed_place[i]] = of->changes[i];
    *is_changed = true;
    of->known = 0;
    if ((status = to_constraints(of)) != fmi3OK) return status;
    if ((status = find_slopes(of, after)) != fmi3OK || (status = find_measured(of)) != fmi3OK) return status;
    for (i = 0; i < indicators; ++i)
      if (has_changed[i] && after[i] * happened[i] <= 1e-6 * fabs(before[i])) wait_for(of, i, happened[i]);
  }
  return look_at_indicators(of);
}

static fmi3Status pass_any(instance *of, bool *any) {
  const fmi3Status status = indicators > 0 ? find_measured(of) : fmi3OK;
  int i;
  *any = false;
  for (i = 0; status == fmi3OK && i < indicators; ++i) *any = *any || passed(of, i) != 0;
  return status;
}

/* Between events, an indicator may cross zero in the other direction. */
static fmi3Status follow_indicators(instance *of, bool *any) {
  const fmi3Status status = pass_any(of, any);
  int i;
  if (status == fmi3OK)
    for (i = 0; i < indicators; ++i)
      if (passed(of, i) == 0) look_at(of, i);
  return status;
}

static fmi3Status advance(instance *of, const double *from, double t, double h) {
  fmi3Status status;
  int i;
  for (i = 0; i < states; ++i) of->x[i] = from[i];
  of->t = t;
  of->known = 0;
  if ((status = find_step(of, h)) != fmi3OK) return status;
  go_to_next(of);
  of->t = t + h;
  return fmi3OK;
}

/* A step with the events in it, each located by bisection. If the step fails, the state is left at the last event. */
static fmi3Status step_with_events(instance *of, double h, bool *ends) {
  enum { most_events = 100, most_halvings = 60 };
  double left = h, before[ROOM(states)];
  int events, halvings, i;
  for (events = 0; left > 0 && !*ends; ++events) {
    const double t = of->t;
    double earliest = 0, latest = left;
    bool any = false, is_changed = false;
    fmi3Status status;
    if (events == most_events) return say(of, fmi3Discard, "more than 100 events happen in one internal step");
    for (i = 0; i < states; ++i) before[i] = of->x[i];
    status = advance(of, before, t, left);
    if (status == fmi3OK) status = pass_any(of, &any);
    if (status == fmi3OK && any) {
      for (halvings = 0; halvings < most_halvings && latest - earliest > 1e-16 * (fabs(t) + h); ++halvings) {
        const double middle = 0.5 * (earliest + latest);
        if ((status = advance(of, before, t, middle)) != fmi3OK || (status = pass_any(of, &any)) != fmi3OK) break;
        if (any)
          latest = middle;
        else
          earliest = middle;
      }
      if (status == fmi3OK && (status = advance(of, before, t, latest)) == fmi3OK)
        status = handle_events(of, &is_changed, ends);
    } else if (status == fmi3OK && indicators > 0) {
      status = look_at_indicators(of);
    }
    if (status != fmi3OK) {
      for (i = 0; i < states; ++i) of->x[i] = before[i];
      of->t = t;
      of->known = 0;
      return status;
    }
    left -= latest;
  }
  return fmi3OK;
}
)";

} // namespace kanexpr::exporting::fmi_source
