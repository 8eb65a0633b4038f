// builds: clang++
// A derivation that is stored and resumed equals one that was not interrupted.
#include <kanexpr/derivation/digest.hpp>
#include <kanexpr/derivation/extract_code.hpp>
#include <kanexpr/lower/tape.hpp>
#include <models/andrews.hpp>
#include <models/bicycle.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/quadruped.hpp>
#include <models/rattleback.hpp>
#include <models/rolling_torus.hpp>
#include <models/simple_pendulum.hpp>
#include <models/spinning_top.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace {

using kanexpr::derivation::derived_system;
using kanexpr::derivation::image;
using kanexpr::derivation::request;
using kanexpr::derivation::stage;
using kanexpr::mechanics::quantity;

/// Zeroed memory is an empty image; pages that are never used take no time.
std::shared_ptr<image> store(derived_system& system) {
  std::shared_ptr<image> stored(static_cast<image*>(std::calloc(1, sizeof(image))), std::free);
  system.write(*stored);
  return stored;
}

void expect_same(const image& a, const image& b) {
  ASSERT_FALSE(a.is_full);
  EXPECT_EQ(a.graph.size, b.graph.size);
  const auto &nodes = a.graph.nodes.value, &others = b.graph.nodes.value;
  const auto are_same = [](const kanexpr::symbolic::node& one, const kanexpr::symbolic::node& other) {
    return one.op == other.op && one.a == other.a && one.b == other.b;
  };
  EXPECT_TRUE(std::equal(nodes, nodes + a.graph.size, others, are_same));
  EXPECT_EQ(a.numbers, b.numbers);
  EXPECT_TRUE(std::equal(a.numerators, a.numerators + a.numbers, b.numerators));
  EXPECT_TRUE(std::equal(a.denominators, a.denominators + a.numbers, b.denominators));
  EXPECT_TRUE(std::equal(a.reals, a.reals + a.numbers, b.reals));
  EXPECT_EQ(a.integers, b.integers);
  EXPECT_TRUE(std::equal(a.integer, a.integer + a.integers, b.integer));
  EXPECT_EQ(a.frames, b.frames);
  EXPECT_TRUE(std::equal(a.frame, a.frame + a.frames, b.frame));
  EXPECT_EQ(a.points, b.points);
  EXPECT_TRUE(std::equal(a.point, a.point + a.points, b.point));
}

/// The steps of the code for a result, which determine its values completely.
kanexpr::lower::tape tape_for(derived_system& system, quantity wanted) {
  const request all[]{{.what = request::kind::result, .wanted = wanted}};
  const auto found = kanexpr::derivation::nodes_for(system, all);
  return kanexpr::lower::tape_of(system.graph(), found.nodes);
}

void expect_same(const kanexpr::lower::tape& a, const kanexpr::lower::tape& b) {
  ASSERT_EQ(a.steps.size(), b.steps.size());
  for (int i = 0; i < a.steps.size(); ++i) {
    EXPECT_EQ(a.steps[i].op, b.steps[i].op);
    EXPECT_EQ(a.steps[i].a, b.steps[i].a);
    EXPECT_EQ(a.steps[i].b, b.steps[i].b);
  }
  ASSERT_EQ(a.numbers.size(), b.numbers.size());
  for (int i = 0; i < a.numbers.size(); ++i) EXPECT_TRUE(a.numbers[i] == b.numbers[i]);
  ASSERT_EQ(a.results.size(), b.results.size());
  EXPECT_TRUE(std::equal(a.results.begin(), a.results.end(), b.results.begin()));
}

template <class Model>
class image_of : public testing::Test {};

using models = testing::Types<simple_pendulum::System, spinning_top::System, iiwa::System, quadruped::System,
                              four_bar::System, andrews::System, bicycle::System, rattleback::System,
                              rolling_torus::System, pendulum_nonminimal::System>;
TYPED_TEST_SUITE(image_of, models);

TYPED_TEST(image_of, a_stage_taken_up_again_is_the_same_when_set_aside) {
  derived_system straight(TypeParam::record);
  for (const stage to : {stage::constrained, stage::equations, stage::linearized}) {
    advance(straight, to);
    ASSERT_FALSE(straight.mistake()) << straight.mistake();
    const auto stored = store(straight);
    derived_system again(TypeParam::record, *stored);
    expect_same(*stored, *store(again));
  }
}

TYPED_TEST(image_of, results_do_not_depend_on_where_the_derivation_was_set_aside) {
  for (const kanexpr::mechanics::result_row& row : kanexpr::mechanics::results) {
    SCOPED_TRACE(row.called);
    derived_system straight(TypeParam::record);
    advance(straight, stage::constrained);
    auto stored = store(straight);
    for (const stage to : {stage::equations, stage::linearized}) {
      if (row.needs < to) break;
      advance(straight, to);
      derived_system again(TypeParam::record, *stored);
      advance(again, to);
      stored = store(again);
    }
    derived_system again(TypeParam::record, *stored);
    expect_same(tape_for(straight, row.is), tape_for(again, row.is));
  }
}

template <class System>
void expect_the_image_of_the_compiler() {
  constexpr std::uint64_t of_compiler =
      kanexpr::derivation::digest_of(kanexpr::derivation::stages_of<System>::linearized.stored);
  derived_system system(System::record);
  for (const stage to : {stage::constrained, stage::equations, stage::linearized}) advance(system, to);
  EXPECT_EQ(digest_of(*store(system)), of_compiler);
}

// The order in which operands are evaluated is unspecified: g++ evaluates the last one first at run time and
// the first one first in a constant expression; clang++ evaluates the first one first in both cases.
TEST(image, of_the_compiler_is_that_of_the_program) {
  expect_the_image_of_the_compiler<four_bar::System>();
  expect_the_image_of_the_compiler<rattleback::System>();
  expect_the_image_of_the_compiler<pendulum_nonminimal::System>();
}

// The signs of two numbers, which a sum of words would lose.
TEST(image, has_a_digest_that_sees_every_entry) {
  derived_system system(rattleback::System::record);
  advance(system, stage::constrained);
  const auto stored = store(system);
  ASSERT_GT(stored->numbers, 2);
  stored->denominators[0] = stored->denominators[1] = 0, stored->reals[0] = 0.25, stored->reals[1] = 0.75;
  const std::uint64_t before = digest_of(*stored);
  EXPECT_EQ(digest_of(*store(system)), digest_of(*store(system)));
  const auto expect_other = [&](auto&... entries) {
    (void(entries = -entries), ...);
    EXPECT_NE(digest_of(*stored), before);
    (void(entries = -entries), ...);
  };
  expect_other(stored->reals[0]);
  expect_other(stored->reals[0], stored->reals[1]);
  const auto last_of = [](const auto* entries, int count) { // of those that have a sign
    while (entries[count - 1] == 0) --count;
    return count - 1;
  };
  expect_other(stored->numerators[last_of(stored->numerators, stored->numbers)]);
  expect_other(stored->graph.nodes.value[stored->graph.size - 1].a);
  expect_other(stored->integer[last_of(stored->integer, stored->integers)], stored->integer[0]);
  EXPECT_EQ(digest_of(*stored), before);
}

TEST(image, of_a_system_that_there_is_no_room_for_says_so) {
  auto ended = std::make_unique<kanexpr::derivation::staged>();
  ended->stored.integers = image::most_integers;
  derived_system system(simple_pendulum::System::record);
  advance(system, stage::constrained);
  ended->take(system, "System");
  EXPECT_TRUE(ended->stored.is_full);
  EXPECT_EQ(ended->mistake.view(), "System exceeds the supported size of a system");
}

} // namespace
