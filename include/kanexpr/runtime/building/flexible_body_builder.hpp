#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/runtime/building/beam_data.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/runtime/building/flexible_integrals.hpp>
#include <kanexpr/runtime/building/frame_builder.hpp>
#include <kanexpr/runtime/building/point_builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// The flexible bodies of a builder, given by their integrals or by numbers.
class flexible_body_builder : private builder_part {
public:
  /// A body that deforms relative to `frame`, which moves with the point `reference`. The amplitudes of its
  /// deformation are coordinates of the system and belong to no other body.
  void flexible_body(std::string_view called, point_id reference, frame_id frame,
                     const std::vector<expression>& amplitudes, const flexible_integrals& data);
  /// The same with numbers, such as those that `flexible::read_sid` reads.
  flexible_body_id flexible_body(std::string_view called, point_id reference, frame_id frame,
                                 const std::vector<expression>& amplitudes,
                                 const mechanics::flexible_data& data);
  /// The point and the frame of a node of a body that was added with numbers. The frame is rotated by the
  /// rotation vector that the shapes give at the node, to the second order.
  section_ids node(std::string_view called, flexible_body_id of, std::string_view node);

protected:
  explicit flexible_body_builder(builder_core& core, frame_builder& frames, point_builder& points)
      : builder_part(core), frames_(frames), points_(points) {}
  ~flexible_body_builder() = default;

private:
  mechanics::components as_components(const flexible_integrals::vector_entries& given);
  symbolic::matrix as_matrix(const flexible_integrals::matrix& given);
  bool has_shapes_of(std::string_view body, std::size_t amplitudes, const flexible_integrals& data);
  bool has_elasticity(std::string_view called, const base::sequence<expression>& amplitudes,
                      const symbolic::matrix& stiffness, const symbolic::matrix& damping);
  bool owns_flexible_body(const mechanics::flexible_body& b);

  /// A flexible body that was added with numbers; its nodes are formed from them.
  struct body_with_data {
    mechanics::flexible_body body{};
    mechanics::flexible_data data{};
  };
  std::vector<body_with_data> bodies_with_data_{};

  frame_builder& frames_;
  point_builder& points_;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/flexible_body_builder.ipp>
#endif
