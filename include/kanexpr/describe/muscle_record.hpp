#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/muscle_parameters.hpp>

namespace kanexpr::describe {

/// The tendon of a muscle; the record of its load contains the activation and the parameters, in the order of
/// `muscle_parameters`.
struct muscle_record {
  muscle_formulation formulation{};
  phrase tendon_state{}; ///< of the kind `nothing` with a rigid tendon
};

inline constexpr muscle_record no_muscle{};

} // namespace kanexpr::describe
