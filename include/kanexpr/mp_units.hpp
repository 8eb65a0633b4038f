#pragma once

/// Values as quantities of mp-units: `{m, 2 * kg}`, and results as quantities: `mp_quantity(x, q1)`.

#include <kanexpr/describe.hpp>

#include <kanexpr/quantities/mp_units_library.hpp>
