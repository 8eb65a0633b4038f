// builds: clang++
// The growth of the equations of a chain of loops with its length. Operations are counted, not timed.
#include "loop_chain.hpp"

#include <gtest/gtest.h>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/mechanics/equations.hpp>

#include <vector>

namespace {

struct size {
  double nodes = 0, operations = 0;
};

size size_of(int loops) {
  loop_chain b(loops);
  EXPECT_EQ(b.check().view(), "");
  kanexpr::mechanics::equations e(b.system());
  kanexpr::base::sequence<int> outputs;
  for (const auto& rate : e.get(kanexpr::mechanics::quantity::udot).entries) outputs.push(rate.node());
  EXPECT_EQ(e.mistake().view(), "");
  EXPECT_EQ(outputs.size(), 3 * loops);
  const kanexpr::symbolic::cost c = kanexpr::lower::cost_of(kanexpr::lower::tape_of(b.graph(), outputs));
  return {static_cast<double>(b.graph().size()),
          static_cast<double>(c.multiplications + c.additions + c.divisions)};
}

TEST(scale, a_chain_of_loops_grows_no_faster_than_the_square_of_its_length) {
  std::vector<size> sizes;
  for (int loops = 1; loops <= 16; loops *= 2) {
    sizes.push_back(size_of(loops));
  }
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    EXPECT_LE(sizes[i].nodes, 4.2 * sizes[i - 1].nodes) << (1 << i) << " loops";
    EXPECT_LE(sizes[i].operations, 4.2 * sizes[i - 1].operations) << (1 << i) << " loops";
  }
}

} // namespace
