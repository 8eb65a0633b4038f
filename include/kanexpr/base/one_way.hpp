#pragma once

/// Whether a library provides the definitions is one decision for a whole program: KANEXPR_COMPILED_ENGINE
/// and similar macros are defined for all of its source files or for none. Each file emits a symbol whose
/// address encodes its choice. Linkers merge equal definitions and reject different ones. The libraries
/// themselves, which are independent of each other, emit no symbol; link-time optimization does not check it.
#if defined __ELF__ && !defined KANEXPR_WITHIN_A_LIBRARY
#define KANEXPR_ONE_WAY(what, way)                                                                           \
  asm(".globl some_source_files_define_" what "_and_some_do_not\n\t"                                         \
      ".set some_source_files_define_" what "_and_some_do_not, " way)
#else
#define KANEXPR_ONE_WAY(what, way) static_assert(true)
#endif
