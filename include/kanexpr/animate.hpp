#pragma once

/// Animated pages of moving systems: what a system looks like as words, and a page that a browser opens
/// without a network. Needs nlohmann-json; the page itself is built by the CMake target kanexpr::animate,
/// with npm.

#include <kanexpr/compiler.hpp>

#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/version.hpp>
