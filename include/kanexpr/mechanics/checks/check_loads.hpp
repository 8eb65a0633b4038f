#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_repeated_loads.hpp>
#include <kanexpr/mechanics/checks/check_weights.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks the loads of a system.
namespace kanexpr::mechanics {

namespace detail {

class gravity_checker {
public:
  constexpr gravity_checker(const mechanism& m, const vector& gravity, const contents& held, load_check& by)
      : m_(m), gravity_(gravity), held_(held), by_(by) {}

  /// Checks all loads. The potential energy of gravity is −m g·r and its force is m g, which is the negative
  /// gradient of the energy only if g does not depend on coordinates.
  constexpr void run() {
    std::string_view coordinate, turns; // a coordinate in gravity, and the frame that turns with it
    gravity_.each_entry([&](expression e) {
      by_.check_constant_rates(e, "gravity", {});
      if (held_.holds(e, kind::coordinate)) coordinate = held_.name_of(e, kind::coordinate);
    });
    for (const vector::part& part : gravity_.parts)
      for (int f = part.frame; f != mechanism::inertial && !part.value.is_zero(); f = m_.frames[f].parent)
        if (const std::string_view q = coordinate_of(m_.frames[f]); !q.empty() && coordinate.empty())
          coordinate = q, turns = by_.frame(part.frame);
    if (by_.mistake() || coordinate.empty() || !gravity_changes()) return;
    if (turns.empty()) return by_.fail_varying(sentence({"coordinate ", coordinate}), "gravity", {});
    by_.fail({"gravity is given along the axes of ", turns, ", which turn with coordinate ", coordinate,
              "; it may contain only parameters, inputs and time"});
  }

private:
  using kind = symbolic::symbol_kind;

  /// A coordinate in the orientation of a frame relative to its parent.
  constexpr std::string_view coordinate_of(const mechanics::frame& f) const {
    for (const expression& e : f.scalars())
      if (held_.holds(e, kind::coordinate)) return held_.name_of(e, kind::coordinate);
    return {};
  }
  /// Whether gravity really depends on coordinates; a vector given along several axes may still be constant.
  constexpr bool gravity_changes() const {
    const components g = express(m_, gravity_, mechanism::inertial);
    symbolic::matrix all(*m_.g, 1 + m_.coordinates.size(), 3); // g, followed by its derivatives
    for (int i = 0; i < 3; ++i) {
      all(0, i) = g[i];
      for (int j = 1; j < all.rows; ++j) all(j, i) = symbolic::differentiate(g[i], m_.coordinates[j - 1]);
    }
    for (const numbers& state : at_generic_states(all)) {
      double whole = 0, most = 0;
      for (int i = 0; i < state.entries.size(); ++i) {
        const double size = numeric::elementary::abs(state.entries[i]);
        if (i < 3) whole += size;
        if (i >= 3 && size > most) most = size;
      }
      if (most > 1e-9 * whole) return true;
    }
    return false;
  }

  const mechanism& m_;
  const vector& gravity_;
  const contents& held_;
  load_check& by_;
};

} // namespace detail

/// The values of the loads that must be positive or not negative, whatever their numbers are.
constexpr sequence<bounded_value> bounded_values(const mechanism& m, const loads& acting) {
  sequence<bounded_value> found;
  load_check by(m, found);
  acting.each([&](const auto& load, int place) { load.check_with(by, place); });
  for (const positive_constant& each : acting.positive_constants) each.check_with(by);
  return found;
}

/// Returns a message that describes the first mistake in the loads; empty if there is none.
constexpr sentence check_loads(const mechanism& m, const loads& acting, const contents& held) {
  load_check by(m, held);
  acting.each([&](const auto& load, int place) {
    if (!by.mistake()) load.check_with(by, place);
  });
  for (const positive_constant& each : acting.positive_constants) each.check_with(by);
  detail::gravity_checker(m, acting.gravity, held, by).run();
  if (!by.mistake()) check_repeated_loads(m, acting, held, by);
  if (!by.mistake()) check_weights(m, acting, held, by);
  return by.mistake();
}

} // namespace kanexpr::mechanics
