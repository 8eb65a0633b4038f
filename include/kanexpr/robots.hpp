#pragma once

/// Robots from files: read_urdf, robot_builder for models of the program. Needs tinyxml2.

#include <kanexpr/compiler.hpp>

#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>
