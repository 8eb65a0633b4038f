#pragma once

#include "bicycle.hpp"
#include "udot.hpp"

/// u̇ of the bicycle.
struct program : embedded::udot_of<embedded::bicycle::calls> {};
