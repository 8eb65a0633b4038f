#pragma once

/// Integrate the equations of motion with steps of a length that is given, for use in real time.

#include <kanexpr/compiled/fixed_step.hpp>
