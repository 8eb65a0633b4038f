#pragma once

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kanexpr::ensembles {

/// The greatest that a function of samples is along a motion: at its samples and, by Brent's method, between
/// those around which it may be greater still.
template <class Path, class Function>
double greatest_along(const Path& path, const Function& of) {
  const std::size_t count = path.size();
  std::vector<double> at(count);
  for (std::size_t i = 0; i < count; ++i) {
    at[i] = of(path[i]);
    if (!std::isfinite(at[i])) return at[i];
  }
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  double best = *std::max_element(at.begin(), at.end());
  const auto look_between = [&](double from, double to) {
    std::uintmax_t most = 60;
    const auto below = [&](double t) {
      const auto s = path.at(t);
      return s ? -of(*s) : std::numeric_limits<double>::infinity();
    };
    const double found = -boost::math::tools::brent_find_minima(below, from, to, 26, most).second;
    if (found > best) best = found;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = i + 1 < count ? i + 1 : i;
    if (at[i] < at[before] || at[i] < at[after]) continue;
    // A parabola rises no more above its greatest sample than that does above the lower of its neighbours.
    const double rise = at[i] - (std::min)(at[before], at[after]);
    if (at[i] + rise >= best && rise > 0 && path[before].t < path[after].t)
      look_between(path[before].t, path[after].t);
  }
  return best;
}

} // namespace kanexpr::ensembles
