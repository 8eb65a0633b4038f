#pragma once

#include "pendulum.hpp"
#include "step.hpp"

/// A step of the pendulum by the Runge-Kutta method, and whether it could be made.
struct program : embedded::step_of<embedded::pendulum::calls> {};
