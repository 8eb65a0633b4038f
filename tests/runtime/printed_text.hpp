#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Evaluates the texts of `print`, without the library's expressions.
class printed_text {
public:
  using value = Eigen::MatrixXd; ///< 1 × 1 if it is a number

  printed_text(std::string text, const std::map<std::string, value>& values)
      : text_(std::move(text)), values_(values) {}

  value whole() {
    const value found = sum();
    EXPECT_EQ(at_, text_.size()) << text_.substr(at_, 40);
    return found;
  }

private:
  static value number(double x) { return value::Constant(1, 1, x); }

  bool takes(const std::string& wanted) {
    if (text_.compare(at_, wanted.size(), wanted) != 0) return false;
    at_ += wanted.size();
    return true;
  }
  void expect(const std::string& wanted) { EXPECT_TRUE(takes(wanted)) << wanted << " at " << at_; }

  value sum() {
    value all = takes("-") ? value(-product()) : product();
    for (;;)
      if (takes(" + "))
        all += product();
      else if (takes(" - "))
        all -= product();
      else
        return all;
  }
  value product() {
    double all = 1;
    value first = power();
    if (first.size() != 1) return first;
    for (all = first(0);;)
      if (takes("*"))
        all *= power()(0);
      else if (takes("/"))
        all /= power()(0);
      else
        return number(all);
  }
  value power() {
    const value base = element();
    return takes("^") ? number(std::pow(base(0), element()(0))) : base;
  }
  value element() {
    const value of = primary();
    if (of.size() == 1 || !takes("[")) return of;
    const double place = primary()(0);
    expect("]");
    return number(of(static_cast<Eigen::Index>(place) - 1));
  }
  value primary() {
    if (takes("(")) {
      const value inner = sum();
      expect(")");
      return inner;
    }
    if (takes("[")) return list();
    double read = 0;
    const auto end = std::from_chars(text_.data() + at_, text_.data() + text_.size(), read);
    if (end.ec == std::errc()) {
      at_ = static_cast<std::size_t>(end.ptr - text_.data());
      return number(read);
    }
    const std::size_t after = text_.find_first_of("()[]*/^, ", at_);
    const std::string name = text_.substr(at_, after - at_);
    at_ += name.size();
    if (takes("(")) return function(name);
    const auto found = values_.find(name);
    EXPECT_NE(found, values_.end()) << "nothing is called " << name << " at " << at_;
    return found == values_.end() ? number(0) : found->second;
  }
  /// A row of numbers, or the rows of a matrix.
  value list() {
    std::vector<value> rows;
    do rows.push_back(sum());
    while (takes(", "));
    expect("]");
    const bool is_row = rows[0].size() == 1;
    const auto count = static_cast<Eigen::Index>(rows.size());
    value all(is_row ? 1 : count, is_row ? count : rows[0].size());
    for (Eigen::Index i = 0; i < count; ++i)
      if (is_row)
        all(0, i) = rows[static_cast<std::size_t>(i)](0);
      else
        all.row(i) = rows[static_cast<std::size_t>(i)];
    return all;
  }
  value function(const std::string& name) {
    std::vector<value> on;
    do on.push_back(sum());
    while (takes(", "));
    expect(")");
    if (name == "solve") return on[0].fullPivLu().solve(on[1].transpose().eval());
    if (name == "transpose") return on[0].transpose();
    if (name == "if_positive") return on[0](0) > 0 ? on[1] : on[2];
    if (name == "atan2") return number(std::atan2(on[0](0), on[1](0)));
    for (const kanexpr::symbolic::function_properties& f : kanexpr::symbolic::functions)
      if (name == f.name)
        return number(kanexpr::symbolic::with_function(f.op, [&]<kanexpr::symbolic::operation op>() {
          return kanexpr::lower::scalar_math<double>::by_name<op>(on[0](0));
        }));
    ADD_FAILURE() << name;
    return number(0);
  }

  std::string text_;
  const std::map<std::string, value>& values_;
  std::size_t at_ = 0;
};

/// The value of an expression that is followed by the definitions of its parts, each of which may refer only
/// to those before it.
inline printed_text::value value_of_text(const std::string& text,
                                         std::map<std::string, printed_text::value> values) {
  std::istringstream lines(text);
  std::string wanted, line;
  std::getline(lines, wanted);
  if (std::getline(lines, line)) {
    EXPECT_EQ(line, "where");
  }
  while (std::getline(lines, line)) {
    const std::size_t equals = line.find(" = ");
    const std::string name = line.substr(2, equals - 2);
    EXPECT_EQ(values.count(name), 0U) << name << " is defined twice";
    values[name] = printed_text(line.substr(equals + 3), values).whole();
  }
  return printed_text(wanted, values).whole();
}
