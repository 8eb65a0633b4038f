#pragma once

/// Beams that bend, twist and stretch, as bodies of a model. To compile their equations, also include
/// `kanexpr.hpp`.
#include <kanexpr/describe.hpp>
#include <kanexpr/describe/beams/beam.hpp>
#include <kanexpr/describe/beams/deformations.hpp>
#include <kanexpr/describe/beams/section.hpp>
#include <kanexpr/describe/beams/shapes.hpp>
#include <kanexpr/describe/joints/joints.hpp>
