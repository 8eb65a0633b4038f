#pragma once

#include <string_view>

/// The parts of an FMU's C that are the same for all models, which begin with the counts of what there is.
/// Memory is taken where an instance is made, and nowhere else; nothing is shared between instances.
namespace kanexpr::exporting::in_c_of_fmu {

/// Types of FMI 3.0 as the standard describes them, and an instance.
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

/* What belongs to the values of an instance as they are. */
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
  bool is_positive[ROOM(indicators)]; /* by indicator, when events were looked for last */
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

/// For functions that have something to check.
inline constexpr std::string_view failure = R"(
/* Says which of the checks failed. */
static fmi3Status failed(const instance *of, unsigned long long status, const char *const *causes, int count) {
  int i;
  for (i = 0; i < count; ++i)
    if (status >> i & 1) say(of, fmi3Discard, causes[i]);
  return fmi3Discard;
}
)";

/// Constraints, events and steps of a fixed length, on functions that evaluate the model.
inline constexpr std::string_view motion = R"(
/* How far the next state is from this one, each entry by its size. */
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

/* Steps of Newton's method, each of which squares what is left. */
static fmi3Status to_constraints(instance *of) {
  enum { most_steps = 100 };
  const double close = 1e-9;
  double way = drifts ? 2 * close : 0;
  int done;
  for (done = 0; !(way <= close) && done < most_steps; ++done) {
    const fmi3Status status = find_correction(of);
    if (status != fmi3OK) return status;
    way = way_to_next(of);
    go_to_next(of);
  }
  if (!(way <= close)) return say(of, fmi3Discard, "Newton's method finds no state that satisfies the constraints");
  of->known |= is_on_constraints;
  return fmi3OK;
}

/* Until the initialization is over, what is asked for follows from what is independent. */
static fmi3Status prepare(instance *of) {
  if (of->mode > initialization || (of->known & is_on_constraints)) return fmi3OK;
  return to_constraints(of);
}

/* Whether a solver lost the constraints by more than its tolerance; the next state has them. */
static fmi3Status look_for_drift(instance *of, bool *is_far) {
  const fmi3Status status = find_correction(of);
  *is_far = status == fmi3OK && way_to_next(of) > of->tolerance;
  return status;
}

static fmi3Status look_at_indicators(instance *of) {
  const fmi3Status status = find_measured(of);
  int i;
  if (status == fmi3OK)
    for (i = 0; i < indicators; ++i) of->is_positive[i] = of->measured[outputs + i] > 0;
  return status;
}

static bool passes(const instance *of, int indicator) {
  const bool is_positive = of->measured[outputs + indicator] > 0;
  return is_positive != of->is_positive[indicator] &&
         (direction[indicator] == 0 || (direction[indicator] > 0) == is_positive);
}

/* All that happens at this instant. The values of all changes are those of the state before. */
static fmi3Status handle_events(instance *of, bool *is_changed, bool *ends) {
  fmi3Status status = find_measured(of);
  bool are_known = false; /* the changes */
  int i;
  if (status != fmi3OK) return status;
  for (i = 0; i < indicators; ++i)
    if (passes(of, i)) *ends = *ends || ends_motion[i];
  for (i = 0; i < change_count; ++i)
    if (passes(of, changed_by[i])) {
      if (!are_known && (status = find_changes(of)) != fmi3OK) return status;
      are_known = true;
      of->x[changed_place[i]] = of->changes[i];
    }
  if (are_known) {
    *is_changed = true;
    of->known = 0;
    if ((status = to_constraints(of)) != fmi3OK) return status;
  }
  return look_at_indicators(of);
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

static fmi3Status pass_any(instance *of, bool *any) {
  const fmi3Status status = indicators > 0 ? find_measured(of) : fmi3OK;
  int i;
  *any = false;
  for (i = 0; status == fmi3OK && i < indicators; ++i) *any = *any || passes(of, i);
  return status;
}

/* Between events an indicator may pass zero the other way. */
static fmi3Status follow_indicators(instance *of, bool *any) {
  const fmi3Status status = pass_any(of, any);
  int i;
  if (status == fmi3OK)
    for (i = 0; i < indicators; ++i)
      if (!passes(of, i)) of->is_positive[i] = of->measured[outputs + i] > 0;
  return status;
}

/* A step with the events that it holds, each found by halving. Where it fails, nothing has moved since the last of
   these. */
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

} // namespace kanexpr::exporting::in_c_of_fmu
