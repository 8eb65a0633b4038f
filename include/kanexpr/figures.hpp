#pragma once

/// Textbook-style figures: draw<System>(state, parameters) draws a system as SVG.

#include <kanexpr/figures/figure.hpp>
