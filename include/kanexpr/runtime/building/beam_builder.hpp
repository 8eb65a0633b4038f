#pragma once

#include <kanexpr/mechanics/loads/add_beam.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/numeric/beams/shape.hpp>
#include <kanexpr/runtime/building/beam_data.hpp>
#include <kanexpr/runtime/building/builder_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// The beams of a builder and their sections.
class beam_builder : private builder_part {
public:
  /// A beam that begins at `root` and deforms relative to `frame`. Each shape has one amplitude, a
  /// coordinate: those of the directions of bending come first, then those of torsion and of extension.
  beam_id beam(std::string_view called, point_id root, frame_id frame,
               const std::vector<expression>& amplitudes, const beam_data& data);
  /// The section of a beam at the fraction ξ of its length; write 0.0 for the root.
  section_ids section(std::string_view called, beam_id on, given_number xi);

protected:
  explicit beam_builder(builder_core& core) : builder_part(core) {}
  ~beam_builder() = default;

private:
  /// A beam and its shapes, from which its sections are formed.
  struct built_beam {
    numeric::beams::beam_shapes shapes{};
    mechanics::beam beam{};
  };
  void deform(built_beam& to, mechanics::deformation what, const beam_deformation& by);
  void deform(built_beam& to, const beam_data& data);
  void check_profile(std::string_view beam, const numeric::beams::shape& profile);
  mechanics::components unit_direction(const vector& given, int frame);
  mechanics::beam_damping damping_of(std::string_view beam, const beam_data& data);
  bool owns_beam(const built_beam& made, const mechanics::beam_damping& damped);

  std::vector<built_beam> beams_{};
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/beam_builder.ipp>
#endif
