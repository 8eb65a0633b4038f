# What the project asks of its own code; never part of the interface a consumer sees.
add_library(kanexpr_strict INTERFACE)
target_compile_options(kanexpr_strict INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
# Optimizing, g++ 12 overlooks the zeros between the sentences of a status; each sentence has one.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(kanexpr_strict INTERFACE -Wno-error=stringop-overread)
endif()
