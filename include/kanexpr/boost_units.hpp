#pragma once

/// Values as quantities of Boost.Units: `{m, 2 * kg}`, and results as quantities: `boost_quantity(x, q1)`.

#include <kanexpr/describe.hpp>

#include <kanexpr/quantities/boost_units_library.hpp>
