#pragma once

#include "iiwa.hpp"
#include "linearization.hpp"

/// A and B of the iiwa, in its independent states.
struct program : embedded::linearization_of<embedded::iiwa::calls> {};
