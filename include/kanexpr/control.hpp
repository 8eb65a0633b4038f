#pragma once

/// What a control loop needs beside the equations: discrete forms of linear systems, linear-quadratic
/// regulators, also computed by the compiler, the extended Kalman filter, and steps with their derivatives.
/// Without a heap.

#include <kanexpr/compiler.hpp>

#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/control/discretize.hpp>
#include <kanexpr/control/ekf.hpp>
#include <kanexpr/control/gain_schedule.hpp>
#include <kanexpr/control/lqr.hpp>
#include <kanexpr/steps/linearized_step.hpp>
#include <kanexpr/version.hpp>
