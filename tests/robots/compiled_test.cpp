// builds: clang++ all
// Robots written by kanexpr_add_robot and derived by the compiler, compared with results of Pinocchio.
#include "robots/files.hpp"

#include <arm_robot.hpp>
#include <arm_with_friction.hpp>
#include <balancer.hpp>
#include <balancer_with_symbols.hpp>
#include <floating.hpp>
#include <gripper_robot.hpp>
#include <gripper_with_numbers.hpp>

#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace {

using namespace kanexpr;

template <class Vector>
Vector filled(const std::vector<double>& numbers) {
  Vector v;
  EXPECT_EQ(static_cast<std::size_t>(v.size()), numbers.size());
  std::ranges::copy(numbers, v.data());
  return v;
}

template <class Matrix>
void expect_equal(const Matrix& ours, const std::vector<double>& theirs) {
  double largest = 0;
  for (double e : theirs) largest = std::max(largest, std::abs(e));
  for (Eigen::Index i = 0; i < ours.size(); ++i)
    EXPECT_NEAR(ours(i / ours.cols(), i % ours.cols()), theirs[static_cast<std::size_t>(i)], 1e-12 * largest)
        << i;
}

template <class System>
void agrees(const std::string& robot, const parameter_values<System>& p) {
  using eom = equations_of_motion<System>;
  const auto references = robot_files::references_of(robot);
  ASSERT_EQ(references.size(), 2u);
  for (const robot_files::reference& there : references) {
    const auto x = filled<state<System>>(there.at("state"));
    const auto r = filled<input_values<System>>(there.at("inputs"));
    const auto [mass, forcing] = eom::together(eom::mass_matrix, eom::forcing)(x, p, r);
    expect_equal(mass, there.at("mass"));
    expect_equal(forcing, there.at("forcing"));
  }
}

TEST(compiled_robots, agree_with_pinocchio) {
  agrees<arm_robot::System>("arm.fixed", {});
  agrees<::floating::System>("walker.floating", {});
  agrees<gripper_robot::System>("gripper.fixed", gripper_robot::values());
}

// Links without gravity, compared with the run-time model.
TEST(compiled_robots, let_links_without_gravity_float) {
  const robots::read_robot read = robots::read_urdf(robot_files::path_of("balancer.urdf"));
  ASSERT_TRUE(read) << read.cause();
  const robots::robot_builder built(read.robot);
  model there = derive(built);
  auto udot = there.function(there.udot());
  Eigen::Vector<double, 6> x;
  x << 0.4, -1.1, 0.3, 0.7, -0.2, 0.9;
  const Eigen::Vector3d r(0.5, 0.3, -0.8);
  const Eigen::Vector3d wanted = udot(x, Eigen::VectorXd(), r);
  using by_numbers = equations_of_motion<::balancer::System>;
  using by_symbols = equations_of_motion<::balancer_with_symbols::System>;
  EXPECT_LT((by_numbers::udot(x, by_numbers::parameters(), r) - wanted).norm(), 1e-12 * wanted.norm());
  EXPECT_LT((by_symbols::udot(x, ::balancer_with_symbols::values(), r) - wanted).norm(),
            1e-12 * wanted.norm());
}

// A joint of the arm takes two lines, and merged links remain available.
TEST(compiled_robots, can_be_asked_for_their_links) {
  state<arm_robot::System> x = arm_robot::at_rest();
  x[arm_robot::q_waist] = 0.3, x[arm_robot::u_waist] = 2;
  const Eigen::Vector3d v = function<arm_robot::System, velocity_of<arm_robot::Tool>>{}(x);
  EXPECT_NEAR(v.z(), 0, 1e-15);
  EXPECT_GT(v.norm(), 0.1);
  EXPECT_EQ(arm_robot::limits::effort[1], 60);
  EXPECT_EQ(::floating::at_rest()[::floating::e0], 1);
}

std::string text_of_units(const mechanics::unit_table& of) {
  std::ostringstream text;
  text << of;
  return text.str();
}

// URDF defines the units of all quantities.
TEST(compiled_robots, know_their_units) {
  using namespace units::si;
  using eom = equations_of_motion<arm_robot::System>;
  static_assert(units_of(eom::udot, arm_robot::u_waist) == radian / pow<2>(second));
  static_assert(units_of(eom::mass_matrix, arm_robot::u_waist, arm_robot::u_elbow) ==
                kilogram * pow<2>(meter));
  static_assert(units_of<arm_robot::System>(velocity_of<arm_robot::Tool>) == meter / second);
  static_assert(units_of(regressor<arm_robot::System>::matrix, 0, 1) == meter / pow<2>(second));
  static_assert(regressor<arm_robot::System>::units[10] == kilogram);
  EXPECT_NE(compiled::stated_units_of<arm_robot::System>(), nullptr); // for tables and pages
  EXPECT_EQ(
      text_of_units(units_of<arm_robot::System>()),
      "q_waist [rad]\nq_shoulder_pitch [rad]\nq_elbow [rad]\nu_waist [rad/s]\nu_shoulder_pitch [rad/s]\n"
      "u_elbow [rad/s]\nT_waist [N m]\nT_shoulder_pitch [N m]\nT_elbow [N m]\n");
  EXPECT_EQ(text_of_units(units_of<gripper_robot::System>()).substr(0, 159),
            "q_lift [m]\nq_left_slide [m]\nu_lift [m/s]\nu_left_slide [m/s]\nm_Hand [kg]\nx_Hand [m]\n"
            "y_Hand [m]\nz_Hand [m]\nixx_Hand [kg m²]\niyy_Hand [kg m²]\nizz_Hand [kg m²]\n");
  const mechanics::unit_table of_walker = units_of<::floating::System>();
  EXPECT_EQ(of_walker.of("px"), meter);
  EXPECT_EQ(of_walker.of("e0"), dimensionless);
  EXPECT_EQ(of_walker.of("vx"), meter / second);
  EXPECT_EQ(of_walker.of("wx"), radian / second);
}

constexpr input<"push", units::si::newton> push;
constexpr input<"drive"> drive;
constexpr parameter<"k"> k;

template <class System>
std::string mistake_of() {
  derivation::derived_system d(System::record);
  d.check_model();
  return std::string(d.mistake().view());
}

// The numbers of a robot have units, too: dampings, dry friction, gears of joints that follow others,
// weights.
TEST(compiled_robots, work_with_words_that_state_units) {
  using namespace units::si;
  using Arm = extended<arm_with_friction::System, parameters<k>, inputs<push>,
                       loads<force<arm_with_friction::Tool, push * arm_with_friction::Tool::x -
                                                                k * velocity_of<arm_with_friction::Tool>>>>;
  using Gripper =
      extended<gripper_with_numbers::System, parameters<k>, inputs<push>,
               loads<force<gripper_with_numbers::Thumb, (push - k * gripper_with_numbers::q_left_slide) *
                                                            gripper_with_numbers::Thumb::z>>>;
  using Balancer =
      extended<::balancer::System, inputs<push>, loads<force<::balancer::Beam, push* ::balancer::Beam::z>>>;
  using Wrong = extended<gripper_with_numbers::System, inputs<push>,
                         loads<torque<gripper_with_numbers::Thumb, push * gripper_with_numbers::Thumb::z>>>;
  EXPECT_EQ(mistake_of<Arm>(), "");
  EXPECT_EQ(mistake_of<Gripper>(), "");
  EXPECT_EQ(mistake_of<Balancer>(), "");
  EXPECT_EQ(mistake_of<Wrong>(), "the torque on Thumb is push [N], but must be in N m");
  EXPECT_EQ(derivation::unit_table_of(Arm::record).of("k"), newton * second / meter);
  EXPECT_EQ(derivation::unit_table_of(Gripper::record).of("k"), newton / meter);
}

// Nothing is checked because of the units of a file.
TEST(compiled_robots, take_words_without_units_as_before) {
  using Loaded =
      extended<arm_robot::System, inputs<drive>,
               loads<torque<arm_robot::Tool, (drive - 3 * arm_robot::u_elbow) * arm_robot::Tool::y>>>;
  EXPECT_EQ(mistake_of<Loaded>(), "");
  const mechanics::unit_table units = derivation::unit_table_of(Loaded::record);
  EXPECT_EQ(units.of("q_waist"), units::si::radian);
  EXPECT_EQ(units.of("drive"), std::nullopt);
}

} // namespace
