#pragma once

#include <cstddef>
#include <string>

namespace kanexpr::symbolic {

/// The default limit on the number of terms of an intermediate sum.
inline constexpr std::size_t default_max_terms = 20'000;

namespace polynomials {

/// Limits the size of a rewriting. After a failure, all further results are short and meaningless.
class budget {
public:
  explicit budget(std::size_t most_terms) : most_terms_(most_terms), products_left_(200 * most_terms) {}

  bool failed() const { return !cause_.empty(); }
  const std::string& cause() const { return cause_; }

  /// Whether a sum may have the given number of terms.
  bool allows(std::size_t terms) {
    if (terms > most_terms_) fail("the sums have more than " + std::to_string(most_terms_) + " terms");
    return !failed();
  }
  /// Whether all sums held simultaneously may have the given number of terms.
  bool allows_total(std::size_t terms) {
    if (terms > 10 * most_terms_)
      fail("the sums together have more than " + std::to_string(10 * most_terms_) + " terms");
    return !failed();
  }
  /// Whether the budget allows the given number of products of terms.
  bool spend(std::size_t products) {
    if (products > products_left_)
      fail("it requires more than " + std::to_string(200 * most_terms_) + " products of terms");
    else
      products_left_ -= products;
    return !failed();
  }
  void fail(const std::string& cause) {
    if (cause_.empty()) cause_ = cause;
  }

private:
  std::size_t most_terms_;
  std::size_t products_left_;
  std::string cause_{};
};

} // namespace polynomials

} // namespace kanexpr::symbolic
