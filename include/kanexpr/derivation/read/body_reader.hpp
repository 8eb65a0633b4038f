#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/beam_reader.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/flexible_reader.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::derivation {

/// Reads the bodies of a model.
class body_reader : part_reader {
public:
  constexpr body_reader(const part_reader& parts, beam_reader& beams, flexible_reader& flexible)
      : part_reader(parts), beams_(beams), flexible_(flexible) {}

  constexpr void read(const body_record& r) {
    if (r.unparsed) return reading_.fail_by_unparsed(r.called, "bodies<...>");
    if (!reading_.check_base_conflict(r.conflict, r.called)) return;
    if (r.declared_name.empty())
      return reading_.fail({"bodies<...> lists ", short_name(r.called).view(), ", which is ",
                            r.instead.empty() ? "not a body" : r.instead});
    if (r.called != r.declared_name) return reading_.fail_by_self("body", r.called, r.declared_name);
    if (!r.fits) return reading_.fail_by_argument_count("body ", r.called, r.fits);
    if (r.has_whole_zeros && r.about == nullptr && !r.inertia_changes && !r.effective)
      return reading_.fail(
          {"the inertia of ", r.called,
           " is zero, which is also the value of 1/2 in C++; a body without inertia is a particle<...>"});
    if (!r.instead_of_inertia.empty())
      return reading_.fail(
          {"the inertia of ", r.called, " is ", r.instead_of_inertia, ", which is not an inertia"});
    for (const body_record* before : read_) {
      if (before == &r) return reading_.fail({"body ", r.called, " is listed twice"});
      if (base::equal(before->called, r.called)) return reading_.fail({"two bodies are called ", r.called});
    }
    read_.push(&r);
    if (r.beam != nullptr) return beams_.read(r);
    if (r.flexible != nullptr) return flexible_.read(r);
    mechanics::body b;
    b.called = base::name(r.called);
    b.mass = phrases_.scalar_of(r.mass, {"the mass of "sv, r.called}, r.called);
    b.center = entities_.point(r.center, r.called);
    if (r.rigid) {
      b.frame = entities_.frame(r.frame, r.called);
      b.inertia = inertia_of(r);
      if (r.about != nullptr) b.about = entities_.point(r.about, r.called);
      b.inertia_changes = r.inertia_changes;
      b.effective = r.effective;
    }
    if (!reading_.mistake) m_.bodies.push(b);
  }

private:
  constexpr mechanics::dyadic inertia_of(const body_record& r) {
    mechanics::dyadic inertia;
    if (r.inertia_axes == nullptr) {
      const value v = phrases_.evaluate_part("the inertia of "sv, r.inertia_dyadic, r.called);
      if (v.kind != shape::dyadic)
        reading_.fail({"the inertia of ", r.called, is_a(r.inertia_dyadic.kind),
                       "it must be a dyadic: I*outer(A::x, A::x)"});
      return v.dyadic;
    }
    expression i[6];
    for (int k = 0; k < 6; ++k)
      i[k] = phrases_.scalar_of(r.inertia[k], {"an inertia scalar of "sv, r.called}, r.called);
    matrix3 given;
    given.row[0] = {i[0], i[3], i[5]};
    given.row[1] = {i[3], i[1], i[4]};
    given.row[2] = {i[5], i[4], i[2]};
    const int axes = entities_.frame(r.inertia_axes, r.called);
    if (!reading_.mistake) inertia.add(axes, axes, given);
    return inertia;
  }

  beam_reader& beams_;
  flexible_reader& flexible_;
  sequence<const body_record*> read_{};
};

} // namespace kanexpr::derivation
