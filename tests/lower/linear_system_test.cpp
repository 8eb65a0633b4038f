// builds: all
// Solutions of linear systems as straight-line code: the same bits by every way of evaluation, for any
// scalar. builds: sanitize no-exceptions Without -mavx a pack is returned in memory; that the flag would
// change this is no concern of one program.
#pragma GCC diagnostic ignored "-Wpsabi"

#include "entry_squares.hpp"
#include "lower/numbered_symbols.hpp"
#include "no_heap.hpp"

#include <kanexpr/lower/constant.hpp>
#include <kanexpr/lower/pack.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/lower/tape_in_pieces.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <Eigen/LU>
#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr;
using symbolic::expression;

/// x in A x = b, y in Aᵀ y = b, z in A z = y, and the singularity measure of A; the arguments are A, row by
/// row, and b.
constexpr lower::tape three_solutions(int n) {
  symbolic::graph g;
  check::numbered_symbols symbols(g);
  symbolic::matrix a(g, n, n);
  for (expression& e : a.entries) e = symbols.next();
  base::sequence<expression> b;
  for (int i = 0; i < n; ++i) b.push(symbols.next());
  const expression factors = factorization(g, a);
  const base::sequence<expression> y = solve_transposed(factors, b);
  base::sequence<int> outputs = nodes_of(solve(factors, b));
  for (int id : nodes_of(y)) outputs.push(id);
  for (int id : nodes_of(solve(factors, y))) outputs.push(id);
  outputs.push(singularity_measure(factors, entry_squares(a)).node());
  return lower::tape_of(g, outputs);
}

template <int n>
struct code {
private:
  static constexpr lower::roomy_tape roomy = lower::fixed(three_solutions(n));

public:
  static constexpr auto tape = lower::trimmed<roomy.sizes>(roomy);
};

/// The same tape, in pieces.
template <int n>
struct cut_code {
  static constexpr const auto& tape = code<n>::tape;
};

} // namespace

template <int n>
inline constexpr kanexpr::lower::lengths kanexpr::lower::lengths_of<cut_code<n>>{0, 8};

namespace {

template <class T>
struct arguments {
  const T* values;
  template <symbolic::symbol_kind, int position>
  T operator()() const {
    return values[position];
  }
};

template <int n>
inline constexpr int results = 3 * n + 1;

template <class T, int n, class Code, int... i>
[[gnu::noinline]] std::array<T, results<n>> evaluated(const std::array<T, n * n + n>& at,
                                                      std::integer_sequence<int, i...>) {
  no_heap::guard guard;
  const lower::evaluated_tape<Code, T> done(arguments<T>{at.data()});
  return {done.template result<i>()...};
}
template <class T, int n, class Code = code<n>>
std::array<T, results<n>> evaluated(const std::array<T, n * n + n>& at) {
  return evaluated<T, n, Code>(at, std::make_integer_sequence<int, results<n>>{});
}

/// A regular matrix with zeros on the diagonal, and a right-hand side.
template <int n>
constexpr std::array<double, n * n + n> sample(unsigned seed) {
  std::array<double, n * n + n> at{};
  for (std::size_t i = 0; i < at.size(); ++i) {
    seed = seed * 1664525u + 1013904223u;
    at[i] = static_cast<double>(seed >> 8) / 8388608.0 - 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    at[i * n + i] = 0;
    at[i * n + (i + 1) % n] += 2;
  }
  return at;
}

template <int n>
constexpr std::array<double, n * n + n> constant_arguments = sample<n>(n);
template <int n>
constexpr auto constant_slots = lower::constant_slots<code<n>::tape>(
    [](const lower::load& l) { return constant_arguments<n>[static_cast<std::size_t>(l.position)]; });

template <class Size>
class linear_system : public testing::Test {
public:
  static constexpr int size = Size::value;
};
template <int n>
using order = std::integral_constant<int, n>;
using orders = testing::Types<order<2>, order<3>, order<4>, order<5>, order<6>, order<7>>;
TYPED_TEST_SUITE(linear_system, orders);

TYPED_TEST(linear_system, is_solved) {
  constexpr int n = TestFixture::size;
  using square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>; // one for all orders
  using vector = Eigen::VectorXd;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto at = sample<n>(seed);
    const square a = Eigen::Map<const square>(at.data(), n, n);
    const vector b = Eigen::Map<const vector>(at.data() + n * n, n);
    const Eigen::FullPivLU<square> lu(a), transposed(a.transpose());
    const auto found = evaluated<double, n>(at);
    const vector x = lu.solve(b), y = transposed.solve(b), z = lu.solve(y);
    const double tolerance = 1e-14 / lu.rcond();
    EXPECT_TRUE(Eigen::Map<const vector>(found.data(), n).isApprox(x, tolerance));
    EXPECT_TRUE(Eigen::Map<const vector>(found.data() + n, n).isApprox(y, tolerance));
    EXPECT_TRUE(Eigen::Map<const vector>(found.data() + 2 * n, n).isApprox(z, tolerance));
    const double singularity_measure = found.back();
    if (n <= 3) {
      EXPECT_NEAR(singularity_measure, std::abs(lu.determinant()), 1e-14);
    } else { // S = P A² + (L - I)² S, entry by entry squared
      const Eigen::PartialPivLU<square> partial(a);
      const square lower = partial.matrixLU().triangularView<Eigen::StrictlyLower>(),
                   kept = square::Identity(n, n) - lower.cwiseAbs2(),
                   sizes = kept.inverse() * (partial.permutationP() * square(a.cwiseAbs2()));
      const vector beside =
          partial.matrixLU().diagonal().cwiseAbs().cwiseQuotient(sizes.diagonal().cwiseSqrt());
      EXPECT_NEAR(singularity_measure, beside.minCoeff(), 1e-13);
    }
  }
}

TYPED_TEST(linear_system, has_the_same_bits_compiled_interpreted_and_constant) {
  constexpr int n = TestFixture::size;
  runtime::interpreter<double> interpreted(three_solutions(n));
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto at = seed == 0 ? constant_arguments<n> : sample<n>(seed);
    const auto compiled = evaluated<double, n>(at);
    std::array<double, results<n>> found;
    interpreted.evaluate([&](const lower::load& l) { return at[static_cast<std::size_t>(l.position)]; },
                         found.data());
    EXPECT_EQ(found, compiled);
    for (std::size_t i = 0; seed == 0 && i < found.size(); ++i)
      EXPECT_EQ(constant_slots<n>[static_cast<std::size_t>(code<n>::tape.results[i])], compiled[i]);
  }
}

TYPED_TEST(linear_system, costs_what_elimination_costs) {
  constexpr int n = TestFixture::size;
  constexpr symbolic::cost cost = code<n>::tape.cost;
  EXPECT_EQ(cost, lower::cost_of(three_solutions(n)));
  if (n <= 3) {
    EXPECT_EQ(cost.divisions, 1); // the reciprocal of the determinant
  } else {
    const int updates = (n - 1) * n * (2 * n - 1) / 6, comparisons = n * (n - 1) / 2;
    const int of_squares = updates + comparisons + 2 * n; // of the multipliers, followed by the pivots
    EXPECT_EQ(cost.multiplications, updates + comparisons + 3 * n * n + n * n + of_squares);
    EXPECT_EQ(cost.additions, updates + comparisons + 3 * n * (n - 1) + updates + n - 1);
    EXPECT_EQ(cost.divisions, n + 1);
  }
}

template <int n>
void check_of_packs_has_the_bits_of_each_lane() {
  typedef double pack __attribute__((vector_size(32)));
  std::array<pack, n * n + n> side_by_side;
  for (unsigned lane = 0; lane < 4; ++lane)
    for (std::size_t i = 0; i < side_by_side.size(); ++i) side_by_side[i][lane] = sample<n>(lane)[i];
  const auto found = evaluated<pack, n>(side_by_side);
  for (unsigned lane = 0; lane < 4; ++lane) {
    const auto own = evaluated<double, n>(sample<n>(lane));
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i][lane], own[i]);
  }
}
TEST(a_linear_system, of_packs_has_the_bits_of_each_lane) {
  check_of_packs_has_the_bits_of_each_lane<3>();
  check_of_packs_has_the_bits_of_each_lane<5>();
}

TEST(a_linear_system, in_pieces_has_the_same_bits) {
  constexpr int n = 4;
  using number = Eigen::AutoDiffScalar<Eigen::Vector2d>;
  static_assert(!lower::is_cut<code<n>, double> && lower::is_cut<cut_code<n>, double>);
  static_assert(lower::cuts_of<cut_code<n>>::value.pieces > 3); // a factorization and three solutions
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto at = sample<n>(seed);
    const auto whole = evaluated<double, n>(at), in_pieces = evaluated<double, n, cut_code<n>>(at);
    EXPECT_EQ(in_pieces, whole);
    std::array<number, n * n + n> seeded;
    for (std::size_t i = 0; i < at.size(); ++i)
      seeded[i] = number(at[i], Eigen::Vector2d(1 + 0.1 * static_cast<double>(i), -0.3));
    const auto slopes = evaluated<number, n>(seeded),
               slopes_in_pieces = evaluated<number, n, cut_code<n>>(seeded);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(slopes_in_pieces[i].value(), slopes[i].value());
      EXPECT_EQ(slopes_in_pieces[i].derivatives(), slopes[i].derivatives());
    }
  }
}

template <int n>
void check_has_derivatives_by_automatic_differentiation() {
  using number = Eigen::AutoDiffScalar<Eigen::Vector2d>;
  const auto at = sample<n>(3);
  std::array<number, n * n + n> seeded;
  std::array<long double, n * n + n> above, below;
  const long double step = 1e-6L;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Eigen::Vector2d direction(1 + 0.1 * static_cast<double>(i), -0.3);
    seeded[i] = number(at[i], direction);
    above[i] = at[i] + step * direction(0);
    below[i] = at[i] - step * direction(0);
  }
  const auto found = evaluated<number, n>(seeded);
  const auto values = evaluated<double, n>(at);
  const auto more = evaluated<long double, n>(above), less = evaluated<long double, n>(below);
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    EXPECT_EQ(found[i].value(), values[i]);
    const double slope = static_cast<double>((more[i] - less[i]) / (2 * step));
    EXPECT_NEAR(found[i].derivatives()(0), slope, 1e-8 * (1 + std::abs(slope)));
  }
}
TEST(a_linear_system, has_derivatives_by_automatic_differentiation) {
  check_has_derivatives_by_automatic_differentiation<2>();
  check_has_derivatives_by_automatic_differentiation<4>();
}

template <int n>
void check_of_other_scalars() {
  const auto at = sample<n>(5);
  std::array<float, n * n + n> rough;
  std::array<long double, n * n + n> fine;
  for (std::size_t i = 0; i < at.size(); ++i) rough[i] = static_cast<float>(at[i]), fine[i] = at[i];
  const auto expected = evaluated<long double, n>(fine);
  const auto by_float = evaluated<float, n>(rough);
  const auto by_double = evaluated<double, n>(at);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double scale = 1 + std::abs(static_cast<double>(expected[i]));
    EXPECT_NEAR(static_cast<double>(by_float[i]), static_cast<double>(expected[i]), 1e-4 * scale);
    EXPECT_NEAR(by_double[i], static_cast<double>(expected[i]), 1e-12 * scale);
  }
}
TEST(a_linear_system, of_other_scalars) {
  check_of_other_scalars<3>();
  check_of_other_scalars<6>();
}

TYPED_TEST(linear_system, is_zero_regular_where_it_is_singular) {
  constexpr int n = TestFixture::size;
  // integers, so that elimination is exact: the last row is the sum of the others, or zero
  for (const bool empty : {false, true}) {
    std::array<double, n * n + n> at{};
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        at[i * n + j] = i == j ? 4 : j == i + 1 ? -2 : 0;
        if (!empty) at[(n - 1) * n + j] += at[i * n + j];
      }
    EXPECT_EQ((evaluated<double, n>(at).back()), 0);
    std::array<float, n * n + n> rough{};
    for (std::size_t i = 0; i < at.size(); ++i) rough[i] = static_cast<float>(at[i]);
    EXPECT_EQ((evaluated<float, n>(rough).back()), 0);
    runtime::interpreter<double> interpreted(three_solutions(n));
    std::array<double, results<n>> found;
    interpreted.evaluate([&](const lower::load& l) { return at[static_cast<std::size_t>(l.position)]; },
                         found.data());
    EXPECT_EQ(found.back(), 0);
  }
  EXPECT_EQ((evaluated<double, n>({}).back()), 0);
}

} // namespace
