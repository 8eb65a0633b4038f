#pragma once

#include "cart.hpp"
#include "step.hpp"

/// A step of the pendulum on a cart by the Runge-Kutta method, and whether it could be made.
struct program : embedded::step_of<embedded::cart::calls> {};
