#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>

#include <string_view>

/// C code for CasADi. `@s@` is the prefix of a step's names. Each column of its derivatives belongs to an
/// entry of the arguments x, r, h, p and t, in this order, so that the derivatives without parameters come
/// first.
namespace kanexpr::exporting::casadi_templates {

inline constexpr std::string_view step = template_text(
#include <kanexpr/exporting/casadi/step.c.in>
);

/// ∂²(λᵀ x⁺)/∂z²: the sum over the stages of Wᵀ H W, where W are the derivatives of the stage's arguments and
/// H the weighted second derivatives of its rates, plus the terms from the product of h and the rates.
inline constexpr std::string_view second_order_of_step = template_text(
#include <kanexpr/exporting/casadi/second_order_of_step.c.in>
);

/// Computes the points, slopes and derivatives of all stages; `after` holds those of the step, and `rest` is
/// free.
inline constexpr std::string_view moved = template_text(
#include <kanexpr/exporting/casadi/moved.c.in>
);

/// Computes the derivatives `total` of a directional derivative: those of a stage's rates follow from the
/// second derivatives of the rates along the stage's direction, and from the derivatives of that direction.
inline constexpr std::string_view moved_along = template_text(
#include <kanexpr/exporting/casadi/moved_along.c.in>
);

inline constexpr std::string_view helpers = template_text(
#include <kanexpr/exporting/casadi/helpers.c.in>
);

} // namespace kanexpr::exporting::casadi_templates
