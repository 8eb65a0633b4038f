#pragma once

/// Only the description types of a model, for headers of models that are compiled elsewhere (see
/// `kanexpr_add_model`). This header does not derive anything.

#include <kanexpr/compiler.hpp>

#include <kanexpr/describe/constraint.hpp>
#include <kanexpr/describe/extended.hpp>
#include <kanexpr/describe/formulation.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/path_load.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit_text.hpp>
#include <kanexpr/version.hpp>
