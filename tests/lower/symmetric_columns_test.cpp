// Symmetric systems with many columns: the same values as with all operations written out, by every way of
// evaluation, for columns with any pattern of zeros.
#include "lower/numbered_symbols.hpp"

#include <kanexpr/lower/constant.hpp>
#include <kanexpr/lower/tape_in_pieces.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace kanexpr;
using symbolic::expression;

constexpr int order = 7;

/// How the columns are solved: by one step, by all of its operations, or apart from each other.
enum class way { together, written_out, apart };

/// The solutions of M x = b for some right sides, and one more for a b that depends on them. A pseudorandom
/// number of the entries of b are zero; so are some of M, and the last unknown is coupled to no other one.
constexpr lower::tape solutions(int columns, unsigned seed, way by) {
  symbolic::graph g;
  check::numbered_symbols symbols(g);
  const auto chance = [&] { return (seed = seed * 1664525U + 1013904223U) >> 24; };
  symbolic::matrix m(g, order, order), right(g, order, columns), x(g, order, columns);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j <= i; ++j) {
      const expression entry = symbols.next();
      if (i == j || (i < order - 1 && chance() < 200)) m(i, j) = m(j, i) = entry;
    }
  base::sequence<int> all;
  for (int j = 0; j < columns; ++j) {
    all.push(j);
    const unsigned zeros = chance() % 200;
    for (int i = 0; i < order; ++i)
      if (chance() >= zeros) right(i, j) = symbols.next();
  }
  right(0, 1) = right(0, 0); // an entry of two columns
  for (int j = 3; j < columns; j += 4) right(order - 1, j) = 1 / m(order - 1, order - 1); // also a factor
  right(1, 1) = {g, symbolic::graph::one};
  const auto solve = [&](const symbolic::matrix& b, const base::sequence<int>& which,
                         symbolic::matrix& into) {
    const symbolic::symmetric_factorization factors(g, m);
    if (by != way::apart) {
      factors.solve_together(b, which, into);
      return;
    }
    for (int j : which) {
      base::sequence<expression> column;
      for (int i = 0; i < order; ++i) column.push(b(i, j));
      const base::sequence<expression> found = factors.solve(column).x;
      for (int i = 0; i < order; ++i) into(i, j) = found[i];
    }
  };
  solve(right, all, x);
  m(0, 0) = symbols.next(), m(order - 1, order - 1) = symbols.next();
  symbolic::matrix more(g, order, columns), y(g, order, columns);
  for (int i = 0; i < order; ++i) more(i, 0) = x(i, 2) * x(i, 3);
  for (int i = 0; i < order; ++i) more(i, 1) = x(i, 2) + right(i, 2);
  solve(more, {0, 1}, y);
  symbolic::matrix results(g, 2 * order, columns);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < columns; ++j) results(i, j) = x(i, j), results(order + i, j) = y(i, j);
  results(0, 0) = right(0, 0); // an entry that is a result itself
  if (by == way::written_out) results = symbolic::written_out(results);
  return lower::tape_of(g, symbolic::nodes_of(results.entries));
}

template <int columns, unsigned seed, way by>
struct code {
private:
  static constexpr lower::roomy_tape roomy = lower::fixed(solutions(columns, seed, by));

public:
  static constexpr auto tape = lower::trimmed<roomy.sizes>(roomy);
};

constexpr unsigned seed_in_pieces = 2;

} // namespace

template <int columns, way by>
inline constexpr kanexpr::lower::lengths kanexpr::lower::lengths_of<code<columns, seed_in_pieces, by>>{
    by == way::together ? 0 : 30000, 40};

namespace {

template <class Number>
struct arguments {
  const std::vector<double>& x;
  template <symbolic::symbol_kind, int position>
  Number operator()() const {
    return static_cast<Number>(x[position]);
  }
};

template <class Code, class Number, int... index>
std::vector<Number> compiled(const std::vector<double>& x, std::integer_sequence<int, index...>) {
  const lower::evaluated_tape<Code, Number> done(arguments<Number>{x});
  return {done.template result<index>()...};
}

bool equal_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <int columns, unsigned seed>
void check_columns() {
  using together = code<columns, seed, way::together>;
  using written = code<columns, seed, way::written_out>;
  using apart = code<columns, seed, way::apart>;
  constexpr int results = together::tape.sizes.results;
  static_assert(lower::solves_columns<together> && !lower::solves_columns<written>);
  static_assert(together::tape.sizes.steps < written::tape.sizes.steps);
  // written out, equal operations of several columns are shared
  EXPECT_GE(together::tape.cost.multiplications, written::tape.cost.multiplications);
  if (seed == seed_in_pieces) {
    EXPECT_GT(lower::cuts_of<together>::value.pieces, 5);
  }
  runtime::interpreter<double, lower::tape_view> interpreted{lower::tape_view(together::tape)};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int turn = 0; turn < 20; ++turn) {
    std::vector<double> x(1000), found(static_cast<std::size_t>(results));
    for (double& each : x) each = any(random);
    for (std::size_t i = order * (order + 1) / 2; i < x.size(); i += 9) x[i] = turn % 2 == 0 ? 0.0 : -0.0;
    constexpr auto all = std::make_integer_sequence<int, results>{};
    const std::vector<double> wanted = compiled<written, double>(x, all),
                              given = compiled<together, double>(x, all),
                              close = compiled<apart, double>(x, all);
    const std::vector<long double> exact = compiled<together, long double>(x, all);
    const std::vector<float> rough = compiled<together, float>(x, all);
    const auto slots = lower::constant_slots<together::tape>(
        [&](const lower::load& l) { return x[static_cast<std::size_t>(l.position)]; });
    interpreted.evaluate([&](const lower::load& l) { return x[static_cast<std::size_t>(l.position)]; },
                         found.data());
    double largest = 0;
    for (double each : wanted) largest = std::fmax(largest, std::fabs(each));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(given[i], wanted[i]) << i; // zeros may differ in their signs, which the graph moves outward
      EXPECT_TRUE(equal_bits(given[i], found[i])) << i;
      EXPECT_TRUE(equal_bits(given[i], slots[static_cast<std::size_t>(together::tape.results[i])])) << i;
      EXPECT_NEAR(given[i], close[i], 1e-9 * largest) << i;
      EXPECT_NEAR(given[i], static_cast<double>(exact[i]), 1e-9 * largest) << i;
      EXPECT_NEAR(given[i], static_cast<double>(rough[i]), 0.1 * largest) << i;
    }
  }
}

TEST(SymmetricColumns, have_the_values_of_written_out_operations) {
  check_columns<12, 1U>();
  check_columns<17, seed_in_pieces>();
}

/// A column of constants, and a system without arguments in its matrix.
TEST(SymmetricColumns, may_be_constant) {
  symbolic::graph g;
  symbolic::matrix m(g, 2, 2), right(g, 2, 3), x(g, 2, 3);
  m(0, 0) = m(1, 1) = {g, g.constant(symbolic::exactly(2))};
  m(0, 1) = m(1, 0) = {g, symbolic::graph::one};
  for (int j = 0; j < 2; ++j) right(j, j) = {g, g.constant(symbolic::exactly(3))};
  right(0, 2) = variable(g, {symbolic::symbol_kind::parameter, base::name("s"), 0});
  symbolic::symmetric_factorization(g, m).solve_together(right, {0, 1, 2}, x);
  const lower::tape code = lower::tape_of(g, symbolic::nodes_of(x.entries));
  runtime::interpreter<double> interpreted(code);
  double found[6];
  interpreted.evaluate([](const lower::load&) { return 0.75; }, found);
  const double wanted[]{2, -1, 0.5, -1, 2, -0.25};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-15) << i;
}

} // namespace
