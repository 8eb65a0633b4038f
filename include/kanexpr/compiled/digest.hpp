#pragma once

#include <kanexpr/base/version.hpp>
#include <kanexpr/derivation/digest.hpp>
#include <kanexpr/derivation/stages.hpp>

namespace kanexpr::compiled {

/// Identifies a system across builds and programs.
template <class System>
inline constexpr std::uint64_t digest_of_model =
    derivation::digest_of(derivation::stages_of<System>::constrained.stored);

/// Identifies a function of the system together with the code that this version of the library derives for
/// it.
template <class Function>
inline constexpr std::uint64_t digest_of_function = [] {
  base::digest all;
  all.take(KANEXPR_VERSION);
  all.take(digest_of_model<typename Function::code::system>);
  all.take(derivation::digest_of(Function::code::tape));
  return all.value();
}();

} // namespace kanexpr::compiled
