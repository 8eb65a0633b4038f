// builds: clang++ all
// What is drawn: positions, directions and names, read from the SVG.
#include "models/double_pendulum.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/figures.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using testing::HasSubstr;
using testing::Not;

namespace crane { // a cart with a spring and a damper to a wall, and a pendulum
constexpr coordinate<"x"> x;
constexpr coordinate<"theta"> theta;
constexpr speed<"v"> v;
constexpr speed<"w"> w;
constexpr parameter<"l"> l;
constexpr parameter<"k"> k;
constexpr parameter<"c1"> c1;
constexpr input<"F"> F;

struct N : inertial_frame<N> {};
struct A : rotated<A, N, theta, N::z> {};
struct O : origin<O, N> {};
struct Wall : offset<Wall, O, -2.0 * N::x> {};
struct C : offset<C, O, x * N::x> {};
struct P : offset<P, C, -l * A::y> {};
struct Cart : particle<Cart, C, 1.0> {};
struct Bob : particle<Bob, P, 1.0> {};
struct System
    : kane_system<
          inertial<N>, coordinates<x, theta>, speeds<v, w>, kinematics<dot(x) == v, dot(theta) == w>,
          bodies<Cart, Bob>,
          loads<gravity<-9.81 * N::y>, force<C, F * N::x>, spring<C, Wall, k, 1.0>, damper<C, Wall, c1>>> {};
} // namespace crane

figure crane_at(double x, double theta, const figure_options& how = {}) {
  using namespace crane;
  return draw<System>({{crane::x, x}, {crane::theta, theta}, {v, 0}, {w, 0}}, {{l, 1.5}, {k, 3}, {c1, 1}},
                      {{F, 2}}, how);
}

std::vector<Eigen::Vector2d> circles(const std::string& svg, const std::string& style) {
  static const std::regex number(R"re(cx="([-.0-9]+)" cy="([-.0-9]+)")re");
  std::vector<Eigen::Vector2d> found;
  for (std::size_t at = 0; (at = svg.find("<circle class=\"" + style + "\"", at)) != std::string::npos;
       ++at) {
    std::smatch match;
    const std::string rest = svg.substr(at, 120);
    if (std::regex_search(rest, match, number)) found.emplace_back(std::stod(match[1]), -std::stod(match[2]));
  }
  return found;
}

std::string without_tags(const std::string& svg) {
  return std::regex_replace(svg.substr(svg.find("</style>")), std::regex("<[^>]*>|\u200b"), "");
}

TEST(figure, places_points_in_the_plane) {
  const figure f = crane_at(0.6, 0.4);
  ASSERT_TRUE(f) << f.cause();
  const double scale = 230 / (2.6 + 1.5 * std::sin(0.4)); // from the wall to the bob
  const auto cart = circles(f.svg(), "filled b0"), bob = circles(f.svg(), "filled b1");
  ASSERT_EQ(cart.size(), 1);
  ASSERT_EQ(bob.size(), 1);
  EXPECT_NEAR(cart[0](0), scale * 0.6, 0.06);
  EXPECT_NEAR(cart[0](1), 0, 0.06);
  EXPECT_NEAR(bob[0](0), scale * (0.6 + 1.5 * std::sin(0.4)), 0.06);
  EXPECT_NEAR(bob[0](1), scale * -1.5 * std::cos(0.4), 0.06);
}

TEST(figure, has_the_names_of_the_model) {
  const std::string seen = without_tags(crane_at(0.6, 0.4).svg());
  for (const char* name : {"\nx\n", "\nl\n", "\nθ\n", "\nk\n", "\nc1\n", "\nF\n", "\n9.81\n", "\nCart\n",
                           "\nBob\n", "\nWall\n", "\nN.x\n", "\nN.y\n", "\nN.z\n", "\nA.x\n", "\nA.y\n"})
    EXPECT_THAT(seen, HasSubstr(name));
}

TEST(figure, leaves_out_what_is_not_wanted) {
  const figure_options bare{.axes = false, .angles = false, .lengths = false, .loads = false, .names = false};
  EXPECT_THAT(crane_at(0.6, 0.4, bare).svg(), Not(HasSubstr("<text")));
  EXPECT_THAT(crane_at(0.6, 0.4, bare).svg(), HasSubstr("filled b1"));
}

TEST(figure, labels_cover_neither_each_other_nor_the_model_much) {
  using namespace double_pendulum;
  for (const double angle : {0.1, 0.5, 1.2, 2.5, -0.7}) {
    const figure f = draw<System>(
        {{q1, angle}, {q2, angle / 2}, {u1, 0}, {u2, 0}},
        {{m1, 1}, {m2, 1}, {d1, 0.5}, {d2, 0.5}, {l1, 1}, {I1, 0.1}, {I2, 0.1}, {g, 9.81}, {c1, 0}, {c2, 0}},
        {{T1, 1}, {T2, 0}});
    ASSERT_TRUE(f) << f.cause();
    std::vector<Eigen::Vector2d> at;
    static const std::regex text(R"re(<text class="\w+" x="([-.0-9]+)" y="([-.0-9]+)")re");
    for (std::sregex_iterator i(f.svg().begin(), f.svg().end(), text), end; i != end; ++i)
      at.emplace_back(std::stod(i->str(1)), std::stod(i->str(2)));
    EXPECT_GT(at.size(), 10);
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(std::abs(at[i](1) - at[j](1)) < 8 && std::abs(at[i](0) - at[j](0)) < 8) << angle;
  }
}

TEST(figure, needs_no_inputs) {
  using namespace crane;
  const figure f = draw<System>({{x, 1}, {theta, 0}, {v, 0}, {w, 0}}, {{l, 1}, {k, 3}, {c1, 0}});
  EXPECT_TRUE(f) << f.cause();
  EXPECT_THAT(without_tags(f.svg()), Not(HasSubstr("\nF\n")));
}

TEST(figure, escapes_what_has_a_meaning_in_xml) {
  EXPECT_THAT(crane_at(0.6, 0.4, {.title = "a <b> & ]]>\n"}).svg(),
              HasSubstr("<title>a &lt;b&gt; &amp; ]]&gt; </title>"));
  EXPECT_THAT(crane_at(0.6, 0.4, {.title = "\xC3\xA9 \xFF \xC3"}).svg(), // not UTF-8
              HasSubstr("<title>\xC3\xA9 \xEF\xBF\xBD \xEF\xBF\xBD</title>"));
}

TEST(figure, rounds_long_numbers) {
  EXPECT_EQ(figures::typeset("9.8123456").svg, "9.8123");
  EXPECT_EQ(figures::typeset("0.00014999").svg, "0.00014999");
  EXPECT_EQ(figures::typeset("1.499912e-07").svg, "1.4999e-07");
  EXPECT_EQ(figures::typeset("1.2566370614359172").svg, "1.2566");
}

TEST(figure, is_upright_where_gravity_points_down) {
  // x down in the simple pendulum of the README: the bob hangs below the pivot
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u");
  b.kinematic_equation(b.dot(q) - u);
  const auto A = b.rotated("A", b.inertial_frame(), q, b.along(b.inertial_frame(), 0.0, 0.0, 1.0));
  const auto O = b.origin("O");
  b.particle("Bob", b.offset("P", O, b.along(A, 1.0, 0.0, 0.0)), b.number(1));
  b.gravity(b.along(b.inertial_frame(), 9.81, 0.0, 0.0));
  model m = derive(b);
  const figure f = draw(m, {{"q", 0.3}, {"u", 0.0}});
  ASSERT_TRUE(f) << f.cause();
  const Eigen::Vector2d bob = circles(f.svg(), "filled b0").at(0);
  EXPECT_NEAR(std::atan2(bob(0), -bob(1)), 0.3, 1e-3);
}

TEST(figure, shows_a_disc_in_space) {
  using namespace rolling_disc;
  model m = derive<System>();
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(m.known()->coordinates + m.known()->speeds, 0.4),
                        p = Eigen::VectorXd::Ones(m.mechanism().parameters.size());
  const figure f = draw(m, x, p);
  ASSERT_TRUE(f) << f.cause();
  EXPECT_THAT(f.svg(), HasSubstr("<ellipse"));
  EXPECT_EQ(f.svg(), draw(m, x, p).svg());
  EXPECT_THAT(f.svg(), HasSubstr("prefers-color-scheme: dark"));
  EXPECT_NE(f.svg(), draw(m, x, p, {}, {.eye = Eigen::Vector3d(1, 1, 1)}).svg());
}

TEST(figure, reports_why_there_is_none) {
  using namespace crane;
  EXPECT_EQ((draw<System>({{x, 1}, {theta, 0}, {v, 0}, {w, 0}}, {{l, 1}, {k, 3}}).cause()),
            "parameter c1 has no value");
  EXPECT_EQ((draw<System>({{x, NAN}, {theta, 0}, {v, 0}, {w, 0}}, {{l, 1}, {k, 3}, {c1, 0}}).cause()),
            "the value of coordinate x is not a number");
  EXPECT_EQ(crane_at(0, 0, {.upward = Eigen::Vector3d(0, 0, 0)}).cause(),
            "the direction upward must be finite and not zero");
  EXPECT_EQ(crane_at(0, 0, {.eye = Eigen::Vector3d(0, NAN, 0)}).cause(),
            "the direction eye must be finite and not zero");
  EXPECT_EQ(crane_at(0, 0, {.eye = Eigen::Vector3d(0, 1, 0)}).cause(),
            "the eye is in the up direction; specify a different `upward`");
  EXPECT_EQ(crane_at(1e300, 0).cause(),
            "the position of a point is not finite or exceeds 1e100; specify values for all parameters");
  EXPECT_NE(
      (draw<System>({{x, 1}, {theta, 0}, {v, 0}, {w, 0}}, {{l, 1}, {k, 3}, {c1, 0}}, {{"G", 1}}).cause()),
      "");
  const figure f = crane_at(0, 0);
  EXPECT_THAT(std::string(f.write("/nowhere/figure.svg").cause()),
              "the figure cannot be written to /nowhere/figure.svg");
}

TEST(figure, is_drawn_from_a_builder_and_from_a_temporary_model) {
  runtime::builder b("N");
  const auto O = b.origin("O");
  const auto q = b.coordinate("q_joint_1");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  b.particle("Bob", b.offset("P", O, b.along(runtime::builder::inertial_frame(), q, 0, 0)), b.number(1));
  const figure f = draw(b, {{"q_joint_1", 1.0}, {"u", 0.0}});
  ASSERT_TRUE(f) << f.cause();
  EXPECT_EQ(f.svg(), draw(derive(b), {{"q_joint_1", 1.0}, {"u", 0.0}}).svg());
  EXPECT_THAT(without_tags(f.svg()), HasSubstr("\nqjoint,1\n")); // the subscript has no underscore
}

TEST(figure, connects_a_damper_beside_a_spring) {
  using namespace crane;
  const auto lines = [](const std::string& svg) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = svg.find("<path class=\"load\"", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  const figure_options only_loads{.axes = false, .angles = false, .lengths = false, .names = false};
  // a zigzag; a damper is two lines, a piston and a cylinder; and two lines connect both
  EXPECT_EQ(lines(crane_at(0.6, 0.4, only_loads).svg()), 1 + 4 + 2 + 2); // and shafts of F and g
}

/// A loop of two equal bars: its closing point is at height 0 below N.x at 2 l cos q1.
runtime::builder& add_two_bars(runtime::builder& b) {
  const auto N = runtime::builder::inertial_frame();
  const auto q1 = b.coordinate("q1"), q2 = b.coordinate("q2");
  b.kinematic_equation(b.dot(q1) - b.speed("u1")), b.kinematic_equation(b.dot(q2) - b.speed("u2"));
  const auto O = b.origin("O");
  const auto A = b.rotated("A", N, q1, b.along(N, 0, 0, 1)), B = b.rotated("B", N, q2, b.along(N, 0, 0, 1));
  const auto P = b.offset("P", O, b.along(A, 1, 0, 0)), Q = b.offset("Q", P, b.along(B, 1, 0, 0));
  b.particle("Bob", P, b.number(1)), b.particle("End", Q, b.number(1));
  b.configuration_constraint(b.dot(b.position_of(Q, O), b.along(N, 0, 1, 0)));
  b.dependent(q2);
  return b;
}

TEST(figure, solves_for_what_the_constraints_determine) {
  runtime::builder b("N");
  add_two_bars(b);
  const figure f = draw(b, {{"q1", 0.5}, {"u1", 0.0}}),
               given = draw(b, {{"q1", 0.5}, {"q2", -0.5}, {"u1", 0.0}});
  ASSERT_TRUE(f) << f.cause();
  ASSERT_TRUE(given) << given.cause();
  const auto bob = circles(f.svg(), "filled b0"), end = circles(f.svg(), "filled b1");
  ASSERT_EQ(end.size(), 1);
  EXPECT_NEAR(end[0](1), 0, 0.06);
  EXPECT_NEAR(end[0](0), 2 * bob[0](0), 0.11);
  EXPECT_EQ(draw(b, {{"q1", 0.5}, {"q2", 0.4}, {"u1", 0.0}, {"u2", 0.0}}).cause().substr(0, 26),
            "configuration constraint 1");
}

/// A crank of length a, a rod of length c and a slider at s on N.x.
runtime::builder& add_slider_crank(runtime::builder& b) {
  const auto N = runtime::builder::inertial_frame();
  const auto q = b.coordinate("q"), r = b.coordinate("r"), s = b.coordinate("s"), a = b.parameter("a");
  const auto u = b.speed("u"), v = b.speed("v"), w = b.speed("w"), c = b.parameter("c");
  b.kinematic_equation(b.dot(q) - u), b.kinematic_equation(b.dot(r) - v), b.kinematic_equation(b.dot(s) - w);
  const auto A = b.rotated("A", N, q, b.along(N, 0, 0, 1)), C = b.rotated("C", N, r, b.along(N, 0, 0, 1));
  const auto O = b.origin("O"), P = b.offset("P", O, b.along(A, a, 0, 0)),
             Q = b.offset("Q", P, b.along(C, c, 0, 0)), S = b.offset("S", O, b.along(N, s, 0, 0));
  b.particle("Crank", P, b.number(1)), b.particle("Slider", S, b.number(1));
  b.configuration_constraint(b.zero_along(b.position_of(Q, S), b.along(N, 1, 0, 0), b.along(N, 0, 1, 0)));
  b.dependent(r), b.dependent(s), b.dependent(v), b.dependent(w);
  return b;
}

TEST(figure, refuses_coordinates_that_contradict_the_constraints) {
  runtime::builder b("N");
  model m = derive(add_slider_crank(b));
  const auto at = [&](const given_state<model>& x, double scale = 1) {
    return draw(m, x, {{"a", scale}, {"c", 2 * scale}}).cause();
  };
  EXPECT_EQ(at({{"q", 0.5}, {"u", 0}}), "");
  EXPECT_EQ(at({{"q", 0.5}, {"r", -0.242}, {"s", 2.82}, {"u", 0}}), "");
  EXPECT_EQ(at({{"q", 0.5}, {"s", 2.82}, {"u", 0}}), "");
  for (const double scale : {1e-12, 1.0, 1e12}) {
    EXPECT_THAT(at({{"q", 0.5}, {"r", 1}, {"s", 7 * scale}, {"u", 0}}, scale), // dependent speeds omitted
                testing::StartsWith("configuration constraint"));
    EXPECT_EQ(at({{"q", 0.5}, {"s", 2.82 * scale}, {"u", 0}}, scale), "");
  }
  EXPECT_EQ(at({{"q", 0.5}, {"s", 7}, {"u", 0}}),
            "coordinate s is given as 7, but the constraints require 2.82");
  EXPECT_EQ(at({{"q", 0.5}, {"r", -0.4}, {"u", 0}}),
            "coordinate r is given as -0.4, but the constraints require -0.242");
}

/// A plate about O, and a point at the distance l from it.
figure plate(double l, double m, double I) {
  runtime::builder b("N");
  const auto N = runtime::builder::inertial_frame();
  const auto q = b.coordinate("q"), length = b.parameter("l");
  b.kinematic_equation(b.dot(q) - b.speed("u"));
  const auto A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  const auto O = b.origin("O");
  b.offset("P", O, b.along(N, length, 0, 0));
  b.rigid_body("Plate", O, A, b.parameter("m"), b.inertia(A, 0, 0, b.parameter("I")));
  return draw(b, {{"q", 0.3}, {"u", 0}}, {{"l", l}, {"m", m}, {"I", I}});
}

TEST(figure, refuses_sizes_that_do_not_fit_into_a_picture) {
  EXPECT_EQ(plate(1, 1, 1e20).cause(), "");
  EXPECT_EQ(plate(1e-90, 1, 1e-180).cause(), "");
  EXPECT_EQ(plate(5e-324, 1, 1).cause(), "the size of the model is 4.94e-324; it must exceed 1e-100");
  EXPECT_EQ(plate(1, 1, 1e30).cause(),
            "the radius of gyration of the body Plate is 1e+15, but the size of the model is 1");
  EXPECT_EQ(plate(1, 1e-300, 1e300).cause(),
            "the radius of gyration of the body Plate is inf, but the size of the model is 1");
}

/// The points of the paths with a style, in pixels.
std::vector<std::vector<Eigen::Vector2d>> paths(const std::string& svg, const std::string& style) {
  static const std::regex number(R"([ML](-?[0-9.]+) (-?[0-9.]+))");
  std::vector<std::vector<Eigen::Vector2d>> found;
  const std::string start = "<path class=\"" + style + "\" d=\"";
  for (std::size_t at = 0; (at = svg.find(start, at)) != std::string::npos; ++at) {
    const std::string d = svg.substr(at + start.size(), svg.find('"', at + start.size()) - at - start.size());
    std::vector<Eigen::Vector2d>& points = found.emplace_back();
    for (std::sregex_iterator each(d.begin(), d.end(), number); each != std::sregex_iterator(); ++each)
      points.emplace_back(std::stod((*each)[1]), -std::stod((*each)[2]));
  }
  return found;
}

/// A cantilever of length 2 bends by q (x/2)² and carries a particle; another body has two nodes.
TEST(figure, draws_flexible_bodies_bent) {
  runtime::builder b("N");
  const auto N = runtime::builder::inertial_frame();
  const auto q = b.coordinate("q"), s = b.coordinate("s");
  for (const auto& each : {q, s}) b.kinematic_equation(b.dot(each) - b.speed("v_" + symbolic::print(each)));
  const auto O = b.origin("O");
  runtime::beam_data data{.axis = b.along(N, 1, 0, 0), .length = 2.0, .mass_per_length = 1.0};
  data.bending.push_back(
      {b.along(N, 0, 1, 0),
       {.stiffness = 3.0, .shapes = {numeric::beams::shape::polynomial({0.0, 0.0, 1.0})}}});
  const auto tip = b.section("Tip", b.beam("Cantilever", O, N, {q}, data), 1);
  b.particle("Bob", tip.point, b.number(1));
  mechanics::flexible_data numbers(1);
  numbers.mass = 1, numbers.modal_mass[0] = 1, numbers.stiffness[0] = 1;
  for (const int i : {0, 1, 2}) numbers.inertia.constant(i) = 1;
  for (const double x : {0.0, 1.0}) {
    mechanics::flexible_node node{.called = base::name(x > 0 ? "b" : "a"),
                                  .position = mechanics::taylor_series(3, 1, 1)};
    node.position.constant(0) = x, node.position.linear(0, 1) = -x;
    numbers.nodes.push(node);
  }
  b.flexible_body("Arm", O, N, {s}, numbers);
  const figure drawn = draw(b, {{"q", 0.5}, {"s", 0.25}, {"v_q", 0.0}, {"v_s", 0.0}}, {}, {},
                            {.upward = Eigen::Vector3d(0, 1, 0), .eye = Eigen::Vector3d(0, 0, 1)});
  ASSERT_TRUE(drawn) << drawn.cause();
  const double tip_at = 2 - 0.25 * 2 / 3.0 / 2, scale = 230 / tip_at; // pixels per meter
  const auto beams = paths(drawn.svg(), "solid b1"), arms = paths(drawn.svg(), "solid b2");
  ASSERT_EQ(beams.size(), 1u);
  ASSERT_EQ(beams[0].size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    const double xi = static_cast<double>(i) / 8;
    const Eigen::Vector2d place(2 * xi - 0.25 * xi * xi * xi / 3, 0.5 * xi * xi);
    EXPECT_LT((beams[0][i] - scale * place).cwiseAbs().maxCoeff(), 0.051) << i;
  }
  ASSERT_EQ(arms.size(), 1u);
  EXPECT_LT((arms[0][1] - scale * Eigen::Vector2d(1, -0.25)).cwiseAbs().maxCoeff(), 0.051);
  EXPECT_THAT(without_tags(drawn.svg()), HasSubstr("Tip.x"));
  EXPECT_THAT(drawn.svg(), Not(HasSubstr("class=\"angle\""))); // of the section
  const auto magnified = [&](double by) {
    return draw(b, {{"q", 0.5 / by}, {"s", 0.25 / by}, {"v_q", 0.0}, {"v_s", 0.0}}, {}, {},
                {.upward = Eigen::Vector3d(0, 1, 0), .eye = Eigen::Vector3d(0, 0, 1), .deflections = by});
  };
  EXPECT_EQ(magnified(8).svg(), drawn.svg());
  EXPECT_EQ(magnified(HUGE_VAL).cause(), "the factor of the deflections must be finite");
}

} // namespace
