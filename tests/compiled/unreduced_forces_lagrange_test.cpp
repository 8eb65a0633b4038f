// builds: clang++
#include "compiled/unreduced_forces.hpp"

#include <models/four_bar.hpp>

namespace {

TEST(unreduced_forces, four_bar_by_lagrange) { forces::balance_and_reduce<four_bar::LagrangeSystem>(); }

} // namespace
