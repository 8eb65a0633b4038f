// builds: clang++ all
#include "animate/samples.hpp"
#include "animate/swept_shapes.hpp"

#include <kanexpr/animate.hpp>
#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace simple_pendulum;
using kanexpr::write_page;
using testing::HasSubstr;
using testing::Not;

using pendulum =
    kanexpr::picture<System, up<-N::x>, ground<-2 * l>, seen_from<N::z>, trace<P>, show<rod<O, P, 0.02>>,
                     show<sphere<P, l / 10>, colour<"#c0392b">>, show<axes<A, P, 0.3>, opacity<0.5>>>;

tests::samples<System> swing(std::initializer_list<double> angles) {
  tests::samples<System> run;
  run.p[m] = 1, run.p[l] = 0.7, run.p[g] = 9.81;
  for (double angle : angles) {
    tests::sample<System> s;
    s.t = 0.1 * static_cast<double>(run.all.size());
    s.x[q] = angle;
    run.all.push_back(s);
  }
  return run;
}

kanexpr::animation pendulum_along(const tests::samples<System>& run) {
  return kanexpr::animated<pendulum>(run);
}

class page : public testing::Test {
protected:
  void SetUp() override {
    directory_ = std::filesystem::path(testing::TempDir()) /
                 testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(directory_);
    write("empty.html", "<title>@title@</title><p>@motion@</p>");
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  kanexpr::page_options options(const std::string& title) const {
    return {.title = title, .empty_page = path("empty.html")};
  }

private:
  std::filesystem::path directory_;
};

TEST(animation, is_that_of_a_pendulum) {
  const kanexpr::animation a = pendulum_along(swing({0.3, -1.2, 2.9}));
  ASSERT_TRUE(a) << a.cause();
  const double angles[]{0.3, -1.2, 2.9};
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d bob(0.7 * std::cos(angles[k]), 0.7 * std::sin(angles[k]), 0);
    EXPECT_LT((a.find("sphere at P")->placements[k].position - bob).norm(), 1e-15);
    EXPECT_LT((a.find("trace at P")->placements[k].position - bob).norm(), 1e-15);
    EXPECT_EQ(a.find("rod from O to P")->placements[k].position, Eigen::Vector3d::Zero());
    EXPECT_LT((a.find("rod from O to P")->placements[k].end - bob).norm(), 1e-15);
    EXPECT_LT((a.find("axes at P")->placements[k].orientation.col(0) - bob / 0.7).norm(), 1e-15);
  }
  EXPECT_EQ(a.up, -Eigen::Vector3d::UnitX());
  EXPECT_EQ(a.ground, -1.4);
  EXPECT_FALSE(a.carried);
}

struct Middle : offset<Middle, O, l / 2 * A::x + l / 10 * sin(q) * A::y> {};
struct Turned : rotated<Turned, A, q, A::z> {};

using curved =
    kanexpr::picture<System, up<-N::x>, show<cable<l / 50, O, Middle, P>>, carried<P>,
                     show<sweep<tapered<rectangle<l / 5, l / 10>, rectangle<l / 6, 0.1>>, station<A, O, A::x>,
                                station<Turned, Middle, Turned::x>, station<A, P, A::x>>>>;

/// The places of curves are those of their points and frames, at each time.
TEST(animation, holds_all_places_of_curves) {
  tests::samples<System> run = swing({0.3, 0.8});
  run.all[0].x[u] = run.all[1].x[u] = 0;
  const kanexpr::animation a = kanexpr::animated<curved>(run);
  ASSERT_TRUE(a) << a.cause();
  const kanexpr::animation::shape& rope = *a.find("cable from O to P");
  const kanexpr::animation::shape& bar = *a.find("sweep from O to P");
  EXPECT_EQ(rope.profile, "circle");
  EXPECT_EQ(bar.profile, "rectangle");
  EXPECT_EQ(bar.sizes, (std::vector<double>{0.7 / 5, 0.7 / 10, 0.7 / 6, 0.1}));
  ASSERT_EQ(rope.places, 3u);
  ASSERT_EQ(rope.placements.size(), 6u);
  ASSERT_EQ(bar.placements.size(), 6u);
  const double angles[]{0.3, 0.8};
  for (std::size_t k = 0; k < 2; ++k) {
    const double angle = angles[k];
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0),
        across(-std::sin(angle), std::cos(angle), 0);
    // the origin is carried such that P keeps its initial position, as its velocity is zero
    const Eigen::Vector3d first(std::cos(0.3), std::sin(0.3), 0), moved = 0.7 * (first - along);
    const Eigen::Vector3d origin = moved - moved.x() * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d middle = origin + 0.35 * along + 0.07 * std::sin(angle) * across;
    const Eigen::Vector3d places[]{origin, middle, origin + 0.7 * along};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((rope.placement_at(k, i).position - places[i]).norm(), 1e-15);
      EXPECT_LT((bar.placement_at(k, i).position - places[i]).norm(), 1e-15);
      const double turned = i == 1 ? 2 * angle : angle;
      const Eigen::Vector3d tangent(std::cos(turned), std::sin(turned), 0),
          x(-std::sin(turned), std::cos(turned), 0);
      EXPECT_LT((bar.placement_at(k, i).orientation.col(0) - x).norm(), 1e-15);
      EXPECT_LT((bar.placement_at(k, i).orientation.col(2) - tangent).norm(), 1e-15);
    }
  }
}

TEST(animation, tells_what_is_wrong_with_a_curve) {
  tests::samples<System> run = swing({0.3, 0.8});
  kanexpr::animation a = kanexpr::animated<curved>(run);
  a.shapes[0].placements.pop_back();
  EXPECT_EQ(kanexpr::animate::check_entries(a),
            "the cable from O to P has 5 placements for 2 times and 3 places");
  a = kanexpr::animated<curved>(run);
  a.shapes[0].placements[4].position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kanexpr::animate::check_numbers(a),
            "the position of the cable from O to P is not finite at t = 0.1");
  using negative = kanexpr::picture<System, up<-N::x>, show<cable<l - 1, O, P>>>;
  EXPECT_EQ(kanexpr::animated<negative>(run).cause(),
            "every dimension of the cable from O to P must be positive and finite");
}

/// The stations that are fixed in one body share its track.
TEST(animation, finds_the_bodies_of_curves) {
  const kanexpr::animation a = kanexpr::animated<curved>(swing({0.3, 0.8, 1.5}));
  const kanexpr::animate::tracks found = kanexpr::animate::tracks_of(a);
  ASSERT_EQ(found.of_shape.size(), 2u);
  ASSERT_EQ(found.of_shape[1].size(), 3u);
  EXPECT_EQ(found.of_shape[1][0].track, found.of_shape[1][2].track);
  EXPECT_NE(found.of_shape[1][0].track, found.of_shape[1][1].track);
  EXPECT_NEAR(found.of_shape[1][2].position.norm(), 0.7, 1e-15);
  EXPECT_EQ(found.of_shape[0][1].track, found.of_shape[1][1].track); // the point Middle of the same frame
}

TEST(animation, tells_what_is_no_number) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  tests::samples<System> run = swing({0.1, 0.2, nan});
  EXPECT_EQ(pendulum_along(run).cause(), "the state is not finite at t = 0.2");
  EXPECT_FALSE(pendulum_along(run));
  run = swing({0.1, 0.2});
  run.p[l] = nan;
  EXPECT_EQ(pendulum_along(run).cause(), "the height of the ground must be finite");
  run.p[l] = -0.5;
  EXPECT_EQ(pendulum_along(run).cause(), "every dimension of the sphere at P must be positive and finite");
}

TEST(animation, tells_which_place_is_no_number) {
  using far = kanexpr::picture<System, up<-N::x>, show<sphere<P, 0.1>>>;
  tests::samples<System> run = swing({0.1, 0.2});
  run.p[l] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kanexpr::animated<far>(run).cause(), "the position of the sphere at P is not finite at t = 0");
}

TEST(animation, tells_which_length_a_page_cannot_show) {
  const std::string range = "; a page can show lengths from 1e-15 to 1e15";
  tests::samples<System> run = swing({0.1, 0.2});
  for (const double shown : {1e-13, 1e13}) {
    run.p[l] = shown;
    EXPECT_EQ(pendulum_along(run).cause(), "");
  }
  run.p[l] = 1e30;
  EXPECT_EQ(pendulum_along(run).cause(), "the height of the ground is -2e+30" + range);
  using apart = kanexpr::picture<System, up<-N::x>, show<sphere<P, l / 10>>>;
  EXPECT_EQ(kanexpr::animated<apart>(run).cause(), "a dimension of the sphere at P is 1e+29" + range);
  run.p[l] = 2e15;
  EXPECT_EQ(kanexpr::animated<apart>(run).cause(),
            "the sphere at P is 2e+15 away from the origin at t = 0" + range);
  run.p[l] = 1e-200; // times cos 0.1
  EXPECT_EQ(kanexpr::animated<apart>(run).cause(), "the largest length in the picture is 9.95e-201" + range);
}

TEST(animation, wants_samples_in_the_order_of_time) {
  EXPECT_EQ(pendulum_along(swing({})).cause(), "the trajectory has no samples");
  tests::samples<System> run = swing({0.1, 0.2, 0.3});
  run.all[1].t = 0.5;
  EXPECT_EQ(pendulum_along(run).cause(), "the times of the samples decrease at t = 0.2");
}

TEST(page_text, holds_everything_to_seven_digits) {
  const kanexpr::animation a = pendulum_along(swing({0.3, -1.2}));
  const auto text = nlohmann::json::parse(kanexpr::animate::page_text({{"", a}}, "A pendulum", "It swings."));
  EXPECT_EQ(text["title"], "A pendulum");
  EXPECT_EQ(text["ground"], -1.4);
  ASSERT_EQ(text["runs"].size(), 1u);
  const auto& run = text["runs"][0];
  EXPECT_EQ(run["times"], nlohmann::json({0.0, 0.1}));
  EXPECT_EQ(
      run["columns"][0],
      nlohmann::json({{"name", "q"}, {"group", "Coordinates"}, {"unit", "rad"}, {"values", {0.3, -1.2}}}));
  ASSERT_EQ(run["shapes"].size(), 4u);
  const auto &rod = run["shapes"][1], &sphere = run["shapes"][2], &axes = run["shapes"][3];
  EXPECT_EQ(sphere["sizes"], nlohmann::json::array({0.07}));
  EXPECT_EQ(sphere["colour"], "#c0392b");
  EXPECT_EQ(axes["placed"], "pose");
  EXPECT_EQ(axes["opacity"], 0.5);
  EXPECT_FALSE(axes.contains("colour"));

  ASSERT_EQ(run["tracks"].size(), 2u);
  EXPECT_EQ(run["tracks"][0],
            nlohmann::json({{"turns", true},
                            {"rows",
                             {0.6687355, 0.2068641, 0.0, 0.0, 0.0, 0.1494381, 0.9887711, 0.2536504,
                              -0.6524274, 0.0, 0.0, 0.0, -0.5646425, 0.8253356}}}));
  EXPECT_EQ(run["tracks"][1],
            nlohmann::json({{"turns", true}, {"rows", {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}}}));
  EXPECT_EQ(rod["anchors"], nlohmann::json({{{"track", 1}}, {{"track", 0}}}));
  for (const auto* each : {&sphere, &axes})
    EXPECT_EQ((*each)["anchors"], nlohmann::json::array({{{"track", 0}}}));
}

/// Rods between points of two bodies that a hinge joins, and a point that moves by itself.
kanexpr::animation hinged_bodies(int times) {
  using Eigen::Vector3d;
  kanexpr::animation a;
  const Vector3d hinge(0.4, 0.1, 0);
  const std::pair<bool, Vector3d> corners[]{
      {false, {0, 0, 0}},  {false, {0, 0.5, 0.1}},  {false, {0.2, 0, 0.3}}, {false, hinge},
      {true, {0.6, 0, 0}}, {true, {0.3, 0.2, 0.4}}, {true, {0.1, 0, -1}}};
  for (int k = 0; k < times; ++k) a.times.push_back(0.1 * k);
  const auto place = [&](const std::pair<bool, Vector3d>& corner, double t) -> Vector3d {
    const auto turn = [](double angle, const Vector3d& axis) {
      return Eigen::AngleAxisd(angle, axis.normalized());
    };
    const auto first = turn(0.9 * t, {1, 2, 3});
    const Vector3d from(t, std::sin(t), -0.3 * t);
    if (!corner.first) return from + first * corner.second;
    return from + first * (hinge + turn(std::cos(t), {0, 0, 1}) * corner.second);
  };
  for (const auto& from : corners)
    for (const auto& to : corners) {
      if (from.first != to.first || &from >= &to) continue;
      auto& s = a.shapes.emplace_back();
      s.kind = "rod", s.placed_by = kanexpr::animate::placement_kind::ends;
      for (double t : a.times) s.placements.push_back({place(from, t), place(to, t)});
    }
  auto& s = a.shapes.emplace_back();
  s.kind = "sphere";
  for (double t : a.times) s.placements.push_back({Vector3d(t * t, 1, std::exp(-t))});
  return a;
}

TEST(tracks, are_those_of_the_rigid_bodies) {
  const kanexpr::animation a = hinged_bodies(30);
  const kanexpr::animate::tracks found = kanexpr::animate::tracks_of(a);
  ASSERT_EQ(found.all.size(), 3u);
  EXPECT_TRUE(found.all[0].is_body() && found.all[1].is_body());
  EXPECT_FALSE(found.all[2].is_body());
  ASSERT_EQ(found.of_shape.size(), a.shapes.size());
  for (std::size_t i = 0; i < a.shapes.size(); ++i)
    for (std::size_t end = 0; end < found.of_shape[i].size(); ++end) {
      const kanexpr::animate::anchor& at = found.of_shape[i][end];
      const kanexpr::animate::track& body = found.all[at.track];
      for (std::size_t k = 0; k < a.times.size(); ++k) {
        const Eigen::Vector3d from = body.positions.col(static_cast<Eigen::Index>(k));
        const Eigen::Vector3d here = body.is_body() ? from + body.orientations[k] * at.position : from;
        const kanexpr::animate::placement& was = a.shapes[i].placements[k];
        EXPECT_LT((here - (end == 0 ? was.position : was.end)).norm(), 1e-14);
      }
    }
}

/// The stations of a beam that bends in two ways move by two deflections.
TEST(tracks, of_a_bent_beam_share_deflections) {
  const kanexpr::animation a = tests::bent_beam();
  const kanexpr::animate::tracks found = kanexpr::animate::tracks_of(a);
  const std::vector<kanexpr::animate::bending> bendings = kanexpr::animate::bendings_of(a, found);
  ASSERT_EQ(bendings.size(), 1u);
  const kanexpr::animate::bending& b = bendings[0];
  EXPECT_EQ(b.base, found.of_shape[0][0].track);
  ASSERT_EQ(b.tracks.size(), 8u);
  ASSERT_EQ(b.weights.rows(), 2);
  for (Eigen::Index k = 0; k < 41; ++k) {
    const double t = a.times[static_cast<std::size_t>(k)], q1 = 0.2 * std::sin(3 * t),
                 q2 = 0.1 * std::cos(8 * t);
    const Eigen::VectorXd numbers = b.mean + b.deflections * b.weights.col(k);
    for (Eigen::Index i = 0; i < 8; ++i) {
      const double x = static_cast<double>(i + 1) / 8;
      // the axes of the root: x is normal to the plane of bending, z along the beam
      const Eigen::Vector3d place = b.size * numbers.segment<3>(6 * i),
                            turned = numbers.segment<3>(6 * i + 3);
      const double slope = 2 * x * q1 + 3 * x * x * q2;
      EXPECT_LT((place - Eigen::Vector3d(0, -x * x * (q1 + x * q2), x)).norm(), 1e-12);
      EXPECT_LT((turned - Eigen::Vector3d(slope, 0, 0)).norm(), 1e-12);
    }
  }
}

/// While the beam is not deformed, its stations are fixed in its root.
TEST(tracks, of_an_undeformed_beam_are_that_of_its_root) {
  const kanexpr::animation a = tests::bent_beam();
  const kanexpr::animate::tracks found = kanexpr::animate::tracks_of(a);
  ASSERT_EQ(found.undeformed.size(), 2u);
  ASSERT_EQ(found.undeformed[0].size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(found.undeformed[0][i].track, found.of_shape[0][0].track);
    const double x = static_cast<double>(i) / 8;
    EXPECT_LT((found.undeformed[0][i].position - Eigen::Vector3d(0, 0, x)).norm(), 1e-12);
  }
  const auto text = nlohmann::json::parse(kanexpr::animate::page_text({{"", a}}, "", ""));
  const auto& last = text["runs"][0]["shapes"][0]["anchors"][8];
  EXPECT_EQ(last["undeformed"]["at"], nlohmann::json({0.0, 0.0, 1.0}));
}

/// A chain whose points move independently has no deflections in common.
TEST(tracks, of_a_loose_chain_do_not_bend) {
  kanexpr::animation a = tests::bent_beam();
  a.shapes.resize(1);
  double k = 0;
  for (kanexpr::animate::placement& here : a.shapes[0].placements)
    here.position += Eigen::Vector3d::Constant(0.1 * std::sin(k * k)), k += 1;
  EXPECT_TRUE(kanexpr::animate::bendings_of(a, kanexpr::animate::tracks_of(a)).empty());
}

TEST(tracks, separate_what_moves_by_more_than_the_digits_of_a_page) {
  kanexpr::animation a = hinged_bodies(30);
  for (kanexpr::animation::shape& s : a.shapes) s.placements[17].position(0) += 1e-8;
  EXPECT_EQ(kanexpr::animate::tracks_of(a).all.size(), 3u);
  a.shapes[0].placements[17].position(0) += 1e-6;
  EXPECT_EQ(kanexpr::animate::tracks_of(a).all.size(), 4u);
}

TEST(page_text, keeps_small_steps_at_large_times) {
  kanexpr::animation a = pendulum_along(swing({0.1, 0.2, 0.3}));
  for (const double start : {1e6, 1e9}) {
    for (std::size_t k = 0; k < 3; ++k) a.times[k] = start + 0.01 * static_cast<double>(k);
    const auto text = nlohmann::json::parse(kanexpr::animate::page_text({{"", a}}, "", ""));
    EXPECT_EQ(text["runs"][0]["times"].get<std::vector<double>>(), a.times);
  }
}

TEST(page_text, names_the_time_beside_what_the_model_names) {
  const auto name_beside = [](std::initializer_list<const char*> names) {
    kanexpr::animation a;
    for (const char* name : names) a.columns.push_back({.name = name});
    return nlohmann::json::parse(kanexpr::animate::page_text({{"", a}}, "", ""))["nameOfTime"];
  };
  EXPECT_EQ(name_beside({"q"}), "t");
  EXPECT_EQ(name_beside({"t", "q"}), "time");
  EXPECT_EQ(name_beside({"time", "t"}), "time_");
}

TEST(page_text, cannot_end_the_element_it_stands_in) {
  const kanexpr::animation a = pendulum_along(swing({0.3}));
  const std::string text = kanexpr::animate::page_text({{"", a}}, "</script><b>", "<!--");
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::json::parse(text)["title"], "</script><b>");
}

TEST_F(page, is_written) {
  const auto report = write_page<pendulum>(path("page.html"), swing({0.3}), options("a < b & c"));
  ASSERT_TRUE(report) << report.cause();
  EXPECT_THAT(read("page.html"), testing::StartsWith("<title>a &lt; b &amp; c</title><p>{"));
  EXPECT_THAT(read("page.html"), testing::EndsWith("}</p>"));
}

TEST_F(page, may_have_any_title) {
  const std::string odd =
      "@motion@ @title@ </title></script><!-- \"'$&` \\ \xC3\xA9 \xFF\x01\n\x7f" + std::string(1, '\0');
  ASSERT_TRUE(write_page<pendulum>(path("page.html"), swing({0.3}), options(odd)));
  const std::string all = read("page.html"), before = "<title>", between = "</title><p>", after = "</p>";
  const std::string title =
      "@motion@ @title@ &lt;/title>&lt;/script>&lt;!-- \"'$&amp;` \\ \xC3\xA9 \xEF\xBF\xBD    ";
  ASSERT_EQ(all.substr(0, all.find("{")), before + title + between);
  const std::size_t motion = all.find("{");
  const auto told = nlohmann::json::parse(all.substr(motion, all.size() - motion - after.size()));
  EXPECT_EQ(told["title"],
            "@motion@ @title@ </title></script><!-- \"'$&` \\ \xC3\xA9 \xEF\xBF\xBD\x01\n\x7f" +
                std::string(1, '\0'));
}

TEST_F(page, has_the_name_of_the_system_for_a_title) {
  ASSERT_TRUE(write_page<pendulum>(path("page.html"), swing({0.3}), options("")));
  EXPECT_THAT(read("page.html"), HasSubstr("<title>System</title>"));
}

TEST_F(page, is_not_written_where_something_is_no_number) {
  const auto report = write_page<pendulum>(path("page.html"),
                                           swing({std::numeric_limits<double>::quiet_NaN()}), options("A"));
  EXPECT_FALSE(report);
  EXPECT_EQ(report.cause(), "the state is not finite at t = 0");
  EXPECT_FALSE(std::filesystem::exists(path("page.html")));
}

TEST_F(page, tells_why_it_is_not_written) {
  const auto run = swing({0.3});
  EXPECT_EQ(write_page<pendulum>(path("no/page.html"), run, options("A")).cause(),
            path("no/page.html") + " cannot be written");
  write("other.html", "<p>");
  EXPECT_EQ(
      write_page<pendulum>(path("page.html"), run, {.title = "A", .empty_page = path("other.html")}).cause(),
      path("other.html") + " is not an empty page into which a motion can be inserted");
  EXPECT_EQ(
      write_page<pendulum>(path("page.html"), run, {.title = "A", .empty_page = path("none.html")}).cause(),
      "the empty page cannot be read, " + path("none.html") + "; the target kanexpr_page builds it with npm");
  EXPECT_EQ(write_page<pendulum>(path("page.html"), run, {.title = "A", .empty_page = path("")}).cause(),
            "the empty page cannot be read, " + path("") + "; the target kanexpr_page builds it with npm");
}

TEST_F(page, shows_several_runs) {
  const kanexpr::animation slow = pendulum_along(swing({0.1, 0.2})), fast = pendulum_along(swing({0.3}));
  const auto report = write_page(path("page.html"), {{"slow", slow}, {"fast", fast}}, options("Runs"));
  ASSERT_TRUE(report) << report.cause();
  const std::string all = read("page.html");
  const std::size_t from = all.find("{"), to = all.rfind("}") + 1;
  const auto text = nlohmann::json::parse(all.substr(from, to - from));
  ASSERT_EQ(text["runs"].size(), 2u);
  EXPECT_EQ(text["runs"][0]["name"], "slow");
  EXPECT_EQ(text["runs"][0]["times"], nlohmann::json({0.0, 0.1}));
  EXPECT_EQ(text["runs"][1]["name"], "fast");
  EXPECT_EQ(text["runs"][1]["columns"][0]["values"], nlohmann::json::array({0.3}));

  ASSERT_TRUE(write_page(path("page.html"), {{"slow", slow}}, options("")));
  EXPECT_THAT(read("page.html"), HasSubstr("<title>System</title>"));
}

TEST_F(page, tells_which_run_it_cannot_show) {
  const kanexpr::animation good = pendulum_along(swing({0.1})), none = pendulum_along(swing({}));
  const auto cause = [&](const std::vector<kanexpr::named_animation>& runs) {
    return write_page(path("page.html"), runs, options("Runs")).cause();
  };
  EXPECT_EQ(cause({}), "a page needs at least one run");
  EXPECT_EQ(cause({{"slow", good}, {"fast", none}}), "run fast: the trajectory has no samples");
  EXPECT_EQ(cause({{"slow", good}, {"", good}}), "one of several runs has no name");
  EXPECT_EQ(cause({{"slow", good}, {"slow", good}}), "two runs are named slow");
  EXPECT_EQ(cause({{"slow", {}}}), "the animation has no times");
  kanexpr::animation odd = good;
  odd.shapes.clear();
  EXPECT_EQ(cause({{"slow", good}, {"fast", odd}}), "run fast: the animation has no shapes");
  odd = good, odd.times.push_back(1);
  EXPECT_EQ(cause({{"odd", odd}}), "the trace at P has 1 placement for 2 times");
  for (kanexpr::animation::shape& s : odd.shapes) s.placements.resize(2);
  EXPECT_EQ(cause({{"odd", odd}}), "q has 1 value for 2 times");
  EXPECT_FALSE(std::filesystem::exists(path("page.html")));
}

/// Two meshes from one file, and the other shapes of the pendulum.
kanexpr::animation hammer() {
  kanexpr::animation a = pendulum_along(swing({0.3}));
  a.folder = "/no/such/folder";
  for (const std::size_t i : {2u, 3u}) {
    a.shapes[i].kind = "mesh";
    a.shapes[i].file = "head.stl";
    a.shapes[i].sizes = {1, -0.7, 0.01};
  }
  a.shapes[2].name = "head";
  return a;
}

TEST(base64, is_that_of_the_standard) { // RFC 4648, section 10
  const char* written[]{"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t n = 0; n < 7; ++n)
    EXPECT_EQ(kanexpr::animate::base64(std::string_view("foobar").substr(0, n)), written[n]);
  EXPECT_EQ(kanexpr::animate::base64("\xFB\xFF\xBF"), "+/+/");
}

TEST(animation, tells_which_scale_is_none) {
  kanexpr::animation a = hammer();
  EXPECT_EQ(kanexpr::animate::check_numbers(a), "");
  for (const double none : {0.0, std::numeric_limits<double>::infinity()}) {
    a.shapes[2].sizes[1] = none;
    EXPECT_EQ(kanexpr::animate::check_numbers(a), "every scale of the head must be finite and nonzero");
  }
}

TEST_F(page, holds_the_file_of_a_mesh_once) {
  write("head.stl", "foobar");
  kanexpr::page_options asked = options("A");
  asked.folder = path("");
  const auto report = kanexpr::animate::write_page(path("page.html"), hammer(), asked);
  ASSERT_TRUE(report) << report.cause();
  const std::string all = read("page.html");
  const std::size_t from = all.find("{"), to = all.rfind("}") + 1;
  const auto text = nlohmann::json::parse(all.substr(from, to - from));
  EXPECT_EQ(text["files"], nlohmann::json({{{"name", "head.stl"}, {"kind", "stl"}, {"data", "Zm9vYmFy"}}}));
  const auto& shapes = text["runs"][0]["shapes"];
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_FALSE(shapes[1].contains("file"));
  for (const std::size_t i : {2u, 3u}) {
    EXPECT_EQ(shapes[i]["file"], "head.stl");
    EXPECT_EQ(shapes[i]["sizes"], nlohmann::json({1.0, -0.7, 0.01}));
  }
}

TEST_F(page, tells_which_mesh_it_cannot_hold) {
  kanexpr::animation a = hammer();
  const auto cause = [&](const std::string& folder) {
    kanexpr::page_options asked = options("A");
    asked.folder = folder;
    return kanexpr::animate::write_page(path("page.html"), a, asked).cause();
  };
  EXPECT_EQ(cause(""), "the file of the head, /no/such/folder/head.stl, does not exist");
  const std::string file = "the file of the head, " + path("meshes/head.stl") + ",";
  EXPECT_EQ(cause(path("meshes")), file + " does not exist");
  std::filesystem::create_directories(path("meshes/head.stl"));
  EXPECT_EQ(cause(path("meshes")), file + " is not a file");
  std::filesystem::remove(path("meshes/head.stl"));
  write("meshes/head.stl", "");
  EXPECT_EQ(cause(path("meshes")), file + " is empty");
  std::filesystem::resize_file(path("meshes/head.stl"), 256'000'001); // of a sparse file
  EXPECT_EQ(cause(path("meshes")), file + " is too large; a page can hold at most 256 MB of meshes");
  a.shapes[2].file = "/other/head.stl";
  EXPECT_EQ(cause(path("meshes")), "the file of the head, /other/head.stl, does not exist");
  a.shapes[2].file = "head.txt";
  EXPECT_EQ(cause(path("meshes")),
            "the file of the head, " + path("meshes/head.txt") + ", is not of the type .stl, .dae or .obj");
  EXPECT_FALSE(std::filesystem::exists(path("page.html")));
}

} // namespace
