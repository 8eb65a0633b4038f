#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <string_view>

namespace kanexpr::describe {

/// A flexible body that a model defines by numbers.
struct flexible_record {
  std::string_view mistake{}; ///< the end of a sentence, such as "has no amplitudes"
  listing<phrase> coordinates{}, speeds{}, kinematics{};
  mechanics::flexible_data (*data)() = nullptr;
};

} // namespace kanexpr::describe
