#pragma once

#include <kanexpr/base/version.hpp>
#include <kanexpr/derive/digest.hpp>
#include <kanexpr/derive/stages.hpp>

namespace kanexpr::compiled {

/// By which a system is known again, in any build of any program.
template <class System>
inline constexpr std::uint64_t digest_of_model =
    deriving::digest_of(deriving::stages_of<System>::constrained.aside);

/// And a function of it, with its code as this version of the library derives it.
template <class Function>
inline constexpr std::uint64_t digest_of_function = [] {
  symbolic::digest all;
  all.take(KANEXPR_VERSION);
  all.take(digest_of_model<typename Function::code::system>);
  all.take(deriving::digest_of(Function::code::tape));
  return all.value();
}();

} // namespace kanexpr::compiled
