#pragma once

/// Describe a mechanical system as types and get its equations of motion as compiled functions. Requires only
/// Eigen and Boost.Hana.

#include <kanexpr/compiler.hpp>

#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/linearization.hpp>
#include <kanexpr/compiled/regressor.hpp>
#include <kanexpr/compiled/second_order.hpp>
#include <kanexpr/compiled/units_of.hpp>
#include <kanexpr/describe/constraint.hpp>
#include <kanexpr/describe/extended.hpp>
#include <kanexpr/describe/formulation.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/path_load.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit_text.hpp>
#include <kanexpr/version.hpp>
