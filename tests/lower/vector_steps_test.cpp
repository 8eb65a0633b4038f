// Columns that are evaluated side by side: the same bits as one column after another, by every way of
// evaluation, for columns with any pattern of zeros, at once and in pieces.
#include <kanexpr/lower/constant.hpp>
#include <kanexpr/lower/side_by_side.hpp>
#include <kanexpr/lower/unrolled_tape.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

namespace {

using namespace kanexpr;
using symbolic::expression;

constexpr int order = 7;

/// The solutions of M x = b for `columns` right sides. A pseudorandom number of their entries are zero.
constexpr lower::tape solutions(int columns, unsigned seed, bool side_by_side) {
  symbolic::graph g;
  int position = 0;
  const auto next = [&] {
    base::name called("s");
    called.append(position);
    return variable(g, {symbolic::symbol_kind::parameter, called, position++});
  };
  const auto chance = [&] { return (seed = seed * 1664525U + 1013904223U) >> 24; };
  symbolic::matrix m(g, order, order);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j <= i; ++j) m(i, j) = m(j, i) = next();
  const symbolic::symmetric_factorization factors(g, m);
  base::sequence<int> outputs, column;
  for (int j = 0; j < columns; ++j) {
    base::sequence<expression> b;
    const unsigned zeros = chance() % 160;
    for (int i = 0; i < order; ++i) b.push(chance() < zeros ? expression(g, symbolic::graph::zero) : next());
    for (const expression& x : factors.solve(b).x) outputs.push(x.node()), column.push(j);
  }
  lower::tape code = lower::tape_of(g, outputs);
  if (side_by_side) code.columns = column;
  return code;
}

constexpr unsigned seed_in_pieces = 2;

template <int columns, unsigned seed, bool side_by_side>
struct code {
private:
  static constexpr lower::roomy_tape roomy = lower::fixed(solutions(columns, seed, side_by_side));

public:
  static constexpr auto tape = lower::trimmed<roomy.sizes>(roomy);
};

} // namespace

template <int columns>
inline constexpr int kanexpr::lower::actions_per_piece<code<columns, seed_in_pieces, true>> = 100;

namespace {

struct arguments {
  const std::vector<double>& x;
  template <symbolic::symbol_kind, int position>
  double operator()() const {
    return x[position];
  }
};

template <class Code, int... index>
std::vector<double> compiled(const std::vector<double>& x, std::integer_sequence<int, index...>) {
  const lower::unrolled_tape<Code, double> done(arguments{x});
  return {done.template result<index>()...};
}

template <int columns, unsigned seed>
void check() {
  using together = code<columns, seed, true>;
  using alone = code<columns, seed, false>;
  constexpr int results = together::tape.sizes.results;
  static_assert(lower::uses_vectors<together, double>() == lower::has_vectors<double>);
  if constexpr (lower::has_vectors<double>) {
    static_assert(lower::steps_on_vectors<together, double>::in_pieces == (seed == seed_in_pieces));
  }
  runtime::interpreter<double, lower::tape_view> interpreted{lower::tape_view(together::tape)};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int turn = 0; turn < 20; ++turn) {
    std::vector<double> x(1000), found(static_cast<std::size_t>(results));
    for (double& each : x) each = any(random);
    for (std::size_t i = order * (order + 1) / 2; i < x.size(); i += 9) x[i] = turn % 2 == 0 ? 0.0 : -0.0;
    constexpr auto all = std::make_integer_sequence<int, results>{};
    const std::vector<double> wanted = compiled<alone>(x, all), given = compiled<together>(x, all);
    const auto slots = lower::constant_slots<together::tape>(
        [&](const lower::load& l) { return x[static_cast<std::size_t>(l.position)]; });
    interpreted.evaluate([&](const lower::load& l) { return x[static_cast<std::size_t>(l.position)]; },
                         found.data());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(given[i]), std::bit_cast<std::uint64_t>(wanted[i])) << i;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(found[i]), std::bit_cast<std::uint64_t>(wanted[i])) << i;
      EXPECT_EQ(slots[static_cast<std::size_t>(together::tape.results[i])], wanted[i]) << i;
    }
  }
}

TEST(VectorSteps, have_the_bits_of_one_column_after_another) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this test is compiled with -mavx2";
#endif
  check<12, 1U>();
  check<17, seed_in_pieces>();
}

} // namespace
