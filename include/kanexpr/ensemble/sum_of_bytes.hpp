#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>

#include <cstdint>
#include <string_view>

namespace kanexpr::ensembles {

/// A number that is another one for nearly all other contents.
KANEXPR_ENSEMBLES std::uint64_t sum_of(std::string_view content);

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/sum_of_bytes.hpp>
#endif
