#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/compiled/digest.hpp>

namespace kanexpr::compiled {

template <class System>
inline constexpr std::uint64_t digest_of_name = [] {
  symbolic::digest all;
  all.take(whole_name_of<System>().whole);
  return all.value();
}();

/// Two files that give two systems one name break C++'s rule of one definition: one of them would run the
/// code of the other. So where code of a system is made it leaves a symbol behind, named by the system's name
/// with the digest of its model as address. Linkers take equal ones as one, and refuse different ones. The
/// program holds neither; link-time optimization does not look.
template <class System>
[[gnu::always_inline]] inline void link_as_one_system() noexcept {
#ifdef __ELF__
  if constexpr (is_known_to_all_files<System>)
    asm(".globl two_source_files_have_different_systems_of_one_name_%c0\n\t"
        ".set two_source_files_have_different_systems_of_one_name_%c0, %c1"
        :
        : "i"(digest_of_name<System> >> 33), "i"(digest_of_model<System> >> 33));
#endif
}

} // namespace kanexpr::compiled
