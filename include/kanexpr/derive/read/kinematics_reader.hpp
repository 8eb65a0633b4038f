#pragma once

#include <kanexpr/derive/read/entity_reader.hpp>
#include <kanexpr/describe/kinematics.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>

namespace kanexpr::deriving {

/// The kinematic differential equations of a model.
class kinematics_reader {
public:
  constexpr kinematics_reader(reading& all, phrase_reader& phrases, entity_reader& entities)
      : reading_(all), m_(all.into.mechanism), phrases_(phrases), entities_(entities) {}

  constexpr void read(const phrase& p) {
    constexpr std::string_view whom = "a kinematic differential equation";
    if (p.kind == shape::kinematics) return read_kinematics_of(p.tokens[0].frame, p.tokens[1].frame);
    if (p.kind != shape::equation)
      return reading_.fail({"kinematics<...> holds something that is not an equation",
                            p.size > 0 ? ", with " : "", name_in(p), "; write dot(q) == u"});
    const value left_minus_right = phrases_.evaluate(p, whom);
    if (!reading_.mistake && left_minus_right.kind != shape::scalar)
      reading_.fail(
          {whom, " with ", name_in(p), " equates vectors; equate their dot products with basis vectors"});
    m_.kinematics.push(left_minus_right.scalar);
  }

private:
  constexpr void read_kinematics_of(const frame_record* of, const frame_record* in) {
    if (in == nullptr)
      return reading_.fail({"kinematics_of takes two frames, and does not have them for ", of->called,
                            "; write kinematics_of<Frame, Reference>"});
    const int place = entities_.frame(of, "kinematics_of"), reference = entities_.frame(in, "kinematics_of");
    if (!reading_.mistake) reading_.mistake = mechanics::check_orientation_kinematics(m_, place, reference);
    if (reading_.mistake) return;
    for (const expression& e : mechanics::orientation_kinematics(m_, place, reference)) m_.kinematics.push(e);
  }

  reading& reading_;
  mechanism& m_;
  phrase_reader& phrases_;
  entity_reader& entities_;
};

} // namespace kanexpr::deriving
