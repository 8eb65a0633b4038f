// builds: clang++
// Results as text, as code or as expressions with named parts: separate parsers read it and obtain the values
// of the interpreter.
#include <kanexpr/runtime/listing.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>

#include "models/bicycle.hpp"
#include "models/double_pendulum.hpp"
#include "models/four_bar.hpp"
#include "models/simple_pendulum.hpp"
#include "runtime/printed_text.hpp"
#include "symbolic/linear/linear_systems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using mechanics::quantity;

/// Evaluates a listing line by line.
class reading {
public:
  explicit reading(std::map<std::string, double> values) : values_(std::move(values)) {}

  void run(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t equals = line.find(" = ");
      values_[line.substr(0, equals)] = expression(line.substr(equals + 3));
    }
  }
  double at(const std::string& name) const {
    const auto found = values_.find(name);
    EXPECT_NE(found, values_.end()) << name;
    return found == values_.end() ? 0 : found->second;
  }

private:
  double expression(const std::string& text) const {
    if (const std::size_t query = text.find(" > 0 ? "); query != std::string::npos) {
      const std::size_t colon = text.find(" : ");
      return operand(text.substr(0, query)) > 0 ? operand(text.substr(query + 7, colon - query - 7))
                                                : operand(text.substr(colon + 3));
    }
    for (const char op : {'+', '-', '*', '/'})
      if (const std::size_t place = text.find(std::string{' ', op, ' '}); place != std::string::npos) {
        const double a = operand(text.substr(0, place)), b = operand(text.substr(place + 3));
        return op == '+' ? a + b : op == '-' ? a - b : op == '*' ? a * b : a / b;
      }
    const std::size_t open = text.find('(');
    if (open == std::string::npos || open == 0) return operand(text);
    if (text[0] == '-') return -operand(text.substr(1));
    const std::string inside = text.substr(open + 1, text.size() - open - 2), called = text.substr(0, open);
    if (const std::size_t comma = inside.find(", "); comma != std::string::npos) {
      const double a = operand(inside.substr(0, comma)), b = operand(inside.substr(comma + 2));
      return called == "pow" ? std::pow(a, b) : std::atan2(a, b);
    }
    return function(called, operand(inside));
  }

  static double function(const std::string& called, double x) {
    for (const symbolic::function_properties& f : symbolic::functions)
      if (called == f.name)
        return symbolic::with_function(
            f.op, [&]<symbolic::operation op>() { return lower::scalar_math<double>::by_name<op>(x); });
    ADD_FAILURE() << called;
    return 0;
  }

  double operand(const std::string& text) const {
    if (text[0] == '(') return operand(text.substr(1, text.size() - 2));
    if (const std::size_t slash = text.find('/'); slash != std::string::npos)
      return operand(text.substr(0, slash)) / operand(text.substr(slash + 1));
    double number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec == std::errc() && read.ptr == text.data() + text.size()) return number;
    return text[0] == '-' ? -at(text.substr(1)) : at(text);
  }

  std::map<std::string, double> values_;
};

/// Compares the texts of all entries, written in full and with named parts.
void expect_printed_values(const symbolic::matrix& result, const std::map<std::string, double>& values,
                           const std::vector<double>& expected) {
  std::map<std::string, printed_text::value> at;
  for (const auto& [name, value] : values) at[name] = printed_text::value::Constant(1, 1, value);
  for (const std::size_t longest : {std::size_t{0}, std::size_t{2000}})
    for (int i = 0; i < result.entries.size(); ++i) {
      const std::string text = symbolic::print(result.entries[i], longest);
      if (text.find("singularity_measure") != std::string::npos) continue; // a function without a closed form
      const double wanted = expected[static_cast<std::size_t>(i)];
      EXPECT_NEAR(value_of_text(text, at)(0), wanted, 1e-12 * std::max(1.0, std::abs(wanted)))
          << i << " within " << longest;
    }
}

void expect_the_interpreted_values(const symbolic::matrix& result) {
  ASSERT_FALSE(result.entries.empty());
  const symbolic::graph& g = result.entries[0].owner();
  const std::string text = listing(result);
  runtime::interpreter<double> interpreted(lower::tape_of(g, symbolic::nodes_of(result.entries)));
  std::mt19937_64 source(3);
  std::uniform_real_distribution<double> any(0.3, 1.5);
  for (int round = 0; round < 5; ++round) {
    std::map<std::string, double> values;
    std::map<std::pair<symbolic::symbol_kind, int>, double> at;
    for (const symbolic::symbol& s : g.symbols()) {
      const bool is_rate =
          s.kind == symbolic::symbol_kind::coordinate_rate || s.kind == symbolic::symbol_kind::speed_rate;
      at[{s.kind, s.position}] = values[std::string(s.called.view()) + (is_rate ? "'" : "")] = any(source);
    }
    std::vector<double> expected(static_cast<std::size_t>(result.entries.size()));
    interpreted.evaluate([&](const lower::load& l) { return at[{l.from, l.position}]; }, expected.data());
    reading found(values);
    found.run(text);
    for (int i = 0; i < result.entries.size(); ++i) {
      std::string name = "result";
      if (result.columns > 1)
        name += "(" + std::to_string(i / result.columns) + ", " + std::to_string(i % result.columns) + ")";
      else if (result.rows > 1)
        name += "(" + std::to_string(i) + ")";
      EXPECT_EQ(found.at(name), expected[static_cast<std::size_t>(i)]) << name;
    }
    if (round == 0) expect_printed_values(result, values, expected);
  }
}

TEST(listing, has_one_operation_a_line) {
  auto derived = derive<simple_pendulum::System>();
  EXPECT_EQ(listing(derived, quantity::forcing), "t1 = u * c\n"
                                                 "t2 = T - t1\n"
                                                 "t3 = m * l\n"
                                                 "s1 = sin(q)\n"
                                                 "t4 = g * s1\n"
                                                 "t5 = t3 * t4\n"
                                                 "t6 = t2 - t5\n"
                                                 "forcing = t6\n");
}

TEST(listing, read_back_gives_the_interpreted_values) {
  for (const quantity q :
       {quantity::mass_matrix, quantity::udot, quantity::kinetic_energy, quantity::inertia_forces})
    expect_the_interpreted_values(derive<double_pendulum::System>().get(q));
  for (const quantity q : {quantity::udot, quantity::dependency, quantity::configuration_step})
    expect_the_interpreted_values(derive<four_bar::System>().get(q));
  expect_the_interpreted_values(derive<bicycle::System>().udot());
}

// Rows are exchanged, and both triangles are used in both directions.
TEST(listing, writes_linear_systems_out) {
  for (int order = 1; order < 8; ++order) {
    moving_system s(order, 5);
    const symbolic::expression factors = factorization(s.g, s.a);
    const base::sequence<symbolic::expression> x = solve(factors, s.b), y = solve_transposed(factors, x);
    base::sequence<symbolic::expression> squares;
    for (const symbolic::expression& e : s.a.entries) squares.push(e * e + 1);
    symbolic::matrix all(s.g, 2 * order + 1, 1);
    for (int i = 0; i < order; ++i) all.entries[i] = x[i], all.entries[order + i] = y[i];
    all.entries[2 * order] = singularity_measure(factors, squares);
    expect_the_interpreted_values(all);
    EXPECT_EQ(listing(all).find(" > 0 ? ") != std::string::npos, order > 3);
  }
}

TEST(listing, has_all_functions) {
  symbolic::graph g;
  const symbolic::expression x = variable(g, {symbolic::symbol_kind::parameter, "x", 0}),
                             y = variable(g, {symbolic::symbol_kind::parameter, "t1", 1});
  symbolic::matrix all(g, 0, 1);
  for (const symbolic::function_properties& f : symbolic::functions)
    all.entries.push(symbolic::apply(f.op, x / 2 - 3 * y / 7));
  for (const symbolic::expression& e :
       {atan2(x, -y), power(x, y), power(x, symbolic::expression(g, g.constant(symbolic::real(-0.3)))), x,
        -x * y, if_positive(x - y, sqrt(x), y), if_positive(y - x, sqrt(x), y), (symbolic::min)(x, y),
        hypot(x, y)})
    all.entries.push(e);
  all.rows = all.entries.size();
  const std::string text = listing(all, "f");
  EXPECT_NE(text.find("atan2(x, t_"), std::string::npos) << text; // the model contains the name t1
  expect_the_interpreted_values(all);
}

TEST(listing, of_nothing_is_empty) { EXPECT_EQ(listing(symbolic::matrix{}), ""); }

} // namespace
