#pragma once

#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>

#include <array>
#include <cmath>
#include <ostream>

namespace peers {

using namespace kanexpr;
using mechanics::none;

/// What does not change as the system moves, as numbers.
using numbers = std::array<double, 3>;
using rotation = std::array<numbers, 3>;

/// A tree of links as other programs take it. Each body is a link, which turns about an axis of its home,
/// where the joint is at zero, or floats.
class tree {
public:
  explicit tree(const mechanics::multibody_system& system) : all_(system), m_(system.mechanism) {}

  /// Lines of `gravity x y z`, `inputs n`, `coordinates n`, `speeds n`, and for each link
  /// `link parent axis mass centre(3) ixx iyy izz ixy iyz izx home(9) joint(3)`: the parent's number, none
  /// for the ground; the axis x, y, z as 0, 1, 2, or none for a link that floats; mass centre and inertia
  /// about it in the axes of the link; the direction cosines from home to parent, row by row, and the joint
  /// in the axes of the parent.
  bool write(std::ostream& out) {
    numbers gravity{};
    for (const auto& part : all_.loads.gravity.parts) gravity = of(part.value);
    out << "gravity";
    write(out, gravity);
    out << "\ninputs " << m_.inputs.size() << "\ncoordinates " << m_.coordinates.size() << "\nspeeds "
        << m_.speeds.size() << '\n';
    for (const mechanics::body& each : m_.bodies) write_link(out, each);
    return sound_;
  }

private:
  double of(const symbolic::expression& e) {
    if (!e.is_constant()) {
      sound_ = false;
      return 0;
    }
    return m_.g->number_at(e.node()).value();
  }
  numbers of(const mechanics::components& c) { return {of(c.x), of(c.y), of(c.z)}; }

  static void write(std::ostream& out, const numbers& v) {
    for (const double entry : v) out << ' ' << entry;
  }

  int link_of(int frame) const {
    for (int i = 0; i < m_.bodies.size(); ++i)
      if (m_.bodies[i].frame == frame) return i;
    return none;
  }

  /// The part of a position that is given along the axes of one frame.
  numbers part_of(const mechanics::vector& v, int frame) {
    for (const auto& part : v.parts)
      if (part.frame == frame) return of(part.value);
    return {};
  }

  void write_link(std::ostream& out, const mechanics::body& each) {
    const mechanics::frame& own = m_.frames[each.frame];
    const bool turns = own.kind == mechanics::orientation::about_basis;
    sound_ = sound_ && (turns || own.quaternion.size() != 0);
    rotation home{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    int below = own.parent;
    if (turns && below != 0 && link_of(below) == none) { // the home of the joint, fixed in the parent
      for (std::size_t i = 0; i < 3; ++i) home[i] = of(m_.frames[below].to_parent.row[i]);
      below = m_.frames[below].parent;
    }
    sound_ = sound_ && (below == 0 || link_of(below) != none);

    const mechanics::vector place = mechanics::position_from_origin(m_, each.center);
    const mechanics::symmetric inertia = mechanics::central_inertia(m_, each, each.frame);
    out << "link " << (below == 0 ? none : link_of(below)) << ' ' << (turns ? own.axis : none) << ' '
        << of(each.mass);
    write(out, part_of(place, each.frame));
    write(out, {of(inertia.xx), of(inertia.yy), of(inertia.zz)});
    write(out, {of(inertia.xy), of(inertia.yz), of(inertia.zx)});
    for (const numbers& row : home) write(out, row);
    write(out, turns ? part_of(place, below) : numbers{});
    out << '\n';
  }

  const mechanics::multibody_system& all_;
  const mechanics::mechanism& m_;
  bool sound_ = true;
};

/// Whether the system is a tree of links with numbers for everything.
inline bool write_tree(std::ostream& out, const describe::system_record& record) {
  symbolic::graph graph;
  mechanics::multibody_system system(graph);
  derivation::reader reader(record, system);
  reader.read();
  return !reader.mistake() && tree(system).write(out);
}

/// Lines of `value name number` for the parameters that the system binds.
inline void write_values(std::ostream& out, const describe::system_record& record) {
  for (int i = 0; i < record.values.size; ++i) {
    const describe::token* const equation = record.values[i].tokens; // parameter, number, subtract
    out << "value " << equation[0].symbol->called.view() << ' ' << equation[1].number.value() << '\n';
  }
}

} // namespace peers
