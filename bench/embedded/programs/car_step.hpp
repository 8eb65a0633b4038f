#pragma once

#include "car.hpp"
#include "step.hpp"

/// A step of the car by the Runge-Kutta method, and whether it could be made.
struct program : embedded::step_of<embedded::car::calls> {};
