// builds: clang++ sanitize
#include <kanexpr/symbolic/polynomials/polynomial_gcd.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic::polynomials;
using real_polynomial = polynomial<rational>;

class random_polynomials {
public:
  explicit random_polynomials(unsigned seed) : engine_(seed) {}

  unsigned pick(unsigned count) { return std::uniform_int_distribution<unsigned>(0, count - 1)(engine_); }

  real_polynomial make(int variables, unsigned terms, unsigned degree, bool with_decimals = false) {
    term_sum<rational> sum;
    for (unsigned i = 0; i < terms; ++i) {
      monomial m;
      for (int v = 0; v < variables; ++v)
        if (const auto exponent = pick(3) == 0 ? pick(degree + 1) : 0; exponent > 0)
          m.push_back({v, exponent});
      const rational whole(static_cast<int>(pick(21)) - 10);
      sum.add(m, with_decimals ? whole * rational(0.1) : whole / rational(1 + pick(3)));
    }
    sum.add({}, rational(31));
    return sum.sorted();
  }

private:
  std::mt19937 engine_;
};

/// The greatest common divisor of a d and b d is a multiple of d, and the quotients are coprime.
void expect_found(const real_polynomial& a, const real_polynomial& b, const real_polynomial& d) {
  budget left(20'000);
  const real_polynomial p = product(a, d, left), q = product(b, d, left);
  const real_polynomial found = divisor_search(left).common_divisor(p, q);
  const auto x = exact_quotient(p, found, left), y = exact_quotient(q, found, left);
  ASSERT_TRUE(x && y && exact_quotient(found, d, left));
  EXPECT_TRUE(divisor_search(left).common_divisor(*x, *y).is_constant());
  EXPECT_FALSE(left.failed()) << left.cause();
}

TEST(common_divisor, of_random_products) {
  random_polynomials random(1);
  for (int i = 0; i < 300; ++i) {
    const int variables = 1 + i % 8;
    const unsigned terms = 2 + random.pick(8);
    expect_found(random.make(variables, terms, 3), random.make(variables, terms, 3),
                 random.make(variables, terms, 2));
  }
}

TEST(common_divisor, of_long_products) {
  random_polynomials random(2);
  for (int i = 0; i < 15; ++i)
    expect_found(random.make(7, 30, 2), random.make(7, 30, 2), random.make(7, 25, 3));
}

TEST(common_divisor, with_large_coefficients) {
  random_polynomials random(3);
  for (int i = 0; i < 60; ++i)
    expect_found(random.make(4, 5, 2, true), random.make(4, 5, 2, true), random.make(4, 5, 2, true));
}

TEST(common_divisor, with_repeated_factors_and_a_content) {
  random_polynomials random(4);
  for (int i = 0; i < 60; ++i) {
    budget left(20'000);
    const real_polynomial d = random.make(4, 4, 2), e = random.make(2, 3, 2);
    const real_polynomial square = product(d, d, left), with_content = product(e, square, left);
    expect_found(product(random.make(4, 3, 1), d, left), random.make(4, 3, 2), with_content);
  }
}

TEST(common_divisor, of_what_has_none_is_a_number) {
  random_polynomials random(5);
  for (int i = 0; i < 100; ++i) {
    budget left(20'000);
    const real_polynomial p = random.make(6, 12, 3), q = random.make(6, 12, 3);
    EXPECT_TRUE(divisor_search(left).common_divisor(p, q).is_constant());
  }
}

TEST(exact_quotient, is_what_was_multiplied) {
  random_polynomials random(6);
  for (int i = 0; i < 200; ++i) {
    budget left(20'000);
    const real_polynomial p = random.make(5, 8, 3), q = random.make(5, 8, 3);
    const real_polynomial both = product(p, q, left);
    EXPECT_EQ(exact_quotient(both, p, left), q);
    EXPECT_EQ(exact_quotient(both + real_polynomial(rational(1)), p, left), std::nullopt);
  }
}

TEST(exact_quotient, of_negative_powers) {
  budget left(100);
  const real_polynomial x({{0, 1}}, 1), inverse({{0, -1}}, 1), one(rational(1));
  const real_polynomial p = x + inverse, q = x - inverse; // x² - x⁻² = (x + x⁻¹)(x - x⁻¹)
  EXPECT_EQ(exact_quotient(product(p, q, left), p, left), q);
  EXPECT_EQ(exact_quotient(x + one, inverse - one, left), std::nullopt);
  EXPECT_EQ(exact_quotient(product(p, p, left), q, left), std::nullopt);
}

} // namespace
