#pragma once

#include "servo.hpp"
#include "udot.hpp"

/// u̇ of the pendulum with a limited motor: what selections and tables take.
struct program : embedded::udot_of<embedded::servo::calls> {};
