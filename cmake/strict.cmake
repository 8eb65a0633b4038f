# What the project asks of its own code; never part of the interface a consumer sees.
add_library(kanexpr_strict INTERFACE)
target_compile_options(kanexpr_strict INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
