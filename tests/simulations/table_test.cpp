// builds: clang++
#include <kanexpr/simulations/tables/table.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace {

using kanexpr::table;

table two_columns() {
  table run;
  EXPECT_TRUE(run.add("t", {0, 0.5, 1}));
  EXPECT_TRUE(run.add("q1", {0.3, -0.2, 0.1}));
  return run;
}

TEST(table, has_columns_by_name) {
  const table run = two_columns();
  EXPECT_EQ(run.rows(), 3u);
  EXPECT_EQ(run.columns(), 2u);
  EXPECT_EQ(run.names(), (std::vector<std::string>{"t", "q1"}));
  const auto angle = run["q1"];
  ASSERT_TRUE(angle);
  EXPECT_EQ(angle.cause(), "");
  EXPECT_EQ(angle.size(), 3u);
  EXPECT_EQ(angle[1], -0.2);
  EXPECT_EQ(std::accumulate(run["t"].begin(), run["t"].end(), 0.0), 1.5);
  EXPECT_EQ(run.values(1), (std::vector<double>{0.3, -0.2, 0.1}));
}

TEST(table, reports_a_missing_column) {
  table run;
  EXPECT_EQ(run["q"].cause(), "the table has no column q; it has none");
  EXPECT_TRUE(run.add("t", {1}));
  EXPECT_EQ(run["q"].cause(), "the table has no column q; it has t");
  EXPECT_TRUE(run.add("q1", {1}));
  EXPECT_EQ(run["q"].cause(), "the table has no column q; it has t and q1");
  EXPECT_TRUE(run.add("q2", {1}));
  const auto missing = run["q"];
  EXPECT_FALSE(missing);
  EXPECT_TRUE(missing.empty());
  EXPECT_EQ(missing.cause(), "the table has no column q; it has t, q1 and q2");
}

TEST(table, that_could_not_be_read_reports_it_wherever_it_is_used) {
  table none{kanexpr::outcome("run.csv is empty")};
  EXPECT_FALSE(none);
  EXPECT_TRUE(table());
  EXPECT_EQ(none["q"].cause(), "run.csv is empty");
  EXPECT_EQ(none.add("q", {1}).cause(), "run.csv is empty");
  EXPECT_EQ(none.columns(), 0u);
}

TEST(table, rejects_columns_that_do_not_fit) {
  table run = two_columns();
  const auto expect_refused = [&](const std::string& name, std::vector<double> values, const char* cause) {
    const kanexpr::outcome added = run.add(name, std::move(values));
    EXPECT_FALSE(added);
    EXPECT_EQ(added.cause(), cause);
    EXPECT_EQ(run.columns(), 2u);
  };
  expect_refused("q1", {1, 2, 3}, "column q1 already exists");
  expect_refused("u1", {1}, "column u1 has 1 number, but the columns before it have 3");
  expect_refused("u1", {}, "column u1 has 0 numbers, but the columns before it have 3");
  expect_refused("", {1, 2, 3}, "a column has no name");
  expect_refused(std::string("q\0r", 3), {1, 2, 3}, "the name of a column contains a zero byte");
}

TEST(table, may_have_no_rows) {
  table run;
  EXPECT_TRUE(run.add("t", {}));
  EXPECT_EQ(run.rows(), 0u);
  EXPECT_TRUE(run["t"]);
  EXPECT_FALSE(run.add("q", {1}));
}

} // namespace
