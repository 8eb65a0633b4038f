// Compares systems derived at run time with reference results. Compiled functions return the same values to
// the last bit (../runtime/agreement.hpp), so no system needs to be compiled.
#pragma once

#include "systems/robot_results.hpp"

#include <kanexpr/symbolic.hpp>

#include <map>
#include <string>

namespace check {

// M, f, q̇, u̇, ẋ, both energies, the balance of forces and the residuals of constraints, regardless of the
// order of symbols. Without `has_gravity`, the weight is a force, and no potential energy is compared.
void interpreted_against_oracle(kanexpr::model model, const std::string& name, bool has_gravity = true);

// A robot with numeric values and a motor in each joint.
void interpreted_robot_against_oracle(kanexpr::model model, const std::string& name,
                                      seen_by_reference seen_by = on_the_ground);

} // namespace check
