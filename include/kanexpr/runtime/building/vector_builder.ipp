#pragma once

#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/runtime/building/vector_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

KANEXPR_ENGINE vector vector_builder::along(frame_id axes, const number_or_expression& x,
                                            const number_or_expression& y, const number_or_expression& z) {
  vector v;
  if (!not_all_zero({&x, &y, &z}, "every component of a vector is 0")) return v;
  const mechanics::components value{as_expression(x), as_expression(y), as_expression(z)};
  if (checks_.owns("a vector", axes, value)) v.add(place(axes), value);
  return v;
}

KANEXPR_ENGINE expression vector_builder::dot(const vector& a, const vector& b) {
  return checks_.owns("a dot product", a, b) ? derivation::dot(m_, a, b) : m_.zero();
}

KANEXPR_ENGINE dyadic vector_builder::inertia(frame_id axes, const number_or_expression& xx,
                                              const number_or_expression& yy, const number_or_expression& zz,
                                              const number_or_expression& xy, const number_or_expression& yz,
                                              const number_or_expression& zx) {
  if (!not_all_zero({&xx, &yy, &zz, &xy, &yz, &zx}, "every entry of an inertia is 0")) return {};
  mechanics::symmetric scalars;
  scalars.xx = as_expression(xx), scalars.yy = as_expression(yy), scalars.zz = as_expression(zz);
  scalars.xy = as_expression(xy), scalars.yz = as_expression(yz), scalars.zx = as_expression(zx);
  const dyadic d = mechanics::dyadic_of(place(axes), scalars);
  return checks_.owns("an inertia", d) ? d : dyadic{};
}

} // namespace kanexpr::runtime
