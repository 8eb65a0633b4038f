// builds: clang++
// Several threads simultaneously, each with its own objects; all share constants.
#include "models/pendulum_nonminimal.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/simulate.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <thread>

namespace {

using namespace pendulum_nonminimal;
using eom = kanexpr::equations_of_motion<System>;

struct shared {
  eom::parameters p;
  eom::state x = eom::state::Zero();
  kanexpr::given_parameters<System> by_name{{m, 1}, {L, 2}, {g, 9.81}};
  kanexpr::simulation_options<System> options;
  shared() {
    p[m] = 1, p[L] = 2, p[g] = 9.81;
    x[q1] = 1.2, x[q2] = 1.6;
    options.output_every = 0.1;
  }
};

// The results of one thread, with all parts of the library.
struct findings {
  eom::state rates, moved, at_rest;
  Eigen::VectorXd derived;
  double frequency = 0;
  bool all_right = false;

  void find(const shared& given) {
    rates = eom::rhs(given.x, given.p);
    auto model = kanexpr::derive<System>();
    derived = model.function(model.rhs())(given.x, given.p);
    Eigen::VectorXd assembled = given.x * 0.9;
    const bool is_assembled = static_cast<bool>(kanexpr::assemble(model, assembled, given.p, given.p));
    auto linear = model.linearize({{m, 1}, {L, 2}, {g, 9.81}, {q1, 2}, {q2, 0}, {u1, 0}, {u2, 0}});
    frequency = linear.explicit_form().A(1, 0).is_constant() ? 1 : 0;
    const auto run = kanexpr::simulate<System>(given.x, given.by_name, {0, 1}, given.options);
    moved = run.state;
    const auto stiff = kanexpr::simulate<System, kanexpr::integrator::bdf>(given.x, given.by_name, {0, 1});
    const kanexpr::operating_point<System> rest({{q1, 1.9}, {q2, 0.1}, {u1, 0}, {u2, 0}}, given.by_name);
    at_rest = rest.x;
    all_right = is_assembled && linear && run && stiff && rest;
  }
};

TEST(threads, find_the_same_results_as_one_thread) {
  const shared given;
  findings alone;
  alone.find(given);
  ASSERT_TRUE(alone.all_right);
  std::array<findings, 4> at_once;
  std::array<std::thread, 4> threads;
  for (std::size_t i = 0; i < threads.size(); ++i)
    threads[i] = std::thread([&found = at_once[i], &given] { found.find(given); });
  for (std::thread& t : threads) t.join();
  for (const findings& one : at_once) {
    EXPECT_TRUE(one.all_right);
    EXPECT_EQ(one.rates, alone.rates);
    EXPECT_EQ(one.derived, alone.derived);
    EXPECT_EQ(one.frequency, alone.frequency);
    EXPECT_EQ(one.moved, alone.moved);
    EXPECT_EQ(one.at_rest, alone.at_rest);
  }
}

} // namespace
