#pragma once

#include <kanexpr/mechanics/loads/muscle.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/mechanics/loads/spring_damper.hpp>

#include <variant>

namespace kanexpr::runtime {

/// A load that pulls two ends together, such as a spring along a pathway; `tension_of` takes it. The
/// functions of a builder return it, empty if they report a mistake.
using pulling_load =
    std::variant<std::monostate, mechanics::spring_damper, mechanics::path_load, mechanics::muscle>;

} // namespace kanexpr::runtime
