#pragma once

#include <kanexpr/symbolic/numbers/number.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <concepts>
#include <utility>

/// Run-time algebra on expressions: exact arithmetic without overflow.
namespace kanexpr::symbolic::polynomials {

using integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// A fraction in lowest terms. Most fractions are integers, for which no common divisor is computed.
class rational {
public:
  rational() = default;
  template <std::integral Whole>
  rational(Whole whole) : numerator_(whole) {}
  explicit rational(integer whole) : numerator_(std::move(whole)) {}
  rational(integer numerator, integer denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    reduce();
  }
  /// The exact value of a finite double.
  explicit rational(double value) {
    int exponent = 0;
    numerator_ = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    (exponent < 0 ? denominator_ : numerator_) <<= std::abs(exponent);
    reduce();
  }

  const integer& numerator() const { return numerator_; }
  const integer& denominator() const { return denominator_; } ///< positive
  bool is_zero() const { return numerator_.is_zero(); }
  bool is_integer() const { return denominator_ == 1; }
  bool is_negative() const { return numerator_.sign() < 0; }
  /// The nearest double.
  double value() const {
    if (is_zero()) return 0;
    const integer magnitude = abs(numerator_);
    const int shift = 63 - static_cast<int>(msb(magnitude)) + static_cast<int>(msb(denominator_));
    const integer divided = shift < 0 ? magnitude : magnitude << shift;
    const integer by = shift < 0 ? denominator_ << -shift : denominator_;
    integer quotient, rest;
    divide_qr(divided, by, quotient, rest);
    const auto digits = quotient.convert_to<std::uint64_t>() | (rest.is_zero() ? 0u : 1u); // 63 or 64 bits
    return std::ldexp((is_negative() ? -1 : 1) * static_cast<double>(digits), -shift);
  }

  bool operator==(const rational&) const = default;
  rational& operator+=(const rational& b) {
    if (is_integer() && b.is_integer())
      numerator_ += b.numerator_;
    else
      *this = {numerator_ * b.denominator_ + b.numerator_ * denominator_, denominator_ * b.denominator_};
    return *this;
  }
  friend rational operator-(rational a) {
    a.numerator_ = -a.numerator_;
    return a;
  }
  friend rational operator+(rational a, const rational& b) { return a += b; }
  friend rational operator-(rational a, const rational& b) { return a += -b; }
  friend rational operator*(const rational& a, const rational& b) {
    if (a.is_integer() && b.is_integer()) return rational(a.numerator_ * b.numerator_);
    return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
  }
  friend rational operator/(const rational& a, const rational& b) {
    return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
  }

private:
  void reduce() {
    if (denominator_.sign() < 0) numerator_ = -numerator_, denominator_ = -denominator_;
    if (denominator_ == 1) return;
    const integer common = gcd(numerator_, denominator_);
    if (common == 1) return;
    numerator_ /= common;
    denominator_ /= common;
  }

  integer numerator_{};
  integer denominator_ = 1;
};

/// A double is converted to its exact binary fraction, so 0.1 is not 1/10; it must be finite.
inline rational exact_value(const number& n) {
  return n.exact() ? rational(integer(n.numerator), integer(n.denominator)) : rational(n.real);
}

/// Whether a fraction is printed as a double because it came from a decimal number such as 0.1 or 9.81: its
/// denominator is a multiple of 2²⁰ or very large.
inline bool is_decimal(const rational& r) { return lsb(r.denominator()) >= 20 || msb(r.denominator()) >= 32; }

/// Fractions that fit into 64 bits stay exact; decimals and larger fractions become the nearest double.
inline number number_of(const rational& r) {
  if (is_decimal(r) || abs(r.numerator()) > (std::numeric_limits<std::int64_t>::max)())
    return real(r.value());
  return exactly(r.numerator().convert_to<std::int64_t>(), r.denominator().convert_to<std::int64_t>());
}

/// The largest positive fraction of which both are integer multiples; zero is a multiple of any fraction.
inline rational rational_gcd(const rational& a, const rational& b) {
  return {gcd(a.numerator(), b.numerator()), lcm(a.denominator(), b.denominator())};
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
/// The sign of the first nonzero part, so that exactly one of a and -a is negative.
inline bool is_negative(const gaussian& a) {
  return a.real.is_zero() ? a.imaginary.is_negative() : a.real.is_negative();
}
inline rational positive_content(const rational& a) { return a.is_negative() ? -a : a; }
inline rational positive_content(const gaussian& a) { return rational_gcd(a.real, a.imaginary); }

inline std::size_t bits_of(const rational& a) {
  return a.is_zero() ? 0 : msb(abs(a.numerator())) + msb(a.denominator());
}
inline std::size_t bits_of(const gaussian& a) { return bits_of(a.real) + bits_of(a.imaginary); }

} // namespace kanexpr::symbolic::polynomials
