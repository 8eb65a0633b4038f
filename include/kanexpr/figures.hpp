#pragma once

/// Figures of textbooks: draw<System>(state, parameters) as SVG.

#include <kanexpr/figures/figure.hpp>
