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

/// Searches the steps of a motion for the maximum of a function of time. Each step is divided until parabolas
/// describe the function; Brent's method then refines maxima that may exceed all values so far.
template <class Function>
class maximum_search {
  struct point {
    double t, value;
  };

public:
  explicit maximum_search(const Function& of) : of_(of) {}

  void take(double value) {
    if (numeric::elementary::detail::is_nan(value))
      has_nan_ = true;
    else if (value > best_)
      best_ = value;
  }
  /// Searches between two times whose values have already been passed to `take`.
  void search(double from, double at_from, double to, double at_to) {
    divide({from, at_from}, sample(inner(from, to)), {to, at_to}, 0);
  }

  /// Returns the maximum so far; NaN if the function was NaN anywhere.
  double best() const { return has_nan_ ? std::numeric_limits<double>::quiet_NaN() : best_; }

private:
  static constexpr int max_divisions = 8;

  /// Returns a point other than the midpoint, since a periodic function could look constant there.
  static double inner(double from, double to) { return from + 0.46 * (to - from); }

  point sample(double t) {
    const double found = of_(t);
    take(found);
    return {t, found};
  }

  /// Returns the distance of a point from the parabola through three others.
  static double distance(const point& a, const point& b, const point& c, const point& from) {
    const double ab = (b.value - a.value) / (b.t - a.t), bc = (c.value - b.value) / (c.t - b.t);
    const double there = a.value + (from.t - a.t) * (ab + (from.t - b.t) * (bc - ab) / (c.t - a.t));
    return std::abs(there - from.value);
  }

  void divide(const point& a, const point& c, const point& e, int divisions) {
    const double early = inner(a.t, c.t), late = inner(c.t, e.t);
    if (!(a.t < early && early < c.t && c.t < late && late < e.t)) return;
    const point b = sample(early), d = sample(late);
    const std::array<point, 5> all{a, b, c, d, e};
    const auto [least, greatest] = std::ranges::minmax(all, {}, &point::value);
    const bool is_parabola = (std::max)(distance(a, c, e, b), distance(a, c, e, d)) <=
                             0.02 * (greatest.value - least.value); // false for infinite values
    if (!is_parabola && divisions < max_divisions) {
      divide(a, b, c, divisions + 1);
      divide(c, d, e, divisions + 1);
      return;
    }
    for (std::size_t i = 0; i < 5; ++i) {
      const point &before = all[i > 0 ? i - 1 : i], &after = all[i < 4 ? i + 1 : i];
      const double rise = all[i].value - (std::min)(before.value, after.value);
      if (all[i].value >= before.value && all[i].value >= after.value && rise > 0 &&
          all[i].value + rise >= best_)
        refine(before.t, after.t);
    }
  }

  void refine(double from, double to) {
    std::uintmax_t most = 60;
    boost::math::tools::brent_find_minima([this](double t) { return -sample(t).value; }, from, to, 26, most);
  }

  const Function& of_;
  double best_ = -std::numeric_limits<double>::infinity();
  bool has_nan_ = false;
};

/// Returns the maximum of a function of samples along a motion, both at its samples and between them;
/// `between` interpolates a sample. Two samples at the same time are the states before and after a jump.
template <class Path, class Between, class Function>
double maximum_along(const Path& path, const Between& between, const Function& of) {
  const auto at = [&](double t) { return of(between(t)); };
  maximum_search found(at);
  double before = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double value = of(path[i]);
    found.take(value);
    if (i > 0 && path[i - 1].t < path[i].t) found.search(path[i - 1].t, before, path[i].t, value);
    before = value;
  }
  return found.best();
}

} // namespace kanexpr::ensembles
