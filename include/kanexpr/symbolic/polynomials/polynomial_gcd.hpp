#pragma once

#include <kanexpr/symbolic/polynomials/sparse_interpolation.hpp>

#include <map>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::polynomials {

/// Divides out the common numerical factor and monomial; the first term becomes positive.
inline polynomial<rational> primitive_part(const polynomial<rational>& p) {
  if (p.is_zero()) return p;
  const rational c = common_number(p);
  return scaled(p, rational(p.terms.front().coefficient.is_negative() ? -1 : 1) / c,
                over({}, common_monomial(p)));
}

/// Greatest common divisors of multivariate polynomials: variables that the divisor cannot contain are found
/// from images modulo a prime and removed; the divisor is then interpolated. The result always divides both
/// polynomials.
class divisor_search {
public:
  explicit divisor_search(budget& left) : left_(left) {}

  /// The divisor up to a numerical factor; 1 if the budget is exceeded.
  polynomial<rational> common_divisor(const polynomial<rational>& a, const polynomial<rational>& b) {
    if (a.is_zero() || b.is_zero()) return a.is_zero() ? b : a;
    const monomial shared = common_part(common_monomial(a), common_monomial(b));
    return scaled(of_primitive(primitive_part(a), primitive_part(b)), rational(1), shared);
  }

private:
  using real_polynomial = polynomial<rational>;

  static real_polynomial one() { return {rational(1)}; }
  static std::int64_t degree(const real_polynomial& p, int base) {
    std::int64_t most = 0;
    for (const term<rational>& t : p.terms) most = (std::max)(most, exponent_of(t.factors, base));
    return most;
  }

  real_polynomial of_primitive(const real_polynomial& a, const real_polynomial& b) {
    if (a.is_constant() || b.is_constant() || left_.failed()) return one();
    if (a == b) return a;
    const std::map<int, std::int64_t> bounds = degree_bounds(a, b);
    const auto is_absent = [&bounds](int base) {
      const auto bound = bounds.find(base);
      return bound == bounds.end() || bound->second == 0;
    };
    const auto has_absent = [&](const real_polynomial& p) {
      return std::ranges::any_of(exponent_ranges(p), [&](const auto& each) { return is_absent(each.first); });
    };
    if (has_absent(a) || has_absent(b)) {
      std::vector<real_polynomial> parts = values_of(coefficients(a, is_absent));
      for (real_polynomial& part : values_of(coefficients(b, is_absent))) parts.push_back(part);
      return of_all(parts);
    }
    for (const auto& [divisor, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      const bool may_divide = std::ranges::all_of(
          bounds, [d = divisor](const auto& each) { return degree(*d, each.first) == each.second; });
      if (may_divide && exact_quotient(*other, *divisor, left_)) return *divisor;
    }
    const int main = std::ranges::min_element(bounds, {}, [&](const auto& each) {
                       return (std::max)(degree(a, each.first), degree(b, each.first));
                     })->first;
    return by_main_variable(a, b, main, bounds);
  }

  real_polynomial by_main_variable(const real_polynomial& a, const real_polynomial& b, int main,
                                   const std::map<int, std::int64_t>& bounds) {
    const real_polynomial of_a = content(a, main), of_b = content(b, main);
    if (of_a.is_one() && of_b.is_one()) return interpolated(a, b, main, bounds);
    const auto x = exact_quotient(a, of_a, left_), y = exact_quotient(b, of_b, left_);
    if (!x || !y) return one();
    return product(common_divisor(of_a, of_b), of_primitive(primitive_part(*x), primitive_part(*y)), left_);
  }

  template <class Map>
  static std::vector<real_polynomial> values_of(const Map& parts) {
    std::vector<real_polynomial> values;
    values.reserve(parts.size());
    for (const auto& [m, p] : parts) values.push_back(p);
    return values;
  }

  real_polynomial of_all(std::vector<real_polynomial> all) {
    std::ranges::sort(all, {}, &real_polynomial::size);
    real_polynomial common;
    for (const real_polynomial& each : all) {
      common = common_divisor(common, each);
      if (common.is_constant()) return one();
    }
    return primitive_or_monomial(common);
  }
  /// The primitive part with its monomial, without sign or numerical factor.
  static real_polynomial primitive_or_monomial(const real_polynomial& p) {
    return scaled(primitive_part(p), rational(1), common_monomial(p));
  }

  real_polynomial content(const real_polynomial& p, int main) {
    return of_all(values_of(coefficients(p, [main](int base) { return base == main; })));
  }

  /// Upper bounds on the degrees of the divisor, for the variables in both.
  std::map<int, std::int64_t> degree_bounds(const real_polynomial& a, const real_polynomial& b) {
    std::map<int, std::int64_t> bounds;
    std::map<int, residue> point;
    const prime_field field(prime_below(residue{1} << 31));
    for (const real_polynomial* p : {&a, &b})
      for (const auto& [base, range] : exponent_ranges(*p))
        point[base] = std::uniform_int_distribution<residue>(1, field.prime() - 1)(random_);
    for (const auto& [base, value] : point) {
      const std::int64_t least = (std::min)(degree(a, base), degree(b, base));
      if (least == 0) continue;
      bounds[base] = least;
      const modular_image x(field, a, base), y(field, b, base);
      if (!left_.spend(x.size() + y.size())) continue;
      const residues p = x.at(point), q = y.at(point);
      if (p.size() > x.degree() && q.size() > y.degree())
        bounds[base] = static_cast<std::int64_t>(field.greatest_common_divisor(p, q).size()) - 1;
    }
    return bounds;
  }

  /// Works modulo one prime after another until a divisor is found.
  real_polynomial interpolated(const real_polynomial& a, const real_polynomial& b, int main,
                               const std::map<int, std::int64_t>& bounds) {
    const auto is_main = [main](int base) { return base == main; };
    const real_polynomial x = coefficients(a, is_main).begin()->second;
    const real_polynomial y = coefficients(b, is_main).begin()->second;
    const real_polynomial leading =
        scaled(primitive_or_monomial(common_divisor(x, y)), rational_gcd(common_number(x), common_number(y)));
    sparse_interpolation::problem given{
        a, b, leading, main, static_cast<std::size_t>(bounds.find(main)->second), {}};
    for (const auto& [base, bound] : bounds)
      if (base != main)
        given.bounds.emplace_back(base, static_cast<std::size_t>(bound + degree(leading, base)));

    std::map<monomial, integer, descending> lifted;
    integer modulus = 1;
    residue prime = residue{1} << 31;
    for (int tries = 0; tries < 60 && !left_.failed(); ++tries) {
      prime = prime_below(prime);
      const prime_field field(prime);
      sparse_interpolation images(field, given, random_, left_);
      const auto found = images.run();
      if (images.image_degree() == 0) return one();
      if (images.image_degree() < given.degree)
        given.degree = images.image_degree(), lifted.clear(), modulus = 1;
      if (!found || !lift(*found, field, lifted, modulus)) continue;
      const real_polynomial candidate = divisor_of(lifted, modulus, main);
      if (exact_quotient(a, candidate, left_) && exact_quotient(b, candidate, left_)) return candidate;
    }
    left_.fail("the common divisor could not be found");
    return one();
  }

  /// Combines coefficients modulo the product of all primes so far (Chinese remainder theorem). Returns
  /// whether the last prime changed nothing or was the first.
  static bool lift(const std::vector<std::pair<monomial, residue>>& found, const prime_field& field,
                   std::map<monomial, integer, descending>& lifted, integer& modulus) {
    const bool is_first = modulus == 1;
    bool is_same = true;
    std::map<monomial, residue, descending> seen;
    for (const auto& [m, c] : found) {
      lifted.try_emplace(m, 0);
      seen[m] = c;
    }
    const integer next = modulus * field.prime();
    const residue by = field.inverse(field.of(modulus));
    for (auto& [m, value] : lifted) {
      const auto place = seen.find(m);
      const residue wanted = place == seen.end() ? 0 : place->second;
      const residue step = field.multiply(field.subtract(wanted, field.of(value)), by);
      if (step == 0) continue;
      is_same = false;
      value += modulus * step;
      if (2 * value > next) value -= next;
    }
    modulus = next;
    return is_first || is_same;
  }

  real_polynomial divisor_of(const std::map<monomial, integer, descending>& lifted, const integer& modulus,
                             int main) {
    real_polynomial sum;
    for (const auto& [m, value] : lifted)
      if (value != 0) sum.terms.push_back({m, rational(2 * value > modulus ? value - modulus : value)});
    const auto quotient = exact_quotient(sum, content(sum, main), left_);
    return quotient ? primitive_part(*quotient) : one();
  }

  budget& left_;
  std::mt19937_64 random_{20240229};
};

} // namespace kanexpr::symbolic::polynomials
