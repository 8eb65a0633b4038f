// builds: clang++ all
// The words of tyres, compared with a builder. The systems are derived at run time; their power is in
// mechanics/loads/elements_test.cpp.
#include <kanexpr/joints.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/read_tir.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/tyres.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

namespace {

using namespace kanexpr;
using Eigen::VectorXd;
using runtime::tyre_data;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr coordinate<"z"> z;
constexpr coordinate<"yaw"> yaw;
constexpr coordinate<"lean"> lean;
constexpr coordinate<"spin"> spin;
constexpr speed<"ux"> ux;
constexpr speed<"uy"> uy;
constexpr speed<"uz"> uz;
constexpr speed<"uyaw"> uyaw;
constexpr speed<"ulean"> ulean;
constexpr speed<"uspin"> uspin;
constexpr parameter<"mu"> mu;
constexpr parameter<"C"> stiffness;
constexpr parameter<"v0"> v0;
constexpr parameter<"Fz"> load_given;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Yawed : rotated<Yawed, N, yaw, N::z> {};
struct Leaning : rotated<Leaning, Yawed, lean, Yawed::x> {};
struct Rolling : rotated<Rolling, Leaning, spin, Leaning::y> {};
struct Hub : offset<Hub, O, x * N::x + y * N::y + z * N::z> {};
struct Wheel : rigid_body<Wheel, Hub, Rolling, 12, inertia<Rolling, 0.3, 0.5, 0.3>> {};

using rim = toroidal_wheel<Hub, Leaning::y, 0.25, 0.05, Rolling>;
using street = flat_ground<O, N::z>;

template <class... Loads>
struct wheel_alone
    : kane_system<inertial<N>, coordinates<x, y, z, yaw, lean, spin>, speeds<ux, uy, uz, uyaw, ulean, uspin>,
                  kinematics<dot(x) == ux, dot(y) == uy, dot(z) == uz, dot(yaw) == uyaw, dot(lean) == ulean,
                             dot(spin) == uspin>,
                  parameters<mu, stiffness, v0, load_given>, used_elsewhere<mu, stiffness, v0, load_given>,
                  bodies<Wheel>, loads<Loads...>> {};

// The same system from a builder.
struct built : runtime::builder {
  mechanics::expression turned = coordinate("x"), aside = coordinate("y"), height = coordinate("z"),
                        heading = coordinate("yaw"), leaning = coordinate("lean"), angle = coordinate("spin"),
                        friction = parameter("mu"), elastic = parameter("C"), slow = parameter("v0"),
                        weight = parameter("Fz");
  runtime::frame_id n = inertial_frame(), b{}, l{};
  runtime::point_id o{}, hub{};

  built() : builder("N") {
    kinematic_equation(dot(turned) - speed("ux"));
    kinematic_equation(dot(aside) - speed("uy"));
    kinematic_equation(dot(height) - speed("uz"));
    kinematic_equation(dot(heading) - speed("uyaw"));
    kinematic_equation(dot(leaning) - speed("ulean"));
    kinematic_equation(dot(angle) - speed("uspin"));
    const auto yawed = rotated("Yawed", n, heading, along(n, 0, 0, 1));
    l = rotated("Leaning", yawed, leaning, along(yawed, 1, 0, 0));
    b = rotated("Rolling", l, angle, along(l, 0, 1, 0));
    o = origin("O");
    hub = offset("Hub", o, along(n, turned, aside, height));
    rigid_body("Wheel", hub, b, number(12), inertia(b, 0.3, 0.5, 0.3));
    for (const auto& e : {friction, elastic, slow, weight}) used_elsewhere(e);
  }

  runtime::wheel_on_ground wheel() {
    return wheel_on_plane({hub, b, along(l, 0, 1, 0), 0.25, 0.05}, o, along(n, 0, 0, 1));
  }
};

void expect_same(model words, model builds, int states) {
  ASSERT_EQ(words.mistake(), "");
  ASSERT_EQ(builds.mistake(), "");
  auto first = words.function(words.rhs()), second = builds.function(builds.rhs());
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> values(0.1, 0.6);
  for (int i = 0; i < 10; ++i) {
    const VectorXd state = VectorXd::NullaryExpr(states, [&] { return values(source); });
    const VectorXd p = VectorXd::NullaryExpr(4, [&] { return 1 + values(source); });
    ASSERT_TRUE(first(state, p).allFinite());
    EXPECT_LT((first(state, p) - second(state, p)).norm(), 1e-13 * first(state, p).norm());
  }
}

TEST(tyre_words, of_a_linear_tyre_with_relaxation_lengths) {
  using words =
      wheel_alone<tyre<rim, street, linear_tyre<3 * stiffness, stiffness>, camber_stiffness<0.1 * stiffness>,
                       relaxation<0.2, 0.4>, standstill<v0>, pneumatic_trail<0.03>>>;
  built s;
  tyre_data t = tyre_data::linear(3 * s.elastic, s.elastic);
  t.camber_stiffness = 0.1 * s.elastic, t.standstill = s.slow, t.trail = 0.03;
  t.relaxation = {0.2, 0.4, s.state_variable("dx_Hub"), s.state_variable("dy_Hub")};
  s.tyre(s.wheel(), t);
  expect_same(derive<words>(), derive(s), 14);
}

// The forces are those that act on the wheel; the slips follow from their definitions.
TEST(tyre_words, slips_and_forces_as_results) {
  using Tyre =
      tyre<rim, street, linear_tyre<3 * stiffness, stiffness>, radial_stiffness<1e4, 0.1, 1e-4>,
           camber_stiffness<0.1 * stiffness>, standstill<v0>, pneumatic_trail<0.03>, effective_radius<0.29>>;
  model m = derive<wheel_alone<Tyre>>();
  ASSERT_EQ(m.mistake(), "");
  auto acting = m.function(m.active_forces());
  auto all = [&] {
    symbolic::matrix wanted(m.graph(), 7, 1);
    const symbolic::matrix each[]{m.get<normal_force_of<Tyre>>(),      m.get<longitudinal_force_of<Tyre>>(),
                                  m.get<lateral_force_of<Tyre>>(),     m.get<aligning_moment_of<Tyre>>(),
                                  m.get<longitudinal_slip_of<Tyre>>(), m.get<lateral_slip_of<Tyre>>(),
                                  m.get<sine_of_camber_of<Tyre>>()};
    for (int i = 0; i < 7; ++i) wanted(i, 0) = each[i](0, 0);
    return m.function(wanted);
  }();
  std::mt19937_64 source(3);
  std::uniform_real_distribution<double> values(0.1, 0.6);
  const double mu_given = 0.8, c = 500, slow = 0.1;
  const VectorXd p{{mu_given, c, slow, 0.0}};
  for (int i = 0; i < 10; ++i) {
    VectorXd s = VectorXd::NullaryExpr(12, [&] { return values(source); });
    s(2) = 0.28, s(4) = i % 2 == 0 ? 0 : 0.2 * s(4), s(6) *= 20, s(11) *= 60;
    const VectorXd f = acting(s, p), q = all(s, p);
    const double cosine = std::cos(s(3)), sine = std::sin(s(3));
    EXPECT_NEAR(f(0), q(1) * cosine - q(2) * sine, 1e-11 * f.norm());
    EXPECT_NEAR(f(1), q(1) * sine + q(2) * cosine, 1e-11 * f.norm());
    EXPECT_NEAR(f(2), q(0), 1e-11 * f.norm());
    EXPECT_NEAR(q(6), std::sin(s(4)), 1e-15);
    if (s(4) > 0) continue;
    EXPECT_NEAR(f(3), q(3), 1e-11 * f.norm());
    const double ahead = s(6) * cosine + s(7) * sine, to_left = s(7) * cosine - s(6) * sine;
    const double speed = std::hypot(ahead, slow), tangent = (to_left + 0.28 * s(10)) / speed;
    EXPECT_NEAR(q(4), (0.29 * s(11) - ahead) / speed, 1e-13);
    EXPECT_NEAR(q(5), tangent, 1e-13);
    EXPECT_NEAR(q(1), 3 * c * q(4), 1e-10);
    EXPECT_NEAR(q(2), -c * tangent, 1e-10);
    EXPECT_NEAR(q(3), 0.03 * c * tangent, 1e-10);
  }
}

// The same results from a builder.
TEST(tyre_words, results_in_a_builder) {
  using Tyre = tyre<rim, street, brush_tyre<mu, stiffness>, wheel_load<load_given * x>, standstill<v0>,
                    pneumatic_trail<0.02>>;
  model words = derive<wheel_alone<Tyre>>();
  built s;
  tyre_data t = tyre_data::brush(s.friction, s.elastic);
  t.load = s.weight * s.turned, t.standstill = s.slow, t.trail = 0.02;
  s.tyre(s.wheel(), t);
  mechanics::known_motion known(s.mechanism());
  const runtime::tyre_forces f = s.forces_of_tyre(1, known);
  const std::pair<symbolic::matrix, symbolic::expression> each[]{
      {words.get<normal_force_of<Tyre>>(), f.load},
      {words.get<longitudinal_force_of<Tyre>>(), f.longitudinal_force},
      {words.get<lateral_force_of<Tyre>>(), f.lateral_force},
      {words.get<aligning_moment_of<Tyre>>(), f.aligning_moment},
      {words.get<longitudinal_slip_of<Tyre>>(), f.longitudinal_slip},
      {words.get<lateral_slip_of<Tyre>>(), f.lateral_slip},
      {words.get<sine_of_camber_of<Tyre>>(), f.sine_of_camber}};
  model builds = derive(s);
  ASSERT_EQ(builds.mistake(), "");
  for (const auto& [word, value] : each) {
    symbolic::matrix one(s.graph(), 1, 1);
    one(0, 0) = value;
    auto first = words.function(word), second = builds.function(one);
    std::mt19937_64 source(7);
    std::uniform_real_distribution<double> values(-0.6, 0.6);
    int acting = 0;
    for (int i = 0; i < 20; ++i) {
      VectorXd state = VectorXd::NullaryExpr(12, [&] { return values(source); });
      state(0) = std::abs(state(0)), state(2) = 0.3 + 0.2 * state(2); // the load is proportional to x
      const VectorXd p = VectorXd::NullaryExpr(4, [&] { return 1 + values(source); });
      const double wanted = first(state, p)(0);
      acting += std::abs(wanted) > 0; // a tyre that slides has no aligning moment
      EXPECT_NEAR(second(state, p)(0), wanted, 1e-13 * std::abs(wanted));
    }
    EXPECT_GE(acting, 10);
  }
  s.forces_of_tyre(2, known);
  EXPECT_EQ(s.mistake().view(), "the forces of tyre 2 are requested, but the number of tyres is 1");
}

TEST(tyre_words, of_brush_tyres) {
  using words = wheel_alone<tyre<rim, street, brush_tyre<mu, stiffness>, wheel_load<load_given * x>,
                                 standstill<v0>, effective_radius<0.29>, relaxation<0.2, 0.4>>>;
  built s;
  tyre_data t = tyre_data::brush(s.friction, s.elastic);
  t.load = s.weight * s.turned, t.standstill = s.slow, t.effective_radius = 0.29;
  t.relaxation = {0.2, 0.4, s.state_variable("dx_Hub"), s.state_variable("dy_Hub")};
  s.tyre(s.wheel(), t);
  expect_same(derive<words>(), derive(s), 14);

  using on_spring =
      wheel_alone<tyre<rim, street, brush_tyre<mu, stiffness, 2 * stiffness>,
                       radial_stiffness<1e3, 0.1, 0.01>, standstill<v0>, pneumatic_trail<0.02>>>;
  built other;
  tyre_data r = tyre_data::brush(other.friction, other.elastic, 2 * other.elastic);
  r.radial = {1e3, 0.1, 0.01}, r.standstill = other.slow, r.trail = 0.02;
  other.tyre(other.wheel(), r);
  expect_same(derive<on_spring>(), derive(other), 12);
}

inline constexpr tyre_coefficients slick{.Fz0 = 4000,
                                         .R0 = 0.3,
                                         .pCx1 = 1.6,
                                         .pDx1 = mu,
                                         .pKx1 = 20,
                                         .rBx1 = 10,
                                         .rCx1 = 1,
                                         .pCy1 = 1.3,
                                         .pDy1 = mu,
                                         .pKy1 = -15,
                                         .pKy2 = 1.5,
                                         .pKy4 = 2,
                                         .rBy1 = 8,
                                         .rCy1 = 1.1,
                                         .qBz1 = 9,
                                         .qBz9 = 10,
                                         .qCz1 = 1.2,
                                         .qDz1 = 0.1,
                                         .qDz8 = -0.3,
                                         .qsx2 = 0.5,
                                         .qsy1 = 0.01};

TEST(tyre_words, of_a_magic_formula) {
  using words = wheel_alone<
      tyre<rim, street, kanexpr::magic_formula<slick>, wheel_load<load_given * x>, standstill<v0>>>;
  built s;
  tyre_data t = tyre_data::of_formula({.Fz0 = 4000,
                                       .R0 = 0.3,
                                       .pCx1 = 1.6,
                                       .pDx1 = s.friction,
                                       .pKx1 = 20,
                                       .rBx1 = 10,
                                       .rCx1 = 1,
                                       .pCy1 = 1.3,
                                       .pDy1 = s.friction,
                                       .pKy1 = -15,
                                       .pKy2 = 1.5,
                                       .pKy4 = 2,
                                       .rBy1 = 8,
                                       .rCy1 = 1.1,
                                       .qBz1 = 9,
                                       .qBz9 = 10,
                                       .qCz1 = 1.2,
                                       .qDz1 = 0.1,
                                       .qDz8 = -0.3,
                                       .qsx2 = 0.5,
                                       .qsy1 = 0.01});
  t.load = s.weight * s.turned, t.standstill = s.slow;
  s.tyre(s.wheel(), t);
  expect_same(derive<words>(), derive(s), 12);
}

// The keys of .tir files, in the order of the coefficients.
constexpr const char* keys_of_tir =
    "FNOMIN UNLOADED_RADIUS LONGVL PCX1 PDX1 PDX2 PDX3 PEX1 PEX2 PEX3 PEX4 PKX1 PKX2 PKX3 PHX1 "
    "PHX2 PVX1 PVX2 PPX1 PPX2 PPX3 PPX4 RBX1 RBX2 RBX3 RCX1 REX1 REX2 RHX1 PCY1 PDY1 PDY2 PDY3 "
    "PEY1 PEY2 PEY3 PEY4 PEY5 PKY1 PKY2 PKY3 PKY4 PKY5 PKY6 PKY7 PHY1 PHY2 PVY1 PVY2 PVY3 PVY4 "
    "PPY1 PPY2 PPY3 PPY4 PPY5 RBY1 RBY2 RBY3 RBY4 RCY1 REY1 REY2 RHY1 RHY2 RVY1 RVY2 RVY3 RVY4 "
    "RVY5 RVY6 QBZ1 QBZ2 QBZ3 QBZ5 QBZ6 QBZ9 QBZ10 QCZ1 QDZ1 QDZ2 QDZ3 QDZ4 QDZ6 QDZ7 QDZ8 QDZ9 "
    "QDZ10 QDZ11 QEZ1 QEZ2 QEZ3 QEZ4 QEZ5 QHZ1 QHZ2 QHZ3 QHZ4 PPZ1 PPZ2 SSZ1 SSZ2 SSZ3 SSZ4 QSX1 "
    "QSX2 QSX3 QSX4 QSX5 QSX6 QSX7 QSX8 QSX9 QSX10 QSX11 PPMX1 QSY1 QSY2 QSY3 QSY4 QSY5 QSY6 QSY8 "
    "INFLPRES NOMPRES QSY7 LFZO LMUX LMUY LKX LKY LCX LCY LEX LEY LHX LHY LVX LVY LKYC LKZC LTR "
    "LRES LXAL LYKA LVYKA LS LMX LVMX LMY ";

TEST(tyre_files, every_key_is_its_coefficient) {
  std::istringstream keys(keys_of_tir);
  std::string text = "[UNITS]\nLENGTH = 'meter'\n[MODEL]\nFITTYP = 61 $ the version\n[ALL_COEFFICIENTS]\n",
              key;
  int count = 0;
  while (keys >> key) text += key + " = " + std::to_string(++count) + "\n";
  const runtime::read_tyre read = runtime::read_tir_text(text);
  ASSERT_TRUE(read) << read.cause();
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(read.nominal_load, 1);
  EXPECT_EQ(read.unloaded_radius, 2);
  int place = 0;
  tyre_data::coefficients::each_member(read.coefficients, [&](const auto&... value) {
    for (const tyre_data::value& each : {value...}) {
      ASSERT_TRUE(each) << place;
      EXPECT_EQ(std::get<runtime::given_number>(each->held()).value(), ++place);
    }
  });
  EXPECT_EQ(place, count);
}

// A file as programs write it: the same model as from the coefficients.
TEST(tyre_files, of_a_magic_formula) {
  const std::string text = R"([MDI_HEADER]
FILE_TYPE = 'tir'
(COMMENTS)
{comment_string}
'any text = here'
$---------------------------------------------- units
[units]
LENGTH                   = 'meter'
FORCE                    = 'newton'
ANGLE                    = 'radians'
MASS                     = 'kg'
[INERTIA]
MASS                     = 9.3
[MODEL]
FITTYP                   = 61               $ version
TYRESIDE                 = 'Left'
LONGVL                   = 16.7
[DIMENSION]
UNLOADED_RADIUS          = 0.3
WIDTH                    = 0.2
[SHAPE]
{radial width}
 1.0    0.0
[VERTICAL]
FNOMIN                   = 4e3
VERTICAL_STIFFNESS       = 2.1e+05
[LONGITUDINAL_COEFFICIENTS]
pcx1                     = +1.6             ! lower case
PDX1                     = 1.1
PKX1                     = 20
RBX1                     = 10
RCX1                     = 1
[LATERAL_COEFFICIENTS]
PCY1 = 1.3
PDY1 = 1.1
PKY1 = -15
PKY2 = 1.5
PKY4 = 2
RBY1 = 8
RCY1 = 1.1
[ALIGNING_COEFFICIENTS]
QBZ1 = 9
QBZ4 = 0.2
QBZ9 = 10
QCZ1 = 1.2
QDZ1 = 0.1
[TURNSLIP_COEFFICIENTS]
PDXP1 = 0.4
PDXP2 = 0
)";
  const runtime::read_tyre read = runtime::read_tir_text(text, "slick.tir");
  ASSERT_TRUE(read) << read.cause();
  EXPECT_EQ(read.side, "LEFT");
  EXPECT_EQ(read.nominal_load, 4000);
  EXPECT_EQ(read.unloaded_radius, 0.3);
  EXPECT_EQ(read.radial_stiffness, 2.1e5);
  ASSERT_EQ(read.notes.size(), 2);
  EXPECT_EQ(read.notes[0], "line 43 of slick.tir: QBZ4 is ignored; the formula has no such coefficient");
  EXPECT_EQ(read.notes[1], "line 48 of slick.tir: the coefficients of turn slip are ignored");
  const auto with = [](const tyre_data::coefficients& c, built& s) {
    tyre_data t = tyre_data::of_formula(c);
    t.load = 3000, t.standstill = s.slow;
    s.tyre(s.wheel(), t);
    return derive(s);
  };
  built by_file, by_hand;
  expect_same(with(read.coefficients, by_file),
              with({.Fz0 = 4000,
                    .R0 = 0.3,
                    .V0 = 16.7,
                    .pCx1 = 1.6,
                    .pDx1 = 1.1,
                    .pKx1 = 20,
                    .rBx1 = 10,
                    .rCx1 = 1,
                    .pCy1 = 1.3,
                    .pDy1 = 1.1,
                    .pKy1 = -15,
                    .pKy2 = 1.5,
                    .pKy4 = 2,
                    .rBy1 = 8,
                    .rCy1 = 1.1,
                    .qBz1 = 9,
                    .qBz9 = 10,
                    .qCz1 = 1.2,
                    .qDz1 = 0.1},
                   by_hand),
              12);
}

TEST(tyre_files, with_mistakes) {
  const auto cause = [](const std::string& text) { return runtime::read_tir_text(text, "a.tir").cause(); };
  const std::string head = "FNOMIN = 4000\nUNLOADED_RADIUS = 0.3\nFITTYP = 62\n";
  EXPECT_EQ(cause(head), "");
  EXPECT_EQ(cause("UNLOADED_RADIUS = 0.3"), "a.tir: FNOMIN, the nominal load, is missing");
  EXPECT_EQ(cause("FNOMIN = 3"), "a.tir: UNLOADED_RADIUS is missing");
  EXPECT_EQ(cause("FNOMIN = -3"), "line 1 of a.tir: FNOMIN is not positive");
  EXPECT_EQ(cause(head + "PCX1 = 1.6e"), "line 4 of a.tir: PCX1 is 1.6e, which is not a finite number");
  EXPECT_EQ(cause(head + "PCX1 = nan"), "line 4 of a.tir: PCX1 is nan, which is not a finite number");
  EXPECT_EQ(cause(head + "PCX1 = 1\nPCX1 = 1"), "line 5 of a.tir: PCX1 is given twice, first in line 4");
  EXPECT_EQ(cause(head + "PCX1 1"), "line 4 of a.tir: expected KEY = value, got PCX1 1");
  EXPECT_EQ(cause(head + "[UNITS]\nLENGTH = 'mm'"),
            "line 5 of a.tir: the unit of LENGTH is MM; it must be METER");
  EXPECT_EQ(cause(head + "TYRESIDE = 'middle'"),
            "line 4 of a.tir: TYRESIDE is MIDDLE; it must be LEFT, RIGHT or SYMMETRIC");
  EXPECT_EQ(cause("FITTYP = 6"), "line 1 of a.tir: FITTYP is 6; only 60, 61 and 62, the versions 6.0 to 6.2 "
                                 "of the Magic Formula, can be read");
  EXPECT_EQ(runtime::read_tir("/nowhere/a.tir").cause(), "/nowhere/a.tir cannot be read");
  EXPECT_EQ(runtime::read_tir("/tmp").cause(), "/tmp cannot be read"); // a folder
  const runtime::read_tyre old = runtime::read_tir_text("FNOMIN = 4000\nUNLOADED_RADIUS = 0.3\n", "a.tir");
  ASSERT_EQ(old.notes.size(), 1);
  EXPECT_EQ(old.notes[0], "a.tir: FITTYP is missing; the coefficients are taken as those of version 6.1");
}

} // namespace
