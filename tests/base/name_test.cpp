#include <kanexpr/base/name.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

using kanexpr::base::name;

TEST(name, is_what_it_is_made_of) {
  name called("q");
  called.append(12), called.append("''");
  EXPECT_EQ(called.view(), "q12''");
  called = "u";
  called.append(-7);
  EXPECT_EQ(called.view(), "u-7");
  const std::string longest(name::capacity, 'x');
  EXPECT_EQ(name(longest).view(), longest);
}

TEST(name, keeps_both_ends_of_what_is_too_long) {
  const std::string type = "Link" + std::string(100, 'x') + "End";
  const name left(type);
  EXPECT_EQ(left.length, name::capacity);
  EXPECT_EQ(left.view(), "Link" + std::string(26, 'x') + "..." + std::string(27, 'x') + "End");
}

// The frames of body-fixed angles are called B', B'' and B.
TEST(name, keeps_what_is_appended_to_a_long_one) {
  for (const std::size_t length : {61u, 62u, 63u, 64u, 200u}) {
    const name last(std::string(length, 'B'));
    name first = last, second = last;
    first.append("'"), second.append("''");
    EXPECT_TRUE(first.view().ends_with("B'")) << first.view();
    EXPECT_TRUE(second.view().ends_with("B''")) << second.view();
    EXPECT_FALSE(first == last || second == last || first == second) << length;
  }
  name numbered(std::string(60, 'q'));
  numbered.append(1234567);
  EXPECT_TRUE(numbered.view().ends_with("qqq1234567")) << numbered.view();
}

} // namespace
