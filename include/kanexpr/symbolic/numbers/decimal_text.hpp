#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <cstdint>

namespace kanexpr::symbolic {

/// Writes a number for a message, in constant expressions, too: a fraction of small integers, otherwise with
/// six digits after the point at most.
constexpr base::name decimal_text(const number& n) {
  base::name text = n.negative() ? "-" : "";
  const number size = n.negative() ? -n : n;
  constexpr std::int64_t most = 1'000'000;
  if (size.exact() && size.numerator < most && size.denominator < most) {
    text.append(static_cast<int>(size.numerator));
    if (!size.integer()) text.append("/"), text.append(static_cast<int>(size.denominator));
    return text;
  }
  if (!(size.value() < 1e9)) return "...";
  const double scaled = size.value() * 1e6;
  auto millionths = static_cast<std::int64_t>(scaled);
  if (scaled - static_cast<double>(millionths) >= 0.5) ++millionths;
  text.append(static_cast<int>(millionths / most));
  millionths %= most;
  if (millionths > 0) text.append(".");
  for (int unit = 100'000; millionths > 0; unit /= 10) {
    text.append(static_cast<int>(millionths / unit));
    millionths %= unit;
  }
  return text;
}

} // namespace kanexpr::symbolic
