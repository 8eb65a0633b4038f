#pragma once

#include "car.hpp"
#include "udot.hpp"

/// u̇ of the car.
struct program : embedded::udot_of<embedded::car::calls> {};
