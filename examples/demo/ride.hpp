#pragma once

#include <kanexpr/simulations/simulation.hpp>
#include <models/bicycle.hpp>

#include <string>

namespace demo {

using ride = kanexpr::simulation<bicycle::BoundSystem>;

/// The bicycle, upright at a speed in m/s, is pushed to the side; the push is a rate of lean in rad/s. No one
/// steers.
ride pushed_bicycle(double speed, double push, double seconds);

/// Returns the reason if the page cannot be written; else empty.
std::string write_page_of(const ride& r, const std::string& path, const std::string& title,
                          const std::string& text);

} // namespace demo
