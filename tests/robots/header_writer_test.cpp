// builds: sanitize
// Models of robots as the text of a header, of robots as they should not be, too.
#include "robots/files.hpp"

#include <kanexpr/robots/header_writer.hpp>
#include <kanexpr/robots/picture_writer.hpp>
#include <kanexpr/robots/read_urdf.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace kanexpr::robots;
using testing::HasSubstr;
using testing::Not;

std::string header_of(const robot& r, const model_options& options = {}) {
  header_writer writer(r, options);
  return writer.cause().empty() ? writer.write("arm", "arm.urdf") : writer.cause();
}

robot robot_of(const std::string& file) {
  const read_robot read = read_urdf(robot_files::path_of(file));
  EXPECT_TRUE(read) << read.cause();
  return read.robot;
}

robot robot_in(const std::string& elements) {
  const read_robot read = read_urdf_text("<robot name='r'>" + elements + "</robot>");
  EXPECT_TRUE(read) << read.cause();
  return read.robot;
}

TEST(header_writer, writes_numbers_with_all_their_digits) {
  EXPECT_EQ(text::digits(0.1), "0.1");
  EXPECT_EQ(text::digits(1. / 3), "0.3333333333333333");
  EXPECT_EQ(text::digits(-0.0), "0");
  EXPECT_EQ(text::digits(1e-30), "1e-30");
  EXPECT_EQ(text::digits(123456789012.), "1.23456789012e+11");
  EXPECT_EQ(text::along("A", {0, -1, 0.5}), "-A::y + 0.5 * A::z");
  EXPECT_EQ(text::along("A", {}), "0 * A::x");
}

TEST(header_writer, writes_what_a_person_can_read) {
  const std::string header = header_of(robot_of("arm.urdf"));
  EXPECT_THAT(header, HasSubstr("namespace arm {"));
  EXPECT_THAT(header, HasSubstr("constexpr coordinate<\"q_shoulder_pitch\"> q_shoulder_pitch;"));
  EXPECT_THAT(header, HasSubstr("// shoulder-pitch: from shoulder to upper arm"));
  EXPECT_THAT(header, HasSubstr("struct Shoulder : pin<Shoulder, N, axis<own::z>, at<0.4 * N::z>, "
                                "by<q_waist, u_waist>,\n"));
  EXPECT_THAT(header, HasSubstr("struct Forearm : pin<Forearm, Upper_arm, axis<-own::y>, "));
  EXPECT_THAT(header, HasSubstr("motor<Shoulder, T_waist>, joint_friction<Shoulder, 0.6>"));
  EXPECT_THAT(header, HasSubstr("struct Tool : weld<Tool, Forearm,")); // folded, and still there
  EXPECT_THAT(header, HasSubstr("  static constexpr double upper[]{2.5, no_limit, 2.1};"));
  EXPECT_THAT(header_of(robot_of("arm.urdf"), {.damping = false}), Not(HasSubstr("joint_friction")));
  EXPECT_THAT(header_of(robot_of("arm.urdf"), {.friction = true}),
              HasSubstr("motor<Shoulder, T_waist - 0.2 * sign(u_waist)>"));
}

// What follows another has no coordinate: it is fixed where that says.
TEST(header_writer, writes_joints_that_follow_others) {
  const std::string header = header_of(robot_of("gripper.urdf"));
  EXPECT_THAT(header, HasSubstr("at<(1.2 * q_left_slide + 0.004) * Right_finger_start::y>"));
  EXPECT_THAT(header, HasSubstr("home<-2.04 * q_left_slide + 0.3432, 0.6 * Thumb_start::x + "));
  EXPECT_THAT(header, HasSubstr("joints<Hand, Left_finger, Right_finger_start, Right_finger, "));
}

TEST(header_writer, writes_parameters_and_their_values) {
  const std::string header = header_of(robot_of("arm.urdf"), {.bind = binding::parameters});
  EXPECT_THAT(header, HasSubstr("constexpr parameter<\"ixx_Shoulder\"> ixx_Shoulder;"));
  EXPECT_THAT(header, HasSubstr("  p[m_Shoulder] = 3.7;"));
  EXPECT_THAT(header, HasSubstr("gravity<-g * N::z>"));
}

TEST(header_writer, writes_names_that_are_identifiers) {
  const std::string header = header_of(robot_in(
      "<link name='System'/><link name='3 *//\\'/><link name='\xc3\xa9'/>"
      "<joint name='!' type='revolute'><parent link='System'/><child link='3 *//\\'/></joint>"
      "<joint name='&lt;' type='revolute'><parent link='3 *//\\'/><child link='\xc3\xa9'/></joint>"));
  EXPECT_THAT(header, HasSubstr("using System_2 = N;"));
  EXPECT_THAT(header, HasSubstr("struct Link_3 : pin<Link_3, N, axis<own::x>, by<q_joint, u_joint>>"));
  EXPECT_THAT(header, HasSubstr("struct Link : pin<Link, Link_3, axis<own::x>, by<q_joint_2, u_joint_2>>"));
  EXPECT_THAT(header, HasSubstr("// !: from System to 3 *//_\n"));
  EXPECT_THAT(
      header,
      HasSubstr("/// Names of the file: System_2 is System, Link_3 is 3 *//_, Link is __, joint is !, "
                "joint_2 is <.\nnamespace"));
  EXPECT_THAT(header_of(robot_of("gripper.urdf")), Not(HasSubstr("Names of the file")));
  EXPECT_TRUE(is_namespace("arm_2"));
  for (const char* no : {"", "2arm", "_arm", "arm_", "a__b", "a-b", "int", "kanexpr", "std"})
    EXPECT_FALSE(is_namespace(no)) << no;
}

TEST(header_writer, writes_what_a_robot_looks_like) {
  const robot arm = robot_of("arm.urdf");
  const std::string picture = picture_writer(arm, {}).write("arm");
  EXPECT_THAT(picture,
              HasSubstr("struct Shoulder_shape : offset<Shoulder_shape, Shoulder, 0.1 * Shoulder::z> {};"));
  EXPECT_THAT(picture, HasSubstr("show<cylinder<Shoulder, Shoulder_shape, Shoulder::x, 0.06, 0.2>,"));
  EXPECT_THAT(picture,
              HasSubstr("show<rod<Upper_arm, Forearm, 0.02>, colour<")); // in place of a mesh
  EXPECT_THAT(picture, HasSubstr("ground<>"));
  EXPECT_THAT(picture_writer(arm, {.base = base_kind::floating}).write("arm"), Not(HasSubstr("ground<>")));
  EXPECT_THAT(picture_writer(robot_of("walker.urdf"), {}).write("walker"),
              HasSubstr("show<sphere<Left_thigh, 0.017>, colour<")); // nothing of it is seen
}

TEST(header_writer, says_why_there_is_none) {
  EXPECT_EQ(header_of(robot_in("<link name='a'/>")), "no joint of the robot moves, and its base is fixed");
  const std::string indefinite =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='2'/></inertial>";
  EXPECT_EQ(header_of(robot_in(
                "<link name='a'/><link name='b'>" + indefinite +
                "</link><joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint>")),
            "the inertia of link b, with what is fixed to it, is indefinite: about some axis its moment is "
            "negative");
  const std::string vast = "<inertial><origin xyz='1e200 0 0'/><mass value='1e200'/></inertial>";
  EXPECT_EQ(header_of(robot_in(
                "<link name='a'/><link name='b'>" + vast + "</link><link name='c'>" + vast +
                "</link><joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint><joint "
                "name='k' type='fixed'><parent link='b'/><child link='c'/><origin xyz='1 0 0'/></joint>")),
            "the numbers of link b are too large to be computed with");
  std::string many = "<link name='l0'/>";
  for (int i = 1; i < 10000; ++i)
    many += "<link name='l" + std::to_string(i) + "'/><joint name='j" + std::to_string(i) +
            "' type='revolute'><parent link='l" + std::to_string(i - 1) + "'/><child link='l" +
            std::to_string(i) + "'/></joint>";
  EXPECT_EQ(header_of(robot_in(many)),
            "the robot has 10000 links that move, and a model has no more than 400");
}

// Each is read, or refused with a sentence.
TEST(header_writer, survives_broken_files) {
  int read_well = 0, refused = 0;
  robot_files::each_broken(1500, [&](const std::string& text) {
    const read_robot read = read_urdf_text(text);
    EXPECT_EQ(static_cast<bool>(read), read.cause().empty());
    ++(read ? read_well : refused);
    if (!read) return;
    for (const base_kind base : {base_kind::fixed, base_kind::floating}) {
      EXPECT_FALSE(header_of(read.robot, {.base = base, .bind = binding::parameters}).empty());
      static_cast<void>(picture_writer(read.robot, {.base = base}).write("arm"));
    }
  });
  EXPECT_GT(read_well, 300);
  EXPECT_GT(refused, 500);
}

} // namespace
