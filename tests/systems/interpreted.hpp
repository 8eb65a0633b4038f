// Systems derived while the program runs against reference results: what the compiled functions return to the
// last bit (../runtime/agreement.hpp), without a compiler for each system.
#pragma once

#include "systems/robot_results.hpp"

#include <kanexpr/symbolic.hpp>

#include <map>
#include <string>

namespace check {

// M, f, q̇, u̇, ẋ, both energies, the balance of forces and the residuals of constraints, whatever the order of
// symbols. Without `has_gravity` the weight is a force, and no potential energy is compared.
void interpreted_against_oracle(kanexpr::model model, const std::string& name, bool has_gravity = true);

// A robot with numbers and a motor in each joint.
void interpreted_robot_against_oracle(kanexpr::model model, const std::string& name,
                                      seen_by_reference seen_by = on_the_ground);

} // namespace check
