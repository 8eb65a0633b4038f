# The warnings for the project's own code; consumers of the library never see these options.
add_library(kanexpr_strict INTERFACE)
target_compile_options(kanexpr_strict INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
