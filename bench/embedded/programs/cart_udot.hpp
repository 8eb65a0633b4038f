#pragma once

#include "cart.hpp"
#include "udot.hpp"

/// u̇ of the pendulum on a cart.
struct program : embedded::udot_of<embedded::cart::calls> {};
