#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the kinematic differential equations of a model.
class kinematics_reader : part_reader {
public:
  using part_reader::part_reader;

  constexpr void read(const phrase& p) {
    constexpr std::string_view whom = "a kinematic differential equation"sv;
    if (p.kind == shape::simple) return note_simple();
    if (p.kind == shape::kinematics) return read_kinematics_of(p.tokens[0].frame, p.tokens[1].frame);
    if (p.kind != shape::equation)
      return reading_.fail({"kinematics<...> contains something that is not an equation",
                            p.size > 0 ? ", involving " : "", name_in(p), "; write dot(q) == u"});
    const value left_minus_right = phrases_.evaluate(p, whom);
    if (!reading_.mistake && left_minus_right.kind != shape::scalar)
      reading_.fail(
          {whom, " with ", name_in(p), " equates vectors; equate their dot products with basis vectors"});
    m_.kinematics.push(left_minus_right.scalar);
  }

  /// Adds the equations that `simple` represents; called after all other equations have been read.
  constexpr void add_simple() {
    if (!has_simple_ || reading_.mistake) return;
    const base::zeros<char> live = symbolic::live_nodes(*m_.g, symbolic::nodes_of(m_.kinematics));
    const auto left_out = [&](const sequence<expression>& symbols, int size) {
      sequence<int> places;
      for (int i = 0; i < size; ++i)
        if (symbols[i].node() >= live.size() || live[symbols[i].node()] == 0) places.push(i);
      return places;
    };
    const sequence<int> coordinates = left_out(m_.coordinate_rates, m_.coordinates.size()),
                        speeds = left_out(m_.speeds, m_.speeds_of_motion());
    if (coordinates.size() != speeds.size())
      return reading_.fail(
          {"kinematics<simple> finds ", base::counted(coordinates.size()).view(),
           coordinates.size() == 1 ? " coordinate and " : " coordinates and ",
           base::counted(speeds.size()).view(), speeds.size() == 1 ? " speed" : " speeds",
           " that appear in no other kinematic differential equation; the numbers must be equal"});
    if (coordinates.size() == 0)
      return reading_.fail(
          {"kinematics<simple> has no coordinate left; all coordinates already have equations"});
    for (int i = 0; i < coordinates.size(); ++i)
      m_.kinematics.push(m_.coordinate_rates[coordinates[i]] - m_.speeds[speeds[i]]);
  }

private:
  constexpr void note_simple() {
    if (has_simple_) return reading_.fail({"kinematics<...> contains simple twice"});
    has_simple_ = true;
  }

  constexpr void read_kinematics_of(const frame_record* of, const frame_record* in) {
    if (in == nullptr)
      return reading_.fail({"kinematics_of is used with the wrong number of frames for ", of->called,
                            "; write kinematics_of<Frame, Reference>"});
    const int place = entities_.frame(of, "kinematics_of"), reference = entities_.frame(in, "kinematics_of");
    if (!reading_.mistake) reading_.mistake = mechanics::check_orientation_kinematics(m_, place, reference);
    if (reading_.mistake) return;
    for (const expression& e : mechanics::orientation_kinematics(m_, place, reference)) m_.kinematics.push(e);
  }

  bool has_simple_ = false;
};

} // namespace kanexpr::derivation
