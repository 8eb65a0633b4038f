#pragma once

/// The tools that a control loop needs in addition to the equations: discretization of linear systems,
/// linear-quadratic regulators, also at compile time, the extended Kalman filter, and steps with their
/// derivatives. They do not allocate memory.

#include <kanexpr/compiler.hpp>

#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/control/discretize.hpp>
#include <kanexpr/control/ekf.hpp>
#include <kanexpr/control/gain_schedule.hpp>
#include <kanexpr/control/lqr.hpp>
#include <kanexpr/steps/linearized_step.hpp>
#include <kanexpr/version.hpp>
