#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/frame.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>

namespace kanexpr::mechanics {

/// The speeds on which the velocities of points, or the rates of their positions, may depend. If all of them
/// are zero, so are these velocities and rates, unless they contain inputs or the time.
class involved_speeds {
public:
  constexpr involved_speeds(const mechanism& m, const contents& held)
      : m_(m), held_(held), is_added_(m.frames.size(), 0) {}

  constexpr void add_point(int place) {
    for (int p = place; p != none; p = m_.points[p].parent) {
      const point& each = m_.points[p];
      add(each.offset), add(each.velocity);
      add_frame(each.fixed_in), add_frame(each.reference);
    }
  }

  /// The nodes of the speeds.
  constexpr sequence<int> all() const {
    const base::zeros<char> live = symbolic::live_nodes(*m_.g, symbolic::nodes_of(scalars_));
    const auto is_live = [&](expression symbol) { return live[symbol.node()] != 0; };
    sequence<int> speeds, rates;
    for (const expression& u : m_.speeds)
      if (is_live(u)) speeds.push(u.node());
    for (int i = 0; i < m_.coordinates.size(); ++i)
      if (is_live(m_.coordinates[i]) || is_live(m_.coordinate_rates[i]))
        rates.push(m_.coordinate_rates[i].node());
    while (add_equations(rates, speeds)) {
    }
    return speeds;
  }

private:
  constexpr void add(const vector& v) {
    for (const vector::part& each : v.parts) add_frame(each.frame);
    v.each_entry([&](expression e) { scalars_.push(e); });
  }
  constexpr void add_frame(int frame) {
    for (int f = frame; f != none && is_added_[f] == 0; f = m_.frames[f].parent) {
      is_added_[f] = 1;
      const mechanics::frame& each = m_.frames[f];
      scalars_.append(each.scalars());
      scalars_.append(each.quaternion);
      add(each.angular_velocity);
      add_frame(each.reference);
    }
  }

  /// Adds the rates and speeds of all kinematic equations that contain one of the rates, which may be solved
  /// for together; returns whether there were more rates.
  constexpr bool add_equations(sequence<int>& rates, sequence<int>& speeds) const {
    using kind = contents::kind;
    const int before = rates.size();
    for (const expression& e : m_.kinematics) {
      const sequence<int> its_rates = held_.symbols_in(e, {kind::coordinate_rate});
      bool is_involved = false;
      for (int rate : its_rates) is_involved = is_involved || rates.contains(rate);
      if (!is_involved) continue;
      held_.collect(e, kind::coordinate_rate, rates);
      held_.collect(e, kind::speed, speeds);
    }
    return rates.size() > before;
  }

  const mechanism& m_;
  const contents& held_;
  sequence<char> is_added_; ///< by frame
  sequence<expression> scalars_{};
};

} // namespace kanexpr::mechanics
