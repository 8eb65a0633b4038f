#pragma once

/// Whether a library holds what headers declare is one decision for a program: KANEXPR_COMPILED_ENGINE and
/// its like are defined for all of its source files or for none. Each file leaves a symbol behind, whose
/// address is the way that it is compiled. Linkers take equal ones as one, and refuse different ones. The
/// libraries themselves, which need not know of each other, leave none; link-time optimization does not look.
#if defined __ELF__ && !defined KANEXPR_WITHIN_A_LIBRARY
#define KANEXPR_ONE_WAY(what, way)                                                                           \
  asm(".globl some_source_files_define_" what "_and_some_do_not\n\t"                                         \
      ".set some_source_files_define_" what "_and_some_do_not, " way)
#else
#define KANEXPR_ONE_WAY(what, way) static_assert(true)
#endif
