#pragma once

#include "flexible_arm.hpp"
#include "udot.hpp"

/// u̇ of a motor with a flexible arm.
struct program : embedded::udot_of<embedded::flexible_arm::calls> {};
