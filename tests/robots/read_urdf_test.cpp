// builds: clang++ sanitize
// Robots from URDF files, and the sentences that report invalid files.
#include "robots/files.hpp"

#include <kanexpr/robots/read_urdf.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace kanexpr::robots;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

read_robot in_robot(const std::string& elements, const reading_options& options = {}) {
  return read_urdf_text("<robot name='r'>\n" + elements + "\n</robot>", options);
}

std::string cause_of(const std::string& elements) { return in_robot(elements).cause(); }

const std::string two_links = "<link name='a'/><link name='b'/>\n";

std::string joint_with(const std::string& inside, const std::string& type = "revolute") {
  return "<joint name='j' type='" + type + "'><parent link='a'/><child link='b'/>" + inside + "</joint>";
}

std::string inertial(const std::string& mass, const std::string& inertia) {
  return "<link name='a'><inertial><mass value='" + mass + "'/><inertia " + inertia + "/></inertial></link>";
}

TEST(read_urdf, reads_what_is_in_a_file) {
  const read_robot read = read_urdf(robot_files::path_of("arm.urdf"));
  ASSERT_TRUE(read) << read.cause();
  EXPECT_THAT(read.notes, IsEmpty());
  const robot& r = read.robot;
  EXPECT_EQ(r.name, "arm");
  ASSERT_EQ(r.links.size(), 6u);
  EXPECT_EQ(r.links[static_cast<std::size_t>(r.root)].name, "pedestal");
  ASSERT_TRUE(r.links[1].inertial);
  EXPECT_EQ(r.links[1].inertial->mass, 3.7);
  EXPECT_EQ(r.links[1].inertial->inertia.zx, -0.0011);
  ASSERT_EQ(r.links[1].visual.size(), 1u);
  EXPECT_EQ(r.links[1].visual[0].kind, shape_kind::cylinder);
  EXPECT_EQ(r.links[1].visual[0].size, (vector3{0.06, 0.2, 0}));
  EXPECT_EQ(r.links[1].visual[0].origin.orientation, (rotation{{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}));
  EXPECT_EQ(r.links[1].collision[0].size, (vector3{0.1, 0.2, 0.3}));
  EXPECT_EQ(r.links[2].visual[0].file, "package://arm/upper.stl");
  EXPECT_EQ(r.links[2].visual[0].size, (vector3{0.001, 0.001, 0.001}));
  ASSERT_EQ(r.joints.size(), 5u);
  EXPECT_EQ(r.joints[0].kind, joint_kind::revolute);
  EXPECT_EQ(r.joints[0].limits.upper, 2.5);
  EXPECT_EQ(r.joints[0].limits.effort, 80);
  EXPECT_EQ(r.joints[0].damping, 0.6);
  EXPECT_EQ(r.joints[0].friction, 0.2);
  EXPECT_EQ(r.joints[0].gear_ratio, 50);
  EXPECT_TRUE(std::isinf(r.joints[1].limits.upper));
  EXPECT_NEAR(r.joints[1].axis[2], -2. / 3, 1e-16);
  EXPECT_EQ(r.joints[2].axis, (vector3{0, -1, 0}));
}

TEST(read_urdf, knows_right_angles_and_half_of_them) {
  const std::string turned = two_links + joint_with("<origin rpy='1.5707 -3.1416 0'/><axis xyz='0 1e-9 1'/>");
  const read_robot exact = in_robot(turned), written = in_robot(turned, {.right_angles = 0});
  ASSERT_TRUE(exact && written);
  EXPECT_EQ(exact.robot.joints[0].origin.orientation, (rotation{{{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}}}));
  EXPECT_EQ(exact.robot.joints[0].axis, (vector3{0, 0, 1}));
  EXPECT_NEAR(written.robot.joints[0].origin.orientation[1][1], std::cos(1.5707), 1e-16);
  EXPECT_EQ(written.robot.joints[0].axis[1], 1e-9);
  for (int eighth = -20; eighth <= 20; ++eighth) {
    const double angle = eighth * std::numbers::pi / 4;
    const sine_and_cosine of = sine_and_cosine_of(angle + 5e-5, 1e-4);
    EXPECT_NEAR(of.sine, std::sin(angle), 1e-14);
    EXPECT_NEAR(of.cosine, std::cos(angle), 1e-14);
    EXPECT_EQ(of.sine * of.cosine == 0, eighth % 2 == 0);
  }
  EXPECT_EQ(sine_and_cosine_of(1.57, 1e-4).cosine, std::cos(1.57)); // is farther away
}

TEST(read_urdf, reads_numbers_the_same_in_every_country) {
  EXPECT_EQ(urdf::number_in("+1.25e-3"), 1.25e-3);
  EXPECT_EQ(urdf::number_in(".5"), 0.5);
  EXPECT_EQ(urdf::number_in("1e-999"), 0);
  for (const char* no : {"", "+", "1,5", "nan", "inf", "-inf", "1e999", "0x10", "1.0f", "--1", "++1"})
    EXPECT_FALSE(urdf::number_in(no)) << no;
}

TEST(read_urdf, says_what_is_wrong_with_the_xml) {
  EXPECT_EQ(read_urdf_text("").cause(), "line 1: there is no element, so the file does not describe a robot");
  EXPECT_EQ(read_urdf_text("<!-- nothing -->").cause(),
            "line 1: there is no element, so the file does not describe a robot");
  EXPECT_THAT(read_urdf_text("<robot>\n<link name='a'>\n</robot>").cause(),
              HasSubstr("an element is not closed properly"));
  EXPECT_THAT(read_urdf_text("arm").cause(), HasSubstr("this is no"));
  EXPECT_EQ(read_urdf_text(std::string("<robot/>\0", 9)).cause(),
            "the file contains a zero byte, so it is not XML");
  EXPECT_EQ(read_urdf_text("<sdf/>").cause(), "line 1: the root element is <sdf>, expected <robot>");
  EXPECT_EQ(read_urdf_text("\n<!DOCTYPE robot [<!ENTITY a 'b'>]>\n<robot/>").cause(),
            "line 2: the document type declares entities, which are not expanded");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(read_urdf_text("<robot>" + deep).cause(), "line 1: elements are nested too deeply");
  EXPECT_EQ(read_urdf("nowhere/arm.urdf").cause(), "nowhere/arm.urdf cannot be read");
}

TEST(read_urdf, says_that_xacro_comes_first) {
  EXPECT_EQ(cause_of("<xacro:include filename='a'/>"), "line 2: this is a xacro file; run xacro on it first");
  EXPECT_EQ(cause_of(inertial("${mass}", "")),
            "line 2: value=\"${mass}\" of the mass of link a contains ${mass}, which is not a finite number; "
            "this may be a xacro file: run xacro on it first");
}

TEST(read_urdf, says_what_is_wrong_with_numbers) {
  EXPECT_EQ(cause_of(two_links + joint_with("<origin xyz='0 0 1,5'/>")),
            "line 3: xyz=\"0 0 1,5\" of the origin of joint j contains 1,5, which is not a finite number; "
            "use a decimal point");
  EXPECT_EQ(cause_of(two_links + joint_with("<origin rpy='0 0'/>")),
            "line 3: rpy=\"0 0\" of the origin of joint j has too few numbers: 2 of 3");
  EXPECT_EQ(cause_of(two_links + joint_with("<axis xyz='0 0 1 0'/>")),
            "line 3: xyz=\"0 0 1 0\" of the axis of joint j has more than 3 numbers");
  EXPECT_EQ(cause_of(two_links + joint_with("<axis xyz='0 0 0'/>")),
            "line 3: the axis of joint j has zero length");
  EXPECT_EQ(cause_of(two_links + joint_with("<dynamics damping='-1'/>")),
            "line 3: the damping of joint j is negative");
  EXPECT_EQ(cause_of(two_links + joint_with("<dynamics friction='-1'/>")),
            "line 3: the friction of joint j is negative");
  EXPECT_THAT(cause_of(inertial("nan", "")), HasSubstr("contains nan, which is not a finite number"));
  EXPECT_THAT(cause_of(inertial("1e999", "")), HasSubstr("contains 1e999, which is not a finite number"));
}

TEST(read_urdf, says_what_is_wrong_with_masses) {
  EXPECT_EQ(cause_of(inertial("-1", "")), "line 2: the mass of link a is negative");
  EXPECT_EQ(cause_of("<link name='a'><inertial/></link>"),
            "line 2: link a has an <inertial> element without a mass");
  EXPECT_EQ(cause_of(inertial("1", "ixx='1' iyy='-1' izz='1'")),
            "line 2: a moment of inertia of link a is negative");
}

TEST(read_urdf, notes_inertias_of_no_body) {
  EXPECT_THAT(in_robot(inertial("1", "ixx='1' iyy='1' izz='3'")).notes,
              ElementsAre("line 2: the inertia of link a is not physical: one principal moment exceeds the "
                          "sum of the other two"));
  EXPECT_THAT(
      in_robot(inertial("1", "ixx='1' iyy='1' izz='1' ixy='2'")).notes,
      ElementsAre("line 2: the inertia of link a is indefinite: its moment about some axis is negative"));
  const read_robot rounded = // where a program computed zero
      in_robot(inertial("1", "ixx='0' iyy='0' izz='0' ixy='1e-20'"));
  EXPECT_THAT(rounded.notes, IsEmpty());
  EXPECT_EQ(rounded.robot.links[0].inertial->inertia.largest(), 0);
}

TEST(read_urdf, notes_masses_and_inertias_that_are_not_together) {
  EXPECT_THAT(in_robot(inertial("0", "ixx='1' iyy='1' izz='1'")).notes,
              ElementsAre("line 2: the inertia of link a is given without a mass and is used as written"));
  EXPECT_THAT(in_robot("<link name='a'><inertial><mass value='2'/></inertial></link>").notes,
              ElementsAre("line 2: link a has a mass but no inertia and is treated as a particle"));
  EXPECT_THAT(in_robot(inertial("1", "ixx='1' iyy='1'")).notes,
              ElementsAre("line 2: the inertia of link a has no izz, which is taken as 0"));
}

TEST(read_urdf, takes_quaternions) {
  const auto turn_of = [](const std::string& origin, const reading_options& options = {}) {
    const read_robot read = in_robot(two_links + joint_with("<origin " + origin + "/>"), options);
    EXPECT_TRUE(read) << read.cause();
    EXPECT_THAT(read.notes, IsEmpty());
    return read ? read.robot.joints[0].origin.orientation : rotation{};
  };
  EXPECT_EQ(turn_of("quat_xyzw='0 0 0.7071 0.7071'"), (rotation{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}));
  EXPECT_EQ(turn_of("quat_xyzw='0 0.7071068 0 0.7071068'"), turn_of("rpy='0 1.5708 0'"));
  const double s = std::sin(0.15), c = std::cos(0.15);
  const rotation turned =
      turn_of("quat_xyzw='" + std::to_string(s) + " 0 0 " + std::to_string(c) + "'", {.right_angles = 0});
  EXPECT_NEAR(turned[1][2], -std::sin(0.3), 1e-6);
  EXPECT_EQ(cause_of(two_links + joint_with("<origin rpy='0 0 0' quat_xyzw='0 0 0 1'/>")),
            "line 3: the origin of joint j has both rpy and quat_xyzw");
  EXPECT_EQ(cause_of(two_links + joint_with("<origin quat_xyzw='0 0 0 0'/>")),
            "line 3: quat_xyzw=\"0 0 0 0\" of the origin of joint j does not have norm 1");
}

TEST(read_urdf, notes_angles_that_may_be_degrees) {
  EXPECT_THAT(
      in_robot(two_links + joint_with("<origin rpy='0 0 90'/>")).notes,
      ElementsAre(
          "line 3: rpy=\"0 0 90\" of the origin of joint j exceeds a full turn; angles are read in radians"));
  EXPECT_THAT(in_robot(two_links + joint_with("<origin rpy='0 -6.2832 6.2832'/>")).notes, IsEmpty());
}

// Repeated elements are read once, and unknown ones are ignored.
TEST(read_urdf, notes_what_is_left_out) {
  const std::string box = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";
  EXPECT_THAT(in_robot("<link name='a'>" + box + "\n" + box + "</link>").notes,
              ElementsAre("line 3: link a has a second <inertial>, which is ignored"));
  EXPECT_THAT(in_robot(two_links + joint_with("<origin xyz='0 0 1'/>\n<origin xyz='0 0 2'/>")).notes,
              ElementsAre("line 4: joint j has a second <origin>, which is ignored"));
  EXPECT_THAT(in_robot(two_links + joint_with("<axis xyz='0 0 1'/>\n<axis xyz='0 1 0'/>")).notes,
              ElementsAre("line 4: joint j has a second <axis>, which is ignored"));
  EXPECT_THAT(in_robot(two_links + joint_with("<origin xzy='0 0 1'/>")).notes,
              ElementsAre("line 3: the origin of joint j has the unknown attribute xzy, which is ignored"));
  EXPECT_THAT(
      in_robot(two_links + joint_with("<dynamics damping='1' stiffness='3'/>")).notes,
      ElementsAre("line 3: the dynamics of joint j has the unknown attribute stiffness, which is ignored"));
  EXPECT_THAT(
      in_robot(two_links + joint_with("<joint_properties damping='1'/>")).notes,
      ElementsAre("line 3: joint j contains the unknown element <joint_properties>, which is ignored"));
  EXPECT_THAT(in_robot("<link name='a'><mass value='1'/></link>").notes,
              ElementsAre("line 2: link a contains the unknown element <mass>, which is ignored"));
  EXPECT_THAT(in_robot("<link name='a'/><loop_joint/>").notes,
              ElementsAre("line 2: the robot contains the unknown element <loop_joint>, which is ignored"));
  EXPECT_THAT(
      in_robot(two_links + joint_with("<dynamics damping='1'/>", "planar")).notes,
      ElementsAre("line 3: the dynamics of joint j are ignored because it has more than one coordinate"));
  EXPECT_THAT(in_robot("<link name='a'/><gazebo reference='j'><gravity>0</gravity><mu1>1</mu1></gazebo>"
                       "\n<gazebo><turnGravityOff>false</turnGravityOff><static>1</static></gazebo>")
                  .notes,
              ElementsAre("line 2: <gravity>0</gravity> of j, a Gazebo element, is ignored",
                          "line 3: <static>1</static>, a Gazebo element, is ignored"));
}

TEST(read_urdf, knows_links_on_which_gravity_does_not_act) {
  const std::string ball =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
  const std::string masses =
      "<link name='a'>" + ball + "</link><link name='b'>" + ball + "</link>" + joint_with("");
  const std::string lighter = "<gazebo reference='b'><turnGravityOff>true</turnGravityOff></gazebo>";
  const read_robot one = in_robot(masses + lighter);
  EXPECT_THAT(one.notes, IsEmpty());
  EXPECT_FALSE(one.robot.gravity);
  EXPECT_FALSE(one.robot.links[0].weightless);
  EXPECT_TRUE(one.robot.links[1].weightless);
  const read_robot none =
      in_robot(masses + lighter + "<gazebo reference='a'><gravity>false</gravity></gazebo>");
  EXPECT_THAT(none.notes, IsEmpty());
  EXPECT_EQ(none.robot.gravity, vector3{});
}

TEST(read_urdf, says_that_not_all_notes_are_listed) {
  std::string springs;
  for (int i = 0; i < 200; ++i) springs += "<spring/>\n";
  const read_robot read = in_robot(springs + "<link name='a'/>");
  ASSERT_EQ(read.notes.size(), 101u);
  EXPECT_EQ(read.notes[99], "line 101: the robot contains the unknown element <spring>, which is ignored");
  EXPECT_EQ(read.notes[100], "further notes are not listed");
}

TEST(read_urdf, says_what_is_wrong_with_names) {
  EXPECT_EQ(cause_of("<link/>"), "line 2: a link has no name");
  EXPECT_EQ(cause_of("<link name='a'/>\n<link name='a'/>"), "line 3: two links are called a");
  EXPECT_EQ(cause_of(two_links + joint_with("") + "\n" + joint_with("")), "line 4: two joints are called j");
  EXPECT_EQ(cause_of(two_links + "<joint name='j'/>"), "line 3: joint j has no type");
  EXPECT_EQ(
      cause_of(two_links + joint_with("", "hinge")),
      "line 3: joint j has type hinge; expected fixed, revolute, continuous, prismatic, planar or floating");
  EXPECT_EQ(cause_of("<link name='a'/>" + joint_with("")),
            "line 2: joint j has the child b, which is not a link");
  EXPECT_EQ(cause_of("<link name='a'/><joint name='j' type='fixed'><child link='a'/></joint>"),
            "line 2: joint j has no parent");
}

std::string joint_between(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint name='" + name + "' type='fixed'><parent link='" + parent + "'/><child link='" + child +
         "'/></joint>\n";
}

TEST(read_urdf, says_why_links_are_no_tree) {
  const std::string links = "<link name='a'/><link name='b'/><link name='c'/>\n";
  EXPECT_EQ(cause_of(""), "line 1: the robot has no links");
  EXPECT_EQ(cause_of(links + joint_between("i", "a", "a")), "line 3: joint i connects a link to itself");
  EXPECT_EQ(cause_of(links + joint_between("i", "a", "c") + joint_between("j", "b", "c")),
            "line 4: link c is the child of two joints, i and j");
  EXPECT_EQ(
      cause_of(links + joint_between("i", "a", "b")),
      "line 1: neither link a nor link c is the child of a joint; a robot has only one such link, its root");
  EXPECT_EQ(cause_of(links + joint_between("i", "b", "c") + joint_between("j", "c", "b")),
            "line 4: the joints form a loop: link b is its own ancestor");
  EXPECT_EQ(cause_of(links + joint_between("i", "a", "b") + joint_between("j", "b", "c") +
                     joint_between("k", "c", "a")),
            "line 1: the joints form a loop: every link is the child of a joint");
}

std::string mimicking(const std::string& type, const std::string& leader) {
  return "<link name='a'/><link name='b'/><link name='c'/>\n<joint name='i' type='revolute'><parent "
         "link='a'/><child "
         "link='b'/><axis xyz='0 0 1'/><mimic joint='" +
         leader + "' offset='1.5708'/></joint>\n<joint name='j' type='" + type +
         "'><parent link='b'/><child link='c'/><mimic joint='i'/></joint>";
}

TEST(read_urdf, says_what_is_wrong_with_joints_that_follow_others) {
  EXPECT_EQ(cause_of(mimicking("revolute", "k")), "line 3: joint i mimics k, which is not a joint");
  EXPECT_EQ(cause_of(mimicking("revolute", "j")), "line 3: joint i mimics a joint that in turn mimics it");
  EXPECT_EQ(cause_of(mimicking("revolute", "i")), "line 3: joint i mimics a joint that in turn mimics it");
  EXPECT_EQ(cause_of(mimicking("planar", "j")),
            "line 3: joint i mimics j, which has more than one coordinate");
  EXPECT_TRUE(in_robot(mimicking("revolute", "k"), {.mimic = false}));
}

TEST(read_urdf, fixes_what_follows_a_fixed_joint) {
  const read_robot read = in_robot(mimicking("fixed", "j"));
  ASSERT_TRUE(read) << read.cause();
  EXPECT_EQ(read.robot.joints[0].kind, joint_kind::fixed);
  EXPECT_THAT(read.notes, ElementsAre("line 4: joint j is fixed, so its mimic is ignored",
                                      "line 3: joint i mimics j, which is fixed, so it is fixed too"));
  EXPECT_EQ(read.robot.joints[0].origin.orientation, (rotation{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}));
}

TEST(read_urdf, reads_gears_and_rotors) {
  const std::string robot = two_links + joint_with("<axis xyz='0 0 1'/>");
  const read_robot read = in_robot(
      robot +
      "<transmission name='t'><joint name='j'/><actuator name='m'><drake:rotor_inertia value='0.002'/>"
      "<drake:gear_ratio value='-100'/></actuator></transmission>");
  ASSERT_TRUE(read) << read.cause();
  EXPECT_EQ(read.robot.joints[0].rotor_inertia, 0.002);
  EXPECT_EQ(read.robot.joints[0].gear_ratio, -100);
  EXPECT_EQ(cause_of(robot +
                     "\n<transmission name='t'><joint name='j'/><mechanicalReduction>x</mechanicalReduction>"
                     "</transmission>"),
            "line 4: the mechanicalReduction of the transmission of joint j is not a finite number");
  EXPECT_EQ(cause_of(robot +
                     "\n<transmission name='t'><joint name='j'/><mechanicalReduction>0</mechanicalReduction>"
                     "</transmission>"),
            "line 4: the mechanicalReduction of the transmission of joint j is 0");
  EXPECT_THAT(in_robot(robot + "\n<transmission name='t'><joint name='k'/></transmission>").notes,
              ElementsAre("line 4: a transmission refers to joint k, which does not exist; it is ignored"));
}

// n² J holds for one rotor that rotates with one joint.
TEST(read_urdf, notes_rotors_that_are_not_alone) {
  const std::string robot = two_links + joint_with("<axis xyz='0 0 1'/>") + "\n",
                    rotor = "<actuator name='m'><rotorInertia>2</rotorInertia></actuator>";
  const auto transmission = [](const std::string& inside) {
    return "<transmission name='t'><joint name='j'/>" + inside + "</transmission>";
  };
  for (const auto& [more, why] :
       {std::pair<std::string, std::string>(transmission(rotor + rotor),
                                            "the transmission has several rotors, gears or joints"),
        {transmission(rotor + "<joint name='j'/>"), "the transmission has several rotors, gears or joints"},
        {transmission(rotor) + transmission(rotor), "the joint already has one"}})
    EXPECT_THAT(
        in_robot(robot + more).notes,
        testing::Contains("line 4: the rotor in the transmission of joint j is ignored because " + why));
  const read_robot read = in_robot(robot + transmission(rotor));
  EXPECT_THAT(read.notes, IsEmpty());
  EXPECT_EQ(read.robot.joints[0].rotor_inertia, 2);
}

TEST(read_urdf, reads_ten_thousand_links) {
  std::string links = "<link name='0'/>\n", joints;
  for (int i = 1; i < 10000; ++i) {
    links += "<link name='" + std::to_string(i) + "'/>\n";
    joints += joint_between("j" + std::to_string(i), std::to_string(i - 1), std::to_string(i));
  }
  const read_robot read = in_robot(links + joints);
  ASSERT_TRUE(read) << read.cause();
  EXPECT_EQ(read.robot.links.size(), 10000u);
}

} // namespace
