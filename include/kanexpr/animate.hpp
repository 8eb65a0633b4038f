#pragma once

/// Animated pages of moving systems: describe the appearance of a system as types, and write a page that a
/// browser can open offline. Requires nlohmann-json; the page itself is built by the CMake target
/// kanexpr::animate, with npm.

#include <kanexpr/compiler.hpp>

#include <kanexpr/animate/bent.hpp>
#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/version.hpp>
