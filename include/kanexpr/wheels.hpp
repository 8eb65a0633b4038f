#pragma once

/// Wheels, the ground on which they roll, and their contact points.
#include <kanexpr/describe/surface.hpp>
#include <kanexpr/describe/wheel.hpp>
