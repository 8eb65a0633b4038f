#pragma once

#include <kanexpr/symbolic/polynomials/polynomial.hpp>
#include <kanexpr/symbolic/polynomials/prime_field.hpp>

#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::polynomials {

/// The value of a monomial with nonnegative exponents.
inline residue value_at(const prime_field& field, const monomial& m, const std::map<int, residue>& point) {
  residue value = 1;
  for (const factor& f : m)
    value = field.multiply(value,
                           field.power(point.find(f.base)->second, static_cast<std::uint64_t>(f.exponent)));
  return value;
}

/// Evaluates polynomials with integer coefficients modulo a prime, as polynomials in one of their variables.
class modular_image {
public:
  modular_image(const prime_field& f, const polynomial<rational>& p, int main) : field_(f) {
    for (const term<rational>& t : p.terms) {
      const auto degree = static_cast<std::size_t>(exponent_of(t.factors, main));
      degree_ = (std::max)(degree_, degree);
      terms_.push_back({without(t.factors, main), degree, f.of(t.coefficient.numerator())});
    }
  }

  std::size_t degree() const { return degree_; }
  std::size_t size() const { return terms_.size(); }
  /// The result is shorter if the leading coefficient vanishes.
  residues at(const std::map<int, residue>& point) const {
    residues sum(degree_ + 1, 0);
    for (const piece& t : terms_)
      sum[t.degree] =
          field_.add(sum[t.degree], field_.multiply(t.coefficient, value_at(field_, t.factors, point)));
    while (!sum.empty() && sum.back() == 0) sum.pop_back();
    return sum;
  }

private:
  struct piece {
    monomial factors;
    std::size_t degree;
    residue coefficient;
  };

  const prime_field& field_;
  std::size_t degree_ = 0;
  std::vector<piece> terms_{};
};

/// The greatest common divisor of two polynomials modulo a prime, with a given leading coefficient in the
/// main variable, interpolated from its values; its terms are found one variable after another (Zippel,
/// Probabilistic algorithms for sparse polynomials, 1979). The result must be verified.
class sparse_interpolation {
public:
  struct problem {
    const polynomial<rational>&a, &b, &leading; ///< integer coefficients, no negative exponents
    int main;
    std::size_t degree;                              ///< of the divisor in the main variable
    std::vector<std::pair<int, std::size_t>> bounds; ///< the other variables and their maximum degrees
  };

  sparse_interpolation(const prime_field& f, const problem& given, std::mt19937_64& random, budget& left)
      : field_(f), given_(given), a_(f, given.a, given.main), b_(f, given.b, given.main),
        leading_(f, given.leading, given.main), random_(random), left_(left) {}

  /// The degree of an image in the main variable; lower than the given degree if that was too high.
  std::size_t image_degree() const { return image_degree_; }

  /// The coefficients, keyed by monomial; nothing if a random point was unsuitable.
  std::optional<std::vector<std::pair<monomial, residue>>> run() {
    for (const auto& [base, bound] : given_.bounds) point_[base] = random_nonzero();
    const residues first = image(point_);
    if (first.empty()) return std::nullopt;
    for (residue c : first) {
      supports_.emplace_back(c != 0 ? 1 : 0);
      values_.emplace_back(c != 0 ? 1 : 0, c);
    }
    for (std::size_t i = 0; i < given_.bounds.size(); ++i)
      if (!extend(i)) return std::nullopt;
    std::vector<std::pair<monomial, residue>> found;
    for (std::size_t k = 0; k < supports_.size(); ++k)
      for (std::size_t s = 0; s < supports_[k].size(); ++s)
        found.emplace_back(times(supports_[k][s], power_of(given_.main, k)), values_[k][s]);
    return found;
  }

private:
  using residues_by_degree = std::vector<residues>;

  static monomial power_of(int base, std::size_t exponent) {
    return exponent == 0 ? monomial{} : monomial{{base, static_cast<std::int64_t>(exponent)}};
  }
  residue random_nonzero() { return std::uniform_int_distribution<residue>(1, field_.prime() - 1)(random_); }

  /// Empty if the point is unsuitable.
  residues image(const std::map<int, residue>& point) {
    if (!left_.spend(a_.size() + b_.size())) return {};
    const residues a = a_.at(point), b = b_.at(point), leading = leading_.at(point);
    if (a.size() <= a_.degree() || b.size() <= b_.degree() || leading.empty()) return {};
    const residues divisor = field_.greatest_common_divisor(a, b);
    image_degree_ = (std::min)(image_degree_, divisor.size() - 1);
    if (divisor.size() - 1 != given_.degree) return {};
    return field_.scaled(divisor, leading.front());
  }

  /// Determines how the coefficients depend on one more variable.
  bool extend(std::size_t index) {
    const auto [base, bound] = given_.bounds[index];
    residues places{point_[base]};
    std::vector<residues_by_degree> all{values_};
    while (places.size() <= bound) {
      const residue place = random_nonzero();
      if (std::ranges::find(places, place) != places.end()) continue;
      std::map<int, residue> point = point_;
      point[base] = place;
      all.push_back(values_at(point, index));
      if (all.back().empty()) return false;
      places.push_back(place);
    }
    for (std::size_t k = 0; k < supports_.size(); ++k) {
      std::vector<monomial> support;
      residues values;
      for (std::size_t s = 0; s < supports_[k].size(); ++s) {
        residues seen;
        for (const residues_by_degree& each : all) seen.push_back(each[k][s]);
        const residues powers = field_.interpolated(places, seen);
        for (std::size_t e = 0; e < powers.size(); ++e) {
          if (powers[e] == 0) continue;
          support.push_back(times(supports_[k][s], power_of(base, e)));
          values.push_back(powers[e]);
        }
      }
      supports_[k] = support;
      values_[k] = values;
    }
    // `values_` are now coefficients of monomials in this variable, too, and no longer depend on its value
    return left_.allows(supports_.size());
  }

  /// The coefficients of the known terms at a point; the first `free` variables vary.
  residues_by_degree values_at(std::map<int, residue> point, std::size_t free) {
    std::size_t most = 1;
    for (const std::vector<monomial>& support : supports_) most = (std::max)(most, support.size());
    if (!left_.allows(most)) return {};
    std::map<int, residue> steps;
    for (std::size_t i = 0; i < free; ++i) steps[given_.bounds[i].first] = random_nonzero();
    for (const auto& [base, step] : steps) point[base] = 1;
    residues_by_degree images(supports_.size());
    for (std::size_t t = 0; t < most; ++t) {
      for (const auto& [base, step] : steps) point[base] = field_.multiply(point[base], step);
      const residues seen = image(point);
      if (seen.empty()) return {};
      for (std::size_t k = 0; k < seen.size(); ++k) images[k].push_back(seen[k]);
    }
    for (std::size_t k = 0; k < supports_.size(); ++k) {
      residues bases;
      for (const monomial& m : supports_[k]) bases.push_back(value_at(field_, m, steps));
      if (std::set<residue>(bases.begin(), bases.end()).size() != bases.size()) return {};
      images[k] = field_.solve_transposed_vandermonde(bases, images[k]);
    }
    return images;
  }

  const prime_field& field_;
  const problem& given_;
  modular_image a_, b_, leading_;
  std::mt19937_64& random_;
  budget& left_;
  std::size_t image_degree_ = (std::numeric_limits<std::size_t>::max)();
  std::map<int, residue> point_{};
  std::vector<std::vector<monomial>> supports_{}; ///< by the power of the main variable
  residues_by_degree values_{};
};

} // namespace kanexpr::symbolic::polynomials
