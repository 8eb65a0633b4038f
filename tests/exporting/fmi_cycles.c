/* Instances of an FMU that come and go, compiled with its sources and sanitizers: fmi_cycles TOKEN. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef void (*log_message)(void *, int, const char *, const char *);

void *fmi3InstantiateModelExchange(const char *, const char *, const char *, bool, bool, void *, log_message);
void *fmi3InstantiateCoSimulation(const char *, const char *, const char *, bool, bool, bool, bool, const uint32_t *,
                                  size_t, void *, log_message, void (*)(void));
void fmi3FreeInstance(void *);
int fmi3EnterInitializationMode(void *, bool, double, double, bool, double);
int fmi3ExitInitializationMode(void *);
int fmi3GetNumberOfContinuousStates(void *, size_t *);
int fmi3GetContinuousStateDerivatives(void *, double *, size_t);
int fmi3GetDirectionalDerivative(void *, const uint32_t *, size_t, const uint32_t *, size_t, const double *, size_t,
                                 double *, size_t);
int fmi3DoStep(void *, double, double, bool, bool *, bool *, bool *, double *);

static void *initialized(void *of) {
  return of != NULL && !fmi3EnterInitializationMode(of, false, 0, 0, false, 0) && !fmi3ExitInitializationMode(of)
             ? of
             : NULL;
}

int main(int count, char **arguments) {
  int cycle;
  for (cycle = 0; count > 1 && cycle < 5000; ++cycle) {
    const char *const token = arguments[1];
    void *const one = initialized(fmi3InstantiateModelExchange("one", token, NULL, false, false, NULL, NULL));
    void *const two = initialized(
        fmi3InstantiateCoSimulation("two", token, NULL, false, false, false, false, NULL, 0, NULL, NULL, NULL));
    const uint32_t state = 1;
    const double seed = 1;
    double rates[64], reached, slope;
    bool event, ends, early;
    size_t states = 0;
    if (one == NULL || two == NULL || fmi3GetNumberOfContinuousStates(one, &states) || states > 64 ||
        fmi3GetContinuousStateDerivatives(one, rates, states) ||
        fmi3GetDirectionalDerivative(one, &state, 1, &state, 1, &seed, 1, &slope, 1) ||
        fmi3DoStep(two, 0, 1e-3, true, &event, &ends, &early, &reached)) {
      fprintf(stderr, "cycle %d fails\n", cycle);
      return 1;
    }
    fmi3FreeInstance(one);
    fmi3FreeInstance(two);
  }
  printf("%d\n", cycle);
  return 0;
}
