#pragma once

#include "cart.hpp"
#include "linearization.hpp"

/// A and B of the pendulum on a cart, in its independent states.
struct program : embedded::linearization_of<embedded::cart::calls> {};
