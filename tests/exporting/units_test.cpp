// builds: clang++ all
// Units in exported files.
#include "runtime/cart_with_units.hpp"
#include "simulations/falling_ball.hpp"
#include "units/pendulum_on_cart.hpp"

#include <kanexpr/export.hpp>
#include <kanexpr/fmi.hpp>
#include <kanexpr/robots/robot_builder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

using namespace kanexpr;
using namespace exporting;
using testing::HasSubstr;
using testing::Not;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  return all.str();
}

struct units_in_files : testing::Test {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "kanexpr_units_in_files_test";
  void SetUp() override { std::filesystem::remove_all(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
};

TEST_F(units_in_files, are_comments_in_c) {
  const cart_with_units cart;
  c_options chosen{.with_python = true, .with_cpp = true};
  chosen.functions.push_back(results("kinetic_energy"));
  chosen.functions.push_back(results("linear_momentum"));
  chosen.functions.push_back(results("runge_kutta_4"));
  chosen.functions.push_back(exporting::expression("tension", cart.k * cart.s));
  chosen.functions.push_back(exporting::expression("free", cart.w * cart.s));
  ASSERT_TRUE(write_c(cart, folder, "cart", chosen));
  const std::string header = text_of(folder / "cart.h");
  EXPECT_THAT(
      header,
      HasSubstr(
          R"(/* Indices in the state x (coordinates, then speeds), in the parameters p and in the inputs r.
   Each comment is the unit of the entry; the time t is in s. */
enum {
  cart_s = 0, /* m */
  cart_q = 1, /* rad */
  cart_v = 2, /* m/s */
  cart_u = 3, /* rad/s */
  cart_m = 0, /* kg */
  cart_l = 1, /* m */
  cart_g = 2, /* m/s2 */
  cart_k = 3, /* N/m */
  cart_c = 4, /* N.m.s/rad */
  cart_w = 5,
  cart_F = 0, /* N */
  cart_coordinates = 2,
)"));
  EXPECT_THAT(
      header,
      HasSubstr("\n   mass_matrix: 2 by 2, row-major; the rows belong to v, u; in kg, kg.m, kg.m, kg.m2."
                "\n   forcing: 2, of v, u; in N, N.m."));
  EXPECT_THAT(header, HasSubstr("\n   udot: 2, of v, u; in m/s2, rad/s2."));
  EXPECT_THAT(header, HasSubstr("\n   kinetic_energy: 1; in J."));
  EXPECT_THAT(header, HasSubstr("\n   linear_momentum: 3; in kg.m/s."));
  EXPECT_THAT(header, HasSubstr("\n   tension: 1; in N."));
  EXPECT_THAT(header, HasSubstr("\n   free: 1."));
  EXPECT_THAT(header, HasSubstr("; in m, rad, m/s, rad/s.\n")) << "a step";
  EXPECT_THAT(text_of(folder / "cart.hpp"),
              HasSubstr("  double m = std::numeric_limits<double>::quiet_NaN(); // kg\n"));
  EXPECT_THAT(text_of(folder / "cart.hpp"), HasSubstr("  double q = 0; // rad\n"));
  EXPECT_THAT(text_of(folder / "cart.py"), HasSubstr(R"(
inputs = ("F",)
units = {
    "s": "m",
    "q": "rad",
    "v": "m/s",
    "u": "rad/s",
    "m": "kg",
    "l": "m",
    "g": "m/s2",
    "k": "N/m",
    "c": "N.m.s/rad",
    "F": "N",
}

_library)"));
}

TEST_F(units_in_files, are_inferred_for_a_model_given_as_types) {
  using namespace pendulum_on_cart;
  const options chosen{{exporting::expression<velocity_of<P>>("speed_of_bob"), results("mass_matrix"),
                        exporting::expression<l * m>("moment")},
                       {{"g", 9.81}}};
  const exported_system cart = exported_from<System>("cart", chosen).system;
  const auto texts = [](const std::vector<exported_unit>& all) {
    return joined(all, " ", [](const exported_unit& each) { return each.text; });
  };
  EXPECT_EQ(texts(cart.units_of_states), "m rad m/s rad/s");
  EXPECT_EQ(texts(cart.units_of_parameters), "kg m N/m") << "without the bound one";
  EXPECT_EQ(texts(cart.units_of_inputs), "N");
  EXPECT_EQ(texts(cart.function("speed_of_bob")->results[0].units), "m/s m/s m/s");
  EXPECT_EQ(texts(cart.function("mass_matrix")->results[0].units), "kg kg.m kg.m kg.m2");
  EXPECT_EQ(texts(cart.function("moment")->results[0].units), "kg.m");

  const requested_function residual{
      .name = "residual",
      .results = {{.name = "residual",
                   .request = {.what = derivation::request::kind::result, .wanted = mechanics::quantity::rhs},
                   .is_residual = true}}};
  EXPECT_EQ(texts(exported_from<System>("cart", {{residual}}).system.function("residual")->results[0].units),
            "m/s rad/s N N.m");

  const exported_system plain = exported_from<falling_ball::System>("plain").system;
  EXPECT_FALSE(plain.states_units);
  EXPECT_THAT(plain.units_of_states, testing::IsEmpty());
  for (const exported_function& f : plain.functions) EXPECT_THAT(f.results[0].units, testing::IsEmpty());
}

// The formats of robots define the units.
TEST_F(units_in_files, are_those_of_a_robot) {
  robots::robot arm;
  arm.links = {{.name = "ground"},
               {.name = "upper", .inertial = robots::inertial{2, {}, {1, 1, 1}}},
               {.name = "slider", .inertial = robots::inertial{1, {}, {1, 1, 1}}}};
  arm.joints.resize(2);
  arm.joints[0].name = "turn", arm.joints[0].kind = robots::joint_kind::continuous;
  arm.joints[0].parent = 0, arm.joints[0].child = 1, arm.joints[0].damping = 0.1;
  arm.joints[1].name = "slide", arm.joints[1].kind = robots::joint_kind::prismatic;
  arm.joints[1].parent = 1, arm.joints[1].child = 2;
  arm.root = 0;
  const robots::robot_builder built(arm, {.bind = robots::binding::parameters});
  ASSERT_EQ(built.cause(), "");
  ASSERT_TRUE(write_c(built, folder, "arm"));
  const std::string header = text_of(folder / "arm.h");
  for (const char* line :
       {"  arm_q_turn = 0, /* rad */\n", "  arm_q_slide = 1, /* m */\n", "/* rad/s */\n",
        "  arm_T_turn = 0, /* N.m */\n", "  arm_F_slide = 1, /* N */\n", "_m_Upper = 1, /* kg */\n"})
    EXPECT_THAT(header, HasSubstr(line));
  EXPECT_THAT(header, HasSubstr("forcing: 2, of u_turn, u_slide; in N.m, N."));
}

TEST_F(units_in_files, are_those_of_variables_in_an_fmu) {
  const cart_with_units cart;
  fmu_options chosen{.bound = {{"l", 0.5}}, .compiler = ""};
  chosen.start = {{"m", 2}, {"g", 9.81}, {"k", 5}, {"c", 0.1}, {"w", 1}};
  chosen.outputs = {results("kinetic_energy"), results("center_of_mass"),
                    exporting::expression("tension", cart.k * cart.s)};
  chosen.events = {exporting::when("end", cart.s - cart.l)};
  runtime::staged_derivation derivation([&] { return runtime::derive_in_own_graph(cart); });
  const made_fmu made = fmu_maker("cart", derivation, chosen).run();
  ASSERT_EQ(made.mistake, "");
  const std::string xml = texts_of(made.of).description;
  EXPECT_THAT(xml, HasSubstr(R"(
    <UnitDefinitions>
        <Unit name="J">
            <BaseUnit kg="1" m="2" s="-2"/>
        </Unit>
        <Unit name="N">
            <BaseUnit kg="1" m="1" s="-2"/>
        </Unit>
        <Unit name="N.m.s/rad">
            <BaseUnit kg="1" m="2" s="-1" rad="-1"/>
        </Unit>
        <Unit name="N/m">
            <BaseUnit kg="1" s="-2"/>
        </Unit>
        <Unit name="kg">
            <BaseUnit kg="1"/>
        </Unit>
        <Unit name="m">
            <BaseUnit m="1"/>
        </Unit>
        <Unit name="m/s">
            <BaseUnit m="1" s="-1"/>
        </Unit>
        <Unit name="m/s2">
            <BaseUnit m="1" s="-2"/>
        </Unit>
        <Unit name="rad">
            <BaseUnit rad="1"/>
        </Unit>
        <Unit name="rad/s">
            <BaseUnit s="-1" rad="1"/>
        </Unit>
        <Unit name="rad/s2">
            <BaseUnit s="-2" rad="1"/>
        </Unit>
        <Unit name="s">
            <BaseUnit s="1"/>
        </Unit>
    </UnitDefinitions>
    <LogCategories>)"));
  const auto has = [&](const std::string& name, const std::string& unit) {
    const std::size_t at = xml.find("<Float64 name=\"" + name + '"');
    ASSERT_NE(at, xml.npos) << name;
    const std::string line = xml.substr(at, xml.find('>', at) - at);
    if (unit.empty())
      EXPECT_THAT(line, Not(HasSubstr("unit="))) << name;
    else
      EXPECT_THAT(line, HasSubstr(" unit=\"" + unit + '"')) << name;
  };
  has("time", "s"), has("q", "rad"), has("der(u)", "rad/s2"), has("der(s)", "m/s"), has("c", "N.m.s/rad");
  has("w", ""), has("F", "N"), has("kinetic_energy", "J"), has("center_of_mass[2]", "m");
  has("tension", "N"), has("end", "m");
}

} // namespace
