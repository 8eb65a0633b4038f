#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/mechanics/model/beam.hpp>
#include <kanexpr/mechanics/model/beam_expressions.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/numeric/beams/modal_integrals.hpp>

/// Sections of a beam, as frames and points of a mechanism.
namespace kanexpr::mechanics {

/// Adds a point that moves with a section.
constexpr int add_point_of_section(mechanism& m, const name& called, const beam& b,
                                   const numeric::beams::section_values& at) {
  point p;
  p.called = called;
  p.parent = b.root;
  p.offset.add(b.frame, beam_expressions(b).place(at));
  return m.points.push(p);
}

/// Adds a frame that turns with a section: rotated by the slope in the first direction of bending, then by
/// the slope in the second one, then about the axis. The intermediate frames are named after the last one.
constexpr int add_frame_of_section(mechanism& m, const name& called, const beam& b,
                                   const numeric::beams::section_values& at) {
  constexpr deformation turns[]{deformation::first_bending, deformation::second_bending,
                                deformation::torsion};
  int left = 0;
  const beam_expressions of(b);
  for (const deformation d : turns) left += of.rotates(d) ? 1 : 0;
  if (left == 0) return add_rotated_frame(m, called, b.frame, m.zero(), b.axis);
  int last = b.frame;
  bool is_first = true;
  for (const deformation d : turns) {
    if (!of.rotates(d)) continue;
    name own = called;
    if (--left > 0) own.append(is_first ? "_bent" : "_bent_twice");
    is_first = false;
    const bool bends = d != deformation::torsion;
    last = add_rotated_frame(m, own, last, of.angle(at, d),
                             bends ? cross(b.axis, b.across[static_cast<int>(d)]) : b.axis);
  }
  return last;
}

} // namespace kanexpr::mechanics
