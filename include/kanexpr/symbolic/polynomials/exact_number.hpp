#pragma once

#include <kanexpr/symbolic/numbers/number.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <concepts>
#include <utility>

/// Run-time algebra on expressions: exact arithmetic without overflow.
namespace kanexpr::symbolic::algebra {

using integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// A fraction in lowest terms. Most fractions are integers, for which no common divisor is computed.
class rational {
public:
  rational() = default;
  template <std::integral Whole>
  rational(Whole whole) : above_(whole) {}
  explicit rational(integer whole) : above_(std::move(whole)) {}
  rational(integer above, integer below) : above_(std::move(above)), below_(std::move(below)) { reduce(); }
  /// The exact value of a finite double.
  explicit rational(double value) {
    int exponent = 0;
    above_ = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    (exponent < 0 ? below_ : above_) <<= std::abs(exponent);
    reduce();
  }

  const integer& above() const { return above_; }
  const integer& below() const { return below_; } ///< positive
  bool is_zero() const { return above_.is_zero(); }
  bool is_whole() const { return below_ == 1; }
  bool is_negative() const { return above_.sign() < 0; }
  /// The nearest double.
  double value() const {
    if (is_zero()) return 0;
    const integer magnitude = abs(above_);
    const int shift = 63 - static_cast<int>(msb(magnitude)) + static_cast<int>(msb(below_));
    const integer divided = shift < 0 ? magnitude : magnitude << shift;
    const integer by = shift < 0 ? below_ << -shift : below_;
    integer quotient, rest;
    divide_qr(divided, by, quotient, rest);
    const auto digits = quotient.convert_to<std::uint64_t>() | (rest.is_zero() ? 0u : 1u); // 63 or 64 bits
    return std::ldexp((is_negative() ? -1 : 1) * static_cast<double>(digits), -shift);
  }

  bool operator==(const rational&) const = default;
  rational& operator+=(const rational& b) {
    if (is_whole() && b.is_whole())
      above_ += b.above_;
    else
      *this = {above_ * b.below_ + b.above_ * below_, below_ * b.below_};
    return *this;
  }
  friend rational operator-(rational a) {
    a.above_ = -a.above_;
    return a;
  }
  friend rational operator+(rational a, const rational& b) { return a += b; }
  friend rational operator-(rational a, const rational& b) { return a += -b; }
  friend rational operator*(const rational& a, const rational& b) {
    if (a.is_whole() && b.is_whole()) return rational(a.above_ * b.above_);
    return {a.above_ * b.above_, a.below_ * b.below_};
  }
  friend rational operator/(const rational& a, const rational& b) {
    return {a.above_ * b.below_, a.below_ * b.above_};
  }

private:
  void reduce() {
    if (below_.sign() < 0) above_ = -above_, below_ = -below_;
    if (below_ == 1) return;
    const integer common = gcd(above_, below_);
    if (common == 1) return;
    above_ /= common;
    below_ /= common;
  }

  integer above_{};
  integer below_ = 1;
};

/// A double is converted to its exact binary fraction, so 0.1 is not 1/10; it must be finite.
inline rational exact_value(const number& n) {
  return n.exact() ? rational(integer(n.numerator), integer(n.denominator)) : rational(n.real);
}

/// Whether a fraction is printed as a double because it came from a decimal number such as 0.1 or 9.81: its
/// denominator is a multiple of 2²⁰ or very large.
inline bool is_decimal(const rational& r) { return lsb(r.below()) >= 20 || msb(r.below()) >= 32; }

/// Fractions that fit into 64 bits stay exact; decimals and larger fractions become the nearest double.
inline number number_of(const rational& r) {
  if (is_decimal(r) || abs(r.above()) > (std::numeric_limits<std::int64_t>::max)()) return real(r.value());
  return exactly(r.above().convert_to<std::int64_t>(), r.below().convert_to<std::int64_t>());
}

/// The largest positive fraction of which both are integer multiples; zero is a multiple of any fraction.
inline rational common_measure(const rational& a, const rational& b) {
  return {gcd(a.above(), b.above()), lcm(a.below(), b.below())};
}

/// a + i b with rational parts.
struct gaussian {
  rational real;
  rational imaginary{};

  gaussian() = default;
  gaussian(rational r, rational i = 0) : real(std::move(r)), imaginary(std::move(i)) {}
  gaussian(int whole) : real(whole) {}
  bool is_zero() const { return real.is_zero() && imaginary.is_zero(); }
  bool operator==(const gaussian&) const = default;
  gaussian& operator+=(const gaussian& b) {
    real += b.real;
    imaginary += b.imaginary;
    return *this;
  }
};

inline gaussian operator-(const gaussian& a) { return {-a.real, -a.imaginary}; }
inline gaussian operator*(const gaussian& a, const gaussian& b) {
  if (b.imaginary.is_zero()) return {a.real * b.real, a.imaginary * b.real};
  if (a.imaginary.is_zero()) return {a.real * b.real, a.real * b.imaginary};
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}
inline gaussian operator/(const gaussian& a, const gaussian& b) {
  if (b.imaginary.is_zero()) return {a.real / b.real, a.imaginary / b.real};
  const rational square = b.real * b.real + b.imaginary * b.imaginary;
  return a * gaussian(b.real / square, -b.imaginary / square);
}

inline bool is_decimal(const gaussian& a) { return is_decimal(a.real) || is_decimal(a.imaginary); }
inline bool is_negative(const rational& a) { return a.is_negative(); }
/// Tests a half-plane, so that exactly one of a and -a is negative.
inline bool is_negative(const gaussian& a) {
  return a.real.is_zero() ? a.imaginary.is_negative() : a.real.is_negative();
}
inline rational measure_of(const rational& a) { return a.is_negative() ? -a : a; }
inline rational measure_of(const gaussian& a) { return common_measure(a.real, a.imaginary); }

inline std::size_t bits_of(const rational& a) {
  return a.is_zero() ? 0 : msb(abs(a.above())) + msb(a.below());
}
inline std::size_t bits_of(const gaussian& a) { return bits_of(a.real) + bits_of(a.imaginary); }

} // namespace kanexpr::symbolic::algebra
