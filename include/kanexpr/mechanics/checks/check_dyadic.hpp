#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_inertia.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_motion.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

/// Physically impossible inertias that are sums over the axes of several frames, or that contain symbols.
namespace kanexpr::mechanics {

namespace detail {

/// Evaluates the inertias in the axes of their bodies at generic states. An inertia that is equal at two
/// states is treated as numeric.
class dyadics_checker {
public:
  constexpr dyadics_checker(const mechanism& m, const contents& held) : m_(m), held_(held) {
    for (int b = 0; b < m.bodies.size(); ++b)
      if (needs_check(m.bodies[b])) candidates_.push({b, {}, {}, {}});
  }

  constexpr base::sentence run() {
    if (candidates_.empty()) return {};
    sequence<expression> wanted;
    for (candidate& d : candidates_) d.from_center = collect_inertia(m_, m_.bodies[d.body], wanted);
    generic_motion motion(m_, held_, wanted);
    for (int state = 0, looked = 0; state < 6 && looked < 2; ++state) {
      motion.draw();
      if (!motion.move()) continue;
      ++looked;
      for (candidate& d : candidates_)
        if (const base::sentence found = look(motion, d, looked == 1)) return found;
    }
    return {};
  }

private:
  struct candidate {
    int body = none;
    vector from_center{};     ///< from the mass center to the reference point of the inertia
    numeric_inertia before{}; ///< the inertia at the first state
    numeric_way way_before{};
  };

  static constexpr bool needs_check(const body& b) {
    if (b.inertia.parts.empty()) return false;
    const dyadic::part& p = b.inertia.parts[0];
    if (b.inertia.parts.size() > 1 || p.left != p.right) return true;
    for (int i = 0; i < 3; ++i)
      if (p.value(i, (i + 1) % 3) != p.value((i + 1) % 3, i)) return true;
    return false;
  }

  constexpr bool is_proper(const generic_motion& motion, const candidate& d) const {
    const body& b = m_.bodies[d.body];
    bool proper = motion.is_proper(b.frame);
    for (const dyadic::part& p : b.inertia.parts)
      proper = proper && motion.is_proper(p.left) && motion.is_proper(p.right);
    for (const vector::part& p : d.from_center.parts) proper = proper && motion.is_proper(p.frame);
    return proper;
  }

  constexpr base::sentence look(const generic_motion& motion, candidate& d, bool is_first) const {
    if (!is_proper(motion, d)) return {};
    const body& b = m_.bodies[d.body];
    numeric_inertia inertia = inertia_in_body(motion, b);
    const double largest = inertia.largest();
    if (!(largest > 1e-100) || !(largest < 1e100)) return {};
    numeric_inertia scaled = inertia;
    scaled.scale(1 / largest);
    for (int i = 0; i < 3; ++i)
      if (numeric::elementary::abs(scaled.at[i][(i + 1) % 3] - scaled.at[(i + 1) % 3][i]) > 1e-9)
        return base::sentence({"the inertia of ", b.called.view(), " is not symmetric"});
    numeric_way way = way_in_body(motion, d);
    if (!is_first && !b.effective && is_same(inertia, d.before, largest)) {
      way.known = way.known && is_same(way, d.way_before);
      return check_principal_values(m_, b, scaled, largest, way);
    }
    d.before = inertia;
    d.way_before = way;
    return {};
  }

  constexpr numeric_inertia inertia_in_body(const generic_motion& motion, const body& b) const {
    const triad& own = motion.basis(b.frame);
    numeric_inertia sum;
    for (const dyadic::part& p : b.inertia.parts)
      for (int k = 0; k < 3; ++k) {
        const triple left = own.along(motion.basis(p.left)[k]),
                     right = own.along(motion.basis(p.right) * motion.value(p.value.row[k]));
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) sum.at[i][j] += left[i] * right[j];
      }
    return sum;
  }

  constexpr numeric_way way_in_body(const generic_motion& motion, const candidate& d) const {
    numeric_way way;
    if (d.from_center.parts.empty()) return way;
    triple r;
    for (const vector::part& p : d.from_center.parts)
      r = r + motion.basis(m_.bodies[d.body].frame).along(motion.basis(p.frame) * motion.value(p.value));
    way.mass = motion[m_.bodies[d.body].mass].value;
    for (int i = 0; i < 3; ++i) way.r[i] = r[i];
    way.known = way.mass < 1e30 && dot(r, r) < 1e60;
    return way;
  }

  static constexpr bool is_same(const numeric_inertia& a, const numeric_inertia& b, double largest) {
    for (int i = 0; i < 9; ++i)
      if (!(numeric::elementary::abs(a.at[i / 3][i % 3] - b.at[i / 3][i % 3]) < 1e-9 * largest)) return false;
    return true;
  }
  static constexpr bool is_same(const numeric_way& a, const numeric_way& b) {
    const triple left{a.r[0], a.r[1], a.r[2]}, right{b.r[0], b.r[1], b.r[2]};
    return numeric::elementary::abs(a.mass - b.mass) < 1e-9 * a.mass &&
           length(left - right) < 1e-9 * length(left);
  }

  const mechanism& m_;
  const contents& held_;
  sequence<candidate> candidates_{};
};

} // namespace detail

} // namespace kanexpr::mechanics
