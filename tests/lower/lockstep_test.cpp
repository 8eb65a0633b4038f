// Equal branches in lockstep: the values of the steps one by one, to the last bit, for mirrored branches and
// for trees of any shape.
#include <kanexpr/lower/tape_in_pieces.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace kanexpr;
using symbolic::expression;
using symbolic::symbol_kind;

constexpr int base = 3, in_branch = 2, columns = 4;

/// A tree on a base of three unknowns, with branches of two unknowns each; the last branches have one unknown
/// less if they are `stunted`. The entries are those of no mechanism, but have its structure: each branch
/// depends on its own coordinates and speeds, half of the branches are mirrored, and the right-hand sides of
/// some columns depend on the unknowns of another system, as derivatives of u̇ depend on u̇. If it is `beside`
/// another system, that one has fewer unknowns.
class tree {
public:
  constexpr tree(int branches, int stunted, bool beside)
      : branches_(branches), stunted_(stunted), is_beside_(beside),
        order_(base + in_branch * branches - stunted), m_(g_, order_, order_), right_(g_, order_, columns),
        x_(g_, order_, columns) {}

  constexpr lower::tape run() {
    base_speed_ = argument(symbol_kind::speed, 0);
    for (int i = 0; i < base; ++i) {
      m_(i, i) = number(5 + i);
      for (int j = 0; j < i; ++j) m_(i, j) = m_(j, i) = number(1) / number(3 + i + j);
      for (int c = 0; c < columns; ++c) right_(i, c) = number(1 + c) * base_speed_;
    }
    for (int k = 0; k < branches_; ++k) add_branch(k);
    base::sequence<int> all;
    for (int c = 0; c < columns; ++c) all.push(c);
    symbolic::symmetric_factorization(g_, m_).solve_together(right_, all, x_);
    base::sequence<expression> results;
    for (const expression& e : x_.entries) results.push(e);
    for (const expression& e : kept_) results.push(e);
    if (is_beside_) solve_another(all, results);
    base::sequence<int> nodes;
    for (const expression& e : results) nodes.push(e.node());
    return lower::tape_of(g_, nodes);
  }

private:
  constexpr expression number(int value) { return {g_, g_.constant(symbolic::exactly(value))}; }
  constexpr expression argument(symbol_kind kind, int position) {
    base::name called(kind == symbol_kind::coordinate ? "q" : kind == symbol_kind::speed ? "u" : "r");
    called.append(position);
    return variable(g_, {kind, called, position});
  }

  constexpr void solve_another(const base::sequence<int>& all, base::sequence<expression>& results) {
    symbolic::matrix m(g_, 2, 2), right(g_, 2, columns), x(g_, 2, columns);
    m(0, 0) = kept_[0] * kept_[0] + number(4), m(1, 1) = number(3), m(0, 1) = m(1, 0) = number(1);
    for (int i = 0; i < 2; ++i)
      for (int c = 0; c < columns; ++c) right(i, c) = kept_[i] * number(c + 1);
    symbolic::symmetric_factorization(g_, m).solve_together(right, all, x);
    for (const expression& e : x.entries) results.push(e);
  }

  constexpr void add_branch(int k) {
    const int first = base + in_branch * k, unknowns = k >= branches_ - stunted_ ? 1 : in_branch;
    const int side = k % 2 == 0 ? 1 : -1;
    const expression q = argument(symbol_kind::coordinate, 2 * k),
                     turned = argument(symbol_kind::coordinate, 2 * k + 1),
                     u = argument(symbol_kind::speed, 1 + 2 * k), v = argument(symbol_kind::speed, 2 + 2 * k),
                     r = argument(symbol_kind::input, k);
    const expression s = sin(q), c = cos(q), s2 = sin(turned);
    const expression arm = number(side * (2 + k)) * s + c, reach = number(3) * c - number(side) * s * s2;
    const expression both = number(side) * q + turned, swing = sin(both) * cos(both) * both;
    const expression spin = base_speed_ + number(side) * u, slip = v * arm - base_speed_ * reach;
    for (int i = 0; i < base; ++i) {
      const expression lever = i == 0 ? arm : i == 1 ? reach : arm * reach;
      m_(i, i) = m_(i, i) + lever * lever;
      for (int j = 0; j < unknowns; ++j) m_(i, first + j) = m_(first + j, i) = j == 0 ? lever : lever * s2;
      for (int column = 0; column < columns; ++column) right_(i, column) += lever * spin * number(column + 1);
    }
    for (int i = 0; i < unknowns; ++i) {
      m_(first + i, first + i) = number(40 + i) + reach * reach;
      if (i > 0) m_(first, first + i) = m_(first + i, first) = arm * s2;
      for (int column = 0; column < columns; ++column)
        right_(first + i, column) =
            (i == 0 ? slip : spin * slip) * number(2 + column) + (column == 3 ? r * c : spin);
    }
    kept_.push(-slip);
    kept_.push(spin * arm);
    kept_.push(swing * slip);
  }

  symbolic::graph g_{};
  int branches_, stunted_;
  bool is_beside_;
  int order_;
  symbolic::matrix m_, right_, x_;
  expression base_speed_{};
  base::sequence<expression> kept_{};
};

constexpr lower::tape tape_of_tree(int branches, int stunted, bool beside) {
  tree t(branches, stunted, beside);
  return t.run();
}

template <int branches, int stunted, bool beside = false>
struct code {
private:
  static constexpr lower::roomy_tape roomy = lower::fixed(tape_of_tree(branches, stunted, beside));

public:
  static constexpr auto tape = lower::trimmed<roomy.sizes>(roomy);
};

} // namespace

template <int branches, int stunted, bool beside>
inline constexpr kanexpr::lower::lengths kanexpr::lower::lengths_of<code<branches, stunted, beside>>{30000,
                                                                                                     1500, 0};

namespace {

template <class Number>
struct arguments {
  const std::vector<double>& x;
  template <symbol_kind kind, int position>
  Number operator()() const {
    return static_cast<Number>(x[static_cast<std::size_t>(100 * static_cast<int>(kind) + position)]);
  }
};

template <class Code, class Number, int... index>
std::vector<Number> compiled(const std::vector<double>& x, std::integer_sequence<int, index...>) {
  const lower::evaluated_tape<Code, Number> done(arguments<Number>{x});
  return {done.template result<index>()...};
}

template <class Code>
constexpr int lanes(int most) {
  return lower::equal_branches_of(lower::tape_view(Code::tape), most).count;
}

template <class Code>
void check_values() {
  constexpr int results = Code::tape.sizes.results;
  constexpr auto all = std::make_integer_sequence<int, results>{};
  runtime::interpreter<double, lower::tape_view> interpreted{lower::tape_view(Code::tape)};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int turn = 0; turn < 20; ++turn) {
    std::vector<double> x(1000), wanted(static_cast<std::size_t>(results));
    for (double& each : x) each = any(random);
    interpreted.evaluate(
        [&](const lower::load& l) {
          return x[static_cast<std::size_t>(100 * static_cast<int>(l.from) + l.position)];
        },
        wanted.data());
    const std::vector<double> found = compiled<Code, double>(x, all);
    const std::vector<long double> exact = compiled<Code, long double>(x, all);
    const std::vector<float> rough = compiled<Code, float>(x, all);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
#if defined(__FMA__) || defined(__aarch64__)
      EXPECT_NEAR(found[i], wanted[i], 1e-13 * std::fmax(1, std::fabs(wanted[i]))) << i;
#else
      EXPECT_EQ(found[i], wanted[i]) << i;
#endif
      EXPECT_NEAR(found[i], static_cast<double>(exact[i]), 1e-13 * std::fmax(1, std::fabs(wanted[i]))) << i;
      EXPECT_NEAR(found[i], static_cast<double>(rough[i]), 1e-4 * std::fmax(1, std::fabs(wanted[i]))) << i;
    }
  }
}

template <class Code>
using plan_of_four = lower::lockstep_plan<Code, lower::cuts_of<Code>, 4>;

TEST(Lockstep, has_the_values_of_steps_one_by_one) {
  check_values<code<4, 0>>();
  check_values<code<3, 1>>();
  check_values<code<4, 0, true>>();
}

TEST(Lockstep, takes_as_many_branches_as_there_are_lanes) {
  EXPECT_EQ((lanes<code<4, 0>>(4)), 4);
  EXPECT_EQ((lanes<code<4, 0>>(8)), 4);
  EXPECT_EQ((lanes<code<4, 0>>(2)), 2);
  EXPECT_EQ((lanes<code<3, 1>>(4)), 2);
}

TEST(Lockstep, evaluates_most_steps_of_four_mirrored_branches_together) {
  constexpr const auto& plan = plan_of_four<code<4, 0>>::value;
  EXPECT_EQ(plan.lanes, 4);
  EXPECT_GT(plan.vector_operations, 45);
  EXPECT_LT(3 * plan.operations, 2 * (lower::cuts_of<code<4, 0>>::value.first[1]));
}

/// Arguments 0 to 7, products 8 to 11 of two each, their sum, which is stored, and a last use of argument 7.
constexpr lower::lockstep_entries sum_of_products() {
  using action = lower::lockstep_action;
  using kind = action::kind;
  lower::lockstep_entries all(20);
  const auto add = [&](action what, int a, int b, int place) {
    all.action[all.count] = what.code();
    all.place[all.count] = place;
    all.a[all.count] = a, all.b[all.count] = b;
    return ++all.count; // entry 0 precedes these
  };
  for (int i = 0; i < 8; ++i) add({kind::argument}, 0, 0, i);
  for (int i = 0; i < 4; ++i) add({kind::value, symbolic::operation::multiply}, 2 * i + 1, 2 * i + 2, 0);
  const int left = add({kind::value, symbolic::operation::add}, 9, 10, 0),
            right = add({kind::value, symbolic::operation::add}, 11, 12, 0),
            sum = add({kind::value, symbolic::operation::add}, left, right, 0);
  add({kind::value, symbolic::operation::negate}, sum, 0, 20);
  add({kind::value, symbolic::operation::add, {}, {}, 0, 0, true}, 8, 8, 21);
  return all;
}

/// The number of values that are live at once at most, or −1 if an operand follows its use.
constexpr int most_at_once(const lower::lockstep_entries& all) {
  int last_use[20]{}, live = 0, most = 0;
  const auto operands = [&](int k) { return std::array{all.a[k] - 1, all.b[k] - 1}; };
  for (int k = 0; k < all.count; ++k)
    for (const int each : operands(k)) {
      if (each >= k) return -1;
      if (each >= 0) last_use[each] = k;
    }
  for (int k = 0; k < all.count; ++k) {
    for (int i = 0; i < k; ++i)
      if (last_use[i] == k) --live;
    if (last_use[k] > k) ++live;
    if (most < live) most = live;
  }
  return most;
}

TEST(Lockstep, keeps_few_values_live) {
  static_assert(most_at_once(sum_of_products()) == 8);
  constexpr int most = [] {
    lower::lockstep_entries all = sum_of_products();
    lower::detail::entry_order(all, 1, 1).run();
    bool is_stored = false;
    for (int k = 0; k < all.count; ++k) is_stored = is_stored || all.place[k] == 20;
    return is_stored ? most_at_once(all) : -1;
  }();
  EXPECT_GT(most, 0);
  EXPECT_LE(most, 5);
}

TEST(Lockstep, requires_equal_branches) {
  EXPECT_EQ((lanes<code<2, 1>>(4)), 0);
  EXPECT_EQ((lanes<code<1, 0>>(4)), 0);
  EXPECT_FALSE((lower::runs_in_lockstep<code<2, 1>, float>));
}

} // namespace
