#pragma once

/// Defines the static members of a class that gives the functions of one package of SUNDIALS the names that
/// they share. `Prefix` begins the names of the package's functions, and `CODE` those of its return codes.
#define KANEXPR_SUNDIALS_CALLS(Prefix, CODE)                                                                 \
  static constexpr auto free = Prefix##Free;                                                                 \
  static constexpr auto set_error_handler = Prefix##SetErrHandlerFn;                                         \
  static constexpr auto set_user_data = Prefix##SetUserData;                                                 \
  static constexpr auto set_weights = Prefix##WFtolerances;                                                  \
  static constexpr auto set_first_step = Prefix##SetInitStep;                                                \
  static constexpr auto set_least_step = Prefix##SetMinStep;                                                 \
  static constexpr auto set_greatest_step = Prefix##SetMaxStep;                                              \
  static constexpr auto set_end = Prefix##SetStopTime;                                                       \
  static constexpr auto watch = Prefix##RootInit;                                                            \
  static constexpr auto set_directions = Prefix##SetRootDirection;                                           \
  static constexpr auto no_warnings = Prefix##SetNoInactiveRootWarn;                                         \
  static constexpr auto root_info = Prefix##GetRootInfo;                                                     \
  static constexpr auto derivative = Prefix##GetDky;                                                         \
  static constexpr auto last_step = Prefix##GetLastStep;                                                     \
  static constexpr auto next_step = Prefix##GetCurrentStep;                                                  \
  static constexpr auto current_time = Prefix##GetCurrentTime;                                               \
  static constexpr auto steps = Prefix##GetNumSteps;                                                         \
  static constexpr auto error_test_failures = Prefix##GetNumErrTestFails;                                    \
  static constexpr auto solver_failures = Prefix##GetNumStepSolveFails;                                      \
  static constexpr auto jacobians = Prefix##GetNumJacEvals;                                                  \
  static constexpr auto set_linear_solver = Prefix##SetLinearSolver;                                         \
  static constexpr auto set_jacobian = Prefix##SetJacFn;                                                     \
  static constexpr auto error_weights = Prefix##GetErrWeights;                                               \
  static constexpr int event_failed = CODE##_RTFUNC_FAIL
