// A program for a board, which the compiler is told to include, and the points at which it is called.
#include "layout.hpp"
#include "points.hpp"

namespace {

[[gnu::section(".points")]] constexpr auto points = embedded::points<program, scalar>();

} // namespace

void measured(const scalar* given, scalar* found) { program::run(given, found); }

[[gnu::section(".points")]] constexpr measured_calls calls{points.front().data(), embedded::point_count,
                                                           program::given.size(), program::found};
