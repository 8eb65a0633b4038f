// builds: clang++
#include <kanexpr/animate/animation.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/ensembles/ensemble_results.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace {

using kanexpr::base::sentence;

TEST(sentence, is_nothing_or_says_something) {
  EXPECT_FALSE(sentence());
  const sentence told({"point ", "P", " is offset from itself"});
  EXPECT_TRUE(told);
  EXPECT_EQ(told.view(), "point P is offset from itself");
  EXPECT_EQ(told.cause(), told.view());
  std::ostringstream out;
  out << told;
  EXPECT_EQ(out.str(), told.view());
}

// A user's function can take the cause of any failure as one type, which outlives the object that reported
// it.
template <class... Told>
constexpr bool have_causes_of_one_type =
    (std::is_same_v<decltype(std::declval<Told>().cause()), std::string> && ...);
static_assert(have_causes_of_one_type<sentence, kanexpr::status, kanexpr::outcome, kanexpr::assembly,
                                      kanexpr::consistency, kanexpr::table, kanexpr::table::column,
                                      kanexpr::csv_writer, kanexpr::ensemble_results, kanexpr::animation>);
static_assert(kanexpr::status("it is singular").view() == "it is singular");

TEST(sentence, leaves_out_the_middle_of_long_names) {
  const std::string one = "A" + std::string(200, 'x') + "1", other = "A" + std::string(200, 'x') + "2";
  const sentence told({one, " is not ", other});
  EXPECT_GT(told.length, sentence::capacity - 3);
  EXPECT_EQ(told.view().substr(0, 5), "Axxxx");
  EXPECT_NE(told.view().find("...x"), std::string_view::npos);
  EXPECT_NE(told.view().find("x1 is not Ax"), std::string_view::npos);
  EXPECT_TRUE(told.view().ends_with("x2")) << told;
}

TEST(sentence, says_that_there_is_more_than_it_has_room_for) {
  const std::string_view n = "name, ";
  const sentence full({n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n,
                       n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n, n});
  EXPECT_EQ(full.length, sentence::capacity);
  EXPECT_TRUE(full.view().ends_with("name, ...")) << full;
}

} // namespace
