#pragma once

#include <kanexpr/numeric/elementary.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace kanexpr::ensembles {

/// Looks for the greatest that a function of time is in the steps of a motion. Between the ends of a step it
/// asks for values until parabolas tell them, and climbs to the top by Brent's method where that may be
/// higher than all before.
template <class Function>
class climber {
public:
  explicit climber(const Function& of) : of_(of) {}

  void take(double value) {
    if (elementary::detail::is_nan(value))
      is_lost_ = true;
    else if (value > best_)
      best_ = value;
  }
  /// Between two times, with the values there, which `take` has seen.
  void look_between(double from, double at_from, double to, double at_to) {
    const double middle = between(from, to);
    divide({from, at_from}, {middle, value(middle)}, {to, at_to}, 0);
  }

  /// Not a number where a value was none.
  double best() const { return is_lost_ ? std::numeric_limits<double>::quiet_NaN() : best_; }

private:
  struct point {
    double t, value;
  };
  static constexpr int most_divisions = 8;

  /// Not in the middle, where what repeats itself would look like a constant.
  static double between(double from, double to) { return from + 0.46 * (to - from); }

  double value(double t) {
    const double found = of_(t);
    take(found);
    return found;
  }

  /// What a parabola through three points is at a time.
  static double parabola(const point& a, const point& b, const point& c, double t) {
    const double ab = (b.value - a.value) / (b.t - a.t), bc = (c.value - b.value) / (c.t - b.t);
    return a.value + (t - a.t) * (ab + (t - b.t) * (bc - ab) / (c.t - a.t));
  }

  void divide(const point& a, const point& c, const point& e, int divisions) {
    const double early = between(a.t, c.t), late = between(c.t, e.t);
    if (!(a.t < early && early < c.t && c.t < late && late < e.t)) return;
    const point b{early, value(early)}, d{late, value(late)};
    const std::array<point, 5> all{a, b, c, d, e};
    double least = all[0].value, greatest = all[0].value;
    for (const point& each : all)
      least = (std::min)(least, each.value), greatest = (std::max)(greatest, each.value);
    const double off =
        (std::max)(std::abs(parabola(a, c, e, b.t) - b.value), std::abs(parabola(a, c, e, d.t) - d.value));
    const bool is_told = off <= 0.02 * (greatest - least); // false where infinities are in it
    if (!is_told && divisions < most_divisions) {
      divide(a, b, c, divisions + 1);
      divide(c, d, e, divisions + 1);
      return;
    }
    for (std::size_t i = 0; i < 5; ++i) {
      const point &before = all[i > 0 ? i - 1 : i], &after = all[i < 4 ? i + 1 : i];
      const double rise = all[i].value - (std::min)(before.value, after.value);
      if (all[i].value >= before.value && all[i].value >= after.value && rise > 0 &&
          all[i].value + rise >= best_)
        climb(before.t, after.t);
    }
  }

  void climb(double from, double to) {
    std::uintmax_t most = 60;
    boost::math::tools::brent_find_minima([this](double t) { return -value(t); }, from, to, 26, most);
  }

  const Function& of_;
  double best_ = -std::numeric_limits<double>::infinity();
  bool is_lost_ = false;
};

/// The greatest that a function of samples is along a motion, at its samples and between them, where
/// `between` gives what a sample would be. Two samples of one time stand before and after a jump.
template <class Path, class Between, class Function>
double greatest_along(const Path& path, const Between& between, const Function& of) {
  const auto at = [&](double t) { return of(between(t)); };
  climber found(at);
  double before = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double value = of(path[i]);
    found.take(value);
    if (i > 0 && path[i - 1].t < path[i].t) found.look_between(path[i - 1].t, before, path[i].t, value);
    before = value;
  }
  return found.best();
}

} // namespace kanexpr::ensembles
