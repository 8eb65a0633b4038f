#pragma once

/// All source files of a program must agree on whether a library provides the definitions:
/// KANEXPR_COMPILED_ENGINE and similar macros are defined for all of them or for none. Each file emits a
/// symbol whose address encodes its choice. Linkers merge identical definitions and reject conflicting ones.
/// The libraries themselves are independent of each other and emit no symbol. With link-time optimization,
/// the choice is not checked.
#if defined __ELF__ && !defined KANEXPR_WITHIN_A_LIBRARY
#define KANEXPR_ONE_WAY(what, way)                                                                           \
  asm(".globl some_source_files_define_" what "_and_some_do_not\n\t"                                         \
      ".set some_source_files_define_" what "_and_some_do_not, " way)
#else
#define KANEXPR_ONE_WAY(what, way) static_assert(true)
#endif
