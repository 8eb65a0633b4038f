#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/units/unit.hpp>

#include <cstdint>

namespace kanexpr::mechanics {

/// An unknown unit, by its number, raised to a power in sixtieths.
struct unknown_power {
  int of = 0;
  int power = 0;
};

/// The unit of a quantity: a known unit times powers of unknown ones.
struct unit_product {
  units::unit known{};
  sequence<unknown_power> unknown{}; ///< in ascending order, without zeros
  bool fits_all = false;             ///< a number, which takes the unit that is expected where it stands

  constexpr bool is_known() const { return unknown.empty(); }
};

constexpr unit_product known_unit(const units::unit& u) { return {u, {}, false}; }

/// a bᵏ, with k in sixtieths. Requires that bᵏ is representable.
constexpr unit_product times_power(const unit_product& a, const unit_product& b, int k) {
  unit_product all{a.known * units::power(b.known, k, units::unit::parts), {}, false};
  int i = 0, j = 0;
  while (i < a.unknown.size() || j < b.unknown.size()) {
    if (j == b.unknown.size() || (i < a.unknown.size() && a.unknown[i].of < b.unknown[j].of)) {
      all.unknown.push(a.unknown[i++]);
      continue;
    }
    const bool is_shared = i < a.unknown.size() && a.unknown[i].of == b.unknown[j].of;
    const int power = (is_shared ? a.unknown[i].power : 0) + b.unknown[j].power * k / units::unit::parts;
    if (power != 0) all.unknown.push({b.unknown[j].of, power});
    i += is_shared ? 1 : 0;
    ++j;
  }
  return all;
}
constexpr unit_product operator*(const unit_product& a, const unit_product& b) {
  return times_power(a, b, units::unit::parts);
}
constexpr unit_product operator/(const unit_product& a, const unit_product& b) {
  return times_power(a, b, -units::unit::parts);
}

/// Whether a unit can be raised to a power exactly.
constexpr bool has_power(const unit_product& of, std::int64_t numerator, std::int64_t denominator) {
  constexpr std::int64_t most = 32767;
  if (!units::has_power(of.known, numerator, denominator)) return false;
  for (const unknown_power& each : of.unknown) {
    const std::int64_t raised = each.power * numerator;
    if (raised % denominator != 0 || raised / denominator > most || raised / denominator < -most)
      return false;
  }
  return true;
}
/// The power of a unit. Requires `has_power`.
constexpr unit_product power(unit_product of, std::int64_t numerator, std::int64_t denominator) {
  of.known = units::power(of.known, numerator, denominator);
  for (unknown_power& each : of.unknown) each.power = static_cast<int>(each.power * numerator / denominator);
  return of;
}

/// Equations between units, solved as they are added, by elimination in the exponents.
class unit_relations {
public:
  constexpr unit_product add_unknown() {
    const int place = solutions_.push({});
    is_solved_.push(0);
    unit_product unknown;
    unknown.unknown.push({place, units::unit::parts});
    return unknown;
  }

  constexpr int size() const { return solutions_.size(); }
  constexpr bool is_solved(int unknown) const { return is_solved_[unknown] != 0; }

  /// Replaces the unknown units that have been found.
  constexpr unit_product resolved(const unit_product& u) const {
    if (u.unknown.empty()) return u;
    unit_product left{u.known, {}, u.fits_all};
    bool is_any = false;
    for (const unknown_power& each : u.unknown)
      if (is_solved(each.of))
        is_any = true;
      else
        left.unknown.push(each);
    if (!is_any) return u;
    for (const unknown_power& each : u.unknown)
      if (is_solved(each.of)) left = times_power(left, resolved(solutions_[each.of]), each.power);
    return left;
  }

  /// States that two quantities have the same unit; returns false if they do not. If this determines an
  /// unknown unit, `last_solved` is its number; units that need no root are preferred, so that those of
  /// coordinates, which are squared in energies, are found elsewhere. An equation that cannot be solved
  /// exactly is omitted.
  constexpr bool equate(const unit_product& a, const unit_product& b) {
    last_solved_ = none;
    if (a.fits_all || b.fits_all) return true;
    if (a.unknown.empty() && b.unknown.empty()) return fits(a.known, b.known);
    const unit_product ratio = resolved(a / b);
    if (ratio.is_known()) return fits(ratio.known, {});
    for (const bool with_root : {false, true})
      for (const unknown_power& each : ratio.unknown)
        if (is_simple(each) != with_root && solve(ratio, each)) return true;
    return true;
  }
  constexpr int last_solved() const { return last_solved_; }

  /// Lets units fit if their powers are almost equal, because a power such as 2.37 is rounded to sixtieths.
  constexpr void tolerate_rounding() { tolerance_ = 5; }
  /// Whether a unit may contain rounded powers, which are in general no multiples of 1/10 or 1/12.
  constexpr bool is_rounded(const units::unit& u) const {
    for (int i = 0; tolerance_ > 0 && i < units::base_units; ++i)
      if (const int power = u[units::base_unit_at(i)]; power % 5 != 0 && power % 6 != 0) return true;
    return false;
  }

  /// Drops the radian from a unit in which nothing turns: a radius is in m although ω r is in m/s, an inertia
  /// in kg m², and the damping of a point in N s/m = kg/s. Angles, their rates and what multiplies them to a
  /// force or a torque keep it.
  static constexpr void drop_angle_of_length(units::unit& u) {
    using enum units::base_unit;
    const units::unit plain = units::without_angle(u);
    if (plain == units::dimensionless) return;
    if (u[second] == 0 || (u[meter] > 0 && u[radian] > 0) || (u[kilogram] != 0 && u[meter] == 0)) u = plain;
  }

private:
  constexpr bool fits(const units::unit& a, const units::unit& b) const {
    if (units::fits(a, b)) return true;
    if (tolerance_ == 0) return false;
    const units::unit ratio = units::without_angle(a / b);
    for (int i = 0; i < units::base_units; ++i)
      if (const int power = ratio[units::base_unit_at(i)]; power > tolerance_ || power < -tolerance_)
        return false;
    return true;
  }
  static constexpr bool is_simple(const unknown_power& p) {
    return p.power == units::unit::parts || p.power == -units::unit::parts;
  }

  /// Solves the equation `ratio` = 1 for one of its unknown units; returns false if the solution is not
  /// exact.
  constexpr bool solve(const unit_product& ratio, const unknown_power& by) {
    unit_product others = ratio;
    others.unknown.clear();
    for (const unknown_power& other : ratio.unknown)
      if (other.of != by.of) others.unknown.push(other);
    if (!mechanics::has_power(others, -units::unit::parts, by.power)) return false;
    solutions_[by.of] = mechanics::power(others, -units::unit::parts, by.power);
    if (solutions_[by.of].is_known()) drop_angle_of_length(solutions_[by.of].known);
    is_solved_[by.of] = 1;
    last_solved_ = by.of;
    return true;
  }

  sequence<unit_product> solutions_{}; ///< in terms of the unknowns that are not solved yet
  sequence<char> is_solved_{};
  int last_solved_ = none;
  int tolerance_ = 0; ///< of powers, in sixtieths
};

} // namespace kanexpr::mechanics
