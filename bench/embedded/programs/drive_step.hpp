#pragma once

#include "drive.hpp"
#include "step.hpp"

/// A step of the motor with an elastic shaft and its controller by the Runge-Kutta method, and whether it
/// could be made.
struct program : embedded::step_of<embedded::drive::calls> {};
