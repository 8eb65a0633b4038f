#pragma once

/// Flexible bodies given by numbers, as bodies of a model. To compile their equations, also include
/// `kanexpr.hpp`. `flexible/read_sid.hpp` reads such numbers from files at run time.
#include <kanexpr/describe.hpp>
#include <kanexpr/describe/flexible/flexible_body.hpp>
#include <kanexpr/describe/flexible/flexible_body_data.hpp>
#include <kanexpr/describe/flexible/node.hpp>
#include <kanexpr/describe/joints/joints.hpp>
