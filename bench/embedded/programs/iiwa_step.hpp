#pragma once

#include "iiwa.hpp"
#include "step.hpp"

/// A step of the iiwa by the Runge-Kutta method, and whether it could be made.
struct program : embedded::step_of<embedded::iiwa::calls> {};
