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

/// The unit of a quantity: a known unit times powers of unknown ones, which `unit_relations` stores.
struct unit_product {
  units::unit known{};
  int first = 0, unknowns = 0; ///< its unknown units, in ascending order, without powers of zero
  bool fits_all = false;       ///< a number, which takes the unit that is expected where it stands

  constexpr bool is_known() const { return unknowns == 0; }
};

constexpr unit_product known_unit(const units::unit& u) { return {u, 0, 0, false}; }

/// A number, which takes the unit that is expected where it stands.
inline constexpr unit_product unit_of_number{{}, 0, 0, true};

/// Equations between units, solved as they are added, by elimination in the exponents.
class unit_relations {
public:
  constexpr unit_product add_unknown() {
    const int place = solutions_.push({});
    is_solved_.push(0);
    return {{}, powers_.push({place, units::unit::parts}), 1, false};
  }

  constexpr int size() const { return solutions_.size(); }
  constexpr bool is_solved(int unknown) const { return is_solved_[unknown] != 0; }

  /// Unknown unit `place` of a unit.
  constexpr const unknown_power& unknown(const unit_product& of, int place) const {
    return powers_[of.first + place];
  }

  constexpr unit_product product(const unit_product& a, const unit_product& b) {
    if (b.unknowns == 0) return {a.known * b.known, a.first, a.unknowns, false};
    if (a.unknowns == 0) return {a.known * b.known, b.first, b.unknowns, false};
    return times_power(a, b, units::unit::parts);
  }
  constexpr unit_product quotient(const unit_product& a, const unit_product& b) {
    if (b.unknowns == 0) return {a.known / b.known, a.first, a.unknowns, false};
    return times_power(a, b, -units::unit::parts);
  }

  /// Whether a unit can be raised to a power exactly.
  constexpr bool has_power(const unit_product& of, std::int64_t numerator, std::int64_t denominator) const {
    constexpr std::int64_t most = 32767;
    if (numerator == denominator || numerator == -denominator) return true;
    if (!units::has_power(of.known, numerator, denominator)) return false;
    for (int i = 0; i < of.unknowns; ++i) {
      const std::int64_t raised = unknown(of, i).power * numerator;
      if (raised % denominator != 0 || raised / denominator > most || raised / denominator < -most)
        return false;
    }
    return true;
  }
  /// The power of a unit. Requires `has_power`.
  constexpr unit_product power(unit_product of, std::int64_t numerator, std::int64_t denominator) {
    of.known = units::power(of.known, numerator, denominator);
    const int first = powers_.size();
    for (int i = 0; i < of.unknowns; ++i) {
      const unknown_power each = unknown(of, i);
      powers_.push({each.of, static_cast<int>(each.power * numerator / denominator)});
    }
    of.first = first;
    return of;
  }

  /// Replaces the unknown units that have been found.
  constexpr unit_product resolved(const unit_product& u) {
    bool is_any = false;
    for (int i = 0; i < u.unknowns; ++i) is_any = is_any || is_solved(unknown(u, i).of);
    if (!is_any) return u;
    unit_product left{u.known, powers_.size(), 0, u.fits_all};
    for (int i = 0; i < u.unknowns; ++i) {
      const unknown_power each = unknown(u, i);
      if (!is_solved(each.of)) powers_.push(each), ++left.unknowns;
    }
    for (int i = 0; i < u.unknowns; ++i) {
      const unknown_power each = unknown(u, i);
      if (is_solved(each.of)) left = times_power(left, resolved(solutions_[each.of]), each.power);
    }
    return left;
  }

  /// States that two quantities have the same unit; returns false if they do not. If this determines an
  /// unknown unit, `last_solved` is its number; units that need no root are preferred, so that those of
  /// coordinates, which are squared in energies, are found elsewhere. An equation that cannot be solved
  /// exactly is omitted.
  constexpr bool equate(const unit_product& a, const unit_product& b) {
    last_solved_ = none;
    if (a.fits_all || b.fits_all) return true;
    if (a.unknowns == 0 && b.unknowns == 0) return a.known == b.known || fits(a.known, b.known);
    const unit_product ratio = resolved(quotient(a, b));
    if (ratio.is_known()) return fits(ratio.known, {});
    for (const bool with_root : {false, true})
      for (int i = 0; i < ratio.unknowns; ++i) {
        const unknown_power each = unknown(ratio, i);
        if (is_simple(each) != with_root && solve(ratio, each)) return true;
      }
    omits_any_ = true;
    return true;
  }
  /// Whether an equation was omitted because it cannot be solved exactly.
  constexpr bool omits_any() const { return omits_any_; }
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
    if (u == plain || plain == units::dimensionless) return;
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

  /// a bᵏ, with k in sixtieths. Requires that bᵏ is representable.
  constexpr unit_product times_power(const unit_product& a, const unit_product& b, int k) {
    unit_product all{a.known * units::power(b.known, k, units::unit::parts), powers_.size(), 0, false};
    int i = 0, j = 0;
    while (i < a.unknowns || j < b.unknowns) {
      const bool is_of_a = i < a.unknowns && (j == b.unknowns || unknown(a, i).of <= unknown(b, j).of);
      const bool is_of_b = j < b.unknowns && (i == a.unknowns || unknown(b, j).of <= unknown(a, i).of);
      unknown_power both{is_of_a ? unknown(a, i).of : unknown(b, j).of, 0};
      if (is_of_a) both.power += unknown(a, i++).power;
      if (is_of_b) both.power += unknown(b, j++).power * k / units::unit::parts;
      if (both.power != 0) powers_.push(both), ++all.unknowns;
    }
    return all;
  }

  /// Solves the equation `ratio` = 1 for one of its unknown units; returns false if the solution is not
  /// exact.
  constexpr bool solve(const unit_product& ratio, const unknown_power& by) {
    unit_product others{ratio.known, powers_.size(), 0, ratio.fits_all};
    for (int i = 0; i < ratio.unknowns; ++i) {
      const unknown_power other = unknown(ratio, i);
      if (other.of != by.of) powers_.push(other), ++others.unknowns;
    }
    if (!has_power(others, -units::unit::parts, by.power)) return false;
    unit_product& solution = solutions_[by.of];
    solution = power(others, -units::unit::parts, by.power);
    if (solution.is_known()) drop_angle_of_length(solution.known);
    is_solved_[by.of] = 1;
    last_solved_ = by.of;
    return true;
  }

  sequence<unknown_power> powers_{};   ///< the unknown units of all products, one after the other
  sequence<unit_product> solutions_{}; ///< in terms of the unknowns that are not solved yet
  sequence<char> is_solved_{};
  int last_solved_ = none;
  bool omits_any_ = false;
  int tolerance_ = 0; ///< of powers, in sixtieths
};

} // namespace kanexpr::mechanics
