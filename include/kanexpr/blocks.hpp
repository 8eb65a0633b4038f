#pragma once

/// Filters, delays and controllers that belong to a model. To compile their equations, also include
/// `kanexpr.hpp`.
#include <kanexpr/describe.hpp>
#include <kanexpr/describe/blocks/activation.hpp>
#include <kanexpr/describe/blocks/dc_motor.hpp>
#include <kanexpr/describe/blocks/delay.hpp>
#include <kanexpr/describe/blocks/lag.hpp>
#include <kanexpr/describe/blocks/muscle.hpp>
#include <kanexpr/describe/blocks/pid.hpp>
#include <kanexpr/mechanics/loads/muscle_equilibrium.hpp>
