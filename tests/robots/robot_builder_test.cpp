// builds: clang++ all
// Run-time models of robots, compared with results of Pinocchio at random states.
#include "robots/files.hpp"

#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>
#include <kanexpr/runtime/explain.hpp>
#include <kanexpr/units/si.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace {

using namespace kanexpr;
using namespace kanexpr::robots;
using mechanics::quantity;

robot robot_of(const std::string& file) {
  const read_robot read = read_urdf(robot_files::path_of(file));
  EXPECT_TRUE(read) << read.cause();
  return read.robot;
}

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

/// Relative to the largest entry.
template <class Matrix>
void expect_equal(const Matrix& ours, const std::vector<double>& theirs, const std::string& what) {
  ASSERT_EQ(static_cast<std::size_t>(ours.size()), theirs.size()) << what;
  double largest = 0;
  for (double e : theirs) largest = std::max(largest, std::abs(e));
  for (Eigen::Index i = 0; i < ours.size(); ++i)
    EXPECT_NEAR(ours(i / ours.cols(), i % ours.cols()), theirs[static_cast<std::size_t>(i)], 1e-12 * largest)
        << what << ' ' << i;
}

class robot_builders : public testing::TestWithParam<std::string> {};

TEST_P(robot_builders, agree_with_pinocchio) {
  const std::string called = GetParam();
  const bool floats = called.ends_with(".floating");
  for (const binding bind : {binding::numbers, binding::parameters}) {
    const robot_builder built(
        robot_of(called.substr(0, called.find('.')) + ".urdf"),
        {.base = floats ? base_kind::floating : base_kind::fixed, .bind = bind, .damping = false});
    ASSERT_EQ(built.cause(), "");
    model m = derive(built);
    ASSERT_EQ(m.mistake(), "");
    Eigen::VectorXd p(static_cast<Eigen::Index>(built.values().size()));
    for (Eigen::Index i = 0; i < p.size(); ++i) p[i] = built.values()[static_cast<std::size_t>(i)].second;
    const auto references = robot_files::references_of(called);
    ASSERT_EQ(references.size(), 2u);
    for (const robot_files::reference& there : references) {
      const Eigen::VectorXd x = vector_of(there.at("state")), r = vector_of(there.at("inputs"));
      for (const auto& [is, what] : {std::pair(quantity::mass_matrix, "mass"),
                                     {quantity::forcing, "forcing"},
                                     {quantity::udot, "udot"},
                                     {quantity::kinetic_energy, "kinetic"},
                                     {quantity::potential_energy, "potential"}}) {
        auto f = m.function(m.get(is));
        expect_equal(f(x, p, r), there.at(what), called + " " + what);
        EXPECT_TRUE(f.status()) << f.status().cause();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(files, robot_builders,
                         testing::Values("arm.fixed", "arm.floating", "carts.fixed", "gripper.fixed",
                                         "walker.floating"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::ranges::replace(name, '.', '_');
                           return name;
                         });

/// The number of checks for singularities in the computation of u̇.
int checks_of_udot(const robot_builder& built) {
  model m = derive(built);
  return m.equations().singularity_checks_of(symbolic::nodes_of(m.udot().entries)).size();
}

// An angular velocity along an oblique axis has the same components on both sides of the joint.
TEST(robot_builder, forms_short_equations_without_checks_about_oblique_axes) {
  struct expected {
    const char* file;
    base_kind base;
    int products_and_sums;
  };
  for (const auto& [file, base, most] : {expected{"arm.urdf", base_kind::fixed, 604},
                                         {"arm.urdf", base_kind::floating, 1226},
                                         {"gripper.urdf", base_kind::fixed, 171},
                                         {"walker.urdf", base_kind::fixed, 97},
                                         {"walker.urdf", base_kind::floating, 1154}}) {
    const robot_builder built(robot_of(file), {.base = base});
    const symbolic::cost cost = explain(built, {.searches = false}).chosen().cost;
    EXPECT_LE(cost.multiplications + cost.additions, most) << file;
    EXPECT_EQ(checks_of_udot(built), 0) << file;
  }
}

// A rod that turns only about its own axis has no kinetic energy, so its mass matrix may be singular.
TEST(robot_builder, checks_mass_matrices_of_rods_about_two_axes) {
  const auto checks_with = [](const std::string& inertia_along_the_rod) {
    const read_robot read = read_urdf_text(
        "<robot><link name='ground'/><link name='cross'/><link name='rod'><inertial><mass value='2'/>"
        "<inertia ixx='0.3' iyy='0.3' izz='" +
        inertia_along_the_rod +
        "' ixy='0' ixz='0' iyz='0'/></inertial></link>"
        "<joint name='a' type='continuous'><parent link='ground'/><child link='cross'/><axis xyz='1 2 "
        "2'/></joint>"
        "<joint name='b' type='continuous'><parent link='cross'/><child link='rod'/><axis xyz='0 3 "
        "4'/></joint>"
        "</robot>");
    EXPECT_TRUE(read) << read.cause();
    const robot_builder built(read.robot);
    EXPECT_EQ(built.cause(), "");
    return checks_of_udot(built);
  };
  EXPECT_EQ(checks_with("0.1"), 0);
  EXPECT_GT(checks_with("0"), 0);
}

TEST(robot_builder, knows_links_by_their_names_in_the_file) {
  robot_builder arm(robot_of("arm.urdf"));
  EXPECT_EQ(arm.frame_of("pedestal"), runtime::builder::inertial_frame());
  EXPECT_NE(arm.frame_of("tool"), arm.frame_of("forearm"));
  EXPECT_EQ(arm.frame_of("nobody"), runtime::builder::inertial_frame());
  EXPECT_EQ(arm.body_of("tool"), "Forearm_body");
  EXPECT_EQ(arm.body_of("pedestal"), "");
  EXPECT_EQ(arm.body_of("nobody"), "");
  arm.force(arm.origin_of("tool"), arm.along(arm.frame_of("tool"), arm.input("push"), 0, 0));
  EXPECT_EQ(arm.cause(), "");
  EXPECT_EQ(arm.mechanism().inputs.size(), 4);
}

// Damping, dry friction and rotors act only at their joints.
TEST(robot_builder, feels_what_is_at_joints) {
  robot r = robot_of("arm.urdf");
  r.joints[1].gear_ratio = -20, r.joints[1].rotor_inertia = 0.003;
  const robot_builder with(r, {.friction = dry_friction{}}),
      without(robot_of("arm.urdf"), {.damping = false});
  ASSERT_EQ(with.cause(), "");
  model m = derive(with), n = derive(without);
  Eigen::VectorXd x(6), none;
  x << 0.3, -0.4, 0.9, 1.5, -0.7, 0.2;
  const Eigen::Vector3d inputs(1, 2, 3);
  auto mass = m.function(m.mass_matrix()), plain_mass = n.function(n.mass_matrix());
  Eigen::Matrix3d added = Eigen::Matrix3d::Zero();
  added(1, 1) = 400 * 0.003;
  EXPECT_TRUE((mass(x, none, inputs) - plain_mass(x, none, inputs)).isApprox(added, 1e-12));
  auto forcing = m.function(m.forcing()), plain = n.function(n.forcing());
  const double dry = 0.2 * 1.5 / std::hypot(1.5, 0.01);
  const Eigen::Vector3d felt(-0.6 * 1.5 - dry, 0.4 * 0.7, 0);
  EXPECT_TRUE((forcing(x, none, inputs) - plain(x, none, inputs)).isApprox(felt, 1e-12));
}

TEST(robot_builder, stops_at_limits) {
  const robot r = robot_of("arm.urdf");
  const joint_limits& limits = r.joints[2].limits;
  const limit_stops by{.turning = 400, .damping = 0.5, .width = 0.02};
  const robot_builder with(r, {.stops = by}), without(r);
  ASSERT_EQ(with.cause(), "");
  model m = derive(with), n = derive(without);
  auto forcing = m.function(m.forcing()), plain = n.function(n.forcing());
  Eigen::VectorXd x(6), none;
  const Eigen::Vector3d inputs(1, 2, 3);
  x << 0.3, -0.4, limits.upper + 0.1, 1.5, -0.7, 0.2;
  const Eigen::Vector3d felt(0, 0, -400 * (0.1 - 0.01) * (1 + 0.5 * 0.2));
  EXPECT_TRUE((forcing(x, none, inputs) - plain(x, none, inputs)).isApprox(felt, 1e-11));
  x(2) = 0.5 * (limits.lower + limits.upper);
  EXPECT_TRUE((forcing(x, none, inputs) - plain(x, none, inputs)).isZero(1e-13));
}

// A robot on a wall and the inputs that hold it still.
TEST(robot_builder, falls_along_the_gravity_of_the_robot) {
  robot r = robot_of("arm.urdf");
  Eigen::VectorXd x(6);
  x << 0.3, -0.4, 0.9, 0, 0, 0;
  const auto held = [&](const model_options& options) -> Eigen::Vector3d {
    const robot_builder built(r, options);
    EXPECT_EQ(built.cause(), "");
    model m = derive(built);
    auto f = m.function(m.get(quantity::gravity_compensation));
    Eigen::VectorXd p(static_cast<Eigen::Index>(built.values().size()));
    for (Eigen::Index i = 0; i < p.size(); ++i) p[i] = built.values()[static_cast<std::size_t>(i)].second;
    return f(x, p);
  };
  const Eigen::Vector3d upright = held({}), on_moon = held({.gravity = 1.62});
  EXPECT_TRUE(on_moon.isApprox(upright * (1.62 / 9.81), 1e-12));
  const auto along = [&](const vector3& to, const model_options& options = {}) {
    r.gravity = to;
    return held(options);
  };
  EXPECT_TRUE(along({0, 0, -1.62}).isApprox(on_moon, 1e-12));
  EXPECT_TRUE(along({1, 2, -3}).isApprox(along({1, 0, 0}) + along({0, 2, 0}) + along({0, 0, -3}), 1e-12));
  EXPECT_TRUE(along({1, 2, -3}, {.bind = binding::parameters}).isApprox(along({1, 2, -3}), 1e-12));
  EXPECT_TRUE(along({1, 2, -3}, {.gravity = 9.81}).isApprox(upright, 1e-12));
  EXPECT_TRUE(along({}).isZero(0));
  r.gravity = vector3{0, 0, std::nan("")};
  EXPECT_EQ(robot_builder(r).cause(), "the gravity of the robot is not finite");
  r.gravity = {};
  EXPECT_EQ(robot_builder(r, {.gravity = std::nan("")}).cause(),
            "the gravity in the model options is not finite");
}

// Compared with weights at the mass centers of the links, without gravity.
TEST(robot_builder, lets_links_without_gravity_float) {
  const robot r = robot_of("balancer.urdf");
  robot heavy = r;
  for (robots::link& l : heavy.links) l.weightless = false;
  for (const base_kind base : {base_kind::fixed, base_kind::floating})
    for (const binding bind : {binding::numbers, binding::parameters}) {
      const robot_builder ours(r, {.base = base, .bind = bind});
      robot_builder by_hand(heavy, {.base = base, .gravity = 0});
      ASSERT_EQ(ours.cause(), "");
      symbolic::matrix energy(by_hand.graph(), 1, 1);
      for (const robots::link& l : r.links) {
        if (l.weightless || by_hand.body_of(l.name).empty()) continue; // that of the ground is empty
        const auto weight = by_hand.along(by_hand.inertial_frame(), 0, 0, -9.81 * l.inertial->mass);
        const vector3& c = l.inertial->center.position;
        const auto at = by_hand.offset("Weight_" + l.name, by_hand.origin_of(l.name),
                                       by_hand.along(by_hand.frame_of(l.name), c[0], c[1], c[2] + 0.0));
        by_hand.force(at, weight);
        energy(0, 0) = energy(0, 0) - by_hand.dot(weight, by_hand.position_of(at, by_hand.origin_of("")));
      }
      ASSERT_EQ(by_hand.cause(), "");
      model m = derive(ours), n = derive(by_hand);
      auto udot = m.function(m.udot()), expected = n.function(n.udot());
      auto height = m.function(m.get(quantity::potential_energy)), expected_height = n.function(energy);
      ASSERT_EQ(m.mistake() + n.mistake(), "");
      Eigen::VectorXd p(static_cast<Eigen::Index>(ours.values().size()));
      for (Eigen::Index i = 0; i < p.size(); ++i) p[i] = ours.values()[static_cast<std::size_t>(i)].second;
      std::mt19937_64 source(7);
      std::uniform_real_distribution<double> values(-1, 1);
      for (int i = 0; i < 5; ++i) {
        Eigen::VectorXd x(base == base_kind::fixed ? 6 : 19), inputs(3);
        for (double& e : x) e = values(source);
        for (double& e : inputs) e = values(source);
        if (base == base_kind::floating) x.segment(3, 4).normalize();
        const Eigen::VectorXd found = udot(x, p, inputs), wanted = expected(x, Eigen::VectorXd(), inputs);
        EXPECT_LT((found - wanted).norm(), 1e-12 * wanted.norm());
        const double high = height(x, p)(0), wanted_height = expected_height(x)(0);
        EXPECT_NEAR(high, wanted_height, 1e-12 * std::abs(wanted_height));
      }
    }
}

// The cart moves a floating link with it along the rail.
TEST(robot_builder, floats_off_a_slide) {
  const read_robot read = read_urdf_text(
      "<robot name='r'><link name='ground'/>"
      "<link name='cart'><inertial><mass value='2'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
      "iyz='0'/>"
      "</inertial></link>"
      "<link name='ship'><inertial><mass value='3'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
      "iyz='0'/>"
      "</inertial></link>"
      "<joint name='rail' type='prismatic'><parent link='ground'/><child link='cart'/><axis xyz='1 0 0'/>"
      "<limit effort='1' velocity='1' lower='-1' upper='1'/></joint>"
      "<joint name='mooring' type='floating'><parent link='cart'/><child link='ship'/></joint></robot>");
  ASSERT_TRUE(read) << read.cause();
  const robot_builder built(read.robot);
  ASSERT_EQ(built.cause(), "");
  model m = derive(built);
  auto mass = m.function(m.mass_matrix());
  auto at = built.at_rest();
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.7, 0.1, -0.5, 0.5).normalized();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(at.size()));
  x.segment<4>(4) << turn.vec(), turn.w();
  const Eigen::MatrixXd of_all = mass(x, Eigen::VectorXd(), Eigen::VectorXd(1));
  EXPECT_NEAR(of_all(0, 0), 5, 1e-12);
  const Eigen::RowVector3d coupled = 3 * turn.toRotationMatrix().row(0);
  EXPECT_TRUE((of_all.block<1, 3>(0, 1).isApprox(coupled, 1e-12))) << of_all;
}

// Only the words of the user are checked, because a file defines the units of its numbers.
TEST(robot_builder, knows_its_units) {
  using namespace units::si;
  robot r = robot_of("gripper.urdf");
  for (joint& j : r.joints) {
    j.damping = j.friction = 1; // factors that are not visible in a product
    if (j.name == "thumb_turn") j.mimic->multiplier = 1;
  }
  for (const binding bind : {binding::numbers, binding::parameters}) {
    robot_builder built(r, {.bind = bind, .friction = dry_friction{}});
    const auto units = built.units();
    EXPECT_EQ(units.of("q_lift"), meter);
    EXPECT_EQ(units.of("u_left_slide"), meter / second);
    EXPECT_EQ(units.of("F_lift"), newton);
    EXPECT_EQ(units.of("izz_Hand"), bind == binding::parameters
                                        ? mechanics::possible_unit(kilogram * pow<2>(meter))
                                        : std::nullopt);
    EXPECT_EQ(derive(built).unit_of(quantity::udot, 1), meter / pow<2>(second));
    const auto thumb = built.frame_of("thumb");
    const auto push = built.input("push"), slide = built.mechanism().coordinates[1], k = built.parameter("k");
    built.torque(thumb, built.along(thumb, 3 * slide, 0, 0));
    built.force(built.origin_of("hand"), built.along(built.frame_of("hand"), push, k * slide, 0));
    EXPECT_EQ(built.cause(), ""); // nothing states a unit
    EXPECT_EQ(built.units().of("k"), std::nullopt);
    const auto m = built.input("M", newton * meter);
    built.used_elsewhere(m);
    EXPECT_EQ(built.cause(), "the torque on Thumb is 3*q_left_slide [m], but must be in N m");
  }
  robot_builder right(r, {.friction = dry_friction{}});
  const auto k = right.parameter("k"), push = right.input("push", newton);
  const auto thumb = right.frame_of("thumb");
  right.force(right.origin_of("thumb"),
              right.along(thumb, push - k * right.mechanism().coordinates[0], 0, 0));
  EXPECT_EQ(right.cause(), "");
  EXPECT_EQ(right.units().of("k"), newton / meter);
}

TEST(robot_builder, survives_broken_files) {
  int built_well = 0;
  robot_files::each_broken(100, [&](const std::string& text) {
    const read_robot read = read_urdf_text(text);
    if (!read) return;
    const robot_builder built(read.robot, {.friction = dry_friction{}});
    if (built.cause().empty()) ++built_well, static_cast<void>(derive(built).udot());
  });
  EXPECT_GT(built_well, 20);
}

TEST(robot_builder, says_what_is_wrong) {
  const read_robot still = read_urdf_text("<robot><link name='a'/></robot>");
  const char* const cause = "no joint of the robot moves, and its base is fixed";
  EXPECT_EQ(robot_builder(still.robot).cause(), cause);
  EXPECT_EQ(derive(robot_builder(still.robot)).mistake(), cause);
  EXPECT_EQ(explain(robot_builder(still.robot)).mistake, cause);
  const read_robot light =
      read_urdf_text("<robot><link name='a'/><link name='b'/><joint name='j' type='revolute'>"
                     "<parent link='a'/><child link='b'/></joint></robot>");
  EXPECT_NE(robot_builder(light.robot).cause(), "");
}

// The massless last link is detected when the mass matrix is formed; all later results have no values.
TEST(robot_builder, tells_of_a_mistake_in_every_function) {
  robot r = robot_of("arm.urdf");
  for (robots::link& l : r.links)
    if (l.name == "forearm" || l.name == "flange") l.inertial.reset();
  const robot_builder built(r);
  ASSERT_EQ(built.cause(), "");
  const std::string cause = "speed u_elbow moves no mass";
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(6, 0.3), none, torques = Eigen::VectorXd::Ones(3);
  model m = derive(built);
  const symbolic::matrix before = m.get(quantity::kinetic_energy);
  for (const quantity each :
       {quantity::udot, quantity::rhs, quantity::mass_matrix, quantity::regressor, quantity::kinetic_energy,
        quantity::state_jacobian, quantity::weighted_hessian}) {
    auto f = m.function(m.get(each));
    EXPECT_FALSE(f(x, none, torques).allFinite() && f(x, none, torques).size() > 0);
    EXPECT_EQ(f.status().cause(), cause);
  }
  auto energy = m.function(before);
  EXPECT_TRUE(std::isnan(energy(x, none, torques)(0, 0)));
  EXPECT_EQ(energy.status().cause(), cause);
  model again = derive(built);
  auto linear = again.linearize();
  for (const symbolic::matrix& each : {linear.explicit_form().A, linear.implicit_form().M}) {
    EXPECT_TRUE(each.entries.empty());
    EXPECT_EQ(again.function(each).status().cause(), cause);
  }
  EXPECT_THAT(linear.failures(), testing::ElementsAre(cause));
}

} // namespace
