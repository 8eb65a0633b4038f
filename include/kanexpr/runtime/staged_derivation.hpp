#pragma once

#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/model.hpp>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace kanexpr {

namespace derivation {
struct image;
}

namespace runtime {

/// Derives a system once, stage by stage. Each model resumes from the stored stage in a separate graph, and
/// its expressions are the same as if it had been derived separately.
class staged_derivation {
public:
  explicit staged_derivation(std::function<model()> derive) : derive_(std::move(derive)) {}

  /// A model from which the results of a stage can be formed. If the system has a mistake, the model reports
  /// it.
  model resume(mechanics::stage at = mechanics::stage::constrained);

private:
  /// The stored stage; null if it has a mistake or exceeds the size of an image.
  std::shared_ptr<const derivation::image> stored(mechanics::stage at);

  std::function<model()> derive_;
  std::optional<model> first_{};
  std::array<std::optional<std::shared_ptr<const derivation::image>>, 3> stored_{};
};

} // namespace runtime

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/staged_derivation.ipp>
#endif
