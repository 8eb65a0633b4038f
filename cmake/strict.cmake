# The warnings for the project's own code; never part of the interface that a consumer sees.
add_library(kanexpr_strict INTERFACE)
target_compile_options(kanexpr_strict INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
