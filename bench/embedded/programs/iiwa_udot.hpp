#pragma once

#include "iiwa.hpp"
#include "udot.hpp"

/// u̇ of the iiwa.
struct program : embedded::udot_of<embedded::iiwa::calls> {};
