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
  explicit budget(std::size_t most_terms) : most_terms_(most_terms) {}

  bool failed() const { return !cause_.empty(); }
  const std::string& cause() const { return cause_; }

  /// Whether a sum may have the given number of terms.
  bool allows(std::size_t terms) {
    return is_within(terms, most_terms_, "the sums have more than ", " terms");
  }
  /// Whether all sums held simultaneously may together have the given number of terms.
  bool allows_total(std::size_t terms) {
    return is_within(terms, 10 * most_terms_, "the sums together have more than ", " terms");
  }
  /// Whether the budget allows the given number of further products of terms.
  bool spend(std::size_t products) {
    products_ += products;
    return is_within(products_, 200 * most_terms_, "it requires more than ", " products of terms");
  }
  void fail(const std::string& cause) {
    if (cause_.empty()) cause_ = cause;
  }

private:
  bool is_within(std::size_t count, std::size_t most, const char* before, const char* unit) {
    if (count > most) fail(before + std::to_string(most) + unit);
    return !failed();
  }

  std::size_t most_terms_;
  std::size_t products_ = 0;
  std::string cause_{};
};

} // namespace polynomials

} // namespace kanexpr::symbolic
