#pragma once

/// Robots from files: read_urdf, and robot_builder for run-time models. Requires tinyxml2.

#include <kanexpr/compiler.hpp>

#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>
