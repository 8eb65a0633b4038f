#pragma once

/// Animated pages of moving systems: the appearance of a system described as types, and a page that a browser
/// opens without a network. Requires nlohmann-json; the page itself is built by the CMake target
/// kanexpr::animate, with npm.

#include <kanexpr/compiler.hpp>

#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/version.hpp>
