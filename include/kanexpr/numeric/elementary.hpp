#pragma once

// Elementary functions of `double` with identical bits at compile time and at run time: <cmath> is not
// constexpr in C++20, and a compiler's builtins need not agree with the libm it links to.
//
// Reductions use integers, and short series use `long double`. On x86-64 that is the 80-bit format, which has
// no fused multiply-add instructions, and results are within 0.51 ulp (pow: 2 ulp near the ends of its
// range). Where long double is double, expect 2-3 ulp. Special values follow Annex F of the C standard. No
// arithmetic here yields NaN or overflows, because neither is permitted in a constant expression.

#include <kanexpr/base/equal.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

// Callers may be compiled with -ffast-math or contraction, but the arithmetic below must not be. Flushing
// subnormal numbers to zero is a mode of the processor, not of the code; the caller is responsible for it.
#if defined(__clang__)
#pragma float_control(push)
#pragma float_control(precise, on)
#pragma clang fp contract(off)
#elif defined(__GNUC__) && defined(__FAST_MATH__)
#pragma GCC push_options
#pragma GCC optimize("no-fast-math")
#endif

namespace kanexpr::numeric::elementary {

namespace detail {

using real = long double;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr real pi = 3.1415926535897932384626433833L;
inline constexpr double half_turn = 3.141592653589793;
inline constexpr real log2_e = 1.4426950408889634073599246810L;
inline constexpr real ln_2 = 0.6931471805599453094172321215L;

inline constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

// Tests on bits, which -ffinite-math-only cannot remove.
constexpr std::uint64_t bits(double x) noexcept { return std::bit_cast<std::uint64_t>(x); }
constexpr std::uint64_t magnitude(double x) noexcept { return bits(x) & ~sign_bit; }
constexpr bool is_negative(double x) noexcept { return (bits(x) & sign_bit) != 0; }
constexpr bool is_finite(double x) noexcept { return magnitude(x) < bits(infinity); }
constexpr bool is_nan(double x) noexcept { return magnitude(x) > bits(infinity); }

constexpr double copy_sign(double x, double sign) noexcept { return __builtin_copysign(x, sign); }

// Returns the m and k of |x| = m * 2^k with 2^52 <= m < 2^53, for finite x != 0.
constexpr std::pair<std::uint64_t, int> decompose(double x) noexcept {
  constexpr std::uint64_t implicit_bit = std::uint64_t{1} << 52;
  const std::uint64_t fraction = bits(x) & (implicit_bit - 1);
  const int biased_exponent = static_cast<int>(magnitude(x) >> 52);
  if (biased_exponent > 0) return {fraction | implicit_bit, biased_exponent - 1075};
  const int shift = std::countl_zero(fraction) - 11;
  return {fraction << shift, -1074 - shift};
}

// Returns 2^n for -1022 <= n <= 1023.
constexpr double power_of_two(int n) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

// Returns x * 2^n for x >= 0 and |n| <= 2000, in two steps because 2^n itself may be out of range; only the
// second step can round. The bound is the midpoint between the largest double and 2^1024.
constexpr double scaled(real x, int n) noexcept {
  const real y = x * static_cast<real>(power_of_two(n / 2)) * static_cast<real>(power_of_two(n - n / 2));
  return y - static_cast<real>((std::numeric_limits<double>::max)()) >= 0x1p970L ? infinity
                                                                                 : static_cast<double>(y);
}

constexpr int nearest(real x) noexcept { return static_cast<int>(x < 0 ? x - 0.5L : x + 0.5L); }

// A plain array, because a call to std::array's operator[] would cost more than the multiplication in
// `series`.
struct coefficients {
  real of[24];
};
constexpr coefficients reciprocals_of(bool factorials) noexcept {
  coefficients c{{1}};
  for (int n = 1; n < 24; ++n) c.of[n] = (factorials ? c.of[n - 1] : 1) / static_cast<real>(n);
  return c;
}
inline constexpr coefficients reciprocals = reciprocals_of(false);
inline constexpr coefficients reciprocal_factorials = reciprocals_of(true);

// Evaluates c[m] + c[m + step] x + c[m + 2 step] x^2 + ... + c[last] x^k with m = last mod step.
constexpr real series(const coefficients& c, int step, int last, real x) noexcept {
  real sum = c.of[last];
  for (int n = last - step; n >= 0; n -= step) sum = sum * x + c.of[n];
  return sum;
}

// Returns the correctly rounded square root of a finite x > 0. With x = m * 4^k, the root of n = m * 2^52
// rounds to the integer r for which -r < n - r^2 <= r. Newton's method gives an r that differs by at most
// one, so the low 64 bits of n - r^2 determine it.
constexpr double positive_sqrt(double x) noexcept {
  const auto [significand, exponent] = decompose(x);
  const int odd = exponent & 1;
  const std::uint64_t m = significand << odd;
  const real target = static_cast<real>(m) * 0x1p-52L;
  real root = 0.6875L + target / 3; // within 4.2 % on [1, 4)
  for (int i = 0; i < 4; ++i) root = (root + target / root) / 2;
  auto r = static_cast<std::uint64_t>(root * 0x1p52L);
  const auto excess = static_cast<std::int64_t>((m << 52) - r * r);
  if (excess > static_cast<std::int64_t>(r)) ++r;
  if (excess <= -static_cast<std::int64_t>(r)) --r;
  return static_cast<double>(r) * power_of_two((exponent - odd) / 2 - 26);
}

// Returns sqrt(1 - x^2) for |x| <= 1; one Newton step refines the rounded root to the precision of long
// double.
constexpr real other_leg(double x) noexcept {
  const real square = (1 - static_cast<real>(x)) * (1 + static_cast<real>(x));
  if (square <= 0) return 0;
  const real root = static_cast<real>(positive_sqrt(static_cast<double>(square)));
  return (root + square / root) / 2;
}

// The bits of 1/(2 pi) starting at weight 2^63, enough for the largest double.
inline constexpr std::uint64_t turns_per_radian[] = {
    0x0000000000000000u, 0x28be60db9391054au, 0x7f09d5f47d4d3770u, 0x36d8a5664f10e410u, 0x7f9458eaf7aef158u,
    0x6dc91b8e909374b8u, 0x01924bba82746487u, 0x3f877ac72c4a69cfu, 0xba208d7d4baed121u, 0x3a671c09ad17df90u,
    0x4e64758e60d4ce7du, 0x272117e2ef7e4a0eu, 0xc7fe25fff7816603u, 0xfbcbc462d6829b47u, 0xdb4d9fb3c9f2c26du,
    0xd3d18fd9a797fa8bu, 0x5d49eeb1faf97c5eu, 0xcf41ce7de294a4bau, 0x9afed7ec47e35742u, 0x1580cc11bf1edaeau};

// Returns the upper 64 bits of a product; not every target has 128-bit integers.
constexpr std::uint64_t high_half(std::uint64_t a, std::uint64_t b) noexcept {
  const std::uint64_t a0 = a & 0xffffffffu, a1 = a >> 32, b0 = b & 0xffffffffu, b1 = b >> 32;
  const std::uint64_t middle = a1 * b0 + (a0 * b0 >> 32);
  return a1 * b1 + (middle >> 32) + ((a0 * b1 + (middle & 0xffffffffu)) >> 32);
}

// Returns the quadrant and the offset, at most pi/4 in magnitude, such that x is quadrant * pi/2 + offset up
// to whole turns. The bits of 1/(2 pi) that contribute only whole turns are skipped (Payne and Hanek, "Radian
// reduction for trigonometric functions", SIGNUM Newsletter 18, 1983). Of the 128 bits retained for the
// fraction of a turn, about 64 are significant even for the double that is closest to a multiple of pi/2 (it
// differs by about 2^-61).
constexpr std::pair<unsigned, real> reduce_angle(double x) noexcept {
  if (magnitude(x) < bits(0.5)) return {0, x};
  const auto [significand, exponent] = decompose(x);
  const std::uint64_t* const digits = turns_per_radian + (exponent + 64) / 64;
  const int shift = (exponent + 64) % 64;
  const auto window = [=](int i) { return (digits[i] << shift) | (digits[i + 1] >> 1 >> (63 - shift)); };
  const std::uint64_t carried = high_half(significand, window(2));
  const std::uint64_t low = significand * window(1) + carried;
  const std::uint64_t high =
      significand * window(0) + high_half(significand, window(1)) + (low < carried ? 1u : 0u);
  const std::uint64_t quadrant = (high + (std::uint64_t{1} << 61)) >> 62;
  const auto remainder = static_cast<std::int64_t>(high - (quadrant << 62));
  const real turns = static_cast<real>(remainder) * 0x1p-64L + static_cast<real>(low) * 0x1p-128L;
  const real offset = turns * (2 * pi);
  if (is_negative(x)) return {static_cast<unsigned>(4 - quadrant), -offset};
  return {static_cast<unsigned>(quadrant), offset};
}

// Returns the sine of the angle quadrant * pi/2 + offset (DLMF 4.19.1, 4.19.2); neglected terms are below
// 2^-62 of the result.
constexpr real sine(unsigned quadrant, real offset) noexcept {
  const real square = offset * offset;
  const real value = quadrant % 2 == 0 ? offset * series(reciprocal_factorials, 2, 17, -square)
                                       : series(reciprocal_factorials, 2, 18, -square);
  return quadrant % 4 < 2 ? value : -value;
}

constexpr double sine_after(unsigned quarter_turns, double x) noexcept {
  if (!is_finite(x)) return not_a_number;
  const auto [quadrant, offset] = reduce_angle(x);
  return static_cast<double>(sine(quadrant + quarter_turns, offset));
}

// Returns the angle of the point (x, y) for finite x, y >= 0. With t = y/x <= 1 and c = k/8 nearest to t,
// arctan t = arctan c + arctan((t - c)/(1 + tc)) (DLMF 4.24.15), so the series 4.24.3 is needed only up to
// 1/16.
constexpr real first_quadrant_angle(real y, real x) noexcept {
  constexpr real arctan_eighths[] = {
      0.000000000000000000000000L, 0.124354994546761435031355L, 0.244978663126864154172082L,
      0.358770670270572220395920L, 0.463647609000806116214256L, 0.558599315343562435971508L,
      0.643501108793284386802809L, 0.718829999621624505417014L, 0.785398163397448309615661L};
  if (y > x) return pi / 2 - first_quadrant_angle(x, y);
  if (y <= 0) return 0;
  const real t = y / x;
  const int k = nearest(8 * t);
  const real c = static_cast<real>(k) / 8;
  const real u = (t - c) / (1 + t * c);
  return arctan_eighths[k] + u * series(reciprocals, 2, 15, -u * u);
}

// Returns the k and r of log|x| = k log 2 + r with |r| <= log(2)/2, for finite x != 0. The series is DLMF
// 4.6.4, with |s| <= 0.172; the first neglected term is below 2^-63 of the result.
constexpr std::pair<int, real> split_log(double x) noexcept {
  const auto [significand, exponent] = decompose(x);
  const real m = static_cast<real>(significand) * 0x1p-52L;
  const bool large = m > 1.4142135623730950488L;
  const real z = large ? m / 2 : m;
  const real s = (z - 1) / (z + 1);
  return {exponent + (large ? 53 : 52), 2 * s * series(reciprocals, 2, 23, s * s)};
}

// Returns the k and e^r of e^x = 2^k e^r with |r| <= log(2)/2, for |x| <= 2000. Log 2 is split into two
// parts, such that the product of k and the first part is exact (Cody and Waite, "Software Manual for the
// Elementary Functions", 1980). The first neglected term of DLMF 4.2.19 is below 2^-62.
constexpr std::pair<int, real> split_exp(double x) noexcept {
  const auto wide = static_cast<real>(x);
  const int k = nearest(wide * log2_e);
  const real r = (wide - k * 0x1.62e42feep-1L) - k * 0x1.a39ef35793c7673p-33L;
  return {k, series(reciprocal_factorials, 1, 14, r)};
}

// Returns x^y for finite x > 0 and y; the exponential series (DLMF 4.2.19) is truncated as in exp.
constexpr double positive_pow(double x, double y) noexcept {
  // Powers of a double up to the 15th stay within the range of the 80-bit format.
  if (magnitude(y) <= bits(15.0) && base::equal(static_cast<double>(static_cast<int>(y)), y)) {
    const int n = static_cast<int>(y < 0 ? -y : y);
    const real factor = static_cast<real>(x);
    real power = 1;
    for (int bit = 8; bit > 0; bit /= 2) power *= power * ((n & bit) != 0 ? factor : 1);
    return scaled(y < 0 ? 1 / power : power, 0);
  }
  // The product with the exponent of x is exact, and n is subtracted from it first, so its magnitude costs no
  // accuracy.
  const auto [exponent, remainder] = split_log(x);
  const real whole = static_cast<real>(y) * exponent;
  const real part = static_cast<real>(y) * (remainder * log2_e);
  if (whole + part > 1100) return infinity;
  if (whole + part < -1100) return 0;
  const int n = nearest(whole + part);
  return scaled(series(reciprocal_factorials, 1, 14, ((whole - n) + part) * ln_2), n);
}

} // namespace detail

[[nodiscard]] constexpr double abs(double x) noexcept { return __builtin_fabs(x); }

// Uses Newton's method with an initial guess accurate to within 20 %.
[[nodiscard]] constexpr double cbrt(double x) noexcept {
  if (base::equal(x, 0.0) || !detail::is_finite(x)) return x;
  const auto [significand, exponent] = detail::decompose(x);
  const int rest = (exponent % 3 + 3) % 3;
  const detail::real m = static_cast<detail::real>(significand << rest) * 0x1p-54L; // from 1/4 to 2
  detail::real root = 0.5L + m / 2;
  for (int i = 0; i < 6; ++i) root = (2 * root + m / (root * root)) / 3;
  return detail::copy_sign(detail::scaled(root, (exponent - rest) / 3 + 18), x);
}

// Uses a series of positive terms (DLMF 7.6.2) up to 2, and 1 - erfc x with a continued fraction (DLMF 7.9.1)
// above; from 6 on, erfc x is negligible. The square of x is split into two parts; the first one is exact.
[[nodiscard]] constexpr double erf(double x) noexcept {
  if (detail::is_nan(x)) return x;
  const double size = abs(x);
  if (size >= 6) return detail::copy_sign(1.0, x);
  const double leading = static_cast<double>(static_cast<float>(size));
  const auto [k, power] = detail::split_exp(-leading * leading);
  const detail::real wide = static_cast<detail::real>(size), first = static_cast<detail::real>(leading);
  const detail::real decay =
      power * static_cast<detail::real>(detail::power_of_two(k)) *
      detail::series(detail::reciprocal_factorials, 1, 4, (first - wide) * (first + wide));
  constexpr detail::real inverse_root_of_pi = 0.5641895835477562869480794516L;
  detail::real value = 0;
  if (size < 2) {
    const detail::real square = wide * wide;
    for (int n = 40; n > 0; --n) value = (1 + value) * (2 * square) / static_cast<detail::real>(2 * n + 1);
    value = 2 * inverse_root_of_pi * wide * decay * (1 + value);
  } else {
    for (int n = 60; n > 0; --n) value = static_cast<detail::real>(n) / 2 / (wide + value);
    value = 1 - inverse_root_of_pi * decay / (wide + value);
  }
  return detail::copy_sign(static_cast<double>(value), x);
}

// Returns the exact remainder of x after division by the double nearest to 2 pi, in [-pi, pi). The
// significand of x is doubled modulo the significand of 2 pi, once per unit of difference between the
// exponents.
[[nodiscard]] constexpr double wrap_to_pi(double x) noexcept {
  if (!detail::is_finite(x)) return detail::not_a_number;
  constexpr double turn = 2 * detail::half_turn;
  double r = abs(x);
  if (r >= 2 * turn) {
    const auto [modulus, lowest] = detail::decompose(turn);
    const auto [significand, exponent] = detail::decompose(x);
    std::uint64_t rest = significand % modulus;
    for (int i = lowest; i < exponent; ++i) rest = 2 * rest % modulus;
    r = static_cast<double>(rest) * detail::power_of_two(lowest);
  }
  for (int i = 0; i < 2; ++i)
    if (r > detail::half_turn) r -= turn; // exact
  r = detail::is_negative(x) ? -r : r;
  return r >= detail::half_turn ? -detail::half_turn : r;
}

// Returns -1 or 1; zeros and NaN are returned unchanged.
[[nodiscard]] constexpr double sign(double x) noexcept {
  return base::equal(x, 0.0) || detail::is_nan(x) ? x : detail::copy_sign(1.0, x);
}

[[nodiscard]] constexpr double floor(double x) noexcept {
  // From 2^52 on, all doubles are integers; -0 is returned unchanged to keep its sign.
  if (base::equal(x, 0.0) || detail::magnitude(x) >= detail::bits(0x1p52)) return x;
  const auto truncated = static_cast<std::int64_t>(x);
  return static_cast<double>(truncated - (static_cast<double>(truncated) > x ? 1 : 0));
}

[[nodiscard]] constexpr double sqrt(double x) noexcept {
  if (base::equal(x, 0.0) || base::equal(x, detail::infinity)) return x;
  return detail::is_nan(x) || x < 0 ? detail::not_a_number : detail::positive_sqrt(x);
}

[[nodiscard]] constexpr double sin(double x) noexcept { return detail::sine_after(0, x); }
[[nodiscard]] constexpr double cos(double x) noexcept { return detail::sine_after(1, x); }

[[nodiscard]] constexpr double tan(double x) noexcept {
  if (!detail::is_finite(x)) return detail::not_a_number;
  const auto [quadrant, offset] = detail::reduce_angle(x);
  return static_cast<double>(detail::sine(quadrant, offset) / detail::sine(quadrant + 1, offset));
}

[[nodiscard]] constexpr double asin(double x) noexcept {
  if (detail::magnitude(x) > detail::bits(1.0)) return detail::not_a_number;
  const auto angle = detail::first_quadrant_angle(static_cast<detail::real>(abs(x)), detail::other_leg(x));
  return detail::copy_sign(static_cast<double>(angle), x);
}

[[nodiscard]] constexpr double acos(double x) noexcept {
  if (detail::magnitude(x) > detail::bits(1.0)) return detail::not_a_number;
  const auto angle = detail::first_quadrant_angle(detail::other_leg(x), static_cast<detail::real>(abs(x)));
  return static_cast<double>(x < 0 ? detail::pi - angle : angle);
}

[[nodiscard]] constexpr double atan2(double y, double x) noexcept {
  if (detail::is_nan(x) || detail::is_nan(y)) return detail::not_a_number;
  const bool finite = detail::is_finite(x) && detail::is_finite(y);
  const auto length = [=](double t) {
    return static_cast<detail::real>(finite ? abs(t) : detail::is_finite(t) ? 0.0 : 1.0);
  };
  const auto angle = detail::first_quadrant_angle(length(y), length(x));
  return detail::copy_sign(static_cast<double>(detail::is_negative(x) ? detail::pi - angle : angle), y);
}

[[nodiscard]] constexpr double atan(double x) noexcept { return atan2(x, 1.0); }

[[nodiscard]] constexpr double exp(double x) noexcept {
  if (detail::is_nan(x)) return detail::not_a_number;
  if (x > 710) return detail::infinity;
  if (x < -746) return 0;
  const auto [k, power] = detail::split_exp(x);
  return detail::scaled(power, k);
}

// Evaluates sinh x / cosh x by their series (DLMF 4.33.1, 4.33.2) up to 1/2, and 1 - 2 / (e^2x + 1) above;
// from 20 on, the quotient is negligible.
[[nodiscard]] constexpr double tanh(double x) noexcept {
  if (detail::is_nan(x)) return detail::not_a_number;
  if (abs(x) >= 20) return detail::copy_sign(1.0, x);
  detail::real value = static_cast<detail::real>(abs(x));
  if (value < 0.5L) {
    const detail::real square = value * value;
    value *= detail::series(detail::reciprocal_factorials, 2, 15, square) /
             detail::series(detail::reciprocal_factorials, 2, 16, square);
  } else {
    const auto [k, power] = detail::split_exp(2 * abs(x));
    value = 1 - 2 / (power * static_cast<detail::real>(detail::power_of_two(k)) + 1);
  }
  return detail::copy_sign(static_cast<double>(value), x);
}

// Evaluates the series (DLMF 4.33.1) up to 1/2, and exponentials above; from 40 on, one of them is
// negligible.
[[nodiscard]] constexpr double sinh(double x) noexcept {
  if (detail::is_nan(x)) return detail::not_a_number;
  const double size = abs(x);
  if (size > 711) return detail::copy_sign(detail::infinity, x);
  detail::real value = static_cast<detail::real>(size);
  if (size < 0.5) {
    value *= detail::series(detail::reciprocal_factorials, 2, 17, value * value);
    return detail::copy_sign(static_cast<double>(value), x);
  }
  const auto [k, power] = detail::split_exp(size);
  if (size > 40) return detail::copy_sign(detail::scaled(power, k - 1), x);
  value = power * static_cast<detail::real>(detail::power_of_two(k));
  return detail::copy_sign(static_cast<double>((value - 1 / value) / 2), x);
}

[[nodiscard]] constexpr double cosh(double x) noexcept {
  if (detail::is_nan(x)) return detail::not_a_number;
  const double size = abs(x);
  if (size > 711) return detail::infinity;
  const auto [k, power] = detail::split_exp(size);
  if (size > 40) return detail::scaled(power, k - 1);
  const detail::real value = power * static_cast<detail::real>(detail::power_of_two(k));
  return static_cast<double>((value + 1 / value) / 2);
}

[[nodiscard]] constexpr double log(double x) noexcept {
  if (base::equal(x, 0.0)) return -detail::infinity;
  if (base::equal(x, detail::infinity)) return x;
  if (detail::is_nan(x) || x < 0) return detail::not_a_number;
  const auto [exponent, remainder] = detail::split_log(x);
  return static_cast<double>(exponent * detail::ln_2 + remainder);
}

[[nodiscard]] constexpr double pow(double x, double y) noexcept {
  if (base::equal(y, 0.0) || base::equal(x, 1.0)) return 1;
  if (detail::is_nan(x) || detail::is_nan(y)) return detail::not_a_number;
  if (!detail::is_finite(y)) return base::equal(x, -1.0) ? 1 : (abs(x) > 1) == (y > 0) ? detail::infinity : 0;
  const bool integer = base::equal(floor(y), y);
  const double sign = integer && !base::equal(floor(y / 2) * 2, y) ? x : 1.0;
  const bool zero = base::equal(x, 0.0);
  if (zero || !detail::is_finite(x)) {
    return detail::copy_sign(zero == (y < 0) ? detail::infinity : 0, sign);
  }
  if (x < 0 && !integer) return detail::not_a_number;
  return base::equal(y, 0.5) ? sqrt(x) : detail::copy_sign(detail::positive_pow(abs(x), y), sign);
}

} // namespace kanexpr::numeric::elementary

#if defined(__clang__)
#pragma float_control(pop)
#elif defined(__GNUC__) && defined(__FAST_MATH__)
#pragma GCC pop_options
#endif
