# The warnings of a strict consumer
set(warnings_of_a_consumer -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wsign-conversion -Wdouble-promotion
  -Wold-style-cast -Wfloat-equal -Weffc++ -Werror)
