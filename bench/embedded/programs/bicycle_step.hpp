#pragma once

#include "bicycle.hpp"
#include "step.hpp"

/// A step of the bicycle by the Runge-Kutta method, and whether it could be made.
struct program : embedded::step_of<embedded::bicycle::calls> {};
