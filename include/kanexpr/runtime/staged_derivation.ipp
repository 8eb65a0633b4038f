#pragma once

#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/runtime/staged_derivation.hpp>

#include <cstdlib>
#include <memory>
#include <type_traits>

namespace kanexpr {

namespace runtime {

/// An empty image. Zeroed memory is a valid one, because an image is an aggregate initialized with zeros;
/// unused pages are never touched. Null if there is not enough memory.
inline std::shared_ptr<derivation::image> make_image() {
  static_assert(std::is_aggregate_v<derivation::image>);
  return {static_cast<derivation::image*>(std::calloc(1, sizeof(derivation::image))), std::free};
}

} // namespace runtime

KANEXPR_ENGINE std::shared_ptr<const derivation::image>
runtime::staged_derivation::stored(mechanics::stage at) {
  auto& found = stored_[static_cast<std::size_t>(at)];
  if (found) return *found;
  found.emplace();
  std::shared_ptr<derived> system = first_->system_;
  if (at != mechanics::stage::constrained) {
    const auto before = stored(static_cast<mechanics::stage>(static_cast<int>(at) - 1));
    if (!before) return nullptr;
    system = system->resumed(*before);
    derivation::advance(*system->equations(), at);
  }
  if (system->mistake()) return nullptr;
  const auto made = make_image();
  if (!made) return nullptr;
  system->store(*made);
  if (!made->is_full) *found = made;
  return *found;
}

KANEXPR_ENGINE model runtime::staged_derivation::resume(mechanics::stage at) {
  if (!first_) first_.emplace(derive_());
  for (int i = static_cast<int>(at); i >= 0; --i)
    if (const auto from = stored(static_cast<mechanics::stage>(i)))
      return model(first_->system_->resumed(*from));
  return derive_();
}

} // namespace kanexpr
