#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/kinematics_reader.hpp>
#include <kanexpr/describe/flexible_record.hpp>
#include <kanexpr/mechanics/loads/add_flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/flexible_expressions.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::derivation {

using describe::body_record;
using describe::flexible_record;

/// Reads the bodies of a model that are given by numbers, except for their symbols, which follow those of the
/// model's lists, of its joints and of its beams.
class flexible_reader : part_reader {
public:
  constexpr flexible_reader(const part_reader& parts, kinematics_reader& kinematics)
      : part_reader(parts), kinematics_(kinematics) {}

  /// Calls `read` with each of these bodies, as long as there is no mistake.
  template <class Read>
  constexpr void each(Read read) const {
    for (const body_record& r : reading_.from.bodies)
      if (r.flexible != nullptr && !reading_.mistake) read(r, *r.flexible);
  }

  /// Checks the words of all bodies; called before any part of them is read.
  constexpr void check_all() {
    each([&](const body_record& r, const flexible_record& f) {
      if (!f.mistake.empty()) reading_.fail({"flexible body ", r.called, " ", f.mistake});
    });
  }

  constexpr void read_kinematics() {
    each([&](const body_record&, const flexible_record& f) {
      for (const phrase& equation : f.kinematics)
        if (!reading_.mistake) kinematics_.read(equation);
    });
  }

  /// Reads a body and adds it to the system.
  constexpr void read(const body_record& r) {
    const int reference = entities_.point(r.center, r.called);
    if (reading_.mistake) return;
    const int frame = entities_.frame(r.frame, r.called);
    sequence<expression> amplitudes;
    for (const phrase& p : r.flexible->coordinates)
      if (!reading_.mistake) amplitudes.push(symbols_.symbol(*p.tokens[0].symbol, r.called));
    if (reading_.mistake) return;
    const mechanics::flexible_data data = r.flexible->data();
    const mechanics::flexible_expressions of(data, amplitudes);
    mechanics::add_flexible_body(m_, reading_.into.loads, of.body(base::name(r.called), frame, reference),
                                 of);
  }

private:
  kinematics_reader& kinematics_;
};

} // namespace kanexpr::derivation
