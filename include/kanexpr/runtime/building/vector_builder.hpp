#pragma once

#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::runtime {

/// The vectors and dyadics of a builder.
class vector_builder : private builder_part {
public:
  /// A vector with the given components, which are numbers or expressions: `b.along(A, l, 0, 0)`. The zero
  /// vector is `{}`.
  vector along(frame_id axes, const number_or_expression& x, const number_or_expression& y,
               const number_or_expression& z);
  expression dot(const vector& a, const vector& b);
  vector dot(const dyadic& d, const vector& v);
  vector cross(const vector& a, const vector& b);
  dyadic outer(const vector& a, const vector& b);
  expression magnitude(const vector& v);
  /// The unit vector along a vector, which is NaN if that is zero.
  vector normalized(const vector& v);
  /// The same vector, expressed by its components in the axes of a frame.
  vector in_axes_of(frame_id axes, const vector& v);

  /// An inertia dyadic with the given entries in the axes of a frame; the products of inertia have the sign
  /// of Σ m (r·r E − r r).
  dyadic inertia(frame_id axes, const number_or_expression& xx, const number_or_expression& yy,
                 const number_or_expression& zz, const number_or_expression& xy = 0,
                 const number_or_expression& yz = 0, const number_or_expression& zx = 0);

protected:
  explicit vector_builder(builder_core& core) : builder_part(core) {}
  ~vector_builder() = default;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/vector_builder.ipp>
#endif
