// builds: clang++ all
// The playground's texts: the models that they build, the sentences of their mistakes, their motion, and the
// C++ types that one takes away.
#include "playground/session.hpp"
#include "playground/take_away/write_words.hpp"

#include "playground/words/all_words.inc"
#include "playground/words/four_bar.inc"
#include "playground/words/sleigh.inc"

#include <kanexpr/kanexpr.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using playground::session;
using testing::HasSubstr;
using testing::Not;

std::string contents_of(const std::string& file) {
  std::ifstream in(KANEXPR_PROJECT "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}
std::string example(const std::string& name) {
  return contents_of("examples/playground/models/" + name + ".txt");
}

TEST(Playground, ReadsAPendulum) {
  session s(example("pendulum"));
  ASSERT_EQ(s.wrong().sentence, "");
  EXPECT_EQ(kanexpr::symbolic::print(s.model().mass_matrix()), "[l^2*m]");
  EXPECT_EQ(kanexpr::symbolic::print(s.model().forcing()), "[T - c*u - g*l*m*sin(q)]");
  EXPECT_EQ(s.moving().x(0), 1);
  EXPECT_EQ(s.moving().p(1), 0.5);
}

TEST(Playground, ReportsTheFirstMistakeAndItsLine) {
  const std::string pendulum = "pin A on N about N.z by q, u\norigin O\noffset P from O by A.x\n";
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"swing A", "1: unknown word swing"},
      {"\npin A from N", "2: expected \"on\", got from; write pin <name> on <frame> about <vector> by "
                         "<coordinate> [= <number>], <speed> [= <number>]"},
      {"particle Bob at",
       "1: expected a point at the end of the line; write particle <name> at <point> mass <scalar>"},
      {"parameter m = 1 2", "1: unexpected 2; write parameter <name> [= <number>]"},
      {"parameter m = (1", "1: expected a closing parenthesis at the end of the line"},
      {"parameter m = 1.2.3", "1: 1.2.3 is not a number"},
      {"parameter m = ", "1: expected an expression at the end of the line"},
      {"parameter class", "1: class is a word of C++ or of kanexpr; choose another name"},
      {"parameter m = 1\nparameter m = 2", "2: there are two things called m"},
      {"parameter m = n", "1: unknown symbol n"},
      {"parameter m\nparameter n = m", "2: expected a number"},
      {"origin O\ngravity O*N.x", "2: O is not a scalar"},
      {"gravity N.w", "1: the axes of frame N are N.x, N.y and N.z"},
      {"gravity B.x", "1: unknown frame B"},
      {"gravity 1 + N.x", "1: a vector and a scalar cannot be added"},
      {"gravity N.x*N.y", "1: the product of two vectors is dot(a, b) or cross(a, b)"},
      {"gravity N.x/N.y", "1: cannot divide by a vector"},
      {"gravity N.x^2", "1: vectors have no powers"},
      {"gravity 2", "1: expected a vector, such as N.x, got a scalar"},
      {"potential_energy N.x", "1: expected a scalar, got a vector"},
      {"potential_energy sin(1, 2)", "1: sin takes 1 argument, got 2"},
      {"potential_energy sine(1)", "1: unknown function sine"},
      {"particle Bob at P mass 1", "1: unknown point P"},
      {"particle Bob at N mass 1", "1: N is not a point"},
      {"origin O\noffset P from O by velocity_of(O)",
       "2: velocity_of is not available in the definitions of frames and points"},
      {pendulum + "rigid_body Rod at P in A mass 1 inertia 1, 2", "4: an inertia has 3 or 6 entries, got 2"},
      {pendulum + "body_fixed B from A by xyz: 1, 2", "4: body_fixed takes 3 angles, got 2"},
      {pendulum + "particle Bob at P mass 1\nparameter d",
       "5: parameter d is declared but not used in the system"},
      {pendulum + "particle Bob at P mass 1\noffset Q from O by 3*N.x\nloop P to Q along N.x\ndependent q, u",
       "0: the constraints determine every speed, so nothing can move"},
      {"", "0: the system has no generalized speeds"},
      {pendulum + "particle Bob at O mass 1", "1: speed u moves no mass"},
      {pendulum + "parameter m = -1\nparticle Bob at P mass m",
       "4: parameter m, the mass of a body, is negative"},
      {pendulum + "origin S\nslider T from S along N.x by x = 5, v\nparticle Bob at P mass 1\n"
                  "particle Rob at T mass 1\nconfiguration_constraint x^2 + 1 = 0\ndependent x, v",
       "0: no state near the initial values satisfies the constraints"},
  };
  for (const auto& [text, expected] : mistakes) {
    const session s(text);
    EXPECT_THAT(std::to_string(s.wrong().line) + ": " + s.wrong().sentence, testing::StartsWith(expected))
        << text;
    EXPECT_NE(s.wrong().sentence, "") << text;
  }
}

/// A pendulum with further lines.
std::string pendulum_and(const std::string& lines) {
  return "pin A on N about N.z by q, u\norigin O\noffset P from O by A.x\nparticle Bob at P mass 1\n" + lines;
}
std::string mistake_in(const std::string& text) { return session(text).wrong().sentence; }
std::string repeated(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(Playground, LimitsTheSizeOfExpressions) {
  const auto force = [](const std::string& e) {
    return mistake_in(pendulum_and("force " + e + "*N.x at P"));
  };
  const std::string too_deep = "the expression is nested more than 100 levels deep";
  EXPECT_EQ(force(repeated(132, "(") + "q" + repeated(132, ")")), too_deep);
  EXPECT_EQ(force(repeated(101, "sin(") + "q" + repeated(101, ")")), too_deep);
  EXPECT_EQ(force(repeated(1000, "-") + "q"), too_deep);
  EXPECT_EQ(force("q" + repeated(132, "^q")), too_deep);
  EXPECT_EQ(force("(q" + repeated(1001, " + q") + ")"), "the expression has more than 1000 operations");
  EXPECT_EQ(force(repeated(90, "(") + "q" + repeated(90, ")")), "");
  EXPECT_EQ(force("(q" + repeated(900, " + q") + ")"), "");
}

TEST(Playground, ReportsMistakesWithoutWordsThatTextsLack) {
  EXPECT_EQ(mistake_in(pendulum_and("parameter d")), "parameter d is declared but not used in the system");
  const std::string twice = mistake_in(pendulum_and(
      "slider S from O along N.x by x, v\nparticle Rob at S mass 1\nvelocity_constraint u = v\n"
      "slider T from O along N.x by y, w\nparticle Tom at T mass 1\nvelocity_constraint 2*u = 2*v\n"
      "dependent v, w"));
  EXPECT_THAT(twice, HasSubstr("follow"));
  EXPECT_THAT(twice, Not(HasSubstr("redundant<")));
  EXPECT_EQ(playground::in_words_of_texts(
                "configuration constraints 2 and 3 follow; add redundant<2, 3> to drop them"),
            "configuration constraints 2 and 3 follow; leave them out");
}

TEST(Playground, RefusesAStartThatViolatesAVelocityConstraint) {
  const std::string sliders = "origin O\nslider S from O along N.x by x, v\nparticle Bob at S mass 1\n"
                              "slider T from O along N.y by y, u\nparticle Rob at T mass 1\n";
  EXPECT_EQ(mistake_in(sliders + "velocity_constraint x*u = 1\ndependent u"),
            "no state near the initial values satisfies the constraints");
  session s(sliders + "velocity_constraint (x + 2)*u = 1\ndependent u");
  ASSERT_EQ(s.wrong().sentence, "");
  EXPECT_NEAR(s.moving().x(3), 0.5, 1e-12);
}

TEST(Playground, DrawsNoFigureFarAway) {
  session s("origin O\nslider P from O along N.x by x, v\nparticle Bob at P mass 1");
  for (const double x : {std::nan(""), HUGE_VAL, 1e200, 1e9}) {
    s.moving().x(0) = x;
    EXPECT_EQ(s.figure().svg(true), "") << x;
  }
  s.moving().x(0) = 1;
  EXPECT_THAT(s.figure().svg(true), HasSubstr("<svg"));
}

TEST(Playground, RefusesNamesThatMeanSomethingElseInCpp) {
  for (const char* name : {"class", "alignas", "co_await", "char8_t", "nullptr", "and_eq", "static_cast",
                           "NULL", "EOF", "NAN", "INFINITY", "errno", "M_PI", "sin", "System", "requires"})
    EXPECT_EQ(mistake_in("parameter " + std::string(name)),
              std::string(name) + " is a word of C++ or of kanexpr; choose another name");
  for (const char* name : {"state", "time", "y0", "index", "t", "std", "point"})
    EXPECT_THAT(mistake_in("parameter " + std::string(name)), Not(HasSubstr("choose another"))) << name;
}

TEST(Playground, WritesTypesThatCompile) {
  session s(pendulum_and("force -(-q)*N.x at P\nforce --u*N.y at P"));
  ASSERT_EQ(s.wrong().sentence, "");
  const std::string header = playground::write_words(s, "class").all[0].text;
  EXPECT_THAT(header, HasSubstr("force<P, -(-q)*N::x>, force<P, -(-u)*N::y>"));
  EXPECT_THAT(header, HasSubstr("namespace class_ {"));
  for (const char* name : {"std", "main", "time", "kanexpr"})
    EXPECT_EQ(playground::namespace_called(name), std::string(name) + '_');
  EXPECT_EQ(playground::namespace_called("crane"), "crane");
  s.moving().x(0) = std::nan("");
  EXPECT_EQ(playground::write_words(s, "pendulum").mistake,
            "the value of q is not finite; go back to the start");
}

TEST(Playground, WritesEachTypeAfterThoseThatItNames) {
  session s("origin O\noffset P from O by 0.1*N.x\npin A on N about N.z by q, u\nfixed P in A\n"
            "offset G from O by A.x\nparticle Bob at G mass 1\nparticle Rob at P mass 1");
  ASSERT_EQ(s.wrong().sentence, "");
  const std::string header = playground::write_words(s, "model").all[0].text;
  EXPECT_LT(header.find("struct A :"), header.find("struct P :"));
  playground::structs circle;
  circle.add("P", "offset<P, O, A::x>");
  circle.add("A", "rotated<A, N, q, N::z>, angular_velocity<N, u*B::z>");
  circle.add("B", "rotated<B, A, r, A::z>");
  EXPECT_EQ(circle.mistake(),
            "A is given in terms of B, which follows from it; C++ types cannot name each other");
}

TEST(Playground, ConservesEnergyAndConstraints) {
  for (const char* name :
       {"pendulum", "double_pendulum", "cart_pole", "spring_pendulum", "gyroscope", "four_bar", "sleigh"}) {
    session s(example(name));
    ASSERT_EQ(s.wrong().sentence, "") << name;
    const double before = s.moving().energy().sum();
    EXPECT_EQ(s.moving().advance(2, 1e-3), "") << name;
    EXPECT_NEAR(s.moving().energy().sum(), before, 1e-6 * std::abs(before)) << name;
    EXPECT_NEAR(s.moving().t, 2, 1e-12) << name;
  }
}

TEST(Playground, DragsAPointAlongTheConstraints) {
  session s(example("four_bar"));
  const Eigen::Vector2d start = s.figure().points().col(1), target = start + Eigen::Vector2d(25, 3);
  s.figure().drag(1, target(0), target(1));
  const Eigen::Vector2d end = s.figure().points().col(1);
  EXPECT_LT((end - target).norm(), 0.5 * (start - target).norm());
  const auto closed = s.figure().points(); // Q and R
  EXPECT_LT((closed.col(2) - closed.col(4)).norm(), 1e-6);
  EXPECT_EQ(s.moving().x.tail(3).norm(), 0);
}

TEST(Playground, DrawsTheFigureAtAFixedScale) {
  session s(example("pendulum"));
  const Eigen::Vector2d before = s.figure().points().col(1);
  EXPECT_THAT(s.figure().svg(true), HasSubstr("Bob"));
  EXPECT_THAT(s.figure().svg(false), Not(HasSubstr("Bob")));
  s.moving().x(0) = 0;
  EXPECT_NEAR(s.figure().points().col(1).norm(), before.norm(), 1e-12);
  EXPECT_TRUE(s.figure().is_planar());
  session spatial(example("gyroscope"));
  EXPECT_FALSE(spatial.figure().is_planar());
}

/// A header without the values at its end, whose last digits depend on the compiler.
std::string words_in(const std::string& header) {
  return header.substr(0, header.find("\n// at the moment"));
}

/// Compares the mass matrix and the forcing of a model with those of its compiled types at random states.
template <class System>
void compare_with(const std::string& name, const std::string& text) {
  session s(text);
  ASSERT_EQ(s.wrong().sentence, "");
  EXPECT_EQ(words_in(playground::write_words(s, name).all[0].text),
            words_in(contents_of("tests/playground/words/" + name + ".inc")));
  auto mass = s.model().function(s.model().mass_matrix()), forcing = s.model().function(s.model().forcing());
  using eom = kanexpr::equations_of_motion<System>;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> any(0.3, 1.3);
  const auto random = [&](Eigen::Index size) {
    return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(size, [&] { return any(generator); }));
  };
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd x = random(s.moving().x.size()), p = random(s.moving().p.size()),
                          r = random(s.moving().r.size());
    const double t = any(generator);
    typename eom::state state(x);
    typename eom::parameters parameters(p);
    typename eom::inputs inputs(r);
    const Eigen::MatrixXd M = mass(t, x, p, r), f = forcing(t, x, p, r);
    const Eigen::MatrixXd compiled_mass = eom::mass_matrix(t, state, parameters, inputs),
                          compiled_forcing = eom::forcing(t, state, parameters, inputs);
    EXPECT_LT((compiled_mass - M).norm(), 1e-12 * M.norm());
    EXPECT_LT((compiled_forcing - f).norm(), 1e-12 * f.norm());
  }
}

TEST(Playground, WritesTypesWithTheSameEquations) {
  compare_with<all_words::System>("all_words", contents_of("tests/playground/words/all_words.txt"));
  compare_with<four_bar::System>("four_bar", example("four_bar"));
  compare_with<sleigh::System>("sleigh", example("sleigh"));
  EXPECT_EQ(four_bar::initial_state[four_bar::q1], 1.2);
}

} // namespace
