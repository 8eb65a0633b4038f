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

KANEXPR_ENGINE vector vector_builder::dot(const dyadic& d, const vector& v) {
  return checks_.owns("a dot product", d, v) ? derivation::dot(m_, d, v) : vector{};
}

KANEXPR_ENGINE vector vector_builder::cross(const vector& a, const vector& b) {
  return checks_.owns("a cross product", a, b) ? derivation::cross(m_, a, b) : vector{};
}

KANEXPR_ENGINE dyadic vector_builder::outer(const vector& a, const vector& b) {
  return checks_.owns("an outer product", a, b) ? derivation::outer(m_, a, b) : dyadic{};
}

KANEXPR_ENGINE expression vector_builder::magnitude(const vector& v) {
  return checks_.owns("a magnitude", v) ? sqrt(derivation::dot(m_, v, v)) : m_.zero();
}

KANEXPR_ENGINE vector vector_builder::normalized(const vector& v) {
  if (!checks_.owns("a unit vector", v)) return {};
  if (v.is_zero()) {
    checks_.fail({"a vector of zero length is normalized"});
    return {};
  }
  return derivation::normalized(m_, v);
}

KANEXPR_ENGINE vector vector_builder::in_axes_of(frame_id axes, const vector& v) {
  vector same;
  if (checks_.owns("a vector", axes, v)) same.add(place(axes), mechanics::express(m_, v, place(axes)));
  return same;
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
