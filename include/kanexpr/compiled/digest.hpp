#pragma once

#include <kanexpr/base/text.hpp>
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

template <class System>
inline constexpr std::uint64_t digest_of_name = [] {
  base::digest all;
  all.take(whole_name_of<System>().whole);
  return all.value();
}();

/// Two files that use the same name for two different systems violate the one-definition rule of C++: one
/// file would run the code of the other. Every file that contains code of a system therefore defines a linker
/// symbol, named after the system, whose address is the digest of its model. Linkers merge equal symbols and
/// reject different ones. The symbol takes no space in the program. With link-time optimization, it is not
/// checked.
template <class System>
[[gnu::always_inline]] inline void enforce_unique_system_name() noexcept {
#ifdef __ELF__
  if constexpr (is_known_to_all_files<System>)
    asm(".globl two_source_files_have_different_systems_of_one_name_%c0\n\t"
        ".set two_source_files_have_different_systems_of_one_name_%c0, %c1"
        :
        : "i"(digest_of_name<System> >> 33), "i"(digest_of_model<System> >> 33));
#endif
}

} // namespace kanexpr::compiled
